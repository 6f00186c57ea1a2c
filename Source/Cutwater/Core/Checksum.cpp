#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>
#include <vector>

#define XXH_INLINE_ALL  // nothing to link, and no symbol of another version can take its place
#include <xxhash.h>

namespace cutwater {

std::uint64_t xxHash64(std::span<const std::byte> bytes) {
  const std::byte* const data = bytes.data();
  if (data == nullptr) return XXH64("", 0, 0);  // of no bytes
  return XXH64(data, bytes.size(), 0);
}

std::uint64_t checksum(std::span<const std::byte> bytes, int threads) {
  constexpr std::size_t kPiece = std::size_t{1} << 20U;
  std::vector<std::uint64_t> pieces((bytes.size() + kPiece - 1) / kPiece);
  parallelFor(pieces.size(), {.threads = threads}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto rest = bytes.subspan(i * kPiece);
      pieces[i] = xxHash64(rest.first(std::min(kPiece, rest.size())));
    }
  });
  return xxHash64(std::as_bytes(std::span(pieces)));
}

}  // namespace cutwater
