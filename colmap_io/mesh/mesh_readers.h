// One reader per format; every one throws InputError "<name>: ..." that names
// the element (counted from 0) or the line (counted from 1).
#pragma once

#include <string>
#include <vector>

#include "colmap_io/mesh/byte_source.h"
#include "colmap_io/mesh/polygon_mesh.h"

namespace octacut {

// Ascii, binary little and big endian; any properties and elements in any
// order. Understands x y z, nx ny nz, red green blue (also r g b and
// diffuse_red ...), confidence, vertex_indices or vertex_index of `face`, and
// `tristrips`. Coordinates that are not finite are left to RemoveNonFinite.
PolygonMesh ReadPly(ByteSource* source, std::vector<std::string>* notes);

// v with colours, vn, vt, f in every form with negative indices. A vertex
// takes the mean of the normals that its corners name.
PolygonMesh ReadObj(ByteSource* source, std::vector<std::string>* notes);

// OFF with the prefixes ST, C and N; text only.
PolygonMesh ReadOff(ByteSource* source, std::vector<std::string>* notes);

// Ascii and binary; vertices with the same coordinates become one.
PolygonMesh ReadStl(ByteSource* source, std::vector<std::string>* notes);

}  // namespace octacut
