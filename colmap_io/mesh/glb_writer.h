// Binary glTF 2.0 (.glb) onto streams.
//
// Written with nlohmann-json instead of tinygltf (package libtinygltf-dev): of
// a GLB file only its short JSON part is any work, and tinygltf would copy all
// buffers and images into its own model first and encode the images with a
// library of its own. tests/plugin has the files checked by the Khronos
// validator.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "core/mesh/indexed_mesh.h"
#include "core/texture/textured_mesh.h"

namespace octacut {

// An encoded image.
struct EncodedImage {
  std::string mime_type;  // "image/png" or "image/jpeg"
  std::vector<unsigned char> bytes;
};

// The encoded pages of an atlas; normals are empty without normal maps.
struct EncodedPages {
  std::vector<EncodedImage> colors;
  std::vector<EncodedImage> normals;
};

// Positions (floats), unit normals and, where present, vertex colours, which
// glTF wants in linear light: 16 bits per channel. Throws InputError beyond the
// 4 GB that the format can hold.
void WriteGlb(const IndexedMesh& mesh, std::ostream& stream);

// A primitive and a rough, non-metallic material for each page. Vertices are
// repeated along the borders of charts.
void WriteTexturedGlb(const TexturedMesh& mesh,
                      const EncodedPages& pages,
                      std::ostream& stream);

}  // namespace octacut
