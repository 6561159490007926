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
namespace {

// The headings of `octacut help`.
constexpr std::string_view kReconstruct = "Reconstruct a mesh";
constexpr std::string_view kMasks = "Masks";
constexpr std::string_view kFinish = "Texture, formats and printing";
constexpr std::string_view kCompare = "Comparison, and COLMAP's dense tools";
constexpr std::string_view kOther = "Other";

constexpr auto kCommands = std::to_array<RegistryEntry>({
    {"octahedral_mesher",
     "Reconstruct a closed mesh from a sparse model, masks and photographs",
     &MakeOctahedralMesher,
     kReconstruct},
    {"visual_hull_mesher",
     "Mesh the visual hull of the masks within seconds",
     &MakeVisualHullMesher,
     kReconstruct},
    {"mesh_refiner",
     "Refine a closed mesh photometrically, below voxel size",
     &MakeMeshRefiner,
     kReconstruct},
    {"mask_extractor",
     "Find the silhouettes of the object in all photographs",
     &MakeMaskExtractor,
     kMasks},
    {"mask_undistorter",
     "Undistort masks as image_undistorter does photographs",
     &MakeMaskUndistorter,
     kMasks},
    {"mask_renderer",
     "Render the silhouettes of a mesh in all views",
     &MakeMaskRenderer,
     kMasks},
    {"mask_comparer",
     "Measure masks against reference masks",
     &MakeMaskComparer,
     kMasks},
    {"mesh_texturer",
     "Texture a mesh from the photographs of a workspace",
     &MakeMeshTexturer,
     kFinish},
    {"mesh_simplifier",
     "Reduce the number of triangles of a closed mesh",
     &MakeMeshSimplifier,
     kFinish},
    {"mesh_exporter",
     "Scale, orient and place a mesh for printing, in millimetres",
     &MakeMeshExporter,
     kFinish},
    {"mesh_auditor",
     "Audit a mesh for printing: topology, walls, overhangs, size",
     &MakeMeshAuditor,
     kFinish},
    {"mesh_comparer",
     "Compare meshes with a reference: topology, distances, scores",
     &MakeMeshComparer,
     kCompare},
    {"mesh_evaluator",
     "Evaluate meshes with masks and photographs, without a reference",
     &MakeMeshEvaluator,
     kCompare},
    {"depth_map_renderer",
     "Write depth and normal maps for COLMAP's stereo_fusion",
     &MakeDepthMapRenderer,
     kCompare},
    {"example_creator",
     "Create a synthetic workspace with ground truth",
     &MakeExampleCreator,
     kOther},
    {"version",
     "Print the versions of octacut and its libraries",
     &MakeVersion,
     kOther},
});

}  // namespace

std::span<const RegistryEntry> CommandRegistry() { return kCommands; }

}  // namespace octacut
