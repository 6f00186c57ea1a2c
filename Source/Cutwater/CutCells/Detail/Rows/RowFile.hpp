// Private: how rows lie in a file: the head below, then all that they have in the order of a visit.
// Arrays have their number of elements before them, as eight bytes, and end at a multiple of eight.
#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/Text/LoadFile.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace cutwater {

/// What tells files of one kind of rows from others.
struct RowFileKind {
  std::array<char, 8> magic;
  std::uint32_t version = 0;  ///< raised whenever the meaning of a byte changes
  const char* rows = "";      ///< what errors call them, after "cut"
};

struct RowFileHead {
  static constexpr std::uint32_t kByteOrder = 0x01020304;

  std::array<char, 8> magic{};
  std::uint32_t version = 0;
  std::uint32_t byteOrder = kByteOrder;
  std::uint64_t fileBytes = 0;
  std::uint64_t checksum = 0;  ///< of all that follows
};
static_assert(sizeof(RowFileHead) == 32);

/// What lies in a file is a multiple of so many bytes.
inline constexpr std::size_t kRowWord = sizeof(std::uint64_t);

class RowWriter {
 public:
  RowWriter() : bytes_(sizeof(RowFileHead)) {}

  template <std::integral Number>
  void operator()(Number number) {
    const auto word = static_cast<std::uint64_t>(std::int64_t(number));
    append(std::as_bytes(std::span(&word, 1)));
  }
  void operator()(double number) { append(std::as_bytes(std::span(&number, 1))); }
  template <typename Record>
  void operator()(const std::vector<Record>& records) {
    static_assert(std::is_trivially_copyable_v<Record>);
    (*this)(records.size());
    append(std::as_bytes(std::span(records)));
  }
  void operator()(const std::vector<std::string>& texts) {
    (*this)(texts.size());
    for (const auto& text : texts) {
      (*this)(text.size());
      append(std::as_bytes(std::span(text)));
    }
  }
  /// The bytes with their head.
  [[nodiscard]] std::vector<std::byte> finish(const RowFileKind& kind) &&;

 private:
  void append(std::span<const std::byte> bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    bytes_.resize((bytes_.size() + kRowWord - 1) / kRowWord * kRowWord);
  }

  std::vector<std::byte> bytes_;
};

class RowReader {
 public:
  /// @throws Error(File) unless the head is one of this kind, and what follows is undamaged.
  RowReader(std::span<const std::byte> bytes, const RowFileKind& kind);

  template <std::integral Number>
  void operator()(Number& number) {
    const auto word = static_cast<std::int64_t>(nextWord());
    number = static_cast<Number>(word);
    need(static_cast<std::int64_t>(number) == word, "a number is out of its range");
  }
  void operator()(double& number) { number = std::bit_cast<double>(nextWord()); }
  template <typename Record>
  void operator()(std::vector<Record>& records) {
    records.resize(count(sizeof(Record)));
    copyTo(std::as_writable_bytes(std::span(records)));
  }
  void operator()(std::vector<std::string>& texts) {
    texts.resize(count(kRowWord));
    for (auto& text : texts) {
      text.resize(count(1));
      copyTo(std::as_writable_bytes(std::span(text)));
    }
  }
  /// @throws Error(File) unless all was read, and nothing is wrong with the rows.
  void finish(const char* flaw) const {
    need(rest_.empty(), "something follows its last array");
    need(flaw == nullptr, flaw);
  }

 private:
  /// @throws Error(File) if not ok.
  void need(bool ok, const char* what) const;
  std::uint64_t nextWord();
  /// Of records of at least so many bytes, which the rest has room for.
  std::size_t count(std::size_t bytes);
  void copyTo(std::span<std::byte> to) { std::ranges::copy(take(to.size()), to.begin()); }
  /// So many bytes; passes over what fills the last word.
  std::span<const std::byte> take(std::size_t count);

  RowFileKind kind_;
  std::span<const std::byte> rest_;
};

/// What cells and leaves have alike. What is added to it and not named here does not compile.
template <typename Pieces, typename Visit>
void visitPieces(Pieces& pieces, Visit&& visit) {
  auto& [cell, volume, centroid, wallArea, wallVector, wallCentroid, wallFaces] = pieces;
  visit(cell);
  visit(volume);
  visit(centroid);
  visit(wallArea);
  visit(wallVector);
  visit(wallCentroid);
  visit(wallFaces);
}
template <typename OpenArcs, typename Visit>
void visitOpenArcs(OpenArcs& openArcs, Visit&& visit) {
  auto& [arc, patch] = openArcs;
  visit(arc);
  visit(patch);
}
template <typename WallParts, typename Visit>
void visitWallParts(WallParts& wallParts, Visit&& visit) {
  auto& [piece, patch, area, vector, centroid] = wallParts;
  visit(piece);
  visit(patch);
  visit(area);
  visit(vector);
  visit(centroid);
}
template <typename Rows, typename Visit>
void visitOnRequest(Rows& all, Visit&& visit) {
  auto& [degree, ofVolumes, ofWalls, ofWallVectors, ofArcs] = all.moments;
  visit(degree);
  visit(ofVolumes);
  visit(ofWalls);
  visit(ofWallVectors);
  visit(ofArcs);
  for (auto* polygons : {&all.arcPolygons, &all.wallPolygons}) {
    auto& [first, points] = *polygons;
    visit(first);
    visit(points);
  }
  visit(all.firstWallPolygon);
  auto& [ofPieces, ofPieceWalls, wallNormals, ofOpenParts] = all.quadrature;
  for (auto* rows : {&ofPieces, &ofPieceWalls, &ofOpenParts}) {
    auto& [first, points, weights] = *rows;
    visit(first);
    visit(points);
    visit(weights);
  }
  visit(wallNormals);
}

/// Writes bytes to a file that appears under its name only once it is complete.
void saveRows(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// What from(bytes) makes of a file; errors name it.
template <typename From>
auto loadRows(const std::filesystem::path& path, From from) {
  const auto bytes = text::loadFile(path, std::numeric_limits<std::uint64_t>::max());
  try {
    return from(std::as_bytes(std::span(bytes.view())));
  } catch (const Error& error) {
    throw Error(error.kind(), path.string() + ": " + error.what());
  }
}

}  // namespace cutwater
