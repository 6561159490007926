#include "plugin/text_table.h"

#include <algorithm>
#include <utility>

namespace octacut {
namespace {

// Characters, not bytes: all but the continuation bytes of UTF-8.
size_t Width(const std::string& text) {
  return static_cast<size_t>(
      std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
      }));
}

}  // namespace

TextTable::TextTable(std::vector<std::string> heading)
    : rows_{std::move(heading)} {}

void TextTable::AddRow(std::vector<std::string> cells) {
  cells.resize(rows_.front().size());
  rows_.push_back(std::move(cells));
}

std::string TextTable::ToString() const {
  std::vector<size_t> widths(rows_.front().size(), 0);
  size_t total = 0;
  for (size_t column = 0; column < widths.size(); ++column) {
    for (const std::vector<std::string>& row : rows_) {
      widths[column] = std::max(widths[column], Width(row[column]));
    }
    total += widths[column] + (column > 0 ? 2 : 0);
  }
  std::string text;
  for (size_t i = 0; i < rows_.size(); ++i) {
    std::string line;
    for (size_t column = 0; column < widths.size(); ++column) {
      const std::string& cell = rows_[i][column];
      const std::string padding(widths[column] - Width(cell), ' ');
      line += column == 0 ? cell + padding : "  " + padding + cell;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
    if (i == 0) {
      text += std::string(total, '-') + '\n';
    }
  }
  return text;
}

}  // namespace octacut
