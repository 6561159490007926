#include "plugin/commands/mesh_simplifier.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "colmap_io/files/atomic_files.h"
#include "colmap_io/mesh/mesh_io.h"
#include "core/base/check_option.h"
#include "core/benchmark/compare/compare_meshes.h"
#include "core/mesh/audit.h"
#include "core/simplify/simplify_mesh.h"
#include "plugin/closed_mesh.h"
#include "plugin/file_roles.h"
#include "plugin/mesh_json.h"
#include "plugin/report.h"
#include "plugin/text_table.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// The least closed mesh is a tetrahedron.
constexpr int64_t kLeastFaces = 4;

// On each surface, beside the vertices: they give the mean to a thousandth.
constexpr int64_t kNumSamples = 200000;

// One mesh of the chain.
struct Level {
  fs::path path;
  SimplifiedMesh simplified;
  MeshComparison comparison;
};

class MeshSimplifier : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  bool UsesRandomSeed() const override { return true; }
  void Run(const CommandEnvironment& environment) override;

 private:
  void Check() const;
  fs::path PathOf(int level) const;
  // Triangles of a level (0: finest) of a mesh of `num_full`, unless the error
  // decides.
  size_t TargetOf(int level, size_t num_full) const;
  Level MakeLevel(int level,
                  const CollapseReplay& replay,
                  const Context& context) const;
  Json LevelToJson(const Level& level, const Context& context) const;
  void WriteFiles(const std::vector<Level>& levels, const Json& report) const;

  fs::path input_path_;
  fs::path output_path_;
  fs::path report_path_;
  int64_t target_faces_ = 0;
  double target_ratio_ = 0;
  double max_error_ = 0;
  int levels_ = 1;
};

void MeshSimplifier::DeclareOptions(OptionManager& options) {
  options.AddRequired("input_path",
                      &input_path_,
                      "Closed mesh to simplify (.ply, .obj, .off or .stl).");
  options.AddRequired("output_path",
                      &output_path_,
                      "Mesh file to write (.ply, .obj, .off, .stl or .glb).");
  options.Add("target_faces",
              &target_faces_,
              "Number of triangles to reach. Exactly one of target_faces, "
              "target_ratio and max_error is needed.");
  options.Add("target_ratio",
              &target_ratio_,
              "Fraction of the triangles to keep, between 0 and 1.");
  options.Add("max_error",
              &max_error_,
              "Greatest distance that the two surfaces may have (Hausdorff "
              "distance), in the units of the mesh.");
  options.Add("levels",
              &levels_,
              "Number of meshes to write, as STEM-1.ply, STEM-2.ply and so on, "
              "the last of which meets the target. Each has the same fraction "
              "of the triangles of the one before; with max_error, each may "
              "have twice the error.");
  options
      .Add("report_path",
           &report_path_,
           "JSON report to write. Default: the output path followed by .json.")
      .ForExperts();
}

void MeshSimplifier::Check() const {
  CheckOption(target_faces_ == 0 || target_faces_ >= kLeastFaces,
              "target_faces",
              target_faces_,
              "must be at least 4");
  CheckOption(target_ratio_ >= 0 && target_ratio_ < 1,
              "target_ratio",
              target_ratio_,
              "must be between 0 and 1");
  CheckOption(max_error_ >= 0 && std::isfinite(max_error_),
              "max_error",
              max_error_,
              "must not be negative");
  CheckOption(
      levels_ >= 1 && levels_ <= 16, "levels", levels_, "must be in 1 .. 16");
  const int num_given =
      (target_faces_ > 0) + (target_ratio_ > 0) + (max_error_ > 0);
  if (num_given != 1) {
    throw OptionError(fmt::format(
        "give exactly one of --target_faces, --target_ratio and --max_error "
        "({} are given)",
        num_given));
  }
}

fs::path MeshSimplifier::PathOf(int level) const {
  fs::path path = output_path_;
  if (levels_ > 1) {
    path.replace_filename(fmt::format("{}-{}{}",
                                      output_path_.stem().string(),
                                      level + 1,
                                      output_path_.extension().string()));
  }
  return path;
}

size_t MeshSimplifier::TargetOf(int level, size_t num_full) const {
  const auto full = double(num_full);
  if (max_error_ > 0) {
    return size_t(kLeastFaces);
  }
  const double ratio =
      target_faces_ > 0 ? double(target_faces_) / full : target_ratio_;
  // The last level is not rounded.
  if (target_faces_ > 0 && level + 1 == levels_) {
    return size_t(target_faces_);
  }
  return size_t(std::max(
      double(kLeastFaces),
      std::floor(full * std::pow(ratio, double(level + 1) / levels_))));
}

