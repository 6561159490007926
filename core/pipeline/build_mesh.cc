#include "core/pipeline/build_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <Eigen/Core>
#include <optional>
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
// A cut is worse if the mean agreement of the photographs over the refined
// surface falls by more than this (docs/experiments/recut.md).
constexpr double kLessAgreement = 0.003;

void RequireSurface(const LabeledVoxels& surface,
                    const ReconstructionOptions& options) {
  if (std::none_of(surface.labels.begin(), surface.labels.end(), IsCut)) {
    throw InputError(fmt::format(
        "the surface vanished: with ballooning = {}, no part of the visual "
        "hull is inside; raise `ballooning`",
        options.evidence.ballooning));
  }
}

// The share of the positions that are farther than `distance` from those before
// they moved.
double ShareOfMoved(const std::vector<Eigen::Vector3d>& before,
                    const std::vector<Eigen::Vector3d>& after,
                    double distance) {
  size_t moved = 0;
  for (size_t v = 0; v < before.size(); ++v) {
    moved += (after[v] - before[v]).norm() > distance;
  }
  return double(moved) / double(before.size());
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
      : inputs_(inputs),
        views_(*views),
        summary_(*summary),
        given_(Projections(*views)) {}

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
    if (inputs_.options.refine && !state_.refinement) {
      Refine([](const auto&) { return true; });
    }
    summary_.levels = std::move(state_.levels);
    summary_.meshing_seconds = state_.meshing_seconds;
    summary_.finish = state_.finished.summary;
    summary_.num_moved_to_hull = state_.num_moved_to_hull;
    summary_.refinement = std::move(state_.refinement);
    return {std::move(state_.finished), state_.hierarchy.Finest()};
  }

 private:
  // What has been found so far.
  struct State {
    LabelHierarchy hierarchy;
    std::vector<float> decided;  // of the finest level, as SolvedLevel has it
    std::vector<LevelSummary> levels;
    // The finest level's surface; empty until it is extracted.
    FinishedMesh finished;
    double meshing_seconds = 0;
    size_t num_moved_to_hull = 0;
    // Once `finished` is refined; and the views as that has aligned them.
    std::optional<RefineSummary> refinement;
    std::vector<ViewProjection> aligned;
  };

  LevelInputs Inputs() const {
    return {views_, inputs_.evidence, inputs_.options, inputs_.context};
  }

  // Cuts the level after l0 again around its refined surface as long as
  // refinement leaves the crust; the last of these cuts is of the next level,
  // unless that is finer than `last`. If the surface is refined once more after
  // a cut, and the photographs agree less, that cut is undone.
  void Settle(int last) {
    const int level = inputs_.hull.Level() + 1;
    State before;  // before the last cut
    Timed(&summary_.recuts.seconds, [&] {
      for (int i = 1; i <= kMaxRecuts; ++i) {
        ExtractMesh();
        if (!RefineIfThatLeavesCrust(level == last)) {
          break;
        }
        if (AgreesLess()) {
          Undo(std::move(before));
          break;
        }
        before = state_;
        if (!Recut(i == kMaxRecuts ? std::min(level + 1, last) : level)) {
          break;
        }
      }
    });
    if (level == last && state_.refinement) {
      summary_.recuts.seconds -= state_.refinement->seconds;
    }
  }

  // Refines the surface of the level after l0 if its coarse rounds move more
  // than a few vertices out of the crust, or if `always`. Returns whether they
  // do.
  bool RefineIfThatLeavesCrust(bool always) {
    const std::vector<Eigen::Vector3d> extracted =
        UnitMesh(state_.finished.mesh, inputs_.cube).positions;
    const int level = inputs_.hull.Level() + 1;
    const double half_width = inputs_.options.crust.HalfWidth() *
                              inputs_.cube.VoxelSize(level) / inputs_.cube.edge;
    double share = 0;
    Refine([&](const std::vector<Eigen::Vector3d>& coarsely) {
      share = ShareOfMoved(extracted, coarsely, half_width);
      return always || share > kLeavesCrust;
    });
    summary_.recuts.moved.push_back(share);
    if (share <= kLeavesCrust) {
      return false;
    }
    inputs_.context.Info(
        fmt::format("Coarse refinement moves {:.1f} % of the vertices out of "
                    "the crust of level {}.",
                    100 * share,
                    level));
    return true;
  }

  // The levels after those that are solved, up to `last`.
  void AddLevels(int last) {
    int level = state_.hierarchy.Empty()
                    ? inputs_.hull.Level()
                    : state_.hierarchy.Finest().voxels.Level() + 1;
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
    SolvedLevel solved = SolveFinerLevel(Inputs(), state_.hierarchy, summary);
    if (level == first + 1) {
      solved =
          DeepenLevel(Inputs(), state_.hierarchy, std::move(solved), summary);
    }
    return solved;
  }

  // Whether the photographs agree less over the refined mesh than over that
  // before the last cut.
  bool AgreesLess() {
    std::vector<double>& agreements = summary_.recuts.agreements;
    agreements.push_back(state_.refinement->agreement_after);
    return agreements.size() > 1 &&
           agreements.back() < *(agreements.end() - 2) - kLessAgreement;
  }

  // Cuts `level` around the refined mesh. Does nothing and returns false where
  // that leaves the cube, as it may if a bounding box cuts the object.
  bool Recut(int level) {
    const IndexedMesh refined = UnitMesh(state_.finished.mesh, inputs_.cube);
    if (LeavesCube(refined)) {
      inputs_.context.Info(
          "The refined surface leaves the bounding box, so no level is cut "
          "again around it.");
      return false;
    }
    inputs_.context.Info(fmt::format(
        "Level {} is cut again around the refined surface.", level));
    state_.levels.resize(size_t(level - inputs_.hull.Level()));
    AddLevel(level, [&](LevelSummary* summary) {
      return RecutLevel(
          Inputs(), inputs_.hull, refined, level, &state_.hierarchy, summary);
    });
    ++summary_.recuts.num_kept;
    return true;
  }

  // Goes back to what was found before the last cut.
  void Undo(State before) {
    inputs_.context.Info(
        "After this cut the photographs agree less, so it is undone.");
    state_ = std::move(before);
    --summary_.recuts.num_kept;
    SetProjections(state_.aligned, &views_);
    ShowSurface();
  }

  template <typename Solve>
  void AddLevel(int level, const Solve& solve) {
    LevelSummary& summary = state_.levels.emplace_back();
    const Phase phase(
        inputs_.context,
        fmt::format("crust, photo-consistency and cut of level {}", level));
    SolvedLevel solved = solve(&summary);
    RequireSurface(solved.surface, inputs_.options);
    state_.hierarchy.Add(std::move(solved.surface));
    state_.decided = std::move(solved.decided);
    state_.finished = {};
    state_.refinement = std::nullopt;
    ReportLevel(summary, inputs_.context);
    ShowSurface();
  }

  void ShowSurface() const {
    if (inputs_.observer) {
      const LabeledVoxels& surface = state_.hierarchy.Finest();
      inputs_.observer(surface.voxels.Level(),
                       PositionedMesh(surface, inputs_.cube, inputs_.context));
    }
  }

  // The labelling's surface, smoothed, and where it is near the hull's border
  // moved towards that; unless it has been extracted.
  void ExtractMesh() {
    if (!state_.finished.mesh.positions.empty()) {
      return;
    }
    state_.meshing_seconds = 0;
    RunStep(inputs_.context,
            "mesh extraction and smoothing",
            &state_.meshing_seconds,
            [&] {
              const LabeledVoxels& surface = state_.hierarchy.Finest();
              state_.finished = FinalMesh(views_,
                                          surface,
                                          inputs_.cube,
                                          inputs_.options.finish,
                                          inputs_.context);
              state_.num_moved_to_hull = MoveToHullBorder(
                  {views_, inputs_.evidence.mask_confidence, inputs_.cube},
                  {surface.voxels, state_.decided},
                  inputs_.context,
                  &state_.finished.mesh);
            });
  }

  // Refines the mesh and aligns the views by it; leaves both as they were where
  // `goes_on` ends it.
  void Refine(const CoarseCheck& goes_on) {
    const std::vector<ViewProjection> before = Projections(views_);
    SetProjections(given_, &views_);
    std::optional<RefinedSurface> refined =
        RefineSurfaceIf(goes_on,
                        state_.finished.mesh,
                        inputs_.cube,
                        inputs_.options.refinement,
                        inputs_.context,
                        &views_);
    if (!refined) {
      SetProjections(before, &views_);
      return;
    }
    state_.finished.mesh = std::move(refined->mesh);
    state_.refinement = std::move(refined->summary);
    state_.aligned = Projections(views_);
  }

  const BuildInputs inputs_;
  ViewSet& views_;
  ReconstructionSummary& summary_;
  std::vector<ViewProjection> given_;  // of the views, before any alignment
  State state_;
};

}  // namespace

BuiltMesh BuildMesh(const BuildInputs& inputs,
                    ViewSet* views,
                    ReconstructionSummary* summary) {
  return MeshBuilder(inputs, views, summary).Run();
}

}  // namespace octacut
