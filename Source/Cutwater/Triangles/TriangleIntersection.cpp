#include <Cutwater/Triangles/ExactPredicates.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace cutwater {

namespace {

using CornerIds = std::array<std::uint32_t, 3>;
using Points = std::array<Vec3<double>, 3>;

/// Reorders both triangles so that shared corners come first, in the same order. No test below
/// depends on the orientation of a triangle.
std::size_t bringSharedToFront(CornerIds& a, CornerIds& b) {
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = shared; j < 3; ++j) {
      if (a[i] != b[j]) continue;
      std::swap(a[shared], a[i]);
      std::swap(b[shared], b[j]);
      ++shared;
      break;
    }
  }
  return shared;
}

/// An axis along which the triangle can be projected, and its orientation there; 0 without area.
struct Projection {
  int axis = 0;
  int turn = 0;
};

/// Tries the axis first along which the triangle seems largest.
Projection projection(const Points& t) {
  const Vec3<double> normal = abs(cross(t[1] - t[0], t[2] - t[0]));
  const int best = normal.x >= normal.y && normal.x >= normal.z ? 0 : normal.y >= normal.z ? 1 : 2;
  for (const int axis : {best, (best + 1) % 3, (best + 2) % 3}) {
    if (const int turn = crossSign(t[0], t[1], t[0], t[2], axis); turn != 0) return {axis, turn};
  }
  return {};
}

/// Whether, in the projection, an edge of `a` has all of `b` strictly on its far side, except for
/// the shared corners, which lie on it. The two then have only these in common. Cheap; decides
/// nearly all neighbours, and the coplanar ones without exact arithmetic.
bool edgeSeparates(const Points& a, Projection view, const Points& b, std::size_t shared) {
  const auto [axis, turn] = view;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const bool holdsShared = shared == 0 || i == 0 || (shared == 1 && j == 0);
    bool separates = holdsShared;
    for (std::size_t k = shared; separates && k < 3; ++k) {
      separates = crossSign(a[i], a[j], a[i], b[k], axis) == -turn;
    }
    if (separates) return true;
  }
  return false;
}

/// The side of the plane for each corner; for corners shared with the plane's triangle it is known.
std::array<int, 3> sidesOf(const Points& triangle, const Points& plane, std::size_t shared) {
  std::array<int, 3> sides{};
  for (std::size_t i = shared; i < 3; ++i) {
    sides[i] = orientation(plane[0], plane[1], plane[2], triangle[i]);
  }
  return sides;
}

/// Whether no corner but the shared ones touches the plane, and all lie on one side.
bool areApart(const std::array<int, 3>& sides, std::size_t shared) {
  return sides[2] != 0 && sides[1] == sides[2] && (shared == 1 || sides[0] == sides[2]);
}

/// Whether a segment in the plane of the triangle meets it. Two convex figures are disjoint if an
/// edge of one has the other strictly on its far side, here in a projection.
bool meetInPlane(const Vec3<double>& p, const Vec3<double>& q, const Points& t) {
  const auto [axis, turn] = projection(t);
  const int first = crossSign(p, q, p, t[0], axis);
  if (first != 0 && first == crossSign(p, q, p, t[1], axis) &&
      first == crossSign(p, q, p, t[2], axis)) {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& a = t[i];
    const auto& b = t[(i + 1) % 3];
    if (crossSign(a, b, a, p, axis) == -turn && crossSign(a, b, a, q, axis) == -turn) return false;
  }
  return true;
}

/// Whether the segment from p to q, whose ends lie on these sides of the triangle's plane, meets
/// it.
bool meet(const Vec3<double>& p, int sideOfP, const Vec3<double>& q, int sideOfQ, const Points& t) {
  if (sideOfP == 0 && sideOfQ == 0) return meetInPlane(p, q, t);
  if (sideOfP == sideOfQ) return false;
  // The line crosses the plane at one point, which lies in the closed triangle unless the line
  // passes two edges on different sides.
  int seen = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = orientation(p, q, t[i], t[(i + 1) % 3]);
    if (side != 0 && seen == -side) return false;
    if (side != 0) seen = side;
  }
  return true;
}

