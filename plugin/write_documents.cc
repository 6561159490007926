// Writes the man page and the completion of bash into a folder; run by the
// build.
#include <exception>
#include <filesystem>
#include <iostream>

#include "colmap_io/files/atomic_files.h"
#include "plugin/bash_completion.h"
#include "plugin/man_page.h"
#include "plugin/registry.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: " << argv[0] << " FOLDER\n";
    return 1;
  }
  try {
    const std::filesystem::path folder = argv[1];
    octacut::WriteFile(folder / "octacut.1", [](std::ostream& stream) {
      stream << octacut::ManPage(octacut::CommandRegistry());
    });
    octacut::WriteFile(folder / "octacut.bash", [](std::ostream& stream) {
      stream << octacut::BashCompletion(octacut::CommandRegistry());
    });
  } catch (const std::exception& error) {
    std::cerr << "ERROR: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
