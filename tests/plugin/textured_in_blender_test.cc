// Textured meshes as Blender reads them. Skipped where it is not installed;
// workflows/setup.sh --with_test_tools 1 does so.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "colmap_io/mesh/textured_mesh_io.h"
#include "core/texture/bake_normals.h"
#include "core/texture/texture_mesh.h"
#include "tests/core/texture/bumpy_sphere.h"
#include "tests/core/texture/small_sphere.h"
#include "tests/plugin/other_programs.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// Prints, for each polygon, its centre in the frame of the file, the colour of
// the image behind the material's base colour there, and the normal that the
// image behind its normal gives by Blender's own (MikkTSpace) tangents.
constexpr const char* kScript = R"(
import sys
import bpy
import numpy
from mathutils import Vector
# Blender 3.4 of Debian 12 uses this name, which NumPy of Debian 12 has removed.
numpy.bool = bool
path = sys.argv[-1]
bpy.ops.wm.read_factory_settings(use_empty=True)
if path.endswith('.glb'):
  bpy.ops.import_scene.gltf(filepath=path)
else:
  bpy.ops.import_scene.obj(filepath=path)

def source(node, name, kind):
  node = node.inputs[name].links[0].from_node
  assert node.type == kind, node.type
  return node

class Image:
  def __init__(self, image):
    self.width, self.height = image.size
    self.pixels = list(image.pixels)
  def at(self, uv):
    x = min(int(uv[0] * self.width), self.width - 1)
    y = min(int(uv[1] * self.height), self.height - 1)
    begin = 4 * (y * self.width + x)
    return Vector(self.pixels[begin:begin + 3])

def images(material):
  shader = [n for n in material.node_tree.nodes if n.type == 'BSDF_PRINCIPLED'][0]
  color = Image(source(shader, 'Base Color', 'TEX_IMAGE').image)
  normal = source(source(shader, 'Normal', 'NORMAL_MAP'), 'Color', 'TEX_IMAGE')
  assert normal.image.colorspace_settings.name == 'Non-Color'
  return color, Image(normal.image)

for o in bpy.context.scene.objects:
  mesh = o.data
  mesh.calc_tangents()
  mesh.calc_normals_split()
  uvs = mesh.uv_layers[0].data
  pages = [images(m) for m in mesh.materials]
  for polygon in mesh.polygons:
    corners = [mesh.loops[i] for i in polygon.loop_indices]
    mean = lambda of: sum((of(c) for c in corners), Vector((0, 0, 0))) / 3
    center = o.matrix_world @ mean(lambda c: mesh.vertices[c.vertex_index].co)
    uv = sum((uvs[c.index].uv for c in corners), Vector((0, 0))) / 3
    color, normals = pages[polygon.material_index]
    rgb = 255 * color.at(uv)
    n = 2 * normals.at(uv) - Vector((1, 1, 1))
    normal = (n.x * mean(lambda c: c.tangent) +
              n.y * mean(lambda c: c.bitangent) +
              n.z * mean(lambda c: c.normal))
    normal = o.matrix_world.to_3x3() @ normal
    # Blender's z points up, and y in the files.
    print('POLYGON', center.x, center.z, -center.y, *rgb,
          normal.x, normal.z, -normal.y)
)";

struct Polygon {
  Eigen::Vector3d center;
  Eigen::Vector3d color;  // red, green, blue
  Eigen::Vector3d normal;
};

class TexturedInBlender : public ::testing::Test {
 protected:
  // The painted sphere with the normals of a bumpy one.
  fs::path Write(const std::string& name) const {
    const Photographs photographs =
        testing::PhotographsOf(testing::AllAround(), 160);
    TexturingOptions options;
    options.texture_size = 512;
    TexturingResult result =
        TextureMesh(testing::SmallSphere(4), photographs, options, Context(1));
    BakeNormals(
        testing::BumpySphere(), result.layout, Context(1), &result.textured);
    AtomicFiles files;
    WriteTexturedMesh(folder_ / name, result.textured, {}, &files);
    files.Commit();
    return folder_ / name;
  }

  std::vector<Polygon> Read(const fs::path& path) const {
    const std::string script = folder_.Write("read.py", kScript);
    std::istringstream lines(
        RunOther(fmt::format("blender --background --factory-startup "
                             "--python-exit-code 1 --python '{}' -- '{}'",
                             script,
                             path.string()),
                 folder_));
    std::vector<Polygon> polygons;
    std::string line;
    while (std::getline(lines, line)) {
      std::istringstream words(line);
      std::string word;
      words >> word;
      if (word == "POLYGON") {
        Polygon& p = polygons.emplace_back();
        for (Eigen::Vector3d* vector : {&p.center, &p.color, &p.normal}) {
          words >> vector->x() >> vector->y() >> vector->z();
        }
        EXPECT_FALSE(words.fail()) << line;
      }
    }
    return polygons;
  }

  static void ExpectPaintAndBumps(const std::vector<Polygon>& polygons) {
    ASSERT_EQ(polygons.size(), testing::SmallSphere(4).triangles.size());
    double color_error = 0;
    double angle = 0;
    double of_smooth = 0;
    for (const Polygon& p : polygons) {
      const Eigen::Vector3d u = p.center.normalized();
      color_error += (p.color - testing::Paint(u).reverse().cast<double>())
                         .cwiseAbs()
                         .mean();
      angle += testing::Degrees(p.normal, testing::BumpyNormal(u));
      of_smooth += testing::Degrees(u, testing::BumpyNormal(u));
    }
    const auto count = double(polygons.size());
    // The colour of the nearest texel, from photographs whose pixels are half a
    // hundredth of the sphere.
    EXPECT_LT(color_error / count, 3);
    EXPECT_LT(angle / count, 0.6);
    EXPECT_GT(of_smooth, 3 * angle);
  }

  TemporaryFolder folder_;
};

TEST_F(TexturedInBlender, GlbHasItsTextureAndNormalMapInPlace) {
  SKIP_WITHOUT("blender");
  ExpectPaintAndBumps(Read(Write("sphere.glb")));
}

TEST_F(TexturedInBlender, ObjHasItsTextureAndNormalMapInPlace) {
  SKIP_WITHOUT("blender");
  ExpectPaintAndBumps(Read(Write("sphere.obj")));
}

}  // namespace
}  // namespace octacut
