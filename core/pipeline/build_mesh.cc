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
    summary_.levels = std::move(solution_.levels);
    return {std::move(finished_), solution_.hierarchy.Finest()};
  }

 private:
  // What the cuts so far have found.
  struct Solution {
    LabelHierarchy hierarchy;
    std::vector<float> decided;  // of the finest level, as SolvedLevel has it
    std::vector<LevelSummary> levels;
  };

  LevelInputs Inputs() const {
    return {views_, inputs_.evidence, inputs_.options, inputs_.context};
  }

  // Cuts the level after l0 again around its refined surface as long as
  // refinement leaves the crust; the last of these cuts is of the next level,
  // unless that is finer than `last`. If the surface is refined once more after
  // a cut, and the photographs agree less, that cut is undone. Leaves the mesh
  // as it was extracted, or none after a cut.
  void Settle(int last) {
    const int level = inputs_.hull.Level() + 1;
    Solution before;  // the last cut, if that may be undone
    Timed(&summary_.recuts.seconds, [&] {
      for (int i = 1; i <= kMaxRecuts && RefinementLeavesCrust(); ++i) {
        const IndexedMesh extracted = finished_.mesh;
        Refine(false);
        if (AgreesLess()) {
          Undo(std::move(before));
          break;
        }
        const bool is_last = i == kMaxRecuts;
        before = is_last ? Solution() : solution_;
        if (!Recut(is_last ? std::min(level + 1, last) : level)) {
          finished_.mesh = extracted;
          break;
        }
      }
    });
  }

  // Whether refinement moves more than a few vertices of the level after l0 out
  // of its crust, by what its coarse rounds show.
  bool RefinementLeavesCrust() {
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
    const double share = double(moved) / double(extracted.positions.size());
    summary_.recuts.moved.push_back(share);
    if (share <= kLeavesCrust) {
      return false;
    }
    inputs_.context.Info(fmt::format(
        "Refinement moves {:.1f} % of the surface out of the crust of level "
        "{}, so the surface is refined.",
        100 * share,
        inputs_.hull.Level() + 1));
    return true;
  }

  // The levels after those that are solved, up to `last`.
  void AddLevels(int last) {
    int level = solution_.hierarchy.Empty()
                    ? inputs_.hull.Level()
                    : solution_.hierarchy.Finest().voxels.Level() + 1;
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
    SolvedLevel solved =
        SolveFinerLevel(Inputs(), solution_.hierarchy, summary);
    if (level == first + 1) {
      solved = DeepenLevel(
          Inputs(), solution_.hierarchy, std::move(solved), summary);
    }
    return solved;
  }

  // Whether the photographs agree less over the refined mesh than over that
  // before the last cut.
  bool AgreesLess() {
    std::vector<double>& agreements = summary_.recuts.agreements;
    agreements.push_back(summary_.refinement->agreement_after);
    return agreements.size() > 1 &&
           agreements.back() < *(agreements.end() - 2) - kLessAgreement;
  }

  // Cuts `level` around the refined mesh. Does nothing and returns false where
  // that leaves the cube, as it may if a bounding box cuts the object.
  bool Recut(int level) {
    const IndexedMesh refined = UnitMesh(finished_.mesh, inputs_.cube);
    if (LeavesCube(refined)) {
      inputs_.context.Info(
          "The refined surface leaves the bounding box, so this cut is left "
          "out.");
      return false;
    }
    inputs_.context.Info(
        fmt::format("Level {} is cut around the refined surface.", level));
    solution_.levels.resize(size_t(level - inputs_.hull.Level()));
    AddLevel(level, [&](LevelSummary* summary) {
      return RecutLevel(Inputs(),
                        inputs_.hull,
                        refined,
                        level,
                        &solution_.hierarchy,
                        summary);
    });
    ++summary_.recuts.num_kept;
    return true;
  }

  // Goes back to what was found before the last cut.
  void Undo(Solution before) {
    inputs_.context.Info(
        "The photographs agree less after the last cut, so it is undone.");
    solution_ = std::move(before);
    --summary_.recuts.num_kept;
    ForgetAlignment();
    SurfaceChanged();
  }

  template <typename Solve>
  void AddLevel(int level, const Solve& solve) {
    LevelSummary& summary = solution_.levels.emplace_back();
    const Phase phase(
        inputs_.context,
        fmt::format("crust, photo-consistency and cut of level {}", level));
    SolvedLevel solved = solve(&summary);
    RequireSurface(solved.surface, inputs_.options);
    solution_.hierarchy.Add(std::move(solved.surface));
    solution_.decided = std::move(solved.decided);
    ReportLevel(summary, inputs_.context);
    SurfaceChanged();
  }

  // The finest level's surface is another one: it has yet to be extracted, and
  // the observer to see it.
  void SurfaceChanged() {
    finished_ = {};
    if (inputs_.observer) {
      const LabeledVoxels& surface = solution_.hierarchy.Finest();
      inputs_.observer(surface.voxels.Level(),
                       PositionedMesh(surface, inputs_.cube, inputs_.context));
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
              const LabeledVoxels& surface = solution_.hierarchy.Finest();
              finished_ = FinalMesh(views_,
                                    surface,
                                    inputs_.cube,
                                    inputs_.options.finish,
                                    inputs_.context);
              summary_.finish = finished_.summary;
              summary_.num_moved_to_hull = MoveToHullBorder(
                  {views_, inputs_.evidence.mask_confidence, inputs_.cube},
                  {surface.voxels, solution_.decided},
                  inputs_.context,
                  &finished_.mesh);
            });
  }

  // Of the views, by refinement.
  void ForgetAlignment() {
    for (size_t i = 0; i < given_.size(); ++i) {
      views_[i].projection = given_[i];
    }
  }

  void Refine(bool coarsely) {
    ForgetAlignment();  // this aligns them anew, by a better surface
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
  Solution solution_;
  FinishedMesh finished_;  // of the finest level; empty until it is extracted
};

}  // namespace

BuiltMesh BuildMesh(const BuildInputs& inputs,
                    ViewSet* views,
                    ReconstructionSummary* summary) {
  return MeshBuilder(inputs, views, summary).Run();
}

}  // namespace octacut
