#include <Cutwater/CutCells/Detail/Tiles/TriangleSplitter.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cutwater {

namespace {

/// The unit of rounding.
constexpr double kU = 0x1p-53;

}  // namespace

void TriangleSplitter::split(const std::array<MovedVertex, 3>& triangle,
                             const std::array<std::uint32_t, 3>& vertices,
                             FunctionRef<void(const Fragment&)> visit) {
  triangle_ = triangle;
  vertices_ = vertices;
  whole_.polygon.size = 0;
  bool isInOneCell = true;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto first = cornerRows_[0][asIndex(axis)];
      auto& row = cornerRows_[i][asIndex(axis)];
      const bool isBeside = i > 0 && isBetweenPlanes(axis, first, triangle[i].position[axis]);
      row = isBeside ? first : rowOf(triangle[i], axis);
      isInOneCell = isInOneCell && row == first;
    }
    whole_.add(triangle[i].position, {.axis = -1, .number = static_cast<int>(i)}, cornerRows_[i]);
  }
  if (isInOneCell) return visitWhole(visit);
  const auto& [a, b, c] = triangle;
  normal_ = abs(cross(b.position - a.position, c.position - a.position));
  size_ = 2 * maxComponent(max(abs(a.position), max(abs(b.position), abs(c.position))));
  divide(whole_, 0, visit);
}

int TriangleSplitter::rowOf(const MovedVertex& corner, int axis) const {
  return planes_.cellAt(axis, corner.position[axis], 0,
                        [&](int plane) { return isAbove(corner, axis, planes_.at(axis, plane)); });
}

bool TriangleSplitter::isBetweenPlanes(int axis, int row, double x) const {
  return row >= 0 && row < planes_.cells(axis) && planes_.at(axis, row) < x &&
         x < planes_.at(axis, row + 1);
}

void TriangleSplitter::visitWhole(FunctionRef<void(const Fragment&)> visit) {
  for (int axis = 0; axis < 3; ++axis) {
    const int row = cornerRows_[0][asIndex(axis)];
    if (row < 0 || row >= planes_.cells(axis)) return;
    whole_.polygon.cell[asIndex(axis)] = row;
  }
  visit(whole_.polygon);
}

/// Divides along this axis and the later ones.
void TriangleSplitter::divide(Part& part, int axis, FunctionRef<void(const Fragment&)> visit) {
  if (axis == 3) return visit(part.polygon);
  int row = part.rows[0][asIndex(axis)];
  int last = row;
  for (int i = 1; i < part.polygon.size; ++i) {
    row = std::min(row, part.rows[asIndex(i)][asIndex(axis)]);
    last = std::max(last, part.rows[asIndex(i)][asIndex(axis)]);
  }
  if (row == last) return take(part, axis, row, visit);
  last = std::min(last, planes_.cells(axis) - 1);
  auto& [below, rests] = work_[asIndex(axis)];
  const Part* rest = &part;
  for (row = std::max(row, -1); row <= last; ++row) {
    auto& above = rest == rests.data() ? rests[1] : rests[0];
    cut(*rest, axis, row + 1, below, above);
    if (below.polygon.size > 0) take(below, axis, row, visit);
    rest = &above;
  }
}

void TriangleSplitter::take(Part& part, int axis, int row,
                            FunctionRef<void(const Fragment&)> visit) {
  if (row < 0 || row >= planes_.cells(axis)) return;
  part.polygon.cell[asIndex(axis)] = row;
  divide(part, axis + 1, visit);
}

/// Divides a part in what is below a plane and what is above it.
void TriangleSplitter::cut(const Part& whole, int axis, int plane, Part& below, Part& above) const {
  below.polygon.size = above.polygon.size = 0;
  below.polygon.cell = above.polygon.cell = whole.polygon.cell;
  const FragmentEdge alongPlane{axis, plane};
  for (int i = 0; i < whole.polygon.size; ++i) {
    const auto& rows = whole.rows[asIndex(i)];
    const auto& edge = whole.polygon.edges[asIndex(i)];
    const bool isHigh = rows[asIndex(axis)] >= plane;
    (isHigh ? above : below).add(whole.polygon.points[asIndex(i)], edge, rows);
    const int next = i + 1 < whole.polygon.size ? i + 1 : 0;
    const bool goesHigh = whole.rows[asIndex(next)][asIndex(axis)] >= plane;
    if (isHigh == goesHigh) continue;
    PointCells there = whole.polygon.cell;
    const auto point = edge.isPlane() ? onLine(edge, alongPlane, goesHigh, there)
                                      : onEdge(edge.number, alongPlane, there);
    there[asIndex(axis)] = plane - 1;
    below.add(point, goesHigh ? alongPlane : edge, there);
    there[asIndex(axis)] = plane;
    above.add(point, goesHigh ? edge : alongPlane, there);
  }
}

