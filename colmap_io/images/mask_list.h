// The list beside extracted masks: masks.json says which masks of a folder are
// octacut's, as it left them, and which views it gave none.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace octacut {

inline constexpr std::string_view kMaskListName = "masks.json";

enum class MaskStatus {
  kExtracted,  // octacut made the mask
  kUnsure,     // octacut was not sure of the view and made no mask
  kGiven,      // the mask was there before, or changed by the user since
};

struct ListedMask {
  std::string image;  // name as the model has it
  MaskStatus status = MaskStatus::kExtracted;
  std::string mask;       // file in the folder; empty for an unsure view
  std::string hash;       // HashOfBytes of that file
  double confidence = 0;  // 0 to 1; 1 for a given mask
  std::string doubt;      // why a view is unsure
};

struct MaskList {
  // The masks show all that turns on a turntable, the plate too.
  bool is_of_turntable = false;
  std::vector<ListedMask> views;

  // Null where the list does not have the image.
  const ListedMask* Find(const std::string& image) const;
  size_t Count(MaskStatus status) const;
};

// 16 hexadecimal digits (FNV-1a): enough to tell whether a file was changed.
std::string HashOfBytes(std::string_view bytes);

// The list in folder `mask_path`; empty where there is none. Throws InputError
// that names file and field when it is no such list.
std::optional<MaskList> ReadMaskList(const std::filesystem::path& mask_path);

// As JSON.
std::string MaskListText(const MaskList& list);

// True when `file`, found in the folder of the list as the mask of `image`, is
// as octacut left it.
bool IsExtractedMask(const std::optional<MaskList>& list,
                     const std::string& image,
                     const std::filesystem::path& file);

}  // namespace octacut
