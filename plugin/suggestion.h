// "Did you mean": the known name nearest to a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace octacut {

// Number of single-character insertions, deletions, replacements and swaps of
// neighbours that turn `a` into `b` (optimal string alignment).
size_t EditDistance(std::string_view a, std::string_view b);

// The candidate nearest to `name`, or an empty string when none is near: at
// most a third of the characters may differ. A name without its group
// ("hull_level" for "OctahedralMeshing.hull_level") counts as near, too.
std::string NearestName(std::string_view name,
                        std::span<const std::string> candidates);

}  // namespace octacut
