#include "plugin/registry.h"

#include <array>

#include "plugin/commands/depth_map_renderer.h"
#include "plugin/commands/example_creator.h"
#include "plugin/commands/mask_comparer.h"
#include "plugin/commands/mask_extractor.h"
#include "plugin/commands/mesh_comparer.h"
#include "plugin/commands/mesh_evaluator.h"
#include "plugin/commands/mesh_refiner.h"
#include "plugin/commands/octahedral_mesher.h"
#include "plugin/commands/version.h"
#include "plugin/commands/visual_hull_mesher.h"

namespace octacut {

std::span<const RegistryEntry> CommandRegistry() {
  static constexpr auto kCommands = std::to_array<RegistryEntry>({
      {"depth_map_renderer",
       "Write depth and normal maps for COLMAP's stereo_fusion",
       &MakeDepthMapRenderer},
      {"example_creator",
       "Create a synthetic workspace with ground truth",
       &MakeExampleCreator},
      {"mask_comparer",
       "Measure masks against reference masks",
       &MakeMaskComparer},
      {"mask_extractor",
       "Find the silhouettes of the object in all photographs",
       &MakeMaskExtractor},
      {"mesh_comparer",
       "Compare meshes with a reference: topology, distances, scores",
       &MakeMeshComparer},
      {"mesh_evaluator",
       "Evaluate meshes with masks and photographs, without a reference",
       &MakeMeshEvaluator},
      {"mesh_refiner",
       "Refine a closed mesh photometrically, below voxel size",
       &MakeMeshRefiner},
      {"octahedral_mesher",
       "Reconstruct a closed mesh from a sparse model, masks and photographs",
       &MakeOctahedralMesher},
      {"version",
       "Print the versions of octacut and its libraries",
       &MakeVersion},
      {"visual_hull_mesher",
       "Mesh the visual hull of the masks within seconds",
       &MakeVisualHullMesher},
  });
  return kCommands;
}

}  // namespace octacut
