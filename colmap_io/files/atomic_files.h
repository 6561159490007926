// Files that appear whole or not at all, alone or several together.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <vector>

namespace octacut {

// Writes one file, binary. What `write` has put into the stream goes to a
// temporary file in the folder of `path`, which takes the place of `path` once
// it is complete. When anything fails, the temporary is removed and `path` is
// as it was. A path that is a symbolic link has the file it leads to replaced.
//
// Throws InputError that names the path when its folder is missing or cannot
// be written to, when it is there but no regular file, or when not everything
// could be written (a full disk), and in front of what an InputError of `write`
// says; passes on what else `write` throws.
void WriteFile(const std::filesystem::path& path,
               const std::function<void(std::ostream&)>& write);

// To be asked before any long work whose result goes to `path`: throws as
// WriteFile does where the file cannot be made, and leaves everything as it
// was.
void CheckFilePath(const std::filesystem::path& path);

// Several files that belong together: none takes its place before all of them
// are complete. What is not committed is removed with the object.
class AtomicFiles {
 public:
  AtomicFiles() = default;
  ~AtomicFiles();
  AtomicFiles(const AtomicFiles&) = delete;
  AtomicFiles& operator=(const AtomicFiles&) = delete;

  // Throws as WriteFile does.
  void Write(const std::filesystem::path& path,
             const std::function<void(std::ostream&)>& write);

  // Gives the files their names, in the order in which they were written.
  // Throws InputError when the system refuses one, which after Write takes
  // somebody else's interference; those before it then have their names.
  void Commit();

 private:
  struct Pending {
    std::filesystem::path temporary;
    std::filesystem::path target;
  };
  std::vector<Pending> pending_;
};

}  // namespace octacut
