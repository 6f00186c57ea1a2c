#pragma once

#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>

#include <cstring>
#include <vector>

#include "Fuzz.hpp"

// A file of rows as it comes, and once more with its checksum made good: what a forger would do.
// Then numbers may be any, but whatever is asked of the rows has an answer.

namespace cutwater::test {

inline void makeGood(std::span<std::byte> bytes) {
  constexpr std::size_t kHeadBytes = 32;
  constexpr std::size_t kFileBytes = 16;  // where these stand
  constexpr std::size_t kChecksum = 24;
  if (bytes.size() < kHeadBytes) return;
  const std::uint64_t size = bytes.size();
  std::memcpy(bytes.data() + kFileBytes, &size, sizeof(size));
  const std::uint64_t sum = checksum(bytes.subspan(kHeadBytes), 1);
  std::memcpy(bytes.data() + kChecksum, &sum, sizeof(sum));
}

template <typename From, typename Ask>
void readOrRefuseRows(std::span<const std::byte> bytes, const From& from, const Ask& ask) {
  try {
    const auto rows = from(bytes);
    ask(rows);
    expect(std::ranges::equal(toBytes(rows), bytes), "rows give the bytes they came from");
  } catch (const Error& error) {
    expect(error.kind() == ErrorKind::File, "the error's kind");
  }
}

/// Both.
template <typename From, typename Ask>
void readTwice(std::span<const std::uint8_t> data, const From& from, const Ask& ask) {
  const auto given = std::as_bytes(data);
  std::vector<std::byte> bytes(given.begin(), given.end());
  readOrRefuseRows(bytes, from, ask);
  makeGood(bytes);
  readOrRefuseRows(bytes, from, ask);
}

}  // namespace cutwater::test
