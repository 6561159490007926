#include "plugin/comparison_options.h"

namespace octacut {

void DeclareMeasureOptions(OptionManager& options,
                           CompareMeshesOptions* compare) {
  options
      .Add("num_samples",
           &compare->num_samples,
           "Number of points on each surface whose distances are measured.")
      .ForExperts();
  options
      .Add("thresholds",
           &compare->thresholds,
           "Distance thresholds of precision, recall and F-score, as "
           "fractions of the reference's bounding box diagonal.")
      .ForExperts();
  options
      .Add("accuracy_fraction",
           &compare->accuracy_fraction,
           "Fraction of a mesh that is used for its accuracy: accuracy is "
           "the distance within which this fraction lies.")
      .ForExperts();
  options
      .Add("completeness_threshold",
           &compare->completeness_threshold,
           "Distance threshold of completeness, as a fraction of the "
           "reference's bounding box diagonal.")
      .ForExperts();
}

void DeclareSeenOptions(OptionManager& options, SeenReferenceOptions* seen) {
  options
      .Add("min_views",
           &seen->min_views,
           "Number of cameras that must see a point. Used with views_path.")
      .ForExperts();
  options
      .Add("max_view_angle",
           &seen->max_angle,
           "Maximum angle in degrees between viewing direction and surface "
           "normal. Used with views_path.")
      .ForExperts();
}

void DeclareAlignmentOptions(OptionManager& options,
                             CompareMeshesOptions* compare) {
  options.Add("align",
              &compare->align,
              "If 1, register each mesh with the reference first (ICP). Both "
              "must be roughly aligned already, unless "
              "Alignment.global_search (see --help_all 1) is 1.");
  options
      .Add("Alignment.num_samples",
           &compare->alignment.num_samples,
           "Number of points on each surface that are used for registration.")
      .ForExperts();
  options.AddConstant("Alignment.max_iterations",
                      AlignMeshesOptions::kMaxIterations);
  options.AddRemoved("Alignment.kept_fraction",
                     "a robust loss leaves out what does not fit");
  options
      .Add("Alignment.global_search",
           &compare->alignment.global_search,
           "If 1, search for rotation, scale and position first: the meshes "
           "may be in frames of their own. Used with align.")
      .ForExperts();
  options
      .Add("Alignment.estimate_scale",
           &compare->alignment.estimate_scale,
           "If 0, estimate only rotation and translation.")
      .ForExperts();
  options.AddConstant("Alignment.tolerance", AlignMeshesOptions::kTolerance);
}

}  // namespace octacut
