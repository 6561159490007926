#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "colmap_io/files/byte_order_mark.h"
#include "colmap_io/mesh/mesh_readers.h"
#include "colmap_io/mesh/text_numbers.h"

namespace octacut {
namespace {

class ObjParser {
 public:
  explicit ObjParser(ByteSource* source) : source_(source) {}

  PolygonMesh Run(std::vector<std::string>* notes) {
    std::string_view line;
    while (source_->ReadLine(&line)) {
      line_number_ = source_->LineNumber();
      if (line_number_ == 1) {
        SkipByteOrderMark(&line);
      }
      if (line.ends_with('\\')) {
        JoinLines(&line);
      }
      ParseLine(line);
    }
    Finish(notes);
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void Fail(std::string_view message) const {
    source_->Fail(fmt::format("line {}: {}", line_number_, message));
  }

  void JoinLines(std::string_view* line) {
    joined_.assign(*line);
    while (joined_.ends_with('\\')) {
      joined_.pop_back();
      joined_ += ' ';
      if (source_->ReadLine(line)) {
        joined_ += *line;
      }
    }
    *line = joined_;
  }

  void ParseLine(std::string_view line) {
    const std::string_view keyword = NextWord(&line);
    if (keyword == "v") {
      ParseVertex(&line);
    } else if (keyword == "vn") {
      ParseNormal(&line);
    } else if (keyword == "f" || keyword == "fo") {
      ParseFace(&line);
    }  // texture coordinates, groups, materials, lines and curves are no shape
  }

  // Numbers until the end of the line or a comment; at most 8.
  size_t ParseNumbers(std::string_view* line, std::array<double, 8>* numbers) {
    size_t count = 0;
    for (std::string_view word = NextWord(line);
         !word.empty() && !word.starts_with('#') && count < numbers->size();
         word = NextWord(line)) {
      if (!ParseNumber(word, &(*numbers)[count])) {
        Fail(fmt::format("\"{}\" is not a number", word.substr(0, 40)));
      }
      ++count;
    }
    return count;
  }

  void ParseVertex(std::string_view* line) {
    std::array<double, 8> numbers;
    const size_t count = ParseNumbers(line, &numbers);
    if (count < 3) {
      Fail(fmt::format("vertex has {} coordinates", count));
    }
    mesh_.positions.emplace_back(numbers[0], numbers[1], numbers[2]);
    if (!mesh_.positions.back().allFinite()) {
      Fail("coordinates are not finite");
    }
    // x y z [r g b], or x y z w [r g b]
    if (count >= 6) {
      const size_t first = count == 6 ? 3 : 4;
      colors_.push_back(Eigen::Vector3d(&numbers[first]).cast<float>());
    }
  }

  void ParseNormal(std::string_view* line) {
    std::array<double, 8> numbers;
    if (ParseNumbers(line, &numbers) < 3) {
      Fail("normal has fewer than three coordinates");
    }
    const Eigen::Vector3f normal =
        Eigen::Vector3d(numbers.data()).cast<float>();
    normals_.push_back(normal.allFinite() ? normal : Eigen::Vector3f::Zero());
  }

  // The index (from 0) that a field of a corner names; `size` elements of its
  // kind stand above.
  std::optional<uint32_t> ParseIndex(std::string_view field, size_t size) {
    int64_t number = 0;
    if (!ParseNumber(field, &number)) {
      return std::nullopt;
    }
    const int64_t index =
        number > 0 ? number - 1 : static_cast<int64_t>(size) + number;
    if (number == 0 || index < 0 || index >= UINT32_MAX) {
      return std::nullopt;
    }
    return static_cast<uint32_t>(index);
  }

  // v, v/vt, v//vn or v/vt/vn
  void ParseCorner(std::string_view word) {
    const size_t slash = word.find('/');
    const std::optional<uint32_t> vertex =
        ParseIndex(word.substr(0, slash), mesh_.positions.size());
    if (!vertex) {
      Fail(fmt::format("face has a bad corner \"{}\"", word.substr(0, 40)));
    }
    mesh_.corners.push_back(*vertex);
    const size_t second =
        slash == word.npos ? word.npos : word.find('/', slash + 1);
    if (second == word.npos || *vertex >= mesh_.positions.size()) {
      return;
    }
    const std::optional<uint32_t> normal =
        ParseIndex(word.substr(second + 1), normals_.size());
    if (normal && *normal < normals_.size()) {
      mesh_.normals.resize(mesh_.positions.size(), Eigen::Vector3f::Zero());
      mesh_.normals[*vertex] += normals_[*normal];
    }
  }

  void ParseFace(std::string_view* line) {
    for (std::string_view word = NextWord(line);
         !word.empty() && !word.starts_with('#');
         word = NextWord(line)) {
      ParseCorner(word);
    }
    mesh_.EndFace();
  }

  void Finish(std::vector<std::string>* notes) {
    if (mesh_.positions.size() >= UINT32_MAX) {
      source_->Fail("has too many vertices");
    }
    if (!mesh_.normals.empty()) {
      mesh_.normals.resize(mesh_.positions.size(), Eigen::Vector3f::Zero());
      for (Eigen::Vector3f& normal : mesh_.normals) {
        normal.stableNormalize();
      }
    }
    if (colors_.size() == mesh_.positions.size()) {
      mesh_.colors = QuantizeColors(colors_, 0);
    } else if (!colors_.empty()) {
      notes->push_back(
          "only some vertices have colours, so all colours are ignored");
    }
  }

  ByteSource* source_;
  PolygonMesh mesh_;
  std::vector<Eigen::Vector3f> normals_;
  std::vector<Eigen::Vector3f> colors_;
  std::string joined_;
  size_t line_number_ = 0;
};

}  // namespace

PolygonMesh ReadObj(ByteSource* source, std::vector<std::string>* notes) {
  PolygonMesh mesh = ObjParser(source).Run(notes);
  if (mesh.positions.empty()) {
    source->Fail("has no vertices");
  }
  return mesh;
}

}  // namespace octacut
