#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/Io/PointData.hpp>

#include <cstring>
#include <vector>

#include "Fuzz.hpp"

// A file of cut cells as it comes, and once more with its checksum made good: what a forger would
// do. Then numbers may be any, but whatever is asked of the cells has an answer.

namespace cutwater::test {
namespace {

constexpr std::size_t kHeadBytes = 32;
constexpr std::size_t kFileBytes = 16;  // where these stand
constexpr std::size_t kChecksum = 24;

void makeGood(std::span<std::byte> bytes) {
  if (bytes.size() < kHeadBytes) return;
  const std::uint64_t size = bytes.size();
  std::memcpy(bytes.data() + kFileBytes, &size, sizeof(size));
  const std::uint64_t sum = checksum(bytes.subspan(kHeadBytes), 1);
  std::memcpy(bytes.data() + kChecksum, &sum, sizeof(sum));
}

void ask(const CutCells& cells) {
  constexpr std::size_t kMost = 100'000;  // more would only take longer
  const auto box = cells.grid.indices();
  if (box.count() > kMost) return;
  static_cast<void>(check(cells));
  static_cast<void>(coarsened(cells, {1, 1, 1}));
  static_cast<void>(merged(cells, {.smallest = 0.5}));
  if (!cells.firstWallPolygon.empty()) static_cast<void>(cutCellMesh(cells, true));
}

void readOrRefuseCells(std::span<const std::byte> bytes) {
  try {
    const auto cells = cutCellsFrom(bytes);
    ask(cells);
    expect(std::ranges::equal(toBytes(cells), bytes), "cells give the bytes they came from");
  } catch (const Error& error) {
    expect(error.kind() == ErrorKind::File, "the error's kind");
  }
}

}  // namespace
}  // namespace cutwater::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace test = cutwater::test;
  const auto given = std::as_bytes(std::span(data, size));
  std::vector<std::byte> bytes(given.begin(), given.end());
  test::readOrRefuseCells(bytes);
  test::makeGood(bytes);
  test::readOrRefuseCells(bytes);
  return 0;
}
