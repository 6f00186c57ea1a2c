#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Rows/RowFlaws.hpp>
#include <Cutwater/Text/LoadFile.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

// A file of cut cells: the head below, then all that is in CutCells in the order of visitRows().
// Arrays have their number of elements before them, as eight bytes, and end at a multiple of eight.

namespace cutwater {

namespace {

/// Raised whenever the meaning of a byte changes.
constexpr std::uint32_t kVersion = 2;
constexpr std::size_t kWord = sizeof(std::uint64_t);

struct FileHead {
  static constexpr std::uint32_t kByteOrder = 0x01020304;
  static constexpr std::uint32_t kOtherByteOrder = 0x04030201;

  std::array<char, 8> magic{'\x89', 'C', 'u', 't', 'C', 'e', 'l', '\x1a'};
  std::uint32_t version = kVersion;
  std::uint32_t byteOrder = kByteOrder;
  std::uint64_t fileBytes = 0;
  std::uint64_t checksum = 0;  ///< of all that follows
};
static_assert(sizeof(FileHead) == 32);

/// Visits all that is in cut cells. What is added to them and not named here does not compile.
template <typename Cells, typename Visit>
void visitRows(Cells& all, Visit&& visit) {
  auto& [grid, cells, pieces, arcs, openArcs, wallParts, patchNames, cellCount, pieceCount, moments,
         arcPolygons, wallPolygons, firstWallPolygon, bodyRuns] = all;
  auto& [planes, first] = grid;
  for (auto& across : planes) visit(across);
  visit(first.i);
  visit(first.j);
  visit(first.k);
  const auto visitEach = [&](auto&... arrays) { (visit(arrays), ...); };
  auto& [index, firstPiece, fluidCorners, meets] = cells;
  visitEach(index, firstPiece, fluidCorners, meets);
  auto& [cell, volume, centroid, wallArea, wallVector, wallCentroid] = pieces;
  visitEach(cell, volume, centroid, wallArea, wallVector, wallCentroid);
  auto& [below, above, area, arcCentroid, arcCell, axis] = arcs;
  visitEach(below, above, area, arcCentroid, arcCell, axis);
  auto& [piece, patch, partArea, vector, partCentroid] = wallParts;
  visitEach(piece, patch, partArea, vector, partCentroid);
  visitEach(patchNames, cellCount, pieceCount);
  auto& [degree, ofVolumes, ofWalls, ofWallVectors, ofArcs] = moments;
  visitEach(degree, ofVolumes, ofWalls, ofWallVectors, ofArcs);
  for (auto* polygons : {&arcPolygons, &wallPolygons}) visitEach(polygons->first, polygons->points);
  visitEach(firstWallPolygon, bodyRuns);
}

/// What follows where there are open patches.
template <typename Cells, typename Visit>
void visitOpenArcs(Cells& all, Visit&& visit) {
  auto& [arc, patch] = all.openArcs;
  visit(arc);
  visit(patch);
}

class RowWriter {
 public:
  RowWriter() : bytes_(sizeof(FileHead)) {}

  template <std::integral Number>
  void operator()(Number number) {
    const auto word = static_cast<std::uint64_t>(std::int64_t(number));
    append(std::as_bytes(std::span(&word, 1)));
  }
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
  [[nodiscard]] std::vector<std::byte> finish() && {
    FileHead head;
    head.fileBytes = bytes_.size();
    head.checksum = checksum(std::span(bytes_).subspan(sizeof(FileHead)));
    std::memcpy(bytes_.data(), &head, sizeof(head));
    return std::move(bytes_);
  }

 private:
  void append(std::span<const std::byte> bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    bytes_.resize((bytes_.size() + kWord - 1) / kWord * kWord);
  }

