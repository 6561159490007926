#include "colmap_io/mesh/byte_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace octacut {
namespace {

constexpr size_t kBlock = size_t{1} << 18;
// No honest line or word of a mesh file is longer.
constexpr size_t kLongestLine = size_t{1} << 26;
constexpr size_t kModestCount = size_t{1} << 16;

bool IsSpace(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' ||
         c == '\f';
}

}  // namespace

ByteSource::ByteSource(std::istream& stream, std::string name)
    : stream_(stream), name_(std::move(name)), buffer_(kBlock) {
  const std::istream::pos_type here = stream_.tellg();
  if (here == std::istream::pos_type(-1)) {
    stream_.clear();
    return;
  }
  stream_.seekg(0, std::ios::end);
  const std::istream::pos_type end = stream_.tellg();
  stream_.clear();
  stream_.seekg(here);
  if (end != std::istream::pos_type(-1) && end >= here) {
    knows_size_ = true;
    unread_ = static_cast<uint64_t>(end - here);
  }
}

uint64_t ByteSource::Remaining() const {
  return knows_size_ ? unread_ + (end_ - begin_) : UINT64_MAX;
}

size_t ByteSource::CheckedCount(uint64_t count,
                                uint64_t min_bytes,
                                std::string_view what) const {
  // One separator may be missing at the very end of a text file.
  const uint64_t left = Remaining();
  if (min_bytes > 0 && knows_size_ && count > (left + 1) / min_bytes) {
    Fail(fmt::format(
        "{} {} announced, but only {} bytes follow", count, what, left));
  }
  return knows_size_ && min_bytes > 0 ? count
                                      : std::min<uint64_t>(count, kModestCount);
}

bool ByteSource::Fill(size_t size) {
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (buffer_.size() < size) {
    buffer_.resize(std::max(size, 2 * buffer_.size()));
  }
  while (end_ < size && stream_) {
    stream_.read(buffer_.data() + end_,
                 static_cast<std::streamsize>(buffer_.size() - end_));
    const size_t count = static_cast<size_t>(stream_.gcount());
    end_ += count;
    unread_ =
        knows_size_ ? unread_ - std::min<uint64_t>(unread_, count) : unread_;
  }
  if (stream_.bad()) {
    Fail("cannot be read");
  }
  return end_ >= size;
}

bool ByteSource::Skip(uint64_t size) {
  while (size > 0) {
    if (begin_ == end_ && !Fill(1)) {
      return false;
    }
    const size_t step = std::min<uint64_t>(size, end_ - begin_);
    begin_ += step;
    size -= step;
  }
  return true;
}

std::string_view ByteSource::Peek(size_t size) {
  if (end_ - begin_ < size) {
    Fill(size);
  }
  return {buffer_.data() + begin_, std::min(size, end_ - begin_)};
}

bool ByteSource::ReadLine(std::string_view* line) {
  size_t searched = 0;
  while (true) {
    const char* first = buffer_.data() + begin_;
    const void* found =
        std::memchr(first + searched, '\n', end_ - begin_ - searched);
    size_t length = end_ - begin_;
    if (found != nullptr) {
      length = static_cast<size_t>(static_cast<const char*>(found) - first);
      begin_ += length + 1;
    } else {
      if (length >= kLongestLine) {
        Fail(fmt::format("line {} is too long", line_number_ + 1));
      }
      searched = length;
      if (Fill(length + 1)) {
        continue;
      }
      if (length == 0) {
        return false;
      }
      first = buffer_.data() + begin_;
      begin_ += length;
    }
    ++line_number_;
    if (length > 0 && first[length - 1] == '\r') {
      --length;
    }
    *line = {first, length};
    return true;
  }
}

std::string_view ByteSource::ReadToken() {
  while (true) {
    while (begin_ < end_ && IsSpace(buffer_[begin_])) {
      ++begin_;
    }
    if (begin_ < end_ || !Fill(1)) {
      break;
    }
  }
  size_t length = 0;
  while (true) {
    while (begin_ + length < end_ && !IsSpace(buffer_[begin_ + length])) {
      ++length;
    }
    if (length >= kLongestLine) {
      Fail("a word is too long");
    }
    if (begin_ + length < end_ || !Fill(length + 1)) {
      break;
    }
  }
  const std::string_view token(buffer_.data() + begin_, length);
  begin_ += length;
  return token;
}

void ByteSource::Fail(std::string_view message) const {
  throw InputError(fmt::format("{}: {}", name_, message));
}

}  // namespace octacut
