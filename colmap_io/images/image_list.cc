#include "colmap_io/images/image_list.h"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <string>
#include <system_error>

#include "core/base/error.h"

namespace octacut {
namespace {

std::string Trimmed(const std::string& line) {
  constexpr const char* kBlanks = " \t\r\n\v\f";
  const size_t first = line.find_first_not_of(kBlanks);
  if (first == line.npos) {
    return {};
  }
  return line.substr(first, line.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace

void KeepListedImages(const std::filesystem::path& list_path,
                      SparseModel* model) {
  std::error_code ignored;
  std::ifstream stream(list_path);
  if (!stream || std::filesystem::is_directory(list_path, ignored)) {
    throw InputError(fmt::format("image_list_path {}: the file cannot be read",
                                 list_path.string()));
  }
  std::set<std::string> names;
  for (const SparseImage& image : model->images) {
    names.insert(image.name);
  }
  std::set<std::string> listed;
  std::string line;
  for (size_t number = 1; std::getline(stream, line); ++number) {
    const std::string name = Trimmed(line);
    if (name.empty()) {
      continue;
    }
    if (!names.contains(name)) {
      throw InputError(fmt::format("{}:{}: {}: the model has no such image",
                                   list_path.string(),
                                   number,
                                   name));
    }
    listed.insert(name);
  }
  if (listed.empty()) {
    throw InputError(fmt::format("image_list_path {}: the file lists no images",
                                 list_path.string()));
  }
  std::erase_if(model->images, [&](const SparseImage& image) {
    return !listed.contains(image.name);
  });
}

}  // namespace octacut
