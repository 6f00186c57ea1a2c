#include <Cutwater/Text/ChunkedBytes.hpp>

#include <algorithm>

namespace cutwater::text {

ChunkedBytes::Chunk ChunkedBytes::next() {
  // Chunks grow with the data read so far, so that their number stays small.
  constexpr std::size_t kSmallest = std::size_t{64} << 10U;
  constexpr std::size_t kLargest = std::size_t{64} << 20U;
  const std::size_t size = std::clamp<std::size_t>(size_ / 8, kSmallest, kLargest);
  parts_.push_back({std::make_unique_for_overwrite<char[]>(size), 0});
  return {parts_.back().data.get(), size};
}

void ChunkedBytes::filled(std::size_t bytes) {
  parts_.back().used = bytes;
  size_ += bytes;
}

std::unique_ptr<char[]> ChunkedBytes::joined() && {
  auto all = std::make_unique_for_overwrite<char[]>(size_);
  char* to = all.get();
  for (auto& part : parts_) {
    to = std::copy_n(part.data.get(), part.used, to);
    part.data.reset();
  }
  return all;
}

}  // namespace cutwater::text
