#include <Cutwater/Triangles/ExactPredicates.hpp>
#include <Cutwater/Triangles/SurfaceLocation.hpp>

namespace cutwater {

namespace {

Box<double> boxOf(const std::array<Vec3<double>, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  return {min(a, min(b, c)), max(a, max(b, c))};
}

}  // namespace

Segment<double> exitOf(const Box<double>& box, const Vec3<double>& point) {
  Segment<double> exit{point, point};
  double shortest = std::numeric_limits<double>::max();
  for (int axis = 0; axis < 3; ++axis) {
    const double up = box.upper[axis] - point[axis];
    const double down = point[axis] - box.lower[axis];
    if (std::min(up, down) >= shortest) continue;
    shortest = std::min(up, down);
    const double margin = 1 + box.upper[axis] - box.lower[axis];  // any that survives rounding
    exit.end = point;
    exit.end[axis] = up <= down ? box.upper[axis] + margin : box.lower[axis] - margin;
  }
  return exit;
}

template <std::floating_point T>
void visitPassages(const TriangleSurface<T>& surface, const Segment<double>& segment,
                   TrianglesAlong along, FunctionRef<double(std::uint32_t, int)> visit) {
  const auto box = Box<double>{}.extend(segment.start).extend(segment.end);
  double wanted = 1;  // also where a leaf has none
  along(segment, [&](std::span<const std::uint32_t> ids) {
    for (const auto id : ids) {
      if (id == kNone) break;
      const auto triangle = surface.corners(id);
      if (!box.overlaps(boxOf(triangle))) continue;
      if (const int direction = passage(segment, triangle); direction != 0) {
        wanted = visit(id, direction);
      }
    }
    return wanted;
  });
}

template <std::floating_point T>
int windingAlong(const TriangleSurface<T>& surface, const Segment<double>& segment,
                 TrianglesAlong along) {
  int sum = 0;
  visitPassages<T>(surface, segment, along, [&](std::uint32_t, int direction) {
    sum += direction;
    return 1.0;
  });
  return sum;
}

template <std::floating_point T>
SurfaceLocation locate(const TriangleSurface<T>& surface, const Vec3<double>& point,
                       TrianglesAlong along) {
  SurfaceLocation result;
  if (!surface.box.contains(point)) return result;
  result.winding = windingAlong(surface, exitOf(surface.box, point), along);
  const Box<double> here{point, point};
  along({point, point}, [&](std::span<const std::uint32_t> ids) {
    for (const auto id : ids) {
      if (id == kNone) break;
      const auto triangle = surface.corners(id);
      if (here.overlaps(boxOf(triangle)) && isOnTriangle(point, triangle)) result.onSurface = true;
    }
    return 1.0;
  });
  return result;
}

#define CUTWATER_INSTANTIATE(T)                                                                    \
  template int windingAlong(const TriangleSurface<T>&, const Segment<double>&, TrianglesAlong);    \
  template SurfaceLocation locate(const TriangleSurface<T>&, const Vec3<double>&, TrianglesAlong); \
  template void visitPassages(const TriangleSurface<T>&, const Segment<double>&, TrianglesAlong,   \
                              FunctionRef<double(std::uint32_t, int)>);
CUTWATER_INSTANTIATE(float)
CUTWATER_INSTANTIATE(double)
#undef CUTWATER_INSTANTIATE

}  // namespace cutwater
