#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Mesh/Detail/CappedWinding.hpp>
#include <Cutwater/Surface/Detail/HoleCaps.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>
#include <Cutwater/Triangles/QueryBox.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cutwater {

template <std::floating_point T>
int CappedWinding::closedWinding(const TriangleSurface<T>& surface, TrianglesAlong along,
                                 const Vec3<double>& p) const {
  const auto& box = surface.box;  // the caps' corners belong to the surface
  if (!box.contains(p)) return 0;
  const auto exit = exitOf(box, p);
  return windingAlong(surface, exit, along) + windingAlong(triangles_, exit, alongCaps());
}

/// A cap is passed where the point is on the side of its plane to which the segment leads: as
/// decided for the caps' own winding number.
int CappedWinding::capsPassed(const Segment<double>& segment, const Vec3<double>& p) const {
  int sum = 0;
  visitPassages<double>(triangles_, segment, alongCaps(), [&](std::uint32_t id, int direction) {
    if (sideOf(p, triangles_.corners(id)) == direction) sum += direction;
    return 1.0;
  });
  return sum;
}

int CappedWinding::capsAlong(const Segment<double>& segment) const {
  return windingAlong(triangles_, segment, alongCaps());
}

/// The point itself at first, then points a few of its ulps away, in directions that no edge has.
Vec3<double> CappedWinding::nudged(const Vec3<double>& p, int attempt) {
  const double step = attempt * 0x1p-50 * std::max(1.0, maxComponent(abs(p)));
  return p + step * Vec3<double>{1, 1.625, -2.3125 + attempt};
}

bool CappedWinding::isInside(Closed closed, const Vec3<double>& p) const {
  if (capsAreFarFrom({p, p})) return closed(p) >= 1;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const auto q = nudged(p, attempt);
    // winding - caps > threshold
    if (const auto found = caps_.isBelow(q, closed(q) - kThreshold)) return *found;
  }
  return false;
}

WindingNumber<double>::Estimate CappedWinding::estimate(Closed closed, const Vec3<double>& p,
                                                        double tolerance) const {
  WindingNumber<double>::Estimate result;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const auto q = nudged(p, attempt);
    const auto [value, error] = caps_.estimate(q, tolerance);
    result = {closed(q) - value, error};
    if (!(error > 0.25)) break;
  }
  return result;
}

bool CappedWinding::isDecided(Closed closed, const Vec3<double>& p, const Box<double>& box) const {
  if (capsAreFarFrom(box)) return true;
  constexpr double kTolerance = 0x1p-20;
  const auto whole = Box<double>{box}.extend(p);
  const double change = length(max(p - whole.lower, whole.upper - p)) * gradientBound(whole);
  if (!(change < 1)) return false;
  // Only at the point itself: one beside it may be out of the box, and across a triangle.
  return caps_.isFarFrom(p, closed(p) - kThreshold, change, kTolerance).value_or(false);
}

bool CappedWinding::mayHoldCap(const Box<double>& box) const {
  const auto around = OrientedBox<double>::of(box);
  const QueryBox query(around);
  bool found = false;
  tree_.overlapping(around, [&](std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      found = found || !query.isApart(query.toBox(triangles_.corners(id)));
    }
    return !found;
  });
  return found;
}

std::optional<int> CappedWinding::leastInside(const Box<double>& box) const {
  if (capsAreFarFrom(box)) return 1;
  return mayHoldCap(box) ? std::nullopt : leastAtCenter(box);
}

std::optional<int> CappedWinding::leastAtCenter(const Box<double>& box) const {
  constexpr double kTolerance = 0x1p-8;
  const double change = 0.5 * box.diagonal() * caps_.gradientBound(box);
  if (!(change < 0.5)) return {};
  const auto [value, error] = caps_.estimate(box.center(), kTolerance);
  // It is inside where it exceeds the threshold and what the caps contribute.
  const double spread = error + (1 + 0x1p-20) * change;
  const double most = std::floor(kThreshold + value + spread);
  if (most != std::floor(kThreshold + value - spread)) return {};
  return static_cast<int>(most) + 1;
}

template <std::floating_point T>
bool CappedWinding::isInside(const TriangleSurface<T>& surface, TrianglesAlong along,
                             const Vec3<double>& p) const {
  return isInside([&](const Vec3<double>& q) { return closedWinding(surface, along, q); }, p);
}

