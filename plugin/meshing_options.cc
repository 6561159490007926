#include "plugin/meshing_options.h"

#include "plugin/refinement_options.h"
#include "plugin/workspace_options.h"

namespace octacut {
namespace {

// Resolution, masks and what is removed at the end.
void DeclareMainOptions(OptionManager& options,
                        ReconstructionOptions* meshing) {
  options.Add(
      "OctahedralMeshing.target_level",
      &meshing->target_level,
      "Resolution of the mesh: (2^level)^3 voxels. A voxel should cover about "
      "1.5 pixels of the photographs on the object. If given, takes "
      "precedence over --quality.");
  options.Add("OctahedralMeshing.hull_level",
              &meshing->hull.hull_level,
              "Resolution of the visual hull: (2^level)^3 voxels. Use 8 for "
              "parts thinner than 1/40 of the object's length.");
  options.Add(
      "OctahedralMeshing.refine",
      &meshing->refine,
      "If 1, refine the mesh and the poses photometrically below voxel size. "
      "If given, takes precedence over --quality.");
  DeclareMaskTolerance(options, &meshing->masks.mask_tolerance);
  DeclareFillFalseGaps(options, &meshing->masks.fill_false_gaps);
  DeclareMoveMaskBorders(options, &meshing->masks.move_mask_borders);
  options.Add(
      "OctahedralMeshing.ballooning",
      &meshing->evidence.ballooning,
      "Weight of the preference for the inside of the object where the "
      "photographs do not determine the surface. Higher values move it outward "
      "and keep untextured parts, lower values open deeper concavities.");
  DeclareChromaWeight(options, &meshing->consistency.chroma_weight);
  options.Add("OctahedralMeshing.min_component",
              &meshing->finish.min_component,
              "Remove components smaller than this fraction of the volume of "
              "the largest one, unless the masks of at least two images show "
              "them.");
  options.Add(
      "OctahedralMeshing.min_handle",
      &meshing->finish.min_handle,
      "Remove bridges up to this circumference, and fill tunnels up to twice "
      "this circumference, in voxels or, if larger, pixels. The limit is up to "
      "four times this value where no silhouette shows the handle. 0 keeps "
      "all.");
}

void DeclareExpertOptions(OptionManager& options,
                          ReconstructionOptions* meshing) {
  options
      .AddEnum(
          "OctahedralMeshing.consistency",
          &meshing->consistency.measure,
          {{"normalized_variance", ConsistencyMeasure::kNormalizedVariance},
           {"ncc", ConsistencyMeasure::kNcc},
           {"variance", ConsistencyMeasure::kVariance}},
          "Photo-consistency measure: colour variance normalised per image, "
          "pairwise correlation, or plain colour variance.")
      .ForExperts();
  options
      .Add("OctahedralMeshing.smoothness",
           &meshing->energy.smoothness,
           "Exponent s of the edge weights phi^s + a; phi is 0 where the views "
           "agree.")
      .ForExperts();
  options
      .Add("OctahedralMeshing.area_weight",
           &meshing->energy.area_weight,
           "Constant a of the edge weights phi^s + a. Higher values prefer "
           "surfaces of smaller area.")
      .ForExperts();
  options
      .Add("OctahedralMeshing.max_grow_rounds",
           &meshing->max_grow_rounds,
           "Maximum number of times the crust (the band of voxels that is "
           "searched) is enlarged because the cut touches its border, 0 to 16.")
      .ForExperts();
  options
      .Add("OctahedralMeshing.lean_cut",
           &meshing->cut.lean,
           "If 1, solve the graph cut with 14-bit edge weights, which needs a "
           "third less memory.")
      .ForExperts();
}

// What the tables of docs/accuracy.md switch off one by one.
void DeclareProjectKeys(OptionManager& options,
                        ReconstructionOptions* meshing) {
  InsideEvidenceOptions& evidence = meshing->evidence;
  options
      .Add("OctahedralMeshing.matter_weight",
           &evidence.matter_weight,
           "Weight of the evidence for the inside that one view gives to a "
           "voxel just behind a surface it has found.")
      .ForProjectFiles();
  options
      .Add("OctahedralMeshing.free_space_weight",
           &evidence.free_space_weight,
           "Weight of the evidence for the outside that one view gives to a "
           "voxel it sees through.")
      .ForProjectFiles();
  options
      .Add("OctahedralMeshing.silhouette_weight",
           &meshing->energy.silhouette_weight,
           "Weight of the evidence for the outside of voxels that are "
           "background in at least one view.")
      .ForProjectFiles();
  options
      .Add("OctahedralMeshing.cover_rounds",
           &evidence.cover_rounds,
           "Maximum number of rounds that restore uncovered object pixels on "
           "the first level, 0 to 8; 0 restores none on any level.")
      .ForProjectFiles();
  options
      .Add("OctahedralMeshing.min_agreeing_views",
           &evidence.min_agreeing_views,
           "Number of other views that must confirm a depth; see "
           "min_like_samples for exceptions.")
      .ForProjectFiles();
  options
      .Add("OctahedralMeshing.min_like_samples",
           &evidence.min_like_samples,
           "If fewer views confirm a depth, but at least one does, this many "
           "of its eight neighbouring samples must share it; 9 rejects all "
           "such depths.")
      .ForProjectFiles();
  options
      .Add("DepthSweep.num_neighbors",
           &evidence.sweep.num_neighbors,
           "Number of neighbouring views that each view is compared with, 2 "
           "to 8.")
      .ForProjectFiles();
  options
      .Add("Smoothing.iterations",
           &meshing->finish.smoothing.iterations,
           "Number of smoothing iterations V <- V + lambda Laplacian(V).")
      .ForProjectFiles();
  options
      .Add("Smoothing.taubin_mu",
           &meshing->finish.smoothing.taubin_mu,
           "Step size mu of the inverse step after each iteration, which "
           "restores the volume (Taubin smoothing); at most -lambda, or 0 for "
           "none.")
      .ForProjectFiles();
}

// Options of earlier versions. The structs say why each has its value.
void DeclareConstants(OptionManager& options,
                      const ReconstructionOptions& meshing) {
  options.AddConstant("OctahedralMeshing.crust_dilation",
                      meshing.crust.crust_dilation);
  options.AddConstant("OctahedralMeshing.mask_border_weight",
                      meshing.energy.mask_border_weight);
  options.AddConstant("OctahedralMeshing.unseen_weight",
                      EnergyOptions::kUnseenWeight);
  const ConsistencyOptions& consistency = meshing.consistency;
  options.AddConstant("OctahedralMeshing.patch_radius",
                      consistency.patch_radius);
  options.AddConstant("OctahedralMeshing.min_patch_pixels",
                      consistency.min_patch_pixels);
  options.AddConstant("OctahedralMeshing.neutral", consistency.neutral);
  options.AddConstant("OctahedralMeshing.pixel_noise", consistency.pixel_noise);
  const VisibilityOptions& visibility = meshing.visibility;
  options.AddConstant("OctahedralMeshing.max_views", visibility.max_views);
  options.AddConstant("OctahedralMeshing.max_angle",
                      VisibilityOptions::kMaxAngle);
  options.AddConstant("OctahedralMeshing.depth_tolerance",
                      visibility.depth_tolerance);
  options.AddConstant("OctahedralMeshing.normal_blur",
                      ReconstructionOptions::kNormalBlur);
  options.AddConstant("OctahedralMeshing.cover_weight",
                      InsideEvidenceOptions::kCoverWeight);
  const DepthSweepOptions& sweep = meshing.evidence.sweep;
  options.AddConstant("DepthSweep.min_angle", sweep.min_angle);
  options.AddConstant("DepthSweep.max_angle", sweep.max_angle);
  options.AddConstant("DepthSweep.samples_per_voxel",
                      DepthSweepOptions::kSamplesPerVoxel);
  options.AddConstant("DepthSweep.planes_per_voxel",
                      DepthSweepOptions::kPlanesPerVoxel);
  options.AddConstant("DepthSweep.window_radius",
                      DepthSweepOptions::kWindowRadius);
  options.AddConstant("DepthSweep.min_score", DepthSweepOptions::kMinScore);
  options.AddConstant("Smoothing.lambda", SmoothOptions::kLambda);
  options.AddConstant("Smoothing.max_displacement",
                      meshing.finish.smoothing.max_displacement);
}

}  // namespace

void DeclareMeshingOptions(OptionManager& options,
                           ReconstructionOptions* meshing) {
  DeclareMainOptions(options, meshing);
  DeclareExpertOptions(options, meshing);
  DeclareProjectKeys(options, meshing);
  DeclareConstants(options, *meshing);
  DeclareRefinementOptions(options, &meshing->refinement);
}

}  // namespace octacut
