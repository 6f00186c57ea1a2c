// The list of unresolved features against its definition: every cell of a mesh against every
// triangle, in rational numbers.

#include <Cutwater/Grid/Detail/OctreeSigns.hpp>
#include <Cutwater/Grid/UnresolvedFeatures.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include <map>
#include <set>

#include <CGAL/Gmpq.h>

#include "Oracle/CgalOracle.hpp"
#include "Oracle/Nasties.hpp"
#include "Support/Clipping.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

using Rational = CGAL::Gmpq;
using ExactPoint = std::array<Rational, 3>;
using Kinds = std::map<std::size_t, UnresolvedKind>;

ExactPoint exactly(const Vec3<double>& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

/// The triangles of a surface and the sides of points, by definition.
class PlainSurface {
 public:
  PlainSurface(const PolygonSoup& soup, bool isLarge) {
    if (isLarge) {
      const auto oracle = std::make_shared<CgalOracle>(soup);
      EXPECT_TRUE(oracle->boundsSolid());
      isInside_ = [oracle](const Vec3<double>& p) { return oracle->isInside(p); };
    } else {
      const auto oracle = std::make_shared<WindingOracle>(soup);
      isInside_ = [oracle](const Vec3<double>& p) { return oracle->side(p) == Side::Inside; };
    }
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      auto& triangle = triangles_.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) triangle[k] = soup.points[soup.polygon(i)[k]];
    }
  }

  struct Meeting {
    bool isWithin = false;  // some of the surface is in the open cell
    bool isAtFace = false;  // ... is in the closed cell and on one of its faces
  };
  [[nodiscard]] Meeting meeting(const Box<double>& cell) const {
    Meeting result;
    const auto lower = exactly(cell.lower);
    const auto upper = exactly(cell.upper);
    forTriangles(cell, [&](const Triangle& triangle) {
      std::vector<ExactPoint> part{exactly(triangle[0]), exactly(triangle[1]),
                                   exactly(triangle[2])};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        part = clipped(clipped(part, axis, lower[axis], 1), axis, upper[axis], -1);
      }
      if (part.empty()) return;
      bool isWithin = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        // Of a convex polygon, the mean of the corners is beyond a plane if anything is.
        Rational sum = 0;
        for (const auto& p : part) {
          sum += p[axis];
          if (p[axis] == lower[axis] || p[axis] == upper[axis]) result.isAtFace = true;
        }
        const Rational count(static_cast<int>(part.size()));
        isWithin = isWithin && sum > count * lower[axis] && sum < count * upper[axis];
      }
      result.isWithin = result.isWithin || isWithin;
    });
    return result;
  }

  /// How often the side changes along an edge of a cell; points of the surface are outside, of
  /// which those that are alone do not count.
  std::size_t changes(const Vec3<double>& from, const Vec3<double>& to, int axis) {
    std::vector<Rational> breaks{Rational(from[axis]), Rational(to[axis])};
    forTriangles({from, to}, [&](const Triangle& t) { addBreaks(t, from, axis, breaks); });
    std::sort(breaks.begin(), breaks.end());
    bool isInside = isInsideOf(from);
    std::size_t count = 0;
    const auto see = [&](const Vec3<double>& p) {
      const bool here = isInsideOf(p);
      count += here != isInside ? 1 : 0;
      isInside = here;
    };
    for (std::size_t i = 1; i < breaks.size(); ++i) {
      if (breaks[i - 1] < Rational(from[axis]) || breaks[i] > Rational(to[axis])) continue;
      auto middle = from;
      middle[axis] = CGAL::to_double((breaks[i - 1] + breaks[i]) / 2);
      if (breaks[i - 1] < Rational(middle[axis]) && Rational(middle[axis]) < breaks[i]) see(middle);
    }
    see(to);
    return count;
  }
  bool isInsideOf(const Vec3<double>& p) {
    const auto [known, isNew] = sides_.try_emplace({p.x, p.y, p.z});
    if (isNew) known->second = isInside_(p);
    return known->second;
  }

 private:
  using Triangle = std::array<Vec3<double>, 3>;

  template <typename Visit>
  void forTriangles(const Box<double>& box, const Visit& visit) const {
    for (const auto& triangle : triangles_) {
      Box<double> around;
      for (const auto& corner : triangle) around.extend(corner);
      if (around.overlaps(box)) visit(triangle);
    }
  }
  /// Where a line along an axis may enter or leave a triangle or its plane; perhaps elsewhere, too.
  static void addBreaks(const Triangle& triangle, const Vec3<double>& onLine, int axis,
                        std::vector<Rational>& breaks) {
    const auto x = static_cast<std::size_t>(axis);
    const auto p = exactly(onLine);
    const std::array corners{exactly(triangle[0]), exactly(triangle[1]), exactly(triangle[2])};
    ExactPoint normal;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto u = (k + 1) % 3;
      const auto v = (k + 2) % 3;
      normal[k] = (corners[1][u] - corners[0][u]) * (corners[2][v] - corners[0][v]) -
                  (corners[1][v] - corners[0][v]) * (corners[2][u] - corners[0][u]);
    }
    if (normal[x] != 0) {
      Rational height = 0;
      for (std::size_t k = 0; k < 3; ++k) height += normal[k] * (corners[0][k] - p[k]);
      breaks.push_back(p[x] + height / normal[x]);
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& a = corners[i];
      const auto& b = corners[(i + 1) % 3];
      breaks.push_back(a[x]);
      for (const auto other : {(x + 1) % 3, (x + 2) % 3}) {
        if (a[other] == b[other]) continue;
        breaks.push_back(a[x] + (p[other] - a[other]) / (b[other] - a[other]) * (b[x] - a[x]));
      }
    }
  }

  std::vector<Triangle> triangles_;
  std::function<bool(const Vec3<double>&)> isInside_;
  std::map<std::array<double, 3>, bool> sides_;  // that are known
};

