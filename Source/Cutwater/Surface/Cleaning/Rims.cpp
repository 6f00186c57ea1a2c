#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>
#include <Cutwater/Surface/Cleaning/Rims.hpp>

#include <utility>

namespace cutwater {

std::vector<Rim> findRims(const PolygonSoup& soup) {
  soup.validate();
  std::vector<Rim> rims;
  for (auto& loop : detail::loopsAround(detail::openEdgesOf(soup))) {
    Rim rim{.points = std::move(loop), .box = {}};
    for (const auto point : rim.points) rim.box.extend(soup.points[point]);
    rims.push_back(std::move(rim));
  }
  return rims;
}

std::optional<AxisPlane> planeOf(const Rim& rim, double tolerance) {
  const Vec3<double> size = rim.box.size();
  const int axis = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  if (!(size[axis] <= 2 * tolerance)) return {};
  return AxisPlane{axis, size[axis] == 0 ? rim.box.lower[axis] : rim.box.center()[axis]};
}

}  // namespace cutwater
