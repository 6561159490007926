#include "core/pipeline/build_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/crust/label_hierarchy.h"
#include "core/pipeline/deepen_level.h"
#include "core/pipeline/hull_border.h"
#include "core/pipeline/level_step.h"
#include "core/pipeline/recut_level.h"
#include "core/pipeline/run_step.h"
#include "core/raycast/unit_mesh.h"

namespace octacut {
namespace {

// The crust is too narrow if refinement moves more than this share of the
// vertices farther than half of its width (docs/experiments/recut.md).
constexpr double kLeavesCrust = 0.01;
// Each gains less than the one before.
constexpr int kMaxRecuts = 3;

void RequireSurface(const LabeledVoxels& surface,
                    const ReconstructionOptions& options) {
  if (std::none_of(surface.labels.begin(), surface.labels.end(), IsCut)) {
    throw InputError(fmt::format(
        "the surface vanished: with ballooning = {}, no part of the visual "
        "hull is inside; raise `ballooning`",
        options.evidence.ballooning));
  }
}

bool LeavesCube(const IndexedMesh& unit_mesh) {
  return std::any_of(unit_mesh.positions.begin(),
                     unit_mesh.positions.end(),
                     [](const Eigen::Vector3d& position) {
                       return (position.array() <= 0).any() ||
                              (position.array() >= 1).any();
                     });
}

void ReportLevel(const LevelSummary& level, const Context& context) {
  context.Info(fmt::format(
      "Level {} ({}^3 voxels) is done: the cut passes through {} of "
      "the crust's {} voxels.",
      level.level,
      level.resolution,
      level.num_cut_voxels,
      level.num_crust_voxels));
}

class MeshBuilder {
 public:
  MeshBuilder(const BuildInputs& inputs,
              ViewSet* views,
              ReconstructionSummary* summary)
      : inputs_(inputs), views_(*views), summary_(*summary) {
    for (const PreparedView& view : views_) {
      given_.push_back(view.projection);
    }
  }

  BuiltMesh Run() {
    const int recut_level = inputs_.hull.Level() + 1;
    const int last = inputs_.options.target_level;
    AddLevels(std::min(recut_level, last));
    // Refinement of a mirror follows its outlines alone, and so does its cut.
    if (inputs_.options.refine && recut_level <= last &&
        !inputs_.evidence.is_mirror) {
      Settle(last);
    }
    AddLevels(last);
    ExtractMesh();
    if (inputs_.options.refine) {
      Refine(false);
    }
    return {std::move(finished_), hierarchy_.Finest()};
  }

 private:
  LevelInputs Inputs() const {
    return {views_, inputs_.evidence, inputs_.options, inputs_.context};
  }

  // Cuts the level after l0 again around its refined surface as long as
  // refinement leaves the crust; the last of these cuts is of the next level,
  // unless that is finer than `last`. Leaves the mesh as it was extracted, or
  // none after a cut.
  void Settle(int last) {
    const int level = inputs_.hull.Level() + 1;
    Timed(&summary_.recuts.seconds, [&] {
      for (int i = 1; i <= kMaxRecuts; ++i) {
        const double moved = ShareMovedOut();
        if (moved <= kLeavesCrust ||
            !Recut(i < kMaxRecuts ? level : std::min(level + 1, last), moved)) {
          break;
        }
      }
    });
  }

  // The share of the vertices of the level after l0 that refinement moves out
  // of its crust, by what its coarse rounds show.
  double ShareMovedOut() {
    ExtractMesh();
    const IndexedMesh extracted = finished_.mesh;
    Refine(true);
    const double distance = inputs_.options.crust.HalfWidth() *
                            inputs_.cube.VoxelSize(inputs_.hull.Level() + 1);
    size_t moved = 0;
    for (size_t v = 0; v < extracted.positions.size(); ++v) {
      moved += (finished_.mesh.positions[v] - extracted.positions[v]).norm() >
               distance;
    }
    finished_.mesh = extracted;
    summary_.recuts.moved.push_back(double(moved) /
                                    double(extracted.positions.size()));
    return summary_.recuts.moved.back();
  }

  // The levels after those that are solved, up to `last`.
  void AddLevels(int last) {
    int level = hierarchy_.Empty() ? inputs_.hull.Level()
                                   : hierarchy_.Finest().voxels.Level() + 1;
    for (; level <= last; ++level) {
      AddLevel(level, [&](LevelSummary* summary) {
        return SolveLevel(level, summary);
      });
    }
  }