/// Whether an edge of `a` meets `b`. With a shared corner, tests only the edge opposite to it.
bool edgesMeet(const Points& a, const std::array<int, 3>& sides, const Points& b,
               std::size_t shared) {
  if (shared == 1) return meet(a[1], sides[1], a[2], sides[2], b);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (meet(a[i], sides[i], a[j], sides[j], b)) return true;
  }
  return false;
}

/// Whether, in the plane of the triangle, an edge has all these points beyond it or on its line.
bool anEdgeKeepsOut(const Points& t, std::span<const Vec3<double>> points) {
  const auto [axis, turn] = projection(t);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& a = t[i];
    const auto& b = t[(i + 1) % 3];
    const auto isOut = [&, view = axis, inward = turn](const Vec3<double>& p) {
      return crossSign(a, b, a, p, view) != inward;
    };
    if (std::ranges::all_of(points, isOut)) return true;
  }
  return false;
}

/// Whether corners of the triangle lie on both sides of a line in its plane.
bool isDividedBy(const Vec3<double>& p, const Vec3<double>& q, const Points& t) {
  const int axis = projection(t).axis;
  std::array<int, 3> sides{};
  for (std::size_t i = 0; i < 3; ++i) sides[i] = crossSign(p, q, p, t[i], axis);
  return std::ranges::count(sides, 1) > 0 && std::ranges::count(sides, -1) > 0;
}

/// Whether the triangle contains, not on its edges, a point of what `b` has in its plane. `sides`:
/// of the corners of `b`. A corner or an edge; what is in the plane while `b` passes through it is
/// left to spansOverlap().
bool containsOf(const Points& a, const Points& b, const std::array<int, 3>& sides) {
  std::array<Vec3<double>, 3> inPlane;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (sides[i] == 0) inPlane[count++] = b[i];
  }
  if (count == 0 || anEdgeKeepsOut(a, std::span(inPlane).first(count))) return false;
  // Convex figures in a plane are apart if the line of an edge of one of them separates them.
  if (count == 1) return true;
  return count == 2 ? isDividedBy(inPlane[0], inPlane[1], a) : !anEdgeKeepsOut(b, a);
}

bool isOnBothSides(const std::array<int, 3>& sides) {
  return std::ranges::count(sides, 1) > 0 && std::ranges::count(sides, -1) > 0;
}

/// Brings a corner to the front that is alone on its side; there are corners on both. Returns its
/// side.
int bringLoneToFront(Points& t, const std::array<int, 3>& sides) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (sides[i] == 0 || std::ranges::count(sides, sides[i]) > 1) continue;
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(i), t.end());
    return sides[i];
  }
  return 0;
}

/// Whether the spans in which two triangles, each on both sides of the other's plane, meet the line
/// of both planes overlap in more than a point: P. Guigue and O. Devillers, "Fast and robust
/// triangle-triangle overlap test using orientation predicates", J. Graph. Tools 8 (2003).
bool spansOverlap(Points a, const std::array<int, 3>& sidesOfA, Points b,
                  const std::array<int, 3>& sidesOfB) {
  const int sideOfA = bringLoneToFront(a, sidesOfA);
  const int sideOfB = bringLoneToFront(b, sidesOfB);
  // Each first corner is to be before the other's plane.
  if (sideOfA < 0) std::swap(b[1], b[2]);
  if (sideOfB < 0) std::swap(a[1], a[2]);
  return orientation(a[1], b[0], a[0], b[1]) < 0 && orientation(a[0], b[0], a[2], b[2]) < 0;
}

/// 1 if a point lies above a triangle along an axis, -1 if below; 0 if it is beside it, or on it.
int orderOf(const Points& t, const Vec3<double>& p, int axis) {
  const int turn = crossSign(t[0], t[1], t[0], t[2], axis);
  for (std::size_t i = 0; i < 3; ++i) {
    if (crossSign(t[i], t[(i + 1) % 3], t[i], p, axis) == -turn) return 0;
  }
  return turn * orientation(t[0], t[1], t[2], p);
}

/// 1 if (r, s) passes above (p, q), -1 if below; 0 if beside it, or through it.
int orderOf(const Vec3<double>& p, const Vec3<double>& q, const Vec3<double>& r,
            const Vec3<double>& s, int axis) {
  if (crossSign(p, q, p, r, axis) * crossSign(p, q, p, s, axis) > 0) return 0;
  if (crossSign(r, s, r, p, axis) * crossSign(r, s, r, q, axis) > 0) return 0;
  return -crossSign(p, q, r, s, axis) * orientation(p, q, r, s);
}

}  // namespace

