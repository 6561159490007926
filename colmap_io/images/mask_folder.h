// Folders of masks that octacut writes: <image name>.png, the list beside them
// (mask_list.h) and a picture of all outlines.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "colmap_io/images/mask_list.h"

namespace octacut {

// Name of the picture with all outlines, in the folder of the masks.
inline constexpr std::string_view kContactSheetName = "contact_sheet.jpg";

// A mask as a PNG file.
std::vector<uchar> EncodeMask(const cv::Mat& mask);

// Throws InputError unless masks can be written to the folder, which need not
// exist yet, and must not be that of the photographs: to be asked before the
// work.
void RequireFolderForMasks(const std::filesystem::path& folder,
                           const std::filesystem::path& image_path);

// Throws InputError that names the first picture in the folder or below it that
// is not a mask as octacut left it: for commands that replace all masks of
// their folder. No folder is fine, and so is the contact sheet. Throws as
// RequireFolderForMasks does, too.
void RequireOnlyOwnMasks(const std::filesystem::path& folder,
                         const std::filesystem::path& image_path);

// Writes, all together: the PNG file of every view in the list that has one in
// `pngs` (in the same order; the others are left as they are), the list with
// the names and hashes of these files, and the contact sheet unless it is
// empty. Earlier masks of octacut's are removed where the view is unsure now.
// What an earlier list of the folder says of other images is kept, as far as
// their masks are there. Throws InputError.
void WriteMaskFolder(const std::filesystem::path& folder,
                     MaskList list,
                     const std::vector<std::vector<uchar>>& pngs,
                     const cv::Mat& contact_sheet);

}  // namespace octacut
