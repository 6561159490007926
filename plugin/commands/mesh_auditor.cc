#include "plugin/commands/mesh_auditor.h"

#include <fmt/format.h>

#include <array>
#include <Eigen/Core>
#include <filesystem>

#include "core/base/check_option.h"
#include "core/print/overhangs.h"
#include "core/print/wall_thickness.h"
#include "plugin/file_roles.h"
#include "plugin/measured_mesh.h"
#include "plugin/print_json.h"
#include "plugin/report.h"
#include "plugin/text_table.h"

namespace octacut {
namespace {

class MeshAuditor : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  bool UsesRandomSeed() const override { return true; }
  void Run(const CommandEnvironment& environment) override;

 private:
  void Check() const;
  void Warn(const MeshAudit& audit,
            const SelfIntersections& intersections,
            double thin_share,
            const Context& context) const;

  std::filesystem::path input_path_;
  std::filesystem::path output_path_;
  std::array<double, 3> up_ = {0, 0, 1};
  double max_overhang_ = 45;
  double min_wall_ = 0;
  WallThicknessOptions walls_;
};

void MeshAuditor::DeclareOptions(OptionManager& options) {
  options.AddRequired(
      "input_path", &input_path_, "Mesh to audit (.ply, .obj, .off or .stl).");
  options.Add(
      "output_path", &output_path_, "JSON report to write. Default: none.");
  options.Add("up",
              &up_,
              "Direction x,y,z that points up on the printer, in the frame of "
              "the mesh. mesh_exporter writes meshes whose z points up.");
  options.Add("max_overhang",
              &max_overhang_,
              "Angle from the vertical in degrees up to which the printer "
              "needs no support.");
  options.Add("min_wall",
              &min_wall_,
              "Thickness in the units of the mesh below which a wall cannot be "
              "printed. 0: none.");
  options
      .Add("num_samples",
           &walls_.num_samples,
           "Number of points of the surface where the thickness is measured.")
      .ForExperts();
}

void MeshAuditor::Check() const {
  CheckOption(Eigen::Vector3d(up_.data()).stableNorm() > 0 &&
                  Eigen::Vector3d(up_.data()).allFinite(),
              "up",
              fmt::format("{},{},{}", up_[0], up_[1], up_[2]),
              "must be a direction that is not zero");
  CheckOption(max_overhang_ > 0 && max_overhang_ < 90,
              "max_overhang",
              max_overhang_,
              "must be between 0 and 90 degrees");
  CheckOption(min_wall_ >= 0, "min_wall", min_wall_, "must not be negative");
  CheckOption(walls_.num_samples >= 100 && walls_.num_samples <= 100'000'000,
              "num_samples",
              walls_.num_samples,
              "must be from 100 to 100000000");
}

std::string YesNo(bool yes) { return yes ? "yes" : "NO"; }

std::string Percent(double share) {
  return fmt::format("{:.2f} %", 100 * share);
}

std::string AuditTable(const MeshAudit& audit,
                       const SelfIntersections& intersections) {
  TextTable table({"topology and size", ""});
  table.AddRow({"triangles", fmt::format("{}", audit.num_triangles)});
  table.AddRow({"watertight", YesNo(audit.IsClosed())});
  table.AddRow(
      {"manifold", YesNo(audit.IsEdgeManifold() && audit.IsVertexManifold())});
  table.AddRow(
      {"oriented outward", YesNo(audit.IsOriented() && audit.IsOutward())});
  table.AddRow({"components", fmt::format("{}", audit.num_components)});
  table.AddRow(
      {"genus", audit.genus < 0 ? "-" : fmt::format("{}", audit.genus)});
  table.AddRow(
      {"intersecting pairs", fmt::format("{}", intersections.num_pairs)});
  const Eigen::Vector3d size = audit.bounding_box.sizes();
  table.AddRow(
      {"size",
       fmt::format("{:.6g} x {:.6g} x {:.6g}", size.x(), size.y(), size.z())});
  table.AddRow({"area", fmt::format("{:.6g}", audit.area)});
  table.AddRow(
      {"volume", audit.IsClosed() ? fmt::format("{:.6g}", audit.volume) : "-"});
  return table.ToString();
}

std::string WallTable(const WallThickness& walls) {
  TextTable table({"wall thickness", ""});
  table.AddRow({"measured on", Percent(walls.measured_share)});
  const auto add = [&](const char* name, double value) {
    table.AddRow(
        {name, walls.measured_share > 0 ? fmt::format("{:.4g}", value) : "-"});
  };
  add("least", walls.min);
  add("1 % of the surface below", walls.percentile_1);
  add("5 %", walls.percentile_5);
  add("half", walls.median);
  for (const ThinPlace& place : walls.thinnest) {
    table.AddRow({fmt::format("at {:.4g}, {:.4g}, {:.4g}",
                              place.point.x(),
                              place.point.y(),
                              place.point.z()),
                  fmt::format("{:.4g}", place.thickness)});
  }
  return table.ToString();
}

void MeshAuditor::Warn(const MeshAudit& audit,
                       const SelfIntersections& intersections,
                       double thin_share,
                       const Context& context) const {
  const std::string failure = audit.DescribeFailure();
  if (!failure.empty()) {
    context.Warn(fmt::format("{}: {}", input_path_.string(), failure));
  }
  if (intersections.num_pairs > 0) {
    context.Warn(fmt::format("{}: {} pairs of triangles intersect",
                             input_path_.string(),
                             intersections.num_pairs));
  }
  if (thin_share > 0) {
    context.Warn(
        fmt::format("{}: walls are thinner than {:g} on {} of the "
                    "surface",
                    input_path_.string(),
                    min_wall_,
                    Percent(thin_share)));
  }
}

void MeshAuditor::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  Check();
  FileRoles files(environment.options);
  files.Read(input_path_, "the mesh to measure");
  files.Write("output_path", output_path_, "the report");
  MeasuredMesh measured =
      MeasureMesh(input_path_, input_path_.filename().string(), true, context);
  const MeshAudit& audit = measured.result.audit;
  walls_.min_wall = min_wall_;
  const WallThickness walls =
      MeasureWallThickness(measured.mesh, walls_, context);
  const Overhangs overhangs = MeasureOverhangs(
      measured.mesh, Eigen::Vector3d(up_.data()), max_overhang_);
  Warn(audit, *measured.result.self_intersections, walls.thin_share, context);
  environment.out << AuditTable(audit, *measured.result.self_intersections)
                  << '\n'
                  << WallTable(walls) << '\n'
                  << fmt::format(
                         "overhangs beyond {:g} degrees: {} of the "
                         "area; rests on the plate: {}\n",
                         max_overhang_,
                         Percent(overhangs.share),
                         Percent(overhangs.base_area / audit.area));
  if (!output_path_.empty()) {
    Json report = MakeReport(environment);
    report["mesh"] = std::move(measured.json);
    report["wall_thickness"] = WallThicknessToJson(walls);
    report["overhangs"] = OverhangsToJson(overhangs);
    WriteReport(output_path_, report);
  }
}

}  // namespace

std::unique_ptr<Command> MakeMeshAuditor() {
  return std::make_unique<MeshAuditor>();
}

}  // namespace octacut
