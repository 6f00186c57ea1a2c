#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutPeriod.hpp>

#include <algorithm>
#include <array>
#include <cmath>

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
  if (!period.isOn(axis) || !body.isBounded(axis)) return {};
  const auto [first, length] = imagesAlong(body, period, axis);
  return {static_cast<int>(std::ceil(first)), static_cast<int>(std::floor(first + length))};
}

/// The interval of the numbers of images has a whole number in its middle if there is room for an
/// odd one of them, else a half.
double bestStart(const BodySize& body, const CutPeriod& period, int axis) {
  const double count = std::floor(imagesAlong(body, period, axis).length);
  const double middle = std::fmod(count, 2) == 0 ? 0.5 : 0;
  return period.rounded(body.box.center()[axis] +
                        (middle - 0.5 * CutPeriod::kReach) * period.length[axis]);
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

void CutPeriod::startBeside(const BodySize& body) {
  for (int axis = 0; axis < 3; ++axis) {
    if (isOn(axis) && body.isBounded(axis)) start[axis] = bestStart(body, *this, axis);
  }
}

std::vector<Vec3<double>> CutPeriod::imagesOf(const BodySize& body) const {
  const auto [x, y, z] = std::array{rangeAlong(body, *this, 0), rangeAlong(body, *this, 1),
                                    rangeAlong(body, *this, 2)};
  std::vector<Vec3<double>> result;
  for (int k = z.first; k <= z.last; ++k) {
    for (int j = y.first; j <= y.last; ++j) {
      for (int i = x.first; i <= x.last; ++i) {
        result.push_back({i * length.x, j * length.y, k * length.z});
      }
    }
  }
  return result;
}

CutPeriod periodOf(const Box<double>& body, const Vec3<double>& length) {
  CutPeriod period{.length = length};
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    require(length[axis] >= 0 && std::isfinite(length[axis]),
            "cut cells: need a period that is finite and not negative", Named{"axis", axis},
            Named{"period", length[axis]});
    largest = std::max(largest, length[axis]);
    if (!BodySize{body}.isBounded(axis)) continue;
    constexpr double kMostImages = 1000;
    require(length[axis] == 0 || body.upper[axis] - body.lower[axis] <= kMostImages * length[axis],
            "cut cells: need a period that is not so short beside the body", Named{"axis", axis},
            Named{"period", length[axis]});
    largest = std::max({largest, std::abs(body.lower[axis]), std::abs(body.upper[axis])});
  }
  if (!period.isOnAny()) return period;
  period.unit = std::ldexp(1.0, std::ilogb(largest) + 1 - kUnitBits);
  period.length = period.rounded(length);
  return period;
}

}  // namespace cutwater
