#pragma once

#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutCells.hpp>

#include <cstring>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "Support/FileRefusal.hpp"

namespace cutwater::test {

/// The bytes of the head of a file of rows.
inline constexpr std::size_t kHead = 32;

template <typename Number>
void put(std::vector<std::byte>& bytes, std::size_t at, Number number) {
  std::memcpy(bytes.data() + at, &number, sizeof(number));
}

/// Forges the checksum.
inline void makeGood(std::vector<std::byte>& bytes) {
  put(bytes, 24, checksum(std::span(bytes).subspan(kHead)));
}

/// The rows that cells and leaves have alike.
template <typename Cut>
void expectSameRows(const Cut& a, const Cut& b) {
  EXPECT_EQ(a.pieces.cell, b.pieces.cell);
  EXPECT_EQ(a.pieces.volume, b.pieces.volume);
  EXPECT_EQ(a.pieces.centroid, b.pieces.centroid);
  EXPECT_EQ(a.pieces.wallArea, b.pieces.wallArea);
  EXPECT_EQ(a.pieces.wallVector, b.pieces.wallVector);
  EXPECT_EQ(a.pieces.wallCentroid, b.pieces.wallCentroid);
  EXPECT_EQ(a.pieces.wallFaces, b.pieces.wallFaces);
  EXPECT_EQ(a.arcs.below, b.arcs.below);
  EXPECT_EQ(a.arcs.above, b.arcs.above);
  EXPECT_EQ(a.arcs.area, b.arcs.area);
  EXPECT_EQ(a.arcs.centroid, b.arcs.centroid);
  EXPECT_EQ(a.arcs.axis, b.arcs.axis);
  EXPECT_EQ(a.wallParts.piece, b.wallParts.piece);
  EXPECT_EQ(a.wallParts.patch, b.wallParts.patch);
  EXPECT_EQ(a.wallParts.area, b.wallParts.area);
  EXPECT_EQ(a.wallParts.vector, b.wallParts.vector);
  EXPECT_EQ(a.wallParts.centroid, b.wallParts.centroid);
  EXPECT_EQ(a.patchNames, b.patchNames);
  EXPECT_EQ(a.moments.degree, b.moments.degree);
  EXPECT_EQ(a.moments.volume, b.moments.volume);
  EXPECT_EQ(a.moments.wall, b.moments.wall);
  EXPECT_EQ(a.moments.wallVector, b.moments.wallVector);
  EXPECT_EQ(a.moments.arc, b.moments.arc);
  EXPECT_EQ(a.firstWallPolygon, b.firstWallPolygon);
  EXPECT_EQ(a.arcPolygons.first, b.arcPolygons.first);
  EXPECT_EQ(a.arcPolygons.points, b.arcPolygons.points);
  EXPECT_EQ(a.wallPolygons.first, b.wallPolygons.first);
  EXPECT_EQ(a.wallPolygons.points, b.wallPolygons.points);
}

/// That a file cannot be read with any bit changed; take(bytes) reads it.
template <typename Take>
void expectEveryBitCounts(std::vector<std::byte> bytes, const Take& take) {
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      bytes[at] ^= std::byte{1} << bit;
      EXPECT_NE(fileRefusal([&] { return take(bytes); }), "") << "bit " << bit << " of byte " << at;
      bytes[at] ^= std::byte{1} << bit;
    }
  }
  EXPECT_EQ(fileRefusal([&] { return take(bytes); }), "");
}

/// That what was cut off at any place, or is followed by more, is refused.
template <typename Take>
void expectNeedsItsLength(const std::vector<std::byte>& bytes, const Take& take) {
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_NE(fileRefusal([&] { return take(std::span(bytes).first(size)); }), "") << size;
  }
  for (const std::size_t more : {1U, 8U, 100U}) {
    auto longer = bytes;
    longer.resize(bytes.size() + more);
    EXPECT_TRUE(fileRefusal([&] {
                  return take(longer);
                }).ends_with("is damaged: it is longer than its head tells"));
  }
}

/// Puts words of all kinds in the place of others, and makes the checksum good: take(bytes) must
/// refuse that, or return what ask() can do anything with.
template <typename Take, typename Ask>
void expectForgeriesAreSafe(const std::vector<std::byte>& intact, int rounds, const Take& take,
                            const Ask& ask) {
  std::mt19937_64 random(5);
  std::size_t refused = 0;
  std::size_t taken = 0;
  const auto tryWith = [&](std::size_t at, std::uint64_t word) {
    auto bytes = intact;
    put(bytes, at, word);
    makeGood(bytes);
    try {
      const auto rows = take(bytes);
      ++taken;
      ask(rows);
    } catch (const Error& error) {
      ++refused;
      EXPECT_EQ(error.kind(), ErrorKind::File) << error.what();
    }
  };
  const auto words = (intact.size() - kHead) / 8;
  for (int n = 0; n < rounds; ++n) {
    const auto at = kHead + 8 * (random() % words);
    std::uint64_t before = 0;
    std::memcpy(&before, intact.data() + at, sizeof(before));
    for (const auto word : {std::uint64_t{0}, ~std::uint64_t{0}, before + 1, before - 1,
                            before ^ (std::uint64_t{1} << 32U), std::uint64_t{random()}}) {
      tryWith(at, word);
    }
  }
  const auto enough = static_cast<std::size_t>(rounds) / 2;
  EXPECT_GT(refused, enough);
  EXPECT_GT(taken, enough);  // most of these have another digit in a number
}

/// What toBytes() says of rows once something in them is changed.
template <typename Cut, typename Change>
std::string flawAfter(Cut cut, const Change& change) {
  change(cut);
  try {
    static_cast<void>(toBytes(cut));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Argument);
    const std::string message = error.what();
    return message.substr(message.rfind(": ") + 2);
  }
  return "";
}

}  // namespace cutwater::test
