#include "plugin/registry.h"

#include <array>

#include "plugin/commands/depth_map_renderer.h"
#include "plugin/commands/example_creator.h"
#include "plugin/commands/mask_comparer.h"
#include "plugin/commands/mask_extractor.h"
#include "plugin/commands/mask_renderer.h"
#include "plugin/commands/mask_undistorter.h"
#include "plugin/commands/mesh_auditor.h"
#include "plugin/commands/mesh_comparer.h"
#include "plugin/commands/mesh_evaluator.h"
#include "plugin/commands/mesh_exporter.h"
#include "plugin/commands/mesh_refiner.h"
#include "plugin/commands/mesh_simplifier.h"
#include "plugin/commands/mesh_texturer.h"
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
      {"mask_renderer",
       "Render the silhouettes of a mesh in all views",
       &MakeMaskRenderer},
      {"mask_undistorter",
       "Undistort masks as image_undistorter does photographs",
       &MakeMaskUndistorter},
      {"mesh_auditor",
       "Audit a mesh for printing: topology, walls, overhangs, size",
       &MakeMeshAuditor},
      {"mesh_comparer",
       "Compare meshes with a reference: topology, distances, scores",
       &MakeMeshComparer},
      {"mesh_evaluator",
       "Evaluate meshes with masks and photographs, without a reference",
       &MakeMeshEvaluator},
      {"mesh_exporter",
       "Scale, orient and place a mesh for printing, in millimetres",
       &MakeMeshExporter},
      {"mesh_refiner",
       "Refine a closed mesh photometrically, below voxel size",
       &MakeMeshRefiner},
      {"mesh_simplifier",
       "Reduce the number of triangles of a closed mesh",
       &MakeMeshSimplifier},
      {"mesh_texturer",
       "Texture a mesh from the photographs of a workspace",
       &MakeMeshTexturer},
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