/// Whether steps along edges lead from one of these corners to all others.
bool areConnected(const std::set<int>& corners) {
  std::set<int> reached;
  std::vector<int> open(corners.begin(), corners.empty() ? corners.end() : ++corners.begin());
  while (!open.empty()) {
    const int corner = open.back();
    open.pop_back();
    if (!reached.insert(corner).second) continue;
    for (const int step : {1, 2, 4}) {
      if (corners.contains(corner ^ step)) open.push_back(corner ^ step);
    }
  }
  return reached == corners;
}

std::optional<UnresolvedKind> kindOf(PlainSurface& surface, const Box<double>& cell,
                                     const PlainSurface::Meeting& meeting) {
  if (!meeting.isWithin && !meeting.isAtFace) return {};
  std::array<std::set<int>, 2> corners;  // outside and inside
  for (int i = 0; i < 8; ++i) corners[surface.isInsideOf(cell.corner(i)) ? 1 : 0].insert(i);
  std::size_t most = 0;
  for (int i = 0; i < 8; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const int to = i | 1 << axis;
      if (to != i) most = std::max(most, surface.changes(cell.corner(i), cell.corner(to), axis));
    }
  }
  if (corners[0].empty() || corners[1].empty()) {
    // Corners on the surface are outside: all of the solid behind them may be lost.
    const bool isLost = surface.isInsideOf(cell.center()) != corners[0].empty();
    if (!meeting.isWithin && !isLost) return {};
    return most > 0 || !meeting.isAtFace ? UnresolvedKind::Thin : UnresolvedKind::Grazing;
  }
  if (most > 1 || !areConnected(corners[0]) || !areConnected(corners[1])) {
    return UnresolvedKind::MultiCut;
  }
  return {};
}

