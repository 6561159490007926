// Buffered reading of a stream with the bounds that untrusted counts are
// checked against.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace octacut {

class ByteSource {
 public:
  // `name` is what errors call the source. The stream must outlive it.
  ByteSource(std::istream& stream, std::string name);

  const std::string& Name() const { return name_; }

  // Bytes not consumed yet; of a stream that cannot seek the largest number
  // there is.
  uint64_t Remaining() const;
  bool KnowsSize() const { return knows_size_; }

  // Room to reserve for `count` elements of at least `min_bytes` bytes each.
  // Throws InputError when the source is too short for them; modest where the
  // size is unknown, so that memory grows only with what is really read.
  size_t CheckedCount(uint64_t count,
                      uint64_t min_bytes,
                      std::string_view what) const;

  // Copies `size` bytes, or returns false when fewer are left.
  bool Read(void* out, size_t size) {
    if (end_ - begin_ < size && !Fill(size)) {
      return false;
    }
    std::memcpy(out, buffer_.data() + begin_, size);
    begin_ += size;
    return true;
  }
  bool Skip(uint64_t size);

  // The next bytes without consuming them: at most `size`, fewer at the end.
  std::string_view Peek(size_t size);

  // The next line without its end (LF or CR LF), valid until the next call;
  // false at the end of the source. Lines are counted from 1.
  bool ReadLine(std::string_view* line);
  size_t LineNumber() const { return line_number_; }

  // The next run of characters between white space, valid until the next
  // call; empty at the end of the source.
  std::string_view ReadToken();

  // Throws InputError "<name>: <message>".
  [[noreturn]] void Fail(std::string_view message) const;

 private:
  // Has at least `size` bytes at begin_, if the source still has them.
  bool Fill(size_t size);

  std::istream& stream_;
  std::string name_;
  std::vector<char> buffer_;
  size_t begin_ = 0;
  size_t end_ = 0;
  bool knows_size_ = false;
  uint64_t unread_ = UINT64_MAX;  // of the stream, not in the buffer
  size_t line_number_ = 0;
};

}  // namespace octacut
