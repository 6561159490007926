// Bytes as text that HTML may hold.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace octacut {

// RFC 4648, with padding, in one line.
std::string EncodeBase64(std::span<const uint8_t> bytes);

}  // namespace octacut