Level MeshSimplifier::MakeLevel(int level,
                                const CollapseReplay& replay,
                                const Context& context) const {
  Level result;
  result.path = PathOf(level);
  CompareMeshesOptions options;
  options.num_samples = kNumSamples;
  const auto compare = [&](const IndexedMesh& mesh) {
    result.comparison = CompareMeshes(mesh, replay.Full(), options, context);
    return result.comparison.Hausdorff();
  };
  const size_t num_full = replay.Full().triangles.size();
  if (max_error_ > 0) {
    result.simplified = SimplifyWithin(
        max_error_ / std::exp2(levels_ - 1 - level), compare, replay, context);
  } else {
    const size_t target = TargetOf(level, num_full);
    result.simplified = SimplifyTo(target, replay, context);
    compare(result.simplified.mesh);
    const size_t reached = result.simplified.mesh.triangles.size();
    if (reached > target) {
      context.Warn(fmt::format(
          "{}: {} triangles could not be reached, {} are left: removing more "
          "would fold the surface, squeeze triangles to needles or make them "
          "intersect",
          result.path.string(),
          target,
          reached));
    }
  }
  if (result.simplified.summary.num_old_intersections > 0) {
    context.Warn(
        fmt::format("{}: {} pairs of triangles intersect as they do "
                    "in the mesh to simplify",
                    result.path.string(),
                    result.simplified.summary.num_old_intersections));
  }
  return result;
}

Json MeshSimplifier::LevelToJson(const Level& level,
                                 const Context& context) const {
  const MeshAudit audit = AuditMesh(level.simplified.mesh, context);
  CheckAudit(audit);
  const SimplifySummary& summary = level.simplified.summary;
  Json json;
  json["path"] = level.path.string();
  json["audit"] = AuditToJson(audit);
  json["self_intersections"] = summary.num_old_intersections;
  json["repairs"] = summary.num_repairs;
  json["held_vertices"] = summary.num_held;
  json["comparison"] = ComparisonToJson(level.comparison);
  return json;
}

void MeshSimplifier::WriteFiles(const std::vector<Level>& levels,
                                const Json& report) const {
  AtomicFiles files;
  for (const Level& level : levels) {
    WriteMesh(level.path, level.simplified.mesh, &files);
  }
  WriteReport(report_path_, report, &files);
  files.Commit();
}

void MeshSimplifier::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  Check();
  if (report_path_.empty()) {
    report_path_ = output_path_.string() + ".json";
  }
  FileRoles files(environment.options);
  files.Read(input_path_, "the mesh to simplify");
  for (int level = 0; level < levels_; ++level) {
    CheckMeshPath(PathOf(level));
    files.Write("output_path", PathOf(level), "the simplified mesh");
  }
  CheckOption(MeshFormatOf(output_path_) != MeshFormat::k3mf,
              "output_path",
              output_path_.string(),
              "must not be a .3mf file, whose units are millimetres; "
              "mesh_exporter writes those");
  files.Write("report_path", report_path_, "the report");
  const IndexedMesh full = ReadClosedMesh(input_path_, context);
  const size_t num_full = full.triangles.size();
  CheckOption(
      target_faces_ <= int64_t(num_full),
      "target_faces",
      target_faces_,
      fmt::format("{} has only {} triangles", input_path_.string(), num_full));
  const size_t least = TargetOf(levels_ - 1, num_full);
  // Where vertices have to stay, others go instead: a tenth more.
  const CollapseReplay replay(full, least - least / 10, context);
  std::vector<Level> levels;
  Json json = Json::array();
  TextTable table({"mesh",
                   "triangles",
                   "mean distance",
                   "% of diagonal",
                   "Hausdorff",
                   "% of diagonal"});
  for (int i = 0; i < levels_; ++i) {
    levels.push_back(MakeLevel(i, replay, context));
    const Level& level = levels.back();
    json.push_back(LevelToJson(level, context));
    const double mean = std::max(level.comparison.to_reference.mean,
                                 level.comparison.from_reference.mean);
    const double hausdorff = level.comparison.Hausdorff();
    const double percent = 100 / level.comparison.reference_diagonal;
    table.AddRow({level.path.filename().string(),
                  fmt::format("{}", level.simplified.mesh.triangles.size()),
                  fmt::format("{:.3g}", mean),
                  fmt::format("{:.4f}", percent * mean),
                  fmt::format("{:.3g}", hausdorff),
                  fmt::format("{:.4f}", percent * hausdorff)});
  }
  Json report = MakeReport(environment);
  report["input"] = {{"path", input_path_.string()}, {"triangles", num_full}};
  report["levels"] = std::move(json);
  WriteFiles(levels, report);
  environment.out << table.ToString();
}

}  // namespace

std::unique_ptr<Command> MakeMeshSimplifier() {
  return std::make_unique<MeshSimplifier>();
}

}  // namespace octacut