/// Where an edge of the triangle meets a plane. `rows` has the cells along axes before the
/// plane's; sets those along axes after it.
Vec3<double> TriangleSplitter::onEdge(int edge, const FragmentEdge& plane, PointCells& rows) const {
  const auto& p = triangle_[asIndex(edge)];
  const auto& q = triangle_[asIndex((edge + 1) % 3)];
  const PlaneAcross crossed{plane.axis, planes_.at(plane.axis, plane.number)};
  const auto point = crossing(edge, crossed);
  for (int axis = plane.axis + 1; axis < 3; ++axis) {
    // Three roundings for the share of the edge, two for the product, one for the sum: 6.
    const double error = 8 * kU * (std::abs(p.position[axis]) + std::abs(q.position[axis]));
    rows[asIndex(axis)] = planes_.cellAt(axis, point[axis], error, [&](int other) {
      return isCrossingAbove(p, q, crossed, {axis, planes_.at(axis, other)});
    });
  }
  return withinCell(point, rows, plane.axis, plane.axis);
}

/// Where the triangle's traces on two planes meet. The part's edge along the first plane goes up
/// or down the second's axis.
Vec3<double> TriangleSplitter::onLine(const FragmentEdge& first, const FragmentEdge& second,
                                      bool goesUp, PointCells& rows) const {
  // Along the trace on the plane to which the triangle is closer to parallel: that on the other
  // one may be as short as rounding.
  const bool isFirst = normal_[first.axis] >= normal_[second.axis];
  const auto& [axis, number] = isFirst ? first : second;
  const auto& other = isFirst ? second : first;
  Vec3<double> shift;  // to where the point is computed
  for (const auto& plane : {first, second}) {
    shift[plane.axis] = planes_.shiftAt(plane.axis, plane.number);
  }
  const auto [from, to] = trace(axis, number, shift);
  const double wanted = planes_.at(other.axis, other.number) - shift[other.axis];
  const double length = to[other.axis] - from[other.axis];
  const double share = length == 0 ? 0.5 : (wanted - from[other.axis]) / length;
  auto point = from + std::clamp(share, 0.0, 1.0) * (to - from);
  point[axis] = planes_.at(axis, number);
  point[other.axis] = planes_.at(other.axis, other.number);

  const int third = 3 - first.axis - second.axis;
  if (third > second.axis) {
    const bool isBelow = rows[asIndex(first.axis)] < first.number;
    rows[asIndex(third)] = rowOnLine(point, third, (to - from)[third] / length, goesUp == isBelow);
  }
  return withinCell(point, rows, first.axis, second.axis);
}
/// The cell along z of a point on a line along z, whose height was computed along a trace that
/// rises by `slope` in z. `facesUp`: whether the moved triangle's normal points up: the edge of a
/// part below a plane x = const then runs up the y axis.
int TriangleSplitter::rowOnLine(const Vec3<double>& point, int axis, double slope,
                                bool facesUp) const {
  // The trace's ends are within 8 u of the size S. The share of the trace is off by 24 u S over
  // its length, and 3 u; the height by that times the rise, and by 12 u S.
  double error = 16 * kU * size_ + 24 * kU * size_ * std::abs(slope);
  if (!(error < size_)) error = size_;
  return planes_.cellAt(axis, point[axis], error, [&](int plane) {
    auto node = point;
    node[axis] = planes_.at(axis, plane);
    return facesUp == (sideOfNode(triangle_, node) < 0);
  });
}

/// The points in which two edges cross a plane; all of it is moved down by a shift.
std::pair<Vec3<double>, Vec3<double>> TriangleSplitter::trace(int axis, int number,
                                                              const Vec3<double>& shift) const {
  const PlaneAcross plane{axis, planes_.at(axis, number) - shift[axis]};
  std::array<Vec3<double>, 2> ends;
  std::size_t count = 0;
  for (int edge = 0; edge < 3 && count < 2; ++edge) {
    const bool isHigh = cornerRows_[asIndex(edge)][asIndex(axis)] >= number;
    const bool goesHigh = cornerRows_[asIndex((edge + 1) % 3)][asIndex(axis)] >= number;
    if (isHigh != goesHigh) ends[count++] = crossing(edge, plane, shift);
  }
  return {ends[0], ends[1]};
}
/// From the end with the lower number, so that both triangles at the edge compute the same.
Vec3<double> TriangleSplitter::crossing(int edge, const PlaneAcross& plane,
                                        const Vec3<double>& shift) const {
  int from = edge;
  int to = (edge + 1) % 3;
  if (vertices_[asIndex(from)] > vertices_[asIndex(to)]) std::swap(from, to);
  const auto p = triangle_[asIndex(from)].position - shift;
  const auto q = triangle_[asIndex(to)].position - shift;
  const double rise = q[plane.axis] - p[plane.axis];
  const double share = rise == 0 ? 0.5 : (plane.position - p[plane.axis]) / rise;
  auto point = max(min(p, q), min(max(p, q), p + share * (q - p)));
  point[plane.axis] = plane.position;
  return point;
}
/// Moves a point by rounding, into its cell along the axes but these two.
Vec3<double> TriangleSplitter::withinCell(Vec3<double> point, const PointCells& rows, int axis,
                                          int second) const {
  for (int other = 0; other < 3; ++other) {
    if (other == axis || other == second) continue;
    const int row = rows[asIndex(other)];
    if (row >= 0) point[other] = std::max(point[other], planes_.at(other, row));
    if (row < planes_.cells(other)) {
      point[other] = std::min(point[other], planes_.at(other, row + 1));
    }
  }
  return point;
}

}  // namespace cutwater