  // Crust, visibility, photo-consistency and cut of the level after those in
  // the hierarchy; the first one begins with the hull.
  SolvedLevel SolveLevel(int level, LevelSummary* summary) {
    const int first = inputs_.hull.Level();
    if (level == first) {
      return SolveInitialLevel(Inputs(), inputs_.hull, summary);
    }
    SolvedLevel solved = SolveFinerLevel(Inputs(), hierarchy_, summary);
    if (level == first + 1) {
      solved = DeepenLevel(Inputs(), hierarchy_, std::move(solved), summary);
    }
    return solved;
  }

  // Refines the extracted mesh and cuts `level` around it. False, and the mesh
  // as it was, where the refined one leaves the cube, as it may if a bounding
  // box cuts the object.
  bool Recut(int level, double moved) {
    inputs_.context.Info(fmt::format(
        "Refinement moves {:.1f} % of the surface out of the crust of level "
        "{}. The surface is refined, and level {} is cut around it.",
        100 * moved,
        inputs_.hull.Level() + 1,
        level));
    const FinishedMesh extracted = finished_;
    Refine(false);
    const IndexedMesh refined = UnitMesh(finished_.mesh, inputs_.cube);
    if (LeavesCube(refined)) {
      inputs_.context.Info(
          "The refined surface leaves the bounding box, so this cut is left "
          "out.");
      finished_ = extracted;
      return false;
    }
    summary_.levels.resize(size_t(level - inputs_.hull.Level()));
    AddLevel(level, [&](LevelSummary* summary) {
      return RecutLevel(
          Inputs(), inputs_.hull, refined, level, &hierarchy_, summary);
    });
    return true;
  }

  template <typename Solve>
  void AddLevel(int level, const Solve& solve) {
    LevelSummary& summary = summary_.levels.emplace_back();
    const Phase phase(
        inputs_.context,
        fmt::format("crust, photo-consistency and cut of level {}", level));
    SolvedLevel solved = solve(&summary);
    RequireSurface(solved.surface, inputs_.options);
    hierarchy_.Add(std::move(solved.surface));
    decided_ = std::move(solved.decided);
    finished_ = {};
    ReportLevel(summary, inputs_.context);
    if (inputs_.observer) {
      inputs_.observer(
          level,
          PositionedMesh(hierarchy_.Finest(), inputs_.cube, inputs_.context));
    }
  }

  // The labelling's surface, smoothed, and where it is near the hull's border
  // moved towards that; unless it has been extracted.
  void ExtractMesh() {
    if (!finished_.mesh.positions.empty()) {
      return;
    }
    summary_.meshing_seconds = 0;
    RunStep(inputs_.context,
            "mesh extraction and smoothing",
            &summary_.meshing_seconds,
            [&] {
              const LabeledVoxels& surface = hierarchy_.Finest();
              finished_ = FinalMesh(views_,
                                    surface,
                                    inputs_.cube,
                                    inputs_.options.finish,
                                    inputs_.context);
              summary_.finish = finished_.summary;
              summary_.num_moved_to_hull = MoveToHullBorder(
                  {views_, inputs_.evidence.mask_confidence, inputs_.cube},
                  {surface.voxels, decided_},
                  inputs_.context,
                  &finished_.mesh);
            });
  }

  void Refine(bool coarsely) {
    // Each refinement aligns the views anew, by a better surface.
    for (size_t i = 0; i < given_.size(); ++i) {
      views_[i].projection = given_[i];
    }
    RefineOptions options = inputs_.options.refinement;
    options.coarse_only = coarsely;
    RefinedSurface refined = RefineSurface(std::move(finished_.mesh),
                                           inputs_.cube,
                                           options,
                                           inputs_.context,
                                           &views_);
    summary_.refinement = std::move(refined.summary);
    finished_.mesh = std::move(refined.mesh);
  }

  const BuildInputs inputs_;
  ViewSet& views_;
  ReconstructionSummary& summary_;
  std::vector<ViewProjection> given_;  // of the views, before any alignment
  LabelHierarchy hierarchy_;
  std::vector<float> decided_;  // of the finest level, as SolvedLevel has it
  FinishedMesh finished_;  // of the finest level; empty until it is extracted
};

}  // namespace

BuiltMesh BuildMesh(const BuildInputs& inputs,
                    ViewSet* views,
                    ReconstructionSummary* summary) {
  return MeshBuilder(inputs, views, summary).Run();
}

}  // namespace octacut
