#include <fmt/format.h>

#include <array>
#include <utility>

#include "colmap_io/files/byte_order_mark.h"
#include "colmap_io/mesh/mesh_readers.h"
#include "colmap_io/mesh/text_numbers.h"

namespace octacut {
namespace {

class OffParser {
 public:
  explicit OffParser(ByteSource* source) : source_(source) {}

  PolygonMesh Run(std::vector<std::string>* notes) {
    std::string_view line = ParseKeyword();
    ParseCounts(&line);
    for (uint64_t i = 0; i < num_vertices_; ++i) {
      ParseVertex(i);
    }
    if (num_colored_ == num_vertices_) {
      mesh_.colors = QuantizeColors(colors_, color_scale_);
    } else if (num_colored_ > 0) {
      notes->push_back(
          "only some vertices have colours, so all colours are ignored");
    }
    for (uint64_t i = 0; i < num_faces_; ++i) {
      ParseFace(i);
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void Fail(std::string_view message) const {
    source_->Fail(fmt::format("line {}: {}", source_->LineNumber(), message));
  }

  // The next line that is not empty, without its comment.
  bool NextLine(std::string_view* line) {
    while (source_->ReadLine(line)) {
      if (source_->LineNumber() == 1) {
        SkipByteOrderMark(line);
      }
      *line = line->substr(0, line->find('#'));
      if (line->find_first_not_of(" \t\r\v\f") != line->npos) {
        return true;
      }
    }
    return false;
  }

  // The rest of the first line after [ST][C][N]OFF, a keyword that may be
  // missing altogether.
  std::string_view ParseKeyword() {
    std::string_view line;
    if (!NextLine(&line)) {
      source_->Fail("is empty");
    }
    std::string_view rest = line;
    std::string_view word = NextWord(&rest);
    if (!word.ends_with("OFF")) {
      return line;
    }
    word.remove_suffix(3);
    const auto take = [&](std::string_view prefix) {
      const bool found = word.starts_with(prefix);
      word.remove_prefix(found ? prefix.size() : 0);
      return found;
    };
    take("ST");
    has_colors_ = take("C");
    has_normals_ = take("N");
    std::string_view ahead = rest;
    if (!word.empty() || NextWord(&ahead) == "BINARY") {
      Fail("only text OFF with the prefixes ST, C and N can be read");
    }
    return rest;
  }

  void ParseCounts(std::string_view* line) {
    if (line->find_first_not_of(" \t") == line->npos && !NextLine(line)) {
      source_->Fail("ends before its counts");
    }
    const std::string_view vertices = NextWord(line);
    const std::string_view faces = NextWord(line);
    if (!ParseNumber(vertices, &num_vertices_) ||
        !ParseNumber(faces, &num_faces_) || num_vertices_ >= UINT32_MAX ||
        num_faces_ >= UINT32_MAX) {
      Fail(fmt::format("bad counts \"{} {}\"", vertices, faces));
    }
    mesh_.positions.reserve(
        source_->CheckedCount(num_vertices_, 6, "vertices"));
    mesh_.face_begins.reserve(source_->CheckedCount(num_faces_, 2, "faces"));
  }

  void ParseVertex(uint64_t vertex) {
    std::string_view line;
    if (!NextLine(&line)) {
      Fail(fmt::format(
          "the file ends before vertex {} of {}", vertex, num_vertices_));
    }
    const size_t num_needed = has_normals_ ? 6 : 3;
    std::array<double, 10> numbers;
    size_t count = 0;
    for (std::string_view word = NextWord(&line);
         !word.empty() && count < numbers.size();
         word = NextWord(&line)) {
      if (!ParseNumber(word, &numbers[count])) {
        Fail(fmt::format(
            "vertex {}: \"{}\" is not a number", vertex, word.substr(0, 40)));
      }
      // Integers are out of 255, numbers with a point out of 1.
      if (count >= num_needed && word.find('.') != word.npos) {
        color_scale_ = 0;
      }
      ++count;
    }
    if (count < num_needed) {
      Fail(fmt::format("vertex {} has {} numbers", vertex, count));
    }
    mesh_.positions.emplace_back(numbers[0], numbers[1], numbers[2]);
    if (!mesh_.positions.back().allFinite()) {
      Fail(fmt::format("vertex {}: coordinates are not finite", vertex));
    }
    if (has_normals_) {
      const Eigen::Vector3f normal = Eigen::Vector3d(&numbers[3]).cast<float>();
      mesh_.normals.push_back(normal.allFinite() ? normal
                                                 : Eigen::Vector3f::Zero());
    }
    if (has_colors_ && count >= num_needed + 3) {
      ++num_colored_;
      colors_.push_back(Eigen::Vector3d(&numbers[num_needed]).cast<float>());
    }
  }

  void ParseFace(uint64_t face) {
    std::string_view line;
    if (!NextLine(&line)) {
      Fail(fmt::format("the file ends before face {} of {}", face, num_faces_));
    }
    uint32_t size = 0;
    if (!ParseNumber(NextWord(&line), &size)) {
      Fail(fmt::format("face {}: bad number of corners", face));
    }
    for (uint32_t i = 0; i < size; ++i) {
      uint32_t vertex = 0;
      const std::string_view word = NextWord(&line);
      if (!ParseNumber(word, &vertex) || vertex >= num_vertices_) {
        Fail(
            fmt::format("face {}: bad vertex index \"{}\", there are {} "
                        "vertices",
                        face,
                        word.substr(0, 40),
                        num_vertices_));
      }
      mesh_.corners.push_back(vertex);
    }
    mesh_.EndFace();
  }

  ByteSource* source_;
  PolygonMesh mesh_;
  std::vector<Eigen::Vector3f> colors_;
  float color_scale_ = 255;
  uint64_t num_vertices_ = 0;
  uint64_t num_faces_ = 0;
  uint64_t num_colored_ = 0;
  bool has_colors_ = false;
  bool has_normals_ = false;
};

}  // namespace

PolygonMesh ReadOff(ByteSource* source, std::vector<std::string>* notes) {
  return OffParser(source).Run(notes);
}

}  // namespace octacut
