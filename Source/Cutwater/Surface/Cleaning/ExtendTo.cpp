#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlanarRegions.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlanarView.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlaneFrame.hpp>
#include <Cutwater/Surface/Cleaning/Detail/RimWalls.hpp>
#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>
#include <Cutwater/Surface/Cleaning/ExtendTo.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cutwater {
namespace {

using detail::Loop;

void requireBeyond(const PolygonSoup& soup, int axis, double level) {
  require(0 <= axis && axis < 3, "extendTo: the axis is 0, 1 or 2", Named{"axis", axis});
  const auto box = soup.boundingBox();
  const double lower = box.lower[axis];
  const double upper = box.upper[axis];
  require(std::isfinite(level) && (level < lower || level > upper),
          "extendTo: the level must lie beyond the surface", Named{"level", level},
          Named{"lowest", lower}, Named{"highest", upper});
}

struct SurfaceRims {
  std::vector<OpenEdge> edges;
  std::vector<Loop> loops;
};

SurfaceRims rimsOf(const PolygonSoup& soup) {
  auto edges = detail::openEdgesOf(soup);
  if (edges.empty()) throw Error(ErrorKind::Topology, "extendTo: the surface has no rim");
  for (const auto& edge : edges) {
    if (std::abs(edge.multiplicity) == 1) continue;
    throw Error(ErrorKind::Topology,
                "extendTo: faces disagree about their orientation along an edge (" +
                    detail::toText(Named{"from", soup.points[edge.lower]}) + ")");
  }
  auto loops = detail::loopsAround(edges);
  return {std::move(edges), std::move(loops)};
}

/// Per rim: the connected part of the surface that it belongs to.
std::vector<std::uint32_t> partsAt(const SurfaceRims& rims, const PolygonSoup& soup) {
  const auto parts = detail::partsOf(soup);
  std::vector<std::uint32_t> result;
  for (const auto& loop : rims.loops) {
    const std::pair<std::uint32_t, std::uint32_t> ends = std::minmax(loop[0], loop[1]);
    const auto edge = std::ranges::lower_bound(
        rims.edges, ends, {}, [](const OpenEdge& e) { return std::pair(e.lower, e.upper); });
    result.push_back(parts[edge->triangle]);
  }
  return result;
}

/// Fills the loops; throws if one cannot be filled.
detail::PlanarFilling filled(const PolygonSoup& soup, std::span<const Loop> loops, int axis) {
  auto filling = detail::fillLoops(soup.points, loops, axis);
  const auto left = std::ranges::find(filling.left, true) - filling.left.begin();
  if (static_cast<std::size_t>(left) < loops.size()) {
    const auto& point = soup.points[loops[static_cast<std::size_t>(left)].front()];
    throw Error(ErrorKind::Topology,
                "extendTo: a rim meets itself or another, seen along the axis (" +
                    detail::toText(Named{"rim", point}) + ")");
  }
  return filling;
}

/// Throws if a rim lies amid the region of another and is not a hole of the same part.
void requireApart(const PolygonSoup& soup, std::span<const Loop> rims,
                  std::span<const std::uint32_t> parts, const detail::PlanarFilling& filling) {
  for (std::size_t i = 0; i < rims.size(); ++i) {
    const auto parent = filling.parents[i];
    if (parent == kNone || filling.isHole[parent]) continue;
    if (filling.isHole[i] && parts[i] == parts[parent]) continue;
    throw Error(ErrorKind::Topology,
                "extendTo: one part of the surface lies above another, seen along the axis (" +
                    detail::toText(Named{"rim", soup.points[rims[i].front()]}) + ")");
  }
}

/// Throws if a face from `firstAdded` on meets another in more than what they share.
void requireClear(const PolygonSoup& soup, std::size_t firstAdded) {
  const auto triangulation = triangulate(soup);
  auto triangles = detail::indicesOf(triangulation.triangles);
  const auto added =
      std::ranges::lower_bound(triangulation.polygons, firstAdded) - triangulation.polygons.begin();
  // Pairs are found in ascending order: what is added comes first.
  const auto surface = std::rotate(triangles.begin(), triangles.begin() + added, triangles.end());
  const auto found = findSelfIntersections<double>(soup.points, triangles, {.limit = 1});
  if (!found) return;
  const auto& [first, second] = found.pairs.examples.front();
  if (index(first) >= static_cast<std::size_t>(surface - triangles.begin())) return;
  throw Error(ErrorKind::Topology,
              "extendTo: walls or apron would meet the surface, which hangs over or under a rim (" +
                  detail::toText(Named{"near", soup.points[triangles[index(second)][0]]}) + ")");
}

/// Turns shells outward; throws if that leaves faces on the level that face the surface.
void turnOutward(PolygonSoup& soup, std::size_t firstOnLevel, int axis, bool isBelow) {
  orientFaces(soup);
  const auto positions = normalizedPositions(soup.points, soup.corners);
  const detail::PlanarView view(positions, axis);
  for (std::size_t i = firstOnLevel; i < soup.polygonCount(); ++i) {
    const auto corners = soup.polygon(i);
    if (view.turn(corners[0], corners[1], corners[2]) != (isBelow ? 1 : -1)) continue;
    throw Error(ErrorKind::Topology,
                "extendTo: parts that touch disagree about their orientation (" +
                    detail::toText(Named{"foot", soup.points[corners[0]]}) + ")");
  }
}

/// `firstAdded`: the first face that is not part of the given surface.
void addWallsAndBottom(PolygonSoup& soup, std::size_t firstAdded, int axis, double level,
                       const ExtendOptions& options, OpeningReport& report) {
  requireBeyond(soup, axis, level);
  const auto rims = rimsOf(soup);
  const auto parts = partsAt(rims, soup);
  const auto sides = detail::patchNamed(soup, options.sides);
  detail::RimWalls walls(soup, axis, level);
  std::vector<Loop> feet;
  for (const auto& rim : rims.loops) {
    report.closed.add(soup.points[rim.front()]);
    report.rimEdges += rim.size();
    feet.push_back(walls.add(rim, sides));
  }
  const auto filling = filled(soup, feet, axis);
  requireApart(soup, rims.loops, parts, filling);
  requireClear(soup, firstAdded);
  const auto bottom = detail::patchNamed(soup, options.bottom);
  const std::size_t firstOnLevel = soup.polygonCount();
  for (const auto& triangle : filling.triangles) soup.addPolygon(triangle, bottom);
  turnOutward(soup, firstOnLevel, axis, level < soup.points[rims.loops.front().front()][axis]);
}

/// Works on a copy, and reports the result.
template <typename Work>
OpeningReport extended(PolygonSoup& soup, Work work) {
  soup.validate();
  PolygonSoup result = soup;
  OpeningReport report;
  report.before = measure(soup);
  work(result, report);
  report.facesAdded = result.polygonCount() - soup.polygonCount();
  report.areaAdded = detail::areaFrom(result, soup.polygonCount());
  report.after = measure(result);
  result.validate();
  soup = std::move(result);
  return report;
}

/// A flat strip between the outer rim and the sides of the box.
class Apron {
 public:
  Apron(PolygonSoup& soup, const Box<double>& box, int axis)
      : soup_(soup), box_(box), u_((axis + 1) % 3), v_((axis + 2) % 3), axis_(axis) {}