  std::vector<std::byte> bytes_;
};

[[noreturn]] void refuse(const std::string& why) {
  throw Error(ErrorKind::File, why);
}

void requireUndamaged(bool ok, const char* what) {
  if (!ok) refuse(std::string("the file of cut cells is damaged: ") + what);
}

class RowReader {
 public:
  explicit RowReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <std::integral Number>
  void operator()(Number& number) {
    requireUndamaged(rest_.size() >= kWord, "it ends within a number");
    std::int64_t word = 0;
    std::memcpy(&word, take(kWord).data(), kWord);
    number = static_cast<Number>(word);
    requireUndamaged(static_cast<std::int64_t>(number) == word, "a number is out of its range");
  }
  template <typename Record>
  void operator()(std::vector<Record>& records) {
    records.resize(count(sizeof(Record)));
    copyTo(std::as_writable_bytes(std::span(records)));
  }
  void operator()(std::vector<std::string>& texts) {
    texts.resize(count(kWord));
    for (auto& text : texts) {
      text.resize(count(1));
      copyTo(std::as_writable_bytes(std::span(text)));
    }
  }
  [[nodiscard]] bool isAtEnd() const { return rest_.empty(); }

 private:
  /// Of records of at least so many bytes, which the rest has room for.
  std::size_t count(std::size_t bytes) {
    std::uint64_t count = 0;
    (*this)(count);
    requireUndamaged(count <= rest_.size() / bytes, "it ends within an array");
    return count;
  }
  void copyTo(std::span<std::byte> to) { std::ranges::copy(take(to.size()), to.begin()); }
  /// So many bytes; passes over what fills the last word.
  std::span<const std::byte> take(std::size_t count) {
    const auto bytes = rest_.first(count);
    rest_ = rest_.subspan(count);
    const auto filling = rest_.first(std::min((kWord - count % kWord) % kWord, rest_.size()));
    requireUndamaged(std::ranges::count(filling, std::byte{0}) == std::ssize(filling),
                     "there is something between its arrays");
    rest_ = rest_.subspan(filling.size());
    return bytes;
  }

  std::span<const std::byte> rest_;
};

/// Checks the head against the bytes, and returns what follows it.
std::span<const std::byte> checkedBody(std::span<const std::byte> bytes) {
  FileHead head;
  const auto magic = head.magic;
  if (bytes.empty()) refuse("there is nothing in it");
  std::memcpy(&head, bytes.data(), std::min(bytes.size(), sizeof(head)));
  if (head.magic != magic) refuse("this is no file of cut cells");
  requireUndamaged(bytes.size() >= sizeof(head), "it ends within its head");
  if (head.byteOrder == FileHead::kOtherByteOrder) {
    refuse("the file of cut cells was written on a machine with another byte order");
  }
  if (head.version != kVersion) {
    refuse("the file of cut cells has version " + std::to_string(head.version) +
           ", this library reads version " + std::to_string(kVersion) + ": cut the cells anew");
  }
  requireUndamaged(head.byteOrder == FileHead::kByteOrder, "its head is none");
  requireUndamaged(bytes.size() >= head.fileBytes, "it is shorter than its head tells");
  requireUndamaged(bytes.size() <= head.fileBytes, "it is longer than its head tells");
  const auto body = bytes.subspan(sizeof(head));
  requireUndamaged(checksum(body) == head.checksum, "its checksum is another");
  return body;
}

}  // namespace

std::vector<std::byte> toBytes(const CutCells& cells) {
  if (const auto* const flaw = flawOf(cells)) {
    throw Error(ErrorKind::Argument,
                std::string("toBytes: need cut cells as they are made: ") + flaw);
  }
  RowWriter writer;
  visitRows(cells, writer);
  if (!cells.openArcs.arc.empty()) visitOpenArcs(cells, writer);
  return std::move(writer).finish();
}

CutCells cutCellsFrom(std::span<const std::byte> bytes) {
  CutCells cells;
  RowReader reader(checkedBody(bytes));
  visitRows(cells, reader);
  if (!reader.isAtEnd()) {
    visitOpenArcs(cells, reader);
    requireUndamaged(!cells.openArcs.arc.empty(), "something follows its last array");
  }
  requireUndamaged(reader.isAtEnd(), "something follows its last array");
  const auto* const flaw = flawOf(cells);
  requireUndamaged(flaw == nullptr, flaw);
  return cells;
}

void saveCutCells(const std::filesystem::path& path, const CutCells& cells) {
  const auto bytes = toBytes(cells);
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

CutCells loadCutCells(const std::filesystem::path& path) {
  const auto bytes = text::loadFile(path, std::numeric_limits<std::uint64_t>::max());
  try {
    return cutCellsFrom(std::as_bytes(std::span(bytes.view())));
  } catch (const Error& error) {
    throw Error(error.kind(), path.string() + ": " + error.what());
  }
}

}  // namespace cutwater
