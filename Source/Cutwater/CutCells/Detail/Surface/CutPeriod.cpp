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

Vec3<double> rounded(const Vec3<double>& p, const CutPeriod& period) {
  return {period.rounded(p.x), period.rounded(p.y), period.rounded(p.z)};
}

/// A body along each axis, once it is rounded.
struct BodySize {
  Box<double> box;
  Vec3<double> longest;  ///< of its triangles
};
BodySize sizeOf(const PolygonSoup& body, const CutPeriod& period) {
  BodySize result;
  for (std::size_t n = 0; n < body.polygonCount(); ++n) {
    Box<double> triangle;
    for (const auto corner : body.polygon(n)) triangle.extend(rounded(body.points[corner], period));
    result.box.extend(triangle);
    result.longest = max(result.longest, triangle.size());
  }
  return result;
}

/// The images that matter along an axis with a period are those whose numbers lie in this interval.
struct ImageNumbers {
  double first = 0;
  double length = 0;
};
/// Those that a triangle may touch which reaches to where cells are cut: vertices that it shares
/// with them are moved by the triangles of both.
ImageNumbers imagesAlong(const BodySize& body, const CutPeriod& period, int axis) {
  const double length = period.length[axis];
  const double longest = body.longest[axis];
  const double first = period.start[axis] - longest - body.box.upper[axis];
  const double size = body.box.size()[axis] + CutPeriod::kReach * length + 2 * longest;
  return {first / length - kTouchingImages, size / length + 2 * kTouchingImages};
}

struct ImageRange {
  int first = 0;
  int last = 0;
};
ImageRange rangeAlong(const BodySize& body, const CutPeriod& period, int axis) {
  if (!period.isOn(axis)) return {};
  const auto [first, length] = imagesAlong(body, period, axis);
  return {static_cast<int>(std::ceil(first)), static_cast<int>(std::floor(first + length))};
}

/// Where cells are to be cut so that the fewest images matter: the interval of their numbers then
/// has a whole number in its middle if there is room for an odd one of them, else a half.
double bestStart(const BodySize& body, const CutPeriod& period, int axis) {
  const double count = std::floor(imagesAlong(body, period, axis).length);
  const double middle = std::fmod(count, 2) == 0 ? 0.5 : 0;
  return period.rounded(body.box.center()[axis] +
                        (middle - 0.5 * CutPeriod::kReach) * period.length[axis]);
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

CutPeriod periodOf(const PolygonSoup& body, const Vec3<double>& length) {
  const auto box = body.boundingBox();
  CutPeriod period{.length = length, .start = {}};
  double largest = maxComponent(max(abs(box.lower), abs(box.upper)));
  for (int axis = 0; axis < 3; ++axis) {
    require(length[axis] >= 0 && std::isfinite(length[axis]),
            "cut cells: need a period that is finite and not negative", Named{"axis", axis},
            Named{"period", length[axis]});
    constexpr double kMostImages = 1000;
    require(length[axis] == 0 || box.upper[axis] - box.lower[axis] <= kMostImages * length[axis],
            "cut cells: need a period that is not so short beside the body", Named{"axis", axis},
            Named{"period", length[axis]});
    largest = std::max(largest, length[axis]);
  }
  if (!period.isOnAny()) return period;
  period.unit = std::ldexp(1.0, std::ilogb(largest) + 1 - kUnitBits);
  period.length = rounded(length, period);
  const auto size = sizeOf(body, period);
  for (int axis = 0; axis < 3; ++axis) {
    if (period.isOn(axis)) period.start[axis] = bestStart(size, period, axis);
  }
  return period;
}

bool imagesMayTouch(const PolygonSoup& body, const CutPeriod& period) {
  if (!period.isOnAny()) return false;
  const auto size = sizeOf(body, period).box.size();
  for (int axis = 0; axis < 3; ++axis) {
    if (period.isOn(axis) && size[axis] >= period.length[axis]) return true;
  }
  return false;
}

PolygonSoup withImages(const PolygonSoup& body, const CutPeriod& period) {
  PolygonSoup result;
  result.patchNames = body.patchNames;
  const auto size = sizeOf(body, period);
  const auto [x, y, z] = std::array{rangeAlong(size, period, 0), rangeAlong(size, period, 1),
                                    rangeAlong(size, period, 2)};
  for (int k = z.first; k <= z.last; ++k) {
    for (int j = y.first; j <= y.last; ++j) {
      for (int i = x.first; i <= x.last; ++i) {
        const auto first = static_cast<std::uint32_t>(result.points.size());
        const Vec3<double> shift{i * period.length.x, j * period.length.y, k * period.length.z};
        for (const auto& p : body.points) result.points.push_back(rounded(p, period) + shift);
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