  void add(const std::string& patchName) {
    const auto rims = rimsOf(soup_).loops;
    const Loop& outer = outermost(rims);
    for (const auto point : outer) requireWithin(soup_.points[point]);
    const auto frame = frameAround(outer);
    const auto patch = detail::patchNamed(soup_, patchName);
    for (const auto& triangle : filled(soup_, std::array{frame, outer}, axis_).triangles) {
      soup_.addPolygon(triangle, patch);
    }
  }

 private:
  /// The rim that surrounds all others; throws if none does.
  [[nodiscard]] const Loop& outermost(std::span<const Loop> rims) const {
    const auto parents = filled(soup_, rims, axis_).parents;
    const auto first = std::ranges::find(parents, kNone);
    const auto second = std::find(first + 1, parents.end(), kNone);
    if (second == parents.end()) return rims[static_cast<std::size_t>(first - parents.begin())];
    const Loop& other = rims[static_cast<std::size_t>(second - parents.begin())];
    throw Error(ErrorKind::Topology,
                "extendToBox: no rim surrounds all others, seen along the axis: use extendTo() for "
                "separate parts (" +
                    detail::toText(Named{"rim", soup_.points[other.front()]}) + ")");
  }

  void requireWithin(const Vec3<double>& p) const {
    if (box_.lower[u_] < p[u_] && p[u_] < box_.upper[u_] && box_.lower[v_] < p[v_] &&
        p[v_] < box_.upper[v_]) {
      return;
    }
    throw Error(
        ErrorKind::Topology,
        "extendToBox: the rim reaches the sides of the box: use extendTo(), or a larger box (" +
            detail::toText(Named{"rim", p}) + ")");
  }