struct Case {
  const char* name;
  PolygonSoup soup;
  std::size_t fewest = 1;  ///< unresolved cells
  bool isLarge = false;
  int level = 3;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

PolygonSoup placed(const PolygonSoup& soup, double scale, const Vec3<double>& at) {
  return withPoints(soup, [&](const Vec3<double>& p) { return scale * p + at; });
}

/// Tips on the axes, exactly.
PolygonSoup octahedron(double radius, const Vec3<double>& at) {
  const auto rounded = [](const Vec3<double>& p) {
    return Vec3<double>{std::round(p.x), std::round(p.y), std::round(p.z)};
  };
  return placed(withPoints(bipyramid(4), rounded), radius, at);
}

/// Into the domain's middle.
PolygonSoup centred(const PolygonSoup& soup, double size) {
  const auto box = soup.boundingBox();
  const double scale = size / maxComponent(box.size());
  return placed(soup, scale, -scale * box.center());
}

class UnresolvedCellsTest : public ::testing::TestWithParam<Case> {};

TEST_P(UnresolvedCellsTest, AreAllThatTheirDefinitionNames) {
  const auto soup = triangulated(GetParam().soup);
  PlainSurface surface(soup, GetParam().isLarge);
  const MeshSDF<double> solid(soup);
  ASSERT_EQ(solid.guarantee().outside, Quality::Exact);
  const OctreeDomain<double> domain({-1, -1, -1}, 0.5, {4, 4, 4});
  const Octree<double> mesh(solid, domain, {.cut = GetParam().level});
  Kinds expected;
  for (std::size_t n = 0; n < mesh.cells().size(); ++n) {
    const auto& cell = mesh.cells()[n];
    const auto meeting = surface.meeting(mesh.box(cell));
    if (meeting.isWithin) {
      EXPECT_TRUE(mayBeCut(cell.kind)) << n;
    } else if (!meeting.isAtFace) {
      // Whether the surface meets a cell within rounding may stay open.
      const auto around = mesh.box(cell).grown(16 * std::numeric_limits<double>::epsilon());
      if (cell.kind == BoxClass::Unknown && surface.meeting(around).isWithin) continue;
      const bool isInside = surface.isInsideOf(mesh.center(cell));
      EXPECT_EQ(cell.kind, isInside ? BoxClass::Inside : BoxClass::Outside) << n;
    }
    if (const auto kind = kindOf(surface, mesh.box(cell), meeting)) expected[n] = *kind;
  }
  Kinds found;
  for (const auto& feature : unresolvedFeatures(solid, mesh)) found[feature.cell] = feature.kind;
  EXPECT_GE(expected.size(), GetParam().fewest);
  EXPECT_EQ(found, expected);
}

INSTANTIATE_TEST_SUITE_P(
    Surfaces, UnresolvedCellsTest,
    ::testing::Values(
        // Cells are 1/16 wide. A hundredth of one: between nodes, on nodes, and turned.
        Case{"PlateBetweenNodes", tessellation::box({-0.7, -0.6, 0.02}, {0.7, 0.6, 0.020625}), 400},
        Case{"PlateOnNodes", tessellation::box({-0.75, -0.5, 0.125}, {0.75, 0.5, 0.125625}), 300},
        Case{"TurnedPlate",
             moved(tessellation::box({-0.5, -0.4, -0.0003}, {0.5, 0.4, 0.0003}), anyPlacement()),
             100},
        Case{"Needle",
             centred(moved(stretched(tetrahedron(), {1, 1e-3, 2e-3}), anyPlacement()), 1.1), 30},
        Case{"StarOfNeedles", placed(starOfNeedles(), 0.6, {0.01, 0.02, 0.03}), 100},
        Case{"Wedge", centred(moved(wedge(0.02), anyPlacement()), 1.3), 20},
        Case{"TwoBallsAlmostTouching",
             together(placed(tessellation::icosphere(0.4, 2), 1, {-0.40031, 0.011, 0.017}),
                      placed(tessellation::icosphere(0.4, 2), 1, {0.40031, 0.011, 0.017})),
             1},
        // Tips at nodes, in the middle of an edge and of a face.
        Case{"TipsAtNodes", octahedron(0.25, {0, 0, 0}), 0},
        Case{"TipsAtEdges", octahedron(0.25, {0.03125, 0, 0}), 0},
        Case{"TipsAtFaces", octahedron(0.25, {0.03125, 0.03125, 0}), 0},
        Case{"TipsBehindFaces", octahedron(0.25 + 1e-9, {0.03125, 0.03125, 0}), 1},
        Case{"FacesInFacesOfCells", tessellation::box({-0.5, -0.25, 0}, {0.25, 0.5, 0.0625}), 144},
        Case{"CellWithinACell", tessellation::box({0.01, 0.01, 0.01}, {0.05, 0.05, 0.05}), 1},
        Case{"Fin", centred(moved(triangulated(fin(0.003)), anyPlacement()), 1.4), 20},
        Case{"Gap", centred(moved(gap(0.003), anyPlacement()), 1.4), 20},
        Case{"Eight", centred(readSurface(CUTWATER_CGAL_MESHES "/eight.off").soup, 1.7), 1, true}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace cutwater::test
