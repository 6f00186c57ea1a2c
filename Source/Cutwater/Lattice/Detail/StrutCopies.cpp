#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/Detail/StrutCopies.hpp>

#include <algorithm>
#include <unordered_map>

namespace cutwater::detail {

namespace {

/// Nodes of the endless lattice: each kind, in units of the period, occurs in all cells.
class NodeTable {
 public:
  NodeTable(const CellCounts& cells, FunctionRef<std::uint32_t(const Vec3<double>&)> addNode)
      : cells_(cells), addNode_(addNode) {}

  /// Index of the node at this end of a strut of the cell at `place`.
  std::uint32_t nodeAt(const Vec3<double>& end, const Vec3<double>& place) {
    Vec3<double> cell;
    for (int axis = 0; axis < 3; ++axis) cell[axis] = std::floor(end[axis] + UnitCell::kSame);
    const auto kind = kindOf(end - cell);
    const auto there = cell + place;
    const auto [entry, isNew] = known_.try_emplace(keyOf(kind, there), 0);
    if (isNew) entry->second = addNode_(kinds_[kind] + there);
    return entry->second;
  }

 private:
  std::size_t kindOf(const Vec3<double>& inCell) {
    const auto kind = std::ranges::find_if(kinds_, [&](const Vec3<double>& other) {
      return maxComponent(abs(other - inCell)) <= UnitCell::kSame;
    });
    const auto index = kind - kinds_.begin();
    if (kind == kinds_.end()) kinds_.push_back(inCell);
    return static_cast<std::size_t>(index);
  }
  /// The number of a node among all possible ones: struts end in [-1, 2]^3.
  [[nodiscard]] std::uint64_t keyOf(std::size_t kind, const Vec3<double>& cell) const {
    std::uint64_t key = kind;
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const std::int64_t count = cells_.count[i];
      std::int64_t index = std::lround(cell[axis]);
      if (cells_.closed[i]) index = (index % count + count) % count;
      key = key * static_cast<std::uint64_t>(count + 4) + static_cast<std::uint64_t>(index + 1);
    }
    return key;
  }

  CellCounts cells_;
  FunctionRef<std::uint32_t(const Vec3<double>&)> addNode_;
  std::vector<Vec3<double>> kinds_;
  std::unordered_map<std::uint64_t, std::uint32_t> known_;
};

/// Whether a strut with this midpoint is one of the block; those in the last faces of closed rows
/// are also in the first.
bool contains(const CellCounts& cells, const Vec3<double>& middle) {
  for (int axis = 0; axis < 3; ++axis) {
    const double count = cells.count[static_cast<std::size_t>(axis)];
    if (middle[axis] > count + UnitCell::kSame) return false;
  }
  return true;
}

}  // namespace

void requireFewStruts(const char* name, const UnitCell& cell, const CellCounts& cells,
                      std::uint32_t parts) {
  double beams = static_cast<double>(cell.struts().size()) * parts;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    require(cells.count[axis] > 0, (std::string(name) + ": need cells along each axis").c_str(),
            Named{"axis", axis});
    beams *= 1.0 + cells.count[axis];
  }
  if (beams > 0x1p31) {
    throw Error(ErrorKind::Limit, std::string(name) + ": need at most 2^31 beams");
  }
}

void forEachStrut(const UnitCell& cell, const CellCounts& cells,
                  FunctionRef<std::uint32_t(const Vec3<double>&)> addNode,
                  FunctionRef<void(const StrutCopy&)> visit) {
  NodeTable table(cells, addNode);
  // Struts with midpoints in lower faces are those in the upper faces of the previous cells.
  const auto last = [&](std::size_t axis) {
    return cells.count[axis] - (cells.closed[axis] ? 1 : 0);
  };
  for (std::uint32_t z = 0; z <= last(2); ++z) {
    for (std::uint32_t y = 0; y <= last(1); ++y) {
      for (std::uint32_t x = 0; x <= last(0); ++x) {
        const Vec3<double> place{1.0 * x, 1.0 * y, 1.0 * z};
        for (const auto& strut : cell.struts()) {
          if (!contains(cells, strut.middle() + place)) continue;
          const auto a = table.nodeAt(strut.a, place);
          const auto b = table.nodeAt(strut.b, place);
          visit({strut.a + place, strut.b + place, {a, b}});
        }
      }
    }
  }
}

}  // namespace cutwater::detail
