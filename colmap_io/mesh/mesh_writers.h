// One writer per format, onto streams. The same bytes whatever the locale.
#pragma once

#include <ostream>
#include <string_view>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

// Binary little endian as COLMAP's meshers write it: float x y z, nx ny nz and
// uchar red green blue and float confidence where present; list uchar int
// vertex_indices. Floats hold 24 bits, which is what octacut's own meshes are
// kept to; of others the other formats (but STL) keep more.
// `confidence_name` is what the property of the confidences is called.
void WritePly(const IndexedMesh& mesh,
              std::ostream& stream,
              std::string_view confidence_name = "confidence");

// v with colours from 0 to 1 as MeshLab has them, vn, f v//vn. Coordinates
// with all their digits.
void WriteObj(const IndexedMesh& mesh, std::ostream& stream);

// OFF, or COFF with colours from 0 to 255; no normals. Coordinates with all
// their digits.
void WriteOff(const IndexedMesh& mesh, std::ostream& stream);

// Binary, with normals of facets; neither colours nor normals of vertices.
void WriteStl(const IndexedMesh& mesh, std::ostream& stream);

// 3MF with the millimetre as its unit and colours of the corners (materials
// extension), through lib3mf, which writes six decimals. Throws Error for a
// mesh that is too small for those or too large for the library.
void Write3mf(const IndexedMesh& mesh, std::ostream& stream);

}  // namespace octacut
