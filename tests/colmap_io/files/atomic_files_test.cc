#include "colmap_io/files/atomic_files.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>

#include <thread>

#include "colmap_io/files/read_file.h"
#include "core/base/error.h"
#include "tests/colmap_io/files/temporary_folder.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::function<void(std::ostream&)> Writer(const std::string& text) {
  return [text](std::ostream& stream) { stream << text; };
}

TEST(WriteFile, ReplacesTheWholeFileAndLeavesNoTemporary) {
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.txt";
  WriteFile(path, Writer("a long first version"));
  EXPECT_EQ(ReadFile(path), "a long first version");
  WriteFile(path, Writer("new\r\n"));
  EXPECT_EQ(ReadFile(path), "new\r\n");
  EXPECT_EQ(folder.NumFiles(), 1u);
}

TEST(WriteFile, HasThePermissionsOfAnyNewFile) {
  const TemporaryFolder folder;
  WriteFile(folder.Path() / "a", Writer(""));
  std::ofstream(folder.Path() / "b") << "";
  EXPECT_EQ(fs::status(folder.Path() / "a").permissions(),
            fs::status(folder.Path() / "b").permissions());
}

TEST(WriteFile, TheOldFileIsThereUntilTheNewOneIsComplete) {
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.txt";
  WriteFile(path, Writer("old"));
  WriteFile(path, [&](std::ostream& stream) {
    stream << "half" << std::flush;
    EXPECT_EQ(ReadFile(path), "old");
    EXPECT_EQ(folder.NumFiles(), 2u);
    stream << " and half";
  });
  EXPECT_EQ(ReadFile(path), "half and half");
}

TEST(WriteFile, FailureKeepsTheOldFileAndRemovesTheTemporary) {
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.txt";
  WriteFile(path, Writer("old"));
  EXPECT_THAT(
      [&] {
        WriteFile(path, [](std::ostream& stream) {
          stream << "half";
          stream.setstate(std::ios::badbit);
        });
      },
      ThrowsMessage<InputError>(HasSubstr(path.string())));
  EXPECT_THROW(WriteFile(path,
                         [](std::ostream& stream) {
                           stream << "half";
                           throw CancelledError();
                         }),
               CancelledError);
  EXPECT_EQ(folder.NumFiles(), 1u);
  EXPECT_EQ(ReadFile(path), "old");
}

// The system refuses whatever goes beyond a size.
TEST(WriteFile, NamesTheFileOfWhatItsWriterRefuses) {
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.txt";
  EXPECT_THAT(
      [&] { WriteFile(path, [](std::ostream&) { throw InputError("odd"); }); },
      ThrowsMessage<InputError>(path.string() + ": odd"));
  EXPECT_EQ(folder.NumFiles(), 0u);
}

TEST(WriteFile, AFullDiskIsAnError) {
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a";
  WriteFile(path, Writer("old"));
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit limit = {1000, before.rlim_max};
  const auto handler = signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  EXPECT_THAT([&] { WriteFile(path, Writer(std::string(100000, 'x'))); },
              ThrowsMessage<InputError>(HasSubstr("the disk may be full")));
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, handler);
  EXPECT_EQ(ReadFile(path), "old");
  EXPECT_EQ(folder.NumFiles(), 1u);
}

TEST(WriteFile, ADeviceStaysWhatItIs) {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/null", folder.Path() / "a");
  EXPECT_THROW(WriteFile(folder.Path() / "a", Writer("x")), InputError);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(folder.NumFiles(), 1u);
}

TEST(WriteFile, NamesThePathThatCannotBe) {
  const TemporaryFolder folder;
  fs::create_directory(folder.Path() / "folder");
  // Nobody may write into /proc, not even root.
  for (const fs::path& path : {folder.Path() / "missing" / "a.txt",
                               folder.Path() / "folder",
                               folder.Path() / "",
                               fs::path("/proc/a.txt")}) {
    const auto names_it =
        ThrowsMessage<InputError>(HasSubstr(path.string() + ": cannot be"));
    EXPECT_THAT([&] { WriteFile(path, Writer("x")); }, names_it);
    EXPECT_THAT([&] { CheckFilePath(path); }, names_it);
  }
  EXPECT_EQ(folder.NumFiles(), 1u);
}

