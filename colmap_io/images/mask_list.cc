#include "colmap_io/images/mask_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "colmap_io/files/read_file.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kProgram = "octacut mask_extractor";
constexpr std::string_view kTurntable = "turntable";

constexpr std::array<std::pair<MaskStatus, std::string_view>, 3> kStatuses = {
    {{MaskStatus::kExtracted, "extracted"},
     {MaskStatus::kUnsure, "unsure"},
     {MaskStatus::kGiven, "given"}}};

std::string_view NameOf(MaskStatus status) {
  return kStatuses[size_t(status)].second;
}

MaskStatus StatusFromName(const std::string& name) {
  for (const auto& [status, status_name] : kStatuses) {
    if (name == status_name) {
      return status;
    }
  }
  throw InputError("status = " + name +
                   ": must be one of extracted, unsure, given");
}

ListedMask MaskFromJson(const Json& json) {
  ListedMask mask;
  mask.image = json.at("image").get<std::string>();
  mask.status = StatusFromName(json.at("status").get<std::string>());
  mask.mask = json.value("mask", "");
  mask.hash = json.value("hash", "");
  mask.confidence = json.value("confidence", 0.0);
  mask.doubt = json.value("doubt", "");
  return mask;
}

Json MaskToJson(const ListedMask& mask) {
  Json json = {{"image", mask.image}, {"status", NameOf(mask.status)}};
  if (!mask.mask.empty()) {
    json["mask"] = mask.mask;
    json["hash"] = mask.hash;
  }
  json["confidence"] = mask.confidence;
  if (!mask.doubt.empty()) {
    json["doubt"] = mask.doubt;
  }
  return json;
}

}  // namespace

const ListedMask* MaskList::Find(const std::string& image) const {
  const auto found =
      std::find_if(views.begin(), views.end(), [&](const ListedMask& mask) {
        return mask.image == image;
      });
  return found == views.end() ? nullptr : &*found;
}

size_t MaskList::Count(MaskStatus status) const {
  return size_t(
      std::count_if(views.begin(), views.end(), [&](const ListedMask& mask) {
        return mask.status == status;
      }));
}

std::string HashOfBytes(std::string_view bytes) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const char byte : bytes) {
    hash = (hash ^ uint8_t(byte)) * 0x100000001b3u;
  }
  return fmt::format("{:016x}", hash);
}

std::optional<MaskList> ReadMaskList(const fs::path& mask_path) {
  const fs::path path = mask_path / kMaskListName;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    return {};
  }
  MaskList list;
  try {
    const Json json = Json::parse(ReadFile(path));
    if (json.at("program") != kProgram) {
      throw InputError("program is not " + std::string(kProgram));
    }
    list.is_of_turntable = json.value("mode", "") == kTurntable;
    for (const Json& view : json.at("views")) {
      list.views.push_back(MaskFromJson(view));
    }
  } catch (const std::exception& error) {
    throw InputError(fmt::format("{}: this is no list of extracted masks ({})",
                                 path.string(),
                                 error.what()));
  }
  return list;
}

std::string MaskListText(const MaskList& list) {
  Json json = {{"program", kProgram}};
  if (list.is_of_turntable) {
    json["mode"] = kTurntable;
  }
  Json& views = json["views"] = Json::array();
  for (const ListedMask& mask : list.views) {
    views.push_back(MaskToJson(mask));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool IsExtractedMask(const std::optional<MaskList>& list,
                     const std::string& image,
                     const fs::path& file) {
  const ListedMask* const listed = list ? list->Find(image) : nullptr;
  return listed != nullptr && listed->status == MaskStatus::kExtracted &&
         listed->mask == fs::path(image + ".png").string() &&
         file.filename() == fs::path(listed->mask).filename() &&
         HashOfBytes(ReadFile(file)) == listed->hash;
}

}  // namespace octacut
