#include "colmap_io/mesh/ply_header.h"

#include <fmt/format.h>

#include <optional>

#include "colmap_io/mesh/text_numbers.h"

namespace octacut {
namespace {

std::optional<PlyType> ParseType(std::string_view word) {
  if (word == "char" || word == "int8") return PlyType::kInt8;
  if (word == "uchar" || word == "uint8") return PlyType::kUint8;
  if (word == "short" || word == "int16") return PlyType::kInt16;
  if (word == "ushort" || word == "uint16") return PlyType::kUint16;
  if (word == "int" || word == "int32") return PlyType::kInt32;
  if (word == "uint" || word == "uint32") return PlyType::kUint32;
  if (word == "float" || word == "float32") return PlyType::kFloat32;
  if (word == "double" || word == "float64") return PlyType::kFloat64;
  return std::nullopt;
}

class HeaderParser {
 public:
  explicit HeaderParser(ByteSource* source) : source_(source) {}

  PlyHeader Run() {
    std::string_view line;
    if (source_->Peek(3) != "ply" || !source_->ReadLine(&line) ||
        NextWord(&line) != "ply") {
      source_->Fail(
          "is not a PLY file: it does not begin with the line \"ply\"");
    }
    bool has_format = false;
    while (source_->ReadLine(&line)) {
      const std::string_view keyword = NextWord(&line);
      if (keyword == "end_header") {
        if (!has_format) {
          source_->Fail("header names no format");
        }
        return std::move(header_);
      }
      if (keyword == "format") {
        ParseFormat(&line);
        has_format = true;
      } else if (keyword == "element") {
        ParseElement(&line);
      } else if (keyword == "property") {
        ParseProperty(&line);
      } else if (keyword != "comment" && keyword != "obj_info" &&
                 !keyword.empty()) {
        Fail("unknown keyword", keyword);
      }
    }
    source_->Fail("header has no end");
  }

 private:
  [[noreturn]] void Fail(std::string_view what, std::string_view word) const {
    source_->Fail(fmt::format(
        "header line {}: {} \"{}\"", source_->LineNumber(), what, word));
  }

  void ParseFormat(std::string_view* line) {
    const std::string_view word = NextWord(line);
    if (word == "ascii") {
      header_.encoding = PlyEncoding::kAscii;
    } else if (word == "binary_little_endian") {
      header_.encoding = PlyEncoding::kBinaryLittleEndian;
    } else if (word == "binary_big_endian") {
      header_.encoding = PlyEncoding::kBinaryBigEndian;
    } else {
      Fail("unknown format", word);
    }
  }

  void ParseElement(std::string_view* line) {
    PlyElement element;
    element.name = NextWord(line);
    const std::string_view count = NextWord(line);
    if (element.name.empty() || !ParseNumber(count, &element.count)) {
      Fail("bad element count", count);
    }
    header_.elements.push_back(std::move(element));
  }

  PlyType ParseTypeWord(std::string_view* line) {
    const std::string_view word = NextWord(line);
    const std::optional<PlyType> type = ParseType(word);
    if (!type) {
      Fail("unknown property type", word);
    }
    return *type;
  }

  void ParseProperty(std::string_view* line) {
    if (header_.elements.empty()) {
      Fail("property before any element", *line);
    }
    PlyProperty property;
    std::string_view ahead = *line;
    if (NextWord(&ahead) == "list") {
      *line = ahead;
      property.is_list = true;
      property.count_type = ParseTypeWord(line);
    }
    property.type = ParseTypeWord(line);
    property.name = NextWord(line);
    if (property.name.empty()) {
      Fail("property without a name", "");
    }
    header_.elements.back().properties.push_back(std::move(property));
  }

  ByteSource* source_;
  PlyHeader header_;
};

}  // namespace

size_t PlyTypeSize(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat32:
      return 4;
    case PlyType::kFloat64:
      return 8;
  }
  return 0;
}

uint64_t PlyElement::MinBytes(PlyEncoding encoding) const {
  if (encoding == PlyEncoding::kAscii) {
    return 2 * properties.size();  // a digit and a separator
  }
  uint64_t size = 0;
  for (const PlyProperty& property : properties) {
    size += PlyTypeSize(property.is_list ? property.count_type : property.type);
  }
  return size;
}

PlyHeader ReadPlyHeader(ByteSource* source) {
  return HeaderParser(source).Run();
}

}  // namespace octacut
