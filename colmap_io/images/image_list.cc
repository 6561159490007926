#include "colmap_io/images/image_list.h"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <string>
#include <system_error>

#include "colmap_io/files/byte_order_mark.h"
#include "colmap_io/files/trim.h"
#include "core/base/error.h"

namespace octacut {

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
  std::string text;
  for (size_t number = 1; std::getline(stream, text); ++number) {
    std::string_view line = text;
    if (number == 1) {
      SkipByteOrderMark(&line);
    }
    const std::string name(Trim(line));
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
