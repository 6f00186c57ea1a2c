#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/Detail/SignCells.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

using Place = std::array<std::int32_t, 3>;

/// In cells: places are rounded by far less.
constexpr double kRoom = 0x1p-20;

/// About so many cells are in the surface's box: a byte goes into each, and some microseconds where
/// caps are near.
double cellsFor(std::size_t triangles) {
  constexpr double kFewest = 64;
  constexpr double kMost = 0x1p15;
  return std::clamp(0.5 * static_cast<double>(triangles), kFewest, kMost);
}

}  // namespace

SignCells::SignCells(const Box<double>& surface, std::size_t triangles,
                     std::span<const std::uint8_t> bytes)
    : bytes_(bytes) {
  // A flat one has a few layers of them.
  const double longest = maxComponent(surface.size());
  const auto size = max(surface.size(), 0x1p-6 * Vec3<double>{longest, longest, longest});
  if (!(longest > 0)) return;
  width_ = std::cbrt(size.x * size.y * size.z / cellsFor(triangles));
  perLength_ = 1 / width_;
  // With a layer around the surface's box.
  origin_ = surface.lower - Vec3<double>{width_, width_, width_};
  for (int axis = 0; axis < 3; ++axis) {
    const double inside = std::ceil(surface.size()[axis] * perLength_ + kRoom);
    counts_[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(inside) + 2;
  }
}

std::size_t SignCells::size() const {
  return static_cast<std::size_t>(counts_[0]) * static_cast<std::size_t>(counts_[1]) *
         static_cast<std::size_t>(counts_[2]);
}

std::size_t SignCells::numberOf(const Place& cell) const {
  const auto n = [](std::int32_t i) { return static_cast<std::size_t>(i); };
  return n(cell[0]) + n(counts_[0]) * (n(cell[1]) + n(counts_[1]) * n(cell[2]));
}

Box<double> SignCells::box(const Place& first, const Place& last) const {
  const Vec3<double> lower(first[0], first[1], first[2]);
  const Vec3<double> upper(last[0] + 1, last[1] + 1, last[2] + 1);
  return Box<double>{origin_ + width_ * lower, origin_ + width_ * upper}.grown(kRoom * width_);
}

std::optional<Place> SignCells::cellAt(const Vec3<double>& p) const {
  Place cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const double place = placeOf(p, axis);
    const auto count = counts_[static_cast<std::size_t>(axis)];
    if (!(place >= 0 && place < count)) return {};
    cell[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(place);
  }
  return cell;
}

auto SignCells::at(const Vec3<double>& p) const -> Cell {
  if (bytes_.empty()) return {};
  const auto cell = cellAt(p);
  return cell ? Cell(bytes_[numberOf(*cell)]) : Cell();
}

bool SignCells::isFarFromCaps(const Vec3<double>& p, double distance) const {
  if (bytes_.empty()) return false;
  const auto cell = cellAt(p);
  if (!cell) return false;
  double inner = 1;  // how far the point is from the sides of its own cell
  for (int axis = 0; axis < 3; ++axis) {
    const double within = placeOf(p, axis) - (*cell)[static_cast<std::size_t>(axis)];
    inner = std::min({inner, within, 1 - within});
  }
  const int rings = Cell(bytes_[numberOf(*cell)]).rings();
  return rings > 0 && distance * perLength_ < inner + (rings - 1) - 2 * kRoom;
}

std::optional<int> SignCells::leastInside(const Box<double>& box) const {
  if (bytes_.empty()) return {};
  const auto first = cellAt(box.lower);
  const auto last = cellAt(box.upper);
  if (!first || !last) return {};
  constexpr std::int32_t kMost = 4;  // along an axis
  for (std::size_t a = 0; a < 3; ++a) {
    if ((*last)[a] - (*first)[a] >= kMost) return {};
  }
  const auto result = Cell(bytes_[numberOf(*first)]).leastInside();
  for (auto k = (*first)[2]; k <= (*last)[2]; ++k) {
    for (auto j = (*first)[1]; j <= (*last)[1]; ++j) {
      for (auto i = (*first)[0]; i <= (*last)[0]; ++i) {
        if (Cell(bytes_[numberOf({i, j, k})]).leastInside() != result) return {};
      }
    }
  }
  return result;
}

namespace {

/// Finds out about all cells.
class CellFinder {
 public:
  CellFinder(const SignCells& grid, const SignQueries& queries)
      : grid_(grid), queries_(queries), cells_(grid.size()) {}

  std::vector<std::uint8_t> run() {
    lookAtBlocks();
    countRings();
    for (std::size_t n = 0; n < cells_.size(); ++n) {
      if (cells_[n].isFree() && !cells_[n].winding) spread(n);
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(cells_.size());
    for (const auto& cell : cells_) {
      const int side = !cell.winding || !cell.least ? 0 : *cell.winding >= *cell.least ? -1 : 1;
      bytes.push_back(SignCells::Cell(side, cell.least, cell.rings).byte());
    }
    return bytes;
  }

 private:
  struct Known {
    bool hasCap = false;
    bool hasNoTriangle = false;
    std::optional<int> least;
    std::optional<int> winding;  // of surface and caps, all over it
    int rings = SignCells::Cell::kMostRings;

    [[nodiscard]] bool isFree() const { return hasNoTriangle && !hasCap; }
  };

  [[nodiscard]] Place placeOf(std::size_t number) const {
    const auto& counts = grid_.counts();
    const auto n = static_cast<std::int32_t>(number);
    return {n % counts[0], n / counts[0] % counts[1], n / counts[0] / counts[1]};
  }
  void lookAtBlocks() {
    constexpr std::int32_t kBlock = 8;
    const auto& counts = grid_.counts();
    std::vector<Place> blocks;
    for (std::int32_t k = 0; k < counts[2]; k += kBlock) {
      for (std::int32_t j = 0; j < counts[1]; j += kBlock) {
        for (std::int32_t i = 0; i < counts[0]; i += kBlock) blocks.push_back({i, j, k});
      }
    }
    parallelFor(blocks.size(), {.grain = 1, .progress = {}}, [&](std::size_t begin, std::size_t) {
      Place last{};
      for (std::size_t a = 0; a < 3; ++a) {
        last[a] = std::min(blocks[begin][a] + kBlock, counts[a]) - 1;
      }
      look(blocks[begin], last, {});
    });
  }
  /// At a block of cells of which this is known; at its halves, along each axis, if they may tell
  /// more.
  void look(const Place& first, const Place& last, Known known) {
    const auto box = grid_.box(first, last);
    if (!known.least) known.least = queries_.leastInside(box);
    if (!known.hasNoTriangle) known.hasNoTriangle = !queries_.mayHoldTriangle(box);
    if (first == last || (known.least && known.hasNoTriangle)) {
      known.hasCap = !known.least && queries_.mayHoldCap(box);
      set(first, last, known);
      return;
    }
    for (int part = 0; part < 8; ++part) {
      auto from = first;
      auto to = last;
      bool isPart = true;
      for (std::size_t a = 0; a < 3; ++a) {
        const auto middle = (first[a] + last[a]) / 2;
        const bool isUpper = (part >> a & 1) != 0;
        isPart = isPart && (!isUpper || middle < last[a]);
        (isUpper ? from : to)[a] = isUpper ? middle + 1 : middle;
      }
      if (isPart) look(from, to, known);
    }
  }
  void set(const Place& first, const Place& last, const Known& known) {
    for (auto k = first[2]; k <= last[2]; ++k) {
      for (auto j = first[1]; j <= last[1]; ++j) {
        for (auto i = first[0]; i <= last[0]; ++i) cells_[grid_.numberOf({i, j, k})] = known;
      }
    }
  }
  /// Calls visit(number) for the neighbours across faces, along one axis.
  template <typename Visit>
  void forNeighbours(std::size_t number, std::size_t axis, Visit&& visit) const {
    const auto place = placeOf(number);
    for (const int step : {-1, 1}) {
      auto next = place;
      next[axis] += step;
      if (next[axis] >= 0 && next[axis] < grid_.counts()[axis]) visit(grid_.numberOf(next));
    }
  }
  /// Widens the set of cells with caps by a ring at a time.
  void countRings() {
    std::vector<char> isNear(cells_.size());
    for (std::size_t n = 0; n < cells_.size(); ++n) isNear[n] = cells_[n].hasCap ? 1 : 0;
    for (int rings = 0; rings < SignCells::Cell::kMostRings; ++rings) {
      for (std::size_t n = 0; n < cells_.size(); ++n) {
        if (isNear[n] != 0) cells_[n].rings = std::min(cells_[n].rings, rings);
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto before = isNear;
        for (std::size_t n = 0; n < cells_.size(); ++n) {
          if (before[n] != 0) forNeighbours(n, axis, [&](std::size_t next) { isNear[next] = 1; });
        }
      }
    }
  }
  /// Cells without triangles and caps that join each other have one winding number.
  void spread(std::size_t first) {
    const int winding = queries_.winding(grid_.box(placeOf(first), placeOf(first)).center());
    cells_[first].winding = winding;
    std::vector<std::size_t> pending{first};
    while (!pending.empty()) {
      const auto number = pending.back();
      pending.pop_back();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        forNeighbours(number, axis, [&](std::size_t next) {
          auto& cell = cells_[next];
          if (!cell.isFree() || cell.winding) return;
          cell.winding = winding;
          pending.push_back(next);
        });
      }
    }
  }

  const SignCells& grid_;
  const SignQueries& queries_;
  std::vector<Known> cells_;
};

}  // namespace

std::vector<std::uint8_t> findSignCells(const SignCells& grid, const SignQueries& queries) {
  return CellFinder(grid, queries).run();
}

}  // namespace cutwater