TEST(WriteFile, ASymbolicLinkStaysAndItsTargetIsReplaced) {
  const TemporaryFolder folder;
  fs::create_directory(folder.Path() / "elsewhere");
  const fs::path target = folder.Path() / "elsewhere" / "real";
  WriteFile(target, Writer("old"));
  fs::create_symlink(target, folder.Path() / "link");
  WriteFile(folder.Path() / "link", Writer("new"));
  EXPECT_TRUE(fs::is_symlink(folder.Path() / "link"));
  EXPECT_EQ(ReadFile(target), "new");
}

TEST(WriteFile, ASymbolicLinkToNothingStays) {
  const TemporaryFolder folder;
  const fs::path link = folder.Path() / "link";
  fs::create_symlink("gone/real", link);
  EXPECT_THAT([&] { WriteFile(link, Writer("x")); },
              ThrowsMessage<InputError>(HasSubstr("leads to no file")));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(folder.NumFiles(), 1u);
}

TEST(WriteFile, ManyAtOnceInOneFolderDoNotMeet) {
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.txt";
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] {
      for (int round = 0; round < 50; ++round) {
        WriteFile(path, Writer(std::string(1000, char('a' + i))));
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  const std::string contents = ReadFile(path);
  EXPECT_EQ(contents.size(), 1000u);
  EXPECT_EQ(contents, std::string(1000, contents[0]));
  EXPECT_EQ(folder.NumFiles(), 1u);
}

TEST(CheckFilePath, LeavesNothingAndTouchesNothing) {
  const TemporaryFolder folder;
  CheckFilePath(folder.Path() / "new");
  EXPECT_EQ(folder.NumFiles(), 0u);
  WriteFile(folder.Path() / "old", Writer("precious"));
  CheckFilePath(folder.Path() / "old");
  EXPECT_EQ(folder.NumFiles(), 1u);
  EXPECT_EQ(ReadFile(folder.Path() / "old"), "precious");
}

TEST(AtomicFiles, TakeTheirPlacesTogether) {
  const TemporaryFolder folder;
  WriteFile(folder.Path() / "b", Writer("old"));
  AtomicFiles files;
  files.Write(folder.Path() / "a", Writer("1"));
  files.Write(folder.Path() / "b", Writer("2"));
  EXPECT_FALSE(fs::exists(folder.Path() / "a"));
  EXPECT_EQ(ReadFile(folder.Path() / "b"), "old");
  files.Commit();
  EXPECT_EQ(ReadFile(folder.Path() / "a"), "1");
  EXPECT_EQ(ReadFile(folder.Path() / "b"), "2");
  EXPECT_EQ(folder.NumFiles(), 2u);
}

TEST(AtomicFiles, OneThatFailsKeepsAllFromTheirPlaces) {
  const TemporaryFolder folder;
  fs::create_directory(folder.Path() / "b");
  {
    AtomicFiles files;
    files.Write(folder.Path() / "a", Writer("1"));
    EXPECT_THROW(files.Write(folder.Path() / "b", Writer("2")), InputError);
    EXPECT_EQ(folder.NumFiles(), 2u);
  }
  EXPECT_EQ(folder.NumFiles(), 1u);
  EXPECT_FALSE(fs::exists(folder.Path() / "a"));
}

TEST(AtomicFiles, WhatStandsInTheWayAtTheEndIsNamed) {
  const TemporaryFolder folder;
  {
    AtomicFiles files;
    files.Write(folder.Path() / "a", Writer("1"));
    files.Write(folder.Path() / "b", Writer("2"));
    fs::create_directories(folder.Path() / "b" / "x");
    EXPECT_THAT([&] { files.Commit(); },
                ThrowsMessage<InputError>(HasSubstr("b: cannot be written")));
  }
  EXPECT_EQ(folder.NumFiles(), 2u);
  EXPECT_EQ(ReadFile(folder.Path() / "a"), "1");
}

}  // namespace
}  // namespace octacut
