#include "plugin/commands/mask_comparer.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "colmap_io/files/lower_extension.h"
#include "colmap_io/images/for_each_file.h"
#include "colmap_io/images/image_file.h"
#include "core/base/error.h"
#include "core/benchmark/evaluate/silhouette_agreement.h"
#include "plugin/file_roles.h"
#include "plugin/report.h"
#include "plugin/text_table.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

class MaskComparer : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  fs::path mask_path_;
  fs::path reference_path_;
  fs::path output_path_;
};

struct ComparedMask {
  std::string name;
  bool is_there = false;
  double overlap = 0;  // intersection over union
  double border_mean = 0;
  double border_percentile_95 = 0;
};

void MaskComparer::DeclareOptions(OptionManager& options) {
  options.AddRequired(
      "mask_path", &mask_path_, "Folder of the masks to measure.");
  options.AddRequired("reference_path",
                      &reference_path_,
                      "Folder of the reference masks, PNG files of the same "
                      "names and sizes.");
  options.Add(
      "output_path", &output_path_, "JSON report to write. Default: none.");
}

// `option` names the folder.
std::vector<std::string> NamesIn(const char* option, const fs::path& folder) {
  std::error_code error;
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    if (entry.is_regular_file() && LowerExtension(entry.path()) == ".png") {
      names.push_back(entry.path().lexically_relative(folder).string());
    }
  }
  if (names.empty()) {
    throw InputError(
        fmt::format("{} {}: no such folder, or one without PNG files",
                    option,
                    folder.string()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

ComparedMask Compare(const fs::path& path, const fs::path& reference_path) {
  ComparedMask compared;
  std::error_code ignored;
  compared.is_there = fs::is_regular_file(path, ignored);
  if (!compared.is_there) {
    return compared;
  }
  const cv::Mat mask = ReadMask(path);
  const cv::Mat reference = ReadMask(reference_path);
  if (mask.size() != reference.size()) {
    throw InputError(
        fmt::format("{}: the mask has {}x{} pixels, but {} has "
                    "{}x{}",
                    path.string(),
                    mask.cols,
                    mask.rows,
                    reference_path.string(),
                    reference.cols,
                    reference.rows));
  }
  OutlineDistances distances;
  const ViewSilhouette view = CompareSilhouettes(reference, mask, &distances);
  const size_t either =
      view.object_pixels + view.mesh_pixels - view.common_pixels;
  compared.overlap =
      either == 0 ? 1 : double(view.common_pixels) / double(either);
  compared.border_mean = view.outline_mean;
  compared.border_percentile_95 = OutlinePercentile(std::move(distances), 0.95);
  return compared;
}

// Means over the masks that are there.
ComparedMask MeanOf(const std::vector<ComparedMask>& masks) {
  ComparedMask mean;
  mean.name = "mean";
  size_t count = 0;
  for (const ComparedMask& mask : masks) {
    if (mask.is_there) {
      ++count;
      mean.overlap += mask.overlap;
      mean.border_mean += mask.border_mean;
      mean.border_percentile_95 += mask.border_percentile_95;
    }
  }
  if (count > 0) {
    mean.is_there = true;
    mean.overlap /= double(count);
    mean.border_mean /= double(count);
    mean.border_percentile_95 /= double(count);
  }
  return mean;
}

Json ToJson(const ComparedMask& mask) {
  Json json = {{"name", mask.name}, {"is_there", mask.is_there}};
  if (mask.is_there) {
    json["overlap"] = mask.overlap;
    json["border_mean"] = mask.border_mean;
    json["border_percentile_95"] = mask.border_percentile_95;
  }
  return json;
}

void MaskComparer::Run(const CommandEnvironment& environment) {
  const std::vector<std::string> names =
      NamesIn("reference_path", reference_path_);
  FileRoles files(environment.options);
  for (const std::string& name : names) {
    files.Read(reference_path_ / name, "a reference mask");
  }
  for (const std::string& name : NamesIn("mask_path", mask_path_)) {
    files.Read(mask_path_ / name, "a mask to measure");
  }
  files.Write("output_path", output_path_, "the report");
  std::vector<ComparedMask> masks(names.size());
  ForEachFile(
      {.count = names.size()}, "masks", environment.context, [&](size_t i) {
        masks[i] = Compare(mask_path_ / names[i], reference_path_ / names[i]);
        masks[i].name = names[i];
      });
  const ComparedMask mean = MeanOf(masks);
  const auto missing = size_t(
      std::count_if(masks.begin(), masks.end(), [](const ComparedMask& mask) {
        return !mask.is_there;
      }));
  TextTable table({"mask", "overlap, %", "border: mean, pixels", "95 %"});
  Json list = Json::array();
  const auto add_row = [&table](const ComparedMask& mask) {
    table.AddRow(
        mask.is_there
            ? std::vector<std::string>{mask.name,
                                       fmt::format("{:.2f}",
                                                   100 * mask.overlap),
                                       fmt::format("{:.2f}", mask.border_mean),
                                       fmt::format("{:.2f}",
                                                   mask.border_percentile_95)}
            : std::vector<std::string>{mask.name, "no mask"});
  };
  for (const ComparedMask& mask : masks) {
    add_row(mask);
    list.push_back(ToJson(mask));
  }
  add_row(mean);
  environment.out << table.ToString()
                  << fmt::format(
                         "{} of {} masks are missing\n", missing, masks.size());
  if (!output_path_.empty()) {
    Json report = MakeReport(environment);
    report["mean"] = ToJson(mean);
    report["missing"] = missing;
    report["masks"] = list;
    WriteReport(output_path_, report);
  }
}

}  // namespace

std::unique_ptr<Command> MakeMaskComparer() {
  return std::make_unique<MaskComparer>();
}

}  // namespace octacut
