#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Surface/Detail/IndexTable.hpp>
#include <Cutwater/Surface/Detail/PointMerging.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cutwater {
namespace {

/// The points that are kept, in cells of twice the tolerance. Points within the tolerance of a
/// given one are in at most eight cells, and no cell holds more than a few, as they are far enough
/// apart.
class KeptPoints {
 public:
  KeptPoints(std::span<const Vec3<double>> points, double tolerance)
      : points_(points), tolerance_(tolerance), next_(points.size(), kNone) {
    double largest = 0;
    for (const auto& p : points) largest = std::max(largest, maxComponent(abs(p)));
    // Quotients by the cell's size stay finite, however small the tolerance.
    cell_ = std::max(2 * tolerance, 0x1p-1000 * largest);
    scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(tolerance), -1022, 1022));
  }

  /// The distance between two points, without overflow or underflow where it is about the
  /// tolerance.
  [[nodiscard]] double distance(std::uint32_t i, std::uint32_t j) const {
    return scaledDistance(i, j) / scale_;
  }

  /// The first of the kept points within the tolerance; kNone if there is none.
  [[nodiscard]] std::uint32_t firstNear(std::uint32_t i) const {
    const auto [xs, xCount] = cellsAround(points_[i].x);
    const auto [ys, yCount] = cellsAround(points_[i].y);
    const auto [zs, zCount] = cellsAround(points_[i].z);
    std::uint32_t first = kNone;
    for (std::size_t x = 0; x < xCount; ++x) {
      for (std::size_t y = 0; y < yCount; ++y) {
        for (std::size_t z = 0; z < zCount; ++z) {
          for (auto j = headOf({xs[x], ys[y], zs[z]}); j != kNone; j = next_[j]) {
            if (j < first && scaledDistance(i, j) <= scale_ * tolerance_) first = j;
          }
        }
      }
    }
    return first;
  }

  void keep(std::uint32_t i) {
    const auto head = heads_.findOrInsert(
        i, [&](std::uint32_t j) { return detail::hashOf(cellOf(j)); },
        [&](std::uint32_t j) { return cellOf(j) == cellOf(i); });
    if (head != i) next_[i] = std::exchange(next_[head], i);
  }

 private:
  struct Cells {
    std::array<double, 3> at;
    std::size_t count;
  };

  [[nodiscard]] double scaledDistance(std::uint32_t i, std::uint32_t j) const {
    return length(scale_ * (points_[i] - points_[j]));
  }

  [[nodiscard]] Vec3<double> cellOf(std::uint32_t i) const {
    const auto& p = points_[i];
    return {std::floor(p.x / cell_), std::floor(p.y / cell_), std::floor(p.z / cell_)};
  }

  /// Where coordinates are too large to resolve the cell size, these cells coincide; points that
  /// differ are then farther apart than the tolerance.
  [[nodiscard]] Cells cellsAround(double coordinate) const {
    const double own = coordinate / cell_;
    constexpr double kReach = 0.5001;  // the tolerance plus rounding
    const double last = std::floor(own + kReach);
    Cells cells{{std::floor(own - kReach)}, 1};
    while (cells.at[cells.count - 1] < last && cells.count < 3) {
      cells.at[cells.count] = cells.at[cells.count - 1] + 1;
      ++cells.count;
    }
    return cells;
  }

  [[nodiscard]] std::uint32_t headOf(const Vec3<double>& cell) const {
    return heads_.lookUp(detail::hashOf(cell), [&](std::uint32_t j) { return cellOf(j) == cell; });
  }

  std::span<const Vec3<double>> points_;
  double tolerance_;
  double cell_ = 1;
  double scale_ = 1;
  detail::IndexTable heads_;         // the first point of each cell
  std::vector<std::uint32_t> next_;  // the next point of the same cell
};

}  // namespace

Correction weldWithin(PolygonSoup& soup, double tolerance) {
  require(tolerance > 0 && std::isfinite(tolerance), "weldWithin: need 0 < tolerance < infinity",
          Named{"tolerance", tolerance});
  const auto& points = soup.points;
  require(points.size() < kNone, "weldWithin: more points than 32-bit indices can name",
          Named{"points", points.size()});
  Correction correction;
  KeptPoints kept(points, tolerance);
  std::vector<std::uint32_t> firsts(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    require(isFinite(points[i]), "weldWithin: points must be finite", Named{"point", points[i]});
    const auto first = kept.firstNear(i);
    firsts[i] = first == kNone ? i : first;
    if (first == kNone) {
      kept.keep(i);
    } else {
      correction.add(points[i], kept.distance(i, first));
    }
  }
  detail::mergePoints(soup, firsts);
  return correction;
}

}  // namespace cutwater
