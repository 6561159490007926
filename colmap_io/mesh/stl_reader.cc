#include <fmt/format.h>

#include <bit>
#include <cctype>
#include <utility>

#include "colmap_io/files/byte_order_mark.h"
#include "colmap_io/mesh/mesh_readers.h"
#include "colmap_io/mesh/text_numbers.h"

namespace octacut {
namespace {

constexpr size_t kHeaderBytes = 80;
constexpr size_t kFacetBytes = 50;

// Gives equal positions the same number: an open hash table over the
// positions found so far.
class Welder {
 public:
  explicit Welder(std::vector<Eigen::Vector3d>* positions)
      : positions_(positions), slots_(1024, kFree) {}

  uint32_t Weld(const Eigen::Vector3d& position) {
    if (2 * positions_->size() >= slots_.size()) {
      Grow();
    }
    // -0 and 0 are the same place.
    const Eigen::Vector3d key = position + Eigen::Vector3d::Zero();
    size_t slot = Find(key);
    if (slots_[slot] == kFree) {
      slots_[slot] = static_cast<uint32_t>(positions_->size());
      positions_->push_back(key);
    }
    return slots_[slot];
  }

 private:
  static constexpr uint32_t kFree = UINT32_MAX;

  size_t Find(const Eigen::Vector3d& key) const {
    uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
      hash = (hash ^ std::bit_cast<uint64_t>(key[axis])) * 0x9e3779b97f4a7c15;
      hash ^= hash >> 32;
    }
    size_t slot = hash & (slots_.size() - 1);
    while (slots_[slot] != kFree && (*positions_)[slots_[slot]] != key) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }

  void Grow() {
    slots_.assign(2 * slots_.size(), kFree);
    for (size_t i = 0; i < positions_->size(); ++i) {
      slots_[Find((*positions_)[i])] = static_cast<uint32_t>(i);
    }
  }

  std::vector<Eigen::Vector3d>* positions_;
  std::vector<uint32_t> slots_;
};

class StlParser {
 public:
  explicit StlParser(ByteSource* source)
      : source_(source), welder_(&mesh_.positions) {}

  PolygonMesh Run() {
    if (IsText()) {
      ReadText();
    } else {
      ReadBinary();
    }
    return std::move(mesh_);
  }

 private:
  // Some binary files begin with "solid" too; text has no zero bytes, which the
  // number of facets nearly always has, and hardly a size that fits it.
  bool IsText() {
    const std::string_view head = source_->Peek(kHeaderBytes + 4);
    std::string_view text = head;
    SkipByteOrderMark(&text);
    text.remove_prefix(
        std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (!text.starts_with("solid")) {
      return false;
    }
    if (head.find('\0') != head.npos) {
      return false;
    }
    if (head.size() < kHeaderBytes + 4 || !source_->KnowsSize()) {
      return true;
    }
    return source_->Remaining() !=
           kHeaderBytes + 4 + kFacetBytes * NumFacets(head);
  }

  static uint64_t NumFacets(std::string_view head) {
    uint64_t count = 0;
    for (int byte = 3; byte >= 0; --byte) {
      count =
          count << 8 | static_cast<unsigned char>(head[kHeaderBytes + byte]);
    }
    return count;
  }

  void AddCorner(const Eigen::Vector3d& position, size_t facet) {
    if (!position.allFinite()) {
      source_->Fail(fmt::format("facet {}: coordinates are not finite", facet));
    }
    if (mesh_.positions.size() + 1 >= UINT32_MAX) {
      source_->Fail("has too many vertices");
    }
    mesh_.corners.push_back(welder_.Weld(position));
  }

  void ReadBinary() {
    const std::string_view head = source_->Peek(kHeaderBytes + 4);
    if (head.size() < kHeaderBytes + 4) {
      source_->Fail("is not an STL file: it is shorter than the header");
    }
    const uint64_t num_facets = NumFacets(head);
    source_->Skip(kHeaderBytes + 4);
    const size_t count =
        source_->CheckedCount(num_facets, kFacetBytes, "facets");
    mesh_.corners.reserve(3 * count);
    mesh_.face_begins.reserve(count + 1);
    for (uint64_t facet = 0; facet < num_facets; ++facet) {
      unsigned char bytes[kFacetBytes];
      if (!source_->Read(bytes, kFacetBytes)) {
        source_->Fail(
            fmt::format("facet {}: the file ends here, {} were announced",
                        facet,
                        num_facets));
      }
      for (size_t corner = 0; corner < 3; ++corner) {
        const unsigned char* first = bytes + 12 + 12 * corner;
        AddCorner({LittleEndianFloat(first),
                   LittleEndianFloat(first + 4),
                   LittleEndianFloat(first + 8)},
                  facet);
      }
      mesh_.EndFace();
    }
  }

  static float LittleEndianFloat(const unsigned char* bytes) {
    uint32_t bits = 0;
    for (int i = 3; i >= 0; --i) {
      bits = bits << 8 | bytes[i];
    }
    return std::bit_cast<float>(bits);
  }

  void ReadText() {
    std::string_view line;
    bool in_facet = false;
    bool in_loop = false;
    while (source_->ReadLine(&line)) {
      if (source_->LineNumber() == 1) {
        SkipByteOrderMark(&line);
      }
      const std::string keyword = LowerCase(NextWord(&line));
      if (keyword == "vertex") {
        if (!in_loop) {
          Fail("vertex outside of a loop");
        }
        ParseVertex(&line);
      } else if (keyword == "outer") {
        in_loop = true;
      } else if (keyword == "endloop") {
        in_loop = false;
        mesh_.EndFace();
      } else if (keyword == "facet" || keyword == "endfacet") {
        in_facet = keyword == "facet";
      } else if (keyword != "solid" && keyword != "endsolid" &&
                 keyword != "color" && !keyword.empty()) {
        Fail(fmt::format("unknown keyword \"{}\"", keyword.substr(0, 40)));
      }
    }
    if (in_facet || in_loop) {
      source_->Fail(
          fmt::format("facet {}: the file ends here", mesh_.NumFaces()));
    }
  }

  void ParseVertex(std::string_view* line) {
    Eigen::Vector3d position;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = NextWord(line);
      if (!ParseNumber(word, &position[axis])) {
        Fail(fmt::format("\"{}\" is not a number", word.substr(0, 40)));
      }
    }
    AddCorner(position, mesh_.NumFaces());
  }

  [[noreturn]] void Fail(std::string_view message) const {
    source_->Fail(fmt::format("line {}: {}", source_->LineNumber(), message));
  }

  static std::string LowerCase(std::string_view word) {
    std::string lower(word);
    for (char& c : lower) {
      c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return lower;
  }

  ByteSource* source_;
  PolygonMesh mesh_;
  Welder welder_;
};

}  // namespace

PolygonMesh ReadStl(ByteSource* source, std::vector<std::string>* notes) {
  PolygonMesh mesh = StlParser(source).Run();
  if (mesh.NumFaces() > 0) {
    notes->push_back(
        fmt::format("facets share {} vertices after joining equal ones",
                    mesh.positions.size()));
  }
  return mesh;
}

}  // namespace octacut
