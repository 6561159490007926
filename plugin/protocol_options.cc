#include "plugin/protocol_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "colmap_io/files/lower_extension.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// What a protocol needs, and what is said of it.
struct ProtocolTraits {
  BenchmarkProtocol protocol;
  const char* name;
  size_t min_tolerances;
  size_t max_tolerances;
  const char* tolerances_are;  // for the error where they are missing
  size_t min_crops;
  size_t max_crops;
  const char* crops_are;
  const char* rules;
};

constexpr ProtocolTraits kTraits[] = {
    {BenchmarkProtocol::kNone, "none", 0, 0, "", 0, 0, "", ""},
    {BenchmarkProtocol::kMetro,
     "metro",
     0,
     0,
     "",
     0,
     0,
     "",
     "Cignoni, Rocchini & Scopigno 1998. No alignment, no crop. Ten points for "
     "each triangle of the larger mesh on both surfaces, spread evenly by "
     "area; distances to the closest point of the other surface; maxima "
     "include vertices."},
    {BenchmarkProtocol::kMiddlebury,
     "middlebury",
     1,
     1,
     "the distance up to which the reference is complete (1.25 mm in the "
     "benchmark's tables)",
     0,
     1,
     "a mesh that fills the reference's holes",
     "Seitz et al. 2006. No alignment. Accuracy is the distance to the "
     "reference that 90 % of the mesh's vertices keep, without those closest "
     "to filled holes; completeness is the fraction of the reference's "
     "vertices within the tolerance of the mesh."},
    {BenchmarkProtocol::kTanksAndTemples,
     "tanks_and_temples",
     1,
     1,
     "tau of the scene",
     1,
     1,
     "the scene's crop volume (.json)",
     "Knapitsch et al. 2017. Three runs of ICP with scale between points (80, "
     "20 and 2 tau), crop by the scene's volume, means in cells of tau / 2; "
     "precision and recall count points closer than tau to the other cloud."},
    {BenchmarkProtocol::kEth3d,
     "eth3d",
     1,
     100,
     "the benchmark has 0.01 to 0.5 m",
     0,
     0,
     "",
     "Schoeps et al. 2017. No alignment. A point in the beam of a laser is "
     "accurate within the tolerance of what the laser hit, inaccurate in front "
     "of it, and not judged behind it or off all beams; fractions are averaged "
     "over cells of 0.01 m."},
    {BenchmarkProtocol::kDtu,
     "dtu",
     0,
     0,
     "",
     2,
     2,
     "the scan's ObsMask<scan>_10.mat and Plane<scan>.mat",
     "Jensen et al. 2014. No alignment. Points thinned to 0.2 mm; accuracy "
     "within the observability mask, completeness above the ground plane; "
     "distances of 20 mm and more are left out as outliers."},
};

const ProtocolTraits& TraitsOf(BenchmarkProtocol protocol) {
  return *std::find_if(
      std::begin(kTraits), std::end(kTraits), [&](const ProtocolTraits& t) {
        return t.protocol == protocol;
      });
}

std::vector<std::string> Texts(const std::vector<fs::path>& paths) {
  std::vector<std::string> texts;
  texts.reserve(paths.size());
  for (const fs::path& path : paths) {
    texts.push_back(path.string());
  }
  return texts;
}

void CheckCount(const char* option,
                const std::string& value,
                size_t count,
                const ProtocolTraits& traits,
                std::pair<size_t, size_t> range,
                const char* meaning) {
  if (count < range.first) {
    throw OptionError(
        fmt::format("--{}: the protocol {} needs {}, and {} given: {}",
                    option,
                    traits.name,
                    range.first == 1 ? "one value" : "two values",
                    count == 0 ? "none is" : "one is",
                    meaning));
  }
  if (count > range.second) {
    throw OptionError(
        range.second == 0
            ? fmt::format("{} = {}: is not used by the protocol {}",
                          option,
                          value,
                          traits.name)
            : fmt::format("{} = {}: the protocol {} takes at most {}: {}",
                          option,
                          value,
                          traits.name,
                          range.second,
                          meaning));
  }
}