  /// New points along the four sides, in the direction opposite to the rim's.
  Loop frameAround(const Loop& rim) {
    const Vec3<double> size = box_.upper - box_.lower;
    const double step = meanEdge(rim);
    const std::array<std::pair<int, double>, 4> sides{
        {{u_, size[u_]}, {v_, size[v_]}, {u_, -size[u_]}, {v_, -size[v_]}}};
    Vec3<double> corner = box_.lower;
    Loop frame;
    for (const auto& [along, extent] : sides) {
      const auto count =
          static_cast<int>(std::clamp(std::ceil(std::abs(extent) / step), 1.0, kMostPerSide));
      for (int i = 0; i < count; ++i) {
        Vec3<double> point = corner;
        point[along] += extent * i / count;
        frame.push_back(addPoint(point, rim));
      }
      corner[along] = extent > 0 ? box_.upper[along] : box_.lower[along];
    }
    if (isCounterClockwise(rim)) std::ranges::reverse(frame);
    return frame;
  }

  std::uint32_t addPoint(Vec3<double> point, const Loop& rim) {
    const auto nearest = *std::ranges::min_element(rim, {}, [&](std::uint32_t i) {
      const Vec3<double> arm = soup_.points[i] - point;
      return arm[u_] * arm[u_] + arm[v_] * arm[v_];
    });
    point[axis_] = soup_.points[nearest][axis_];
    soup_.points.push_back(point);
    return static_cast<std::uint32_t>(soup_.points.size() - 1);
  }

  /// Mean length of the rim's edges, seen along the axis.
  [[nodiscard]] double meanEdge(const Loop& rim) const {
    double sum = 0;
    auto from = rim.back();
    for (const auto to : rim) {
      const Vec3<double> edge = soup_.points[to] - soup_.points[from];
      sum += std::hypot(edge[u_], edge[v_]);
      from = to;
    }
    return sum / static_cast<double>(rim.size());
  }

  [[nodiscard]] bool isCounterClockwise(const Loop& rim) const {
    std::vector<Vec3<double>> corners;
    for (const auto point : rim) corners.push_back(soup_.points[point]);
    return polygonArea(corners).normal[axis_] > 0;
  }

  static constexpr double kMostPerSide = 4096;

  PolygonSoup& soup_;
  const Box<double>& box_;
  int u_;
  int v_;
  int axis_;
};

}  // namespace

OpeningReport extendTo(PolygonSoup& soup, int axis, double level, const ExtendOptions& options) {
  return extended(soup, [&](PolygonSoup& work, OpeningReport& report) {
    addWallsAndBottom(work, soup.polygonCount(), axis, level, options, report);
  });
}

OpeningReport extendToBox(PolygonSoup& soup, const Box<double>& box, int axis, BoxEnd end,
                          const ExtendOptions& options) {
  require(0 <= axis && axis < 3, "extendToBox: the axis is 0, 1 or 2", Named{"axis", axis});
  require(isFinite(box) && !box.empty(), "extendToBox: need a finite box",
          Named{"lower", box.lower}, Named{"upper", box.upper});
  const double level = end == BoxEnd::Lower ? box.lower[axis] : box.upper[axis];
  return extended(soup, [&](PolygonSoup& work, OpeningReport& report) {
    requireBeyond(work, axis, level);
    Apron(work, box, axis).add(options.apron);
    addWallsAndBottom(work, soup.polygonCount(), axis, level, options, report);
  });
}

}  // namespace cutwater