bool meetWithin(const Points& a, const Points& b) {
  const auto sidesOfA = sidesOf(a, b, 0);
  const auto sidesOfB = sidesOf(b, a, 0);
  if (isOnBothSides(sidesOfA) && isOnBothSides(sidesOfB)) {
    return spansOverlap(a, sidesOfA, b, sidesOfB);
  }
  return containsOf(a, b, sidesOfB) || containsOf(b, a, sidesOfA);
}

bool hasArea(const std::array<Vec3<double>, 3>& triangle) {
  return projection(triangle).turn != 0;
}

bool intersect(std::span<const Vec3<double>> positions, const std::array<std::uint32_t, 3>& a,
               const std::array<std::uint32_t, 3>& b) {
  CornerIds ca = a;
  CornerIds cb = b;
  const std::size_t shared = bringSharedToFront(ca, cb);
  if (shared == 3) return true;
  // Triangles that meet do so in a convex set. If it has an end on the rim of one of them, an edge
  // of that one meets the other. With a shared corner, a further common point lies, as seen from
  // there, before the opposite edge of each; where the ray to it leaves the first of them, it is in
  // both.
  const Points ta{positions[ca[0]], positions[ca[1]], positions[ca[2]]};
  const Points tb{positions[cb[0]], positions[cb[1]], positions[cb[2]]};
  const Projection view = projection(ta);
  if (edgeSeparates(ta, view, tb, shared)) return false;
  // Their common edge does not separate them: if they lie in one plane, they are folded over.
  if (shared == 2) return orientation(ta[0], ta[1], ta[2], tb[2]) == 0;
  const int turn = crossSign(tb[0], tb[1], tb[0], tb[2], view.axis);
  if (turn != 0 && edgeSeparates(tb, {view.axis, turn}, ta, shared)) return false;
  const auto sidesOfB = sidesOf(tb, ta, shared);
  if (areApart(sidesOfB, shared)) return false;
  const auto sidesOfA = sidesOf(ta, tb, shared);
  if (areApart(sidesOfA, shared)) return false;
  return edgesMeet(ta, sidesOfA, tb, shared) || edgesMeet(tb, sidesOfB, ta, shared);
}

int orderAlong(const Points& a, const Points& b, int axis) {
  // Where one is above the other is convex; if it has an end that is no corner, edges cross there.
  for (const auto& p : b) {
    if (const int order = orderOf(a, p, axis); order != 0) return order;
  }
  for (const auto& p : a) {
    if (const int order = orderOf(b, p, axis); order != 0) return -order;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const int order = orderOf(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3], axis);
      if (order != 0) return order;
    }
  }
  return 0;
}

bool areFartherApart(const std::array<Vec3<double>, 3>& a, const std::array<Vec3<double>, 3>& b,
                     double distance) {
  // Of heights above a plane through the origin with a normal of length 1.
  constexpr double kRounding = 0x1p-48;
  const auto isBetween = [&](const Vec3<double>& normal) {
    const auto heights = [&](const std::array<Vec3<double>, 3>& t) {
      return std::array{dot(normal, t[0]), dot(normal, t[1]), dot(normal, t[2])};
    };
    const auto ofA = std::ranges::minmax(heights(a));
    const auto ofB = std::ranges::minmax(heights(b));
    const double room = std::max(ofB.min - ofA.max, ofA.min - ofB.max);
    return room > (distance + kRounding) * length(normal) && room > 0x1p-200;
  };
  const std::array edgesOfA{a[1] - a[0], a[2] - a[1], a[0] - a[2]};
  const std::array edgesOfB{b[1] - b[0], b[2] - b[1], b[0] - b[2]};
  const auto normalOfA = cross(edgesOfA[0], edgesOfA[1]);
  const auto normalOfB = cross(edgesOfB[0], edgesOfB[1]);
  if (isBetween(normalOfA) || isBetween(normalOfB)) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (isBetween(cross(normalOfA, edgesOfA[i])) || isBetween(cross(normalOfB, edgesOfB[i]))) {
      return true;
    }
    for (std::size_t j = 0; j < 3; ++j) {
      if (isBetween(cross(edgesOfA[i], edgesOfB[j]))) return true;
    }
  }
  return false;
}

}  // namespace cutwater
