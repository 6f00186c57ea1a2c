#include <Cutwater/CutCells/Detail/Surface/PeriodicSoup.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace cutwater {

namespace {

/// Of the body once it is rounded.
BodySize sizeOf(const PolygonSoup& body, const CutPeriod& period) {
  BodySize result;
  for (std::size_t n = 0; n < body.polygonCount(); ++n) {
    Box<double> triangle;
    for (const auto corner : body.polygon(n)) triangle.extend(period.rounded(body.points[corner]));
    result.box.extend(triangle);
    result.longest = max(result.longest, triangle.size());
  }
  return result;
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

CutPeriod periodOf(const PolygonSoup& body, const Vec3<double>& length) {
  auto period = periodOf(body.boundingBox(), length);
  if (period.isOnAny()) period.startBeside(sizeOf(body, period));
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
  for (const auto& shift : period.imagesOf(sizeOf(body, period))) {
    const auto first = static_cast<std::uint32_t>(result.points.size());
    for (const auto& p : body.points) result.points.push_back(period.rounded(p) + shift);
    for (std::size_t n = 0; n < body.polygonCount(); ++n) {
      const auto c = body.polygon(n);
      result.addPolygon(std::array{first + c[0], first + c[1], first + c[2]}, body.patches[n]);
    }
  }
  weldExactly(result);
  sortPoints(result);
  return result;
}

}  // namespace cutwater
