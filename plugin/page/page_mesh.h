// A mesh as a page shows it: simplified, quantised, with values to paint it by.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/cluster_vertices.h"
#include "core/mesh/remarkable_places.h"
#include "plugin/option_value.h"
#include "plugin/page/page_blobs.h"

namespace octacut {

// The most triangles, or points of clouds, of all meshes of a page together:
// what software rendering turns smoothly, and what fits into the page.
inline constexpr size_t kPageTriangles = 300'000;

// One value per vertex of the full mesh; not a number where there is none.
struct PageValues {
  std::string kind;   // "distance" or "support"
  std::string label;  // "to <name of the other mesh>"
  std::vector<float> values;
};

struct PageMesh {
  std::string name;
  bool is_reference = false;
  size_t num_triangles = 0;  // of the full mesh
  size_t num_points = 0;     // of the full cloud; 0 for a mesh
  ClusteredMesh display;
  std::vector<std::array<uint8_t, 3>> colors;  // of the display; may be empty
  std::vector<PageValues> values;
  // Places on the full mesh, found by its `place_kind`: "distance" or
  // "support".
  std::string place_kind;
  std::vector<RemarkablePlace> places;
};

// Positions become 16 bits in the bounding box, indices 24 bits.
Json PageMeshToJson(const PageMesh& mesh, PageBlobs* blobs);

// [{"position", "normal", `value_key`}, ...]
Json PlacesToJson(const std::vector<RemarkablePlace>& places,
                  const std::string& value_key);

}  // namespace octacut