// Options whose rules the protocol replaces.
void CheckExcludedOptions(const ProtocolTraits& traits,
                          const OptionManager& options) {
  for (const char* name : {"num_samples",
                           "thresholds",
                           "accuracy_fraction",
                           "completeness_threshold",
                           "views_path",
                           "min_views",
                           "max_view_angle",
                           "bounding_box",
                           "align",
                           "reference_is_truth",
                           "Alignment.global_search",
                           "Alignment.num_samples",
                           "Alignment.estimate_scale"}) {
    if (options.IsSet(name)) {
      throw OptionError(fmt::format(
          "--{} cannot be used with --protocol {}, which has rules of its own "
          "for alignment, crop and sampling{}",
          name,
          traits.name,
          std::string_view(name) == "align"
              ? "; align in a run without a protocol, save the matrix with "
                "--transform_output_path and pass it as --transform_path"
              : ""));
    }
  }
}

}  // namespace

std::string ProtocolName(BenchmarkProtocol protocol) {
  return TraitsOf(protocol).name;
}

std::string ProtocolRules(const ProtocolOptions& protocol) {
  const ProtocolTraits& traits = TraitsOf(protocol.protocol);
  std::string text =
      fmt::format("Benchmark protocol {}: {}", traits.name, traits.rules);
  if (!protocol.tolerances.empty()) {
    text += fmt::format(" Tolerances, in the reference's units: {:g}.",
                        fmt::join(protocol.tolerances, ", "));
  }
  if (!protocol.crop_paths.empty()) {
    text += fmt::format(" Crop by {}.",
                        fmt::join(Texts(protocol.crop_paths), " and "));
  }
  return text;
}

void DeclareProtocolOptions(OptionManager& options, ProtocolOptions* protocol) {
  std::vector<std::pair<std::string, BenchmarkProtocol>> names;
  for (const ProtocolTraits& traits : kTraits) {
    names.emplace_back(traits.name, traits.protocol);
  }
  options.AddEnum("protocol",
                  &protocol->protocol,
                  names,
                  "Measure as a benchmark does, with its rules for alignment, "
                  "crop, sampling and occlusion (docs/comparison.md).");
  options.Add("tolerances",
              &protocol->tolerances,
              "Distances of the protocol, in the reference's units: tau of "
              "tanks_and_temples, the tolerances of eth3d, the completeness "
              "distance of middlebury.");
  options.AddRepeatable(
      "crop_path",
      &protocol->crop_paths,
      "File that limits what the protocol counts: the crop volume (.json) of "
      "tanks_and_temples, ObsMask and Plane (.mat) of dtu, a mesh that fills "
      "the reference's holes for middlebury.");
}

void CheckProtocolOptions(const ProtocolOptions& protocol,
                          const fs::path& reference_path,
                          const OptionManager& options) {
  const ProtocolTraits& traits = TraitsOf(protocol.protocol);
  const std::string tolerances =
      fmt::format("{:g}", fmt::join(protocol.tolerances, ","));
  CheckCount("tolerances",
             tolerances,
             protocol.tolerances.size(),
             traits,
             {traits.min_tolerances, traits.max_tolerances},
             traits.tolerances_are);
  for (const double tolerance : protocol.tolerances) {
    if (!(tolerance > 0) || !std::isfinite(tolerance)) {
      throw OptionError(
          fmt::format("tolerances = {}: must be positive", tolerances));
    }
  }
  CheckCount("crop_path",
             fmt::format("{}", fmt::join(Texts(protocol.crop_paths), ",")),
             protocol.crop_paths.size(),
             traits,
             {traits.min_crops, traits.max_crops},
             traits.crops_are);
  if (protocol.protocol != BenchmarkProtocol::kNone) {
    CheckExcludedOptions(traits, options);
  }
  if (protocol.protocol == BenchmarkProtocol::kEth3d &&
      LowerExtension(reference_path) != ".mlp") {
    throw OptionError(fmt::format(
        "reference_path = {}: the protocol eth3d needs the MeshLab project "
        "(.mlp) with the laser scans and their poses",
        reference_path.string()));
  }
}

}  // namespace octacut