template <std::floating_point T>
WindingNumber<double>::Estimate CappedWinding::estimate(const TriangleSurface<T>& surface,
                                                        TrianglesAlong along, const Vec3<double>& p,
                                                        double tolerance) const {
  return estimate([&](const Vec3<double>& q) { return closedWinding(surface, along, q); }, p,
                  tolerance);
}

template <std::floating_point T>
bool CappedWinding::isDecided(const TriangleSurface<T>& surface, TrianglesAlong along,
                              const Box<double>& box) const {
  return isDecided([&](const Vec3<double>& q) { return closedWinding(surface, along, q); },
                   box.center(), box);
}

double CappedWinding::gradientBound(const Box<double>& box) const {
  const double byEdges = caps_.gradientBound(box);
  // Sufficient to distinguish 0 and 1 from 1/2 anywhere in the box.
  if (byEdges * box.diagonal() < 0.5) return byEdges;
  return std::min(byEdges, caps_.gradientBoundByArea(box));
}

template <std::floating_point T>
CappedWindingArrays::CappedWindingArrays(std::span<const Vec3<T>> positions,
                                         std::span<const OpenEdge> edges) {
  auto caps = capHoles(positions, edges);
  positions_ = std::move(caps.positions);
  triangles_ = std::move(caps.triangles);
  const auto boxes = triangleBoxes<double>(positions_, triangles_);
  auto tree = buildBvh<WindingTree::kArity, WindingTree::kLeafWidth>(boxes);
  winding_ = buildWindingMoments<double>(positions_, triangles_, tree.tree());
  frame_ = tree.frame;
  depth_ = tree.depth;
  nodes_ = std::move(tree.nodes);
  slots_ = std::move(tree.slots);
}

double CappedWindingArrays::reach() const {
  // At a distance d the caps, of total area A, subtend at most A / d^2: at most half of the full
  // sphere where d^2 >= A / (2 pi).
  double area = 0;
  for (const auto& [a, b, c] : triangles_) {
    area += 0.5 * length(cross(positions_[b] - positions_[a], positions_[c] - positions_[a]));
  }
  return std::sqrt(area / (2 * std::numbers::pi));
}

auto CappedWindingArrays::addTo(BlockWriter& writer) const -> Sections {
  return {.positions = writer.add(positions_),
          .triangles = writer.add(triangles_),
          .nodes = writer.add(nodes_),
          .slots = writer.add(slots_),
          .moments = writer.add(winding_.moments),
          .edges = writer.add(winding_.edges),
          .openEdges = writer.add(winding_.openEdges),
          .frame = frame_,
          .depth = depth_};
}

CappedWinding CappedWindingArrays::Sections::view(const Block& block) const {
  CappedWinding result;
  result.triangles_.positions = block.array<Vec3<double>>(positions);
  result.triangles_.triangles = block.array<std::array<std::uint32_t, 3>>(triangles);
  result.tree_ = tree(block);
  result.caps_ =
      WindingNumber<double>(result.triangles_.positions, result.triangles_.triangles, result.tree_,
                            block.array<WindingMoments>(moments), block.array<WindingEdges>(edges),
                            block.array<OpenEdge>(openEdges));
  return result;
}

#define CUTWATER_INSTANTIATE(T)                                                        \
  template bool CappedWinding::isInside(const TriangleSurface<T>&, TrianglesAlong,     \
                                        const Vec3<double>&) const;                    \
  template WindingNumber<double>::Estimate CappedWinding::estimate(                    \
      const TriangleSurface<T>&, TrianglesAlong, const Vec3<double>&, double) const;   \
  template bool CappedWinding::isDecided(const TriangleSurface<T>&, TrianglesAlong,    \
                                         const Box<double>&) const;                    \
  template int CappedWinding::closedWinding(const TriangleSurface<T>&, TrianglesAlong, \
                                            const Vec3<double>&) const;
CUTWATER_INSTANTIATE(float)
CUTWATER_INSTANTIATE(double)
#undef CUTWATER_INSTANTIATE

template CappedWindingArrays::CappedWindingArrays(std::span<const Vec3<float>>,
                                                  std::span<const OpenEdge>);
template CappedWindingArrays::CappedWindingArrays(std::span<const Vec3<double>>,
                                                  std::span<const OpenEdge>);

}  // namespace cutwater
