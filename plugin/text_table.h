// A table of words and numbers for a terminal.
#pragma once

#include <string>
#include <vector>

namespace octacut {

class TextTable {
 public:
  explicit TextTable(std::vector<std::string> heading);

  // Adds as many cells as the heading has; missing ones are empty.
  void AddRow(std::vector<std::string> cells);

  // Lines with an end each. The first column is aligned to the left, the
  // others to the right; a rule follows the heading. Widths are those of
  // UTF-8 characters.
  std::string ToString() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace octacut
