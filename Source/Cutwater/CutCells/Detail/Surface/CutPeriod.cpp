#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutPeriod.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

namespace cutwater {

namespace {

/// Of the largest coordinate in units: planes may be four times as far away. With fewer, triangles
/// in one plane would not stay in it within SheetTree::kNear.
constexpr int kUnitBits = 50;
/// In periods: images that are so near are taken to touch.
constexpr double kTouchingImages = 1e-9;

std::int64_t inUnits(const CutPeriod& period, double x) {
  return static_cast<std::int64_t>(x / period.unit);
}

/// The images along an axis: their first and last number.
std::array<int, 2> imagesAlong(const Box<double>& body, const CutPeriod& period, int axis) {
  if (!period.isOn(axis)) return {0, 0};
  const double length = period.length[axis];
  const double start = period.start[axis];
  auto first = static_cast<int>(std::ceil((start - body.upper[axis]) / length - kTouchingImages));
  auto last = static_cast<int>(std::floor(
      (start + CutPeriod::kReach * length - body.lower[axis]) / length + kTouchingImages));
  // Those that touch these: vertices that they share are to be moved by the triangles of both.
  if (body.upper[axis] - body.lower[axis] >= length) --first, ++last;
  return {first, last};
}

/// Numbers points in the order of their coordinates.
void sortPoints(PolygonSoup& soup) {
  std::vector<std::uint32_t> order(soup.points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::uint32_t n) {
    const auto& p = soup.points[n];
    return std::tuple(p.x, p.y, p.z);
  });
  std::vector<std::uint32_t> numbers(order.size());
  std::vector<Vec3<double>> points(order.size());
  for (std::uint32_t n = 0; n < order.size(); ++n) {
    numbers[order[n]] = n;
    points[n] = soup.points[order[n]];
  }
  soup.points = std::move(points);
  for (auto& corner : soup.corners) corner = numbers[corner];
}

Box<double> roundedBox(const Box<double>& body, const CutPeriod& period) {
  Box<double> box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = period.rounded(body.lower[axis]);
    box.upper[axis] = period.rounded(body.upper[axis]);
  }
  return box;
}

}  // namespace

double CutPeriod::rounded(double x) const {
  return std::nearbyint(x / unit) * unit;
}

bool CutPeriod::has(double x) const {
  return std::abs(x / unit) < 0x1p52 && rounded(x) == x;
}

std::int64_t CutPeriod::periodsTo(int axis, double plane) const {
  const auto way = inUnits(*this, plane) - inUnits(*this, start[axis]);
  const auto each = inUnits(*this, length[axis]);
  return way / each - (way % each < 0 ? 1 : 0);
}

CutPeriod periodOf(const Box<double>& body, const Vec3<double>& length) {
  CutPeriod period{.length = length, .start = {}};
  double largest = maxComponent(max(abs(body.lower), abs(body.upper)));
  for (int axis = 0; axis < 3; ++axis) {
    require(length[axis] >= 0 && std::isfinite(length[axis]),
            "cut cells: need a period that is finite and not negative", Named{"axis", axis},
            Named{"period", length[axis]});
    constexpr double kMostImages = 1000;
    require(length[axis] == 0 || body.upper[axis] - body.lower[axis] <= kMostImages * length[axis],
            "cut cells: need a period that is not so short beside the body", Named{"axis", axis},
            Named{"period", length[axis]});
    largest = std::max(largest, length[axis]);
  }
  if (!period.isOnAny()) return period;
  period.unit = std::ldexp(1.0, std::ilogb(largest) + 1 - kUnitBits);
  for (int axis = 0; axis < 3; ++axis) {
    if (length[axis] == 0) continue;
    period.length[axis] = period.rounded(length[axis]);
    const double size = body.upper[axis] - body.lower[axis];
    const double gap = std::max(period.length[axis] - size, 0.0);
    period.start[axis] = period.rounded(body.lower[axis] - 0.5 * gap);
  }
  return period;
}

bool imagesMayTouch(const Box<double>& body, const CutPeriod& period) {
  const auto box = roundedBox(body, period);
  for (int axis = 0; axis < 3; ++axis) {
    if (period.isOn(axis) && box.upper[axis] - box.lower[axis] >= period.length[axis]) return true;
  }
  return false;
}

PolygonSoup withImages(const PolygonSoup& body, const CutPeriod& period) {
  PolygonSoup result;
  result.patchNames = body.patchNames;
  const auto box = roundedBox(body.boundingBox(), period);
  std::array<std::array<int, 2>, 3> images;
  for (int axis = 0; axis < 3; ++axis) {
    images[static_cast<std::size_t>(axis)] = imagesAlong(box, period, axis);
  }
  for (int k = images[2][0]; k <= images[2][1]; ++k) {
    for (int j = images[1][0]; j <= images[1][1]; ++j) {
      for (int i = images[0][0]; i <= images[0][1]; ++i) {
        const auto first = static_cast<std::uint32_t>(result.points.size());
        const std::array number{i, j, k};
        for (auto p : body.points) {
          for (int axis = 0; axis < 3; ++axis) {
            p[axis] = period.rounded(p[axis]) +
                      number[static_cast<std::size_t>(axis)] * period.length[axis];
          }
          result.points.push_back(p);
        }
        for (std::size_t n = 0; n < body.polygonCount(); ++n) {
          const auto c = body.polygon(n);
          result.addPolygon(std::array{first + c[0], first + c[1], first + c[2]}, body.patches[n]);
        }
      }
    }
  }
  weldExactly(result);
  sortPoints(result);
  return result;
}

}  // namespace cutwater
