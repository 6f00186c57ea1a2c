#include <Cutwater/Simd/InstructionSet.hpp>
#include <Cutwater/Triangles/Search/BoxSearch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cutwater {

namespace {

/// The directions of the half axes, as far as they have any.
std::array<Vec3<double>, 3> directionsOf(const OrientedBox<double>& box) {
  std::array<Vec3<double>, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = normalized(box.halfAxis[i]);
    if (result[i] != Vec3<double>{}) continue;
    const QueryBox query(box);
    return {query.axis(0), query.axis(1), query.axis(2)};
  }
  return result;
}

using TreeOverlap = BoxOverlap(const TriangleSearch&, const TreeBox&, std::uint32_t&,
                               const ExactOverlap&);

}  // namespace

#define CUTWATER_DECLARE(set)                                                            \
  namespace set {                                                                        \
  BoxOverlap overlapWithTree(const TriangleSearch&, const TreeBox&, std::uint32_t& node, \
                             const ExactOverlap&);                                       \
  }
CUTWATER_FOR_INSTRUCTION_SETS(CUTWATER_DECLARE)
#undef CUTWATER_DECLARE

TreeBox::TreeBox(const OrientedBox<double>& box, const BvhFrame& frame)
    : center(frame.toFrame(box.center)), isAligned(QueryBox::isAligned(box)) {
  const auto& [x, y, z] = box.halfAxis;
  Vec3<double> lengths{std::abs(x.x), std::abs(y.y), std::abs(z.z)};
  double skew = 0;  // components of the half axes along each other's directions
  if (!isAligned) {
    const auto directions = directionsOf(box);
    for (int i = 0; i < 3; ++i) {
      const auto& direction = directions[static_cast<std::size_t>(i)];
      const Vec3<double> along = abs(Vec3<double>{dot(x, direction), dot(y, direction),  //
                                                  dot(z, direction)});
      lengths[i] = along.x + along.y + along.z;
      skew += lengths[i] - along[i];
      axes[i] = Vec3<float>(direction);
      halfAxes[i] = Vec3<float>(frame.scale * lengths[i] * direction);
    }
  }
  // Several times what QueryBox allows for, and the rounding of positions in the frame. QueryBox
  // has orthonormal axes; the boxes differ by the skew of the half axes.
  const double sizeOfAll = oneNorm(box.center) + oneNorm(x) + oneNorm(y) + oneNorm(z);
  const double margin = 16 * 0x1p-48 * (1 + sizeOfAll) + 8 * skew;
  const double scale = frame.scale;
  half = Vec3<float>(scale * (lengths + Vec3<double>{box.slack, box.slack, box.slack}));
  size = half.x + half.y + half.z;
  leastHalf = std::min({half.x, half.y, half.z});
  const double inFrame = 0x1p-48 * (1 + oneNorm(center) + double{size});
  rounding = static_cast<float>(scale * margin + inFrame);
  depth = static_cast<float>(scale * (2 * margin + 2 * box.slack) + inFrame);
  // A box and its image with slack differ by twice the slack, and so do a box within it and its
  // image.
  reach = static_cast<float>(scale * (margin + 8 * box.slack) + inFrame);
}

template <std::floating_point T>
BoxOverlap overlapOf(const TriangleSearch& tree, const TriangleSurface<T>& surface,
                     const OrientedBox<double>& box, std::uint32_t& node) {
  static TreeOverlap* const function = CUTWATER_BEST_OF(TreeOverlap, overlapWithTree);
  struct Context {
    const TriangleSurface<T>& surface;
    const OrientedBox<double>& box;
    std::optional<QueryBox> query;  // rarely needed
    BoxOverlap found = BoxOverlap::None;
  };
  Context context{surface, box, {}};
  const auto exact = [](void* given, std::uint32_t triangle) {
    auto& [triangles, asked, query, found] = *static_cast<Context*>(given);
    if (!query) query.emplace(asked);
    return found = query->overlapWith(triangles.corners(triangle), found);
  };
  return function(tree, TreeBox(box, tree.frame), node, {exact, &context});
}

template BoxOverlap overlapOf(const TriangleSearch&, const TriangleSurface<float>&,
                              const OrientedBox<double>&, std::uint32_t&);
template BoxOverlap overlapOf(const TriangleSearch&, const TriangleSurface<double>&,
                              const OrientedBox<double>&, std::uint32_t&);

}  // namespace cutwater
