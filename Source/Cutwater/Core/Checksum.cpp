#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

namespace cutwater {

namespace {

// The specification's primes.
constexpr std::uint64_t kPrime1 = 0x9E3779B185EBCA87U;
constexpr std::uint64_t kPrime2 = 0xC2B2AE3D27D4EB4FU;
constexpr std::uint64_t kPrime3 = 0x165667B19E3779F9U;
constexpr std::uint64_t kPrime4 = 0x85EBCA77C2B2AE63U;
constexpr std::uint64_t kPrime5 = 0x27D4EB2F165667C5U;

/// The number at `from`, lowest byte first.
template <typename Number>
Number littleEndian(const std::byte* from) {
  std::array<std::byte, sizeof(Number)> raw;
  std::memcpy(raw.data(), from, raw.size());
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
  return std::bit_cast<Number>(raw);
}

constexpr std::uint64_t mixed(std::uint64_t lane, std::uint64_t word) {
  return std::rotl(lane + word * kPrime2, 31) * kPrime1;
}

/// Takes whole stripes of 32 bytes off the front, in four lanes that are independent of each other.
std::uint64_t hashOfStripes(std::span<const std::byte>& rest) {
  std::array<std::uint64_t, 4> lanes{kPrime1 + kPrime2, kPrime2, 0, 0 - kPrime1};
  const std::byte* at = rest.data();
  const std::byte* const end = at + rest.size() / 32 * 32;
  for (; at != end; at += 32) {
    for (std::size_t i = 0; i < 4; ++i) {
      lanes[i] = mixed(lanes[i], littleEndian<std::uint64_t>(at + 8 * i));
    }
  }
  rest = rest.last(rest.size() % 32);
  constexpr std::array kTurns{1, 7, 12, 18};
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < 4; ++i) hash += std::rotl(lanes[i], kTurns[i]);
  for (const auto lane : lanes) hash = (hash ^ mixed(0, lane)) * kPrime1 + kPrime4;
  return hash;
}

std::uint64_t withRest(std::uint64_t hash, std::span<const std::byte> rest) {
  for (; rest.size() >= 8; rest = rest.subspan(8)) {
    hash ^= mixed(0, littleEndian<std::uint64_t>(rest.data()));
    hash = std::rotl(hash, 27) * kPrime1 + kPrime4;
  }
  if (rest.size() >= 4) {
    hash ^= littleEndian<std::uint32_t>(rest.data()) * kPrime1;
    hash = std::rotl(hash, 23) * kPrime2 + kPrime3;
    rest = rest.subspan(4);
  }
  for (const auto byte : rest) {
    hash ^= std::to_integer<std::uint64_t>(byte) * kPrime5;
    hash = std::rotl(hash, 11) * kPrime1;
  }
  return hash;
}

/// Makes every bit of the hash depend on every other.
constexpr std::uint64_t avalanche(std::uint64_t hash) {
  hash = (hash ^ hash >> 33U) * kPrime2;
  hash = (hash ^ hash >> 29U) * kPrime3;
  return hash ^ hash >> 32U;
}

}  // namespace

std::uint64_t xxHash64(std::span<const std::byte> bytes) {
  auto rest = bytes;
  const std::uint64_t hash = bytes.size() >= 32 ? hashOfStripes(rest) : kPrime5;
  return avalanche(withRest(hash + bytes.size(), rest));
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
