#include <Cutwater/Mesh/BoxSearch.hpp>
#include <Cutwater/Simd/InstructionSet.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

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

TreeBox::TreeBox(const QueryBox& box, double slack, const BvhFrame& frame)
    : center(frame.toFrame(box.center())), isAligned(box.isAligned()) {
  const Vec3<double> lengths = frame.scale * box.half();
  half = Vec3<float>(lengths);
  size = half.x + half.y + half.z;
  leastHalf = std::min({half.x, half.y, half.z});
  for (int i = 0; i < 3 && !isAligned; ++i) {
    axes[i] = Vec3<float>(box.axis(i));
    halfAxes[i] = Vec3<float>(lengths[i] * box.axis(i));
  }
  // What QueryBox allows for, several times over, and the rounding of positions in the frame.
  const Vec3<double> away = abs(center);
  const double all = 8 * frame.scale * box.rounding() +
                     0x1p-48 * (1 + away.x + away.y + away.z + double{size});
  const double within = maxComponent(box.half() - box.innerHalf());
  rounding = static_cast<float>(1.01 * all);
  depth = static_cast<float>(1.01 * (all + frame.scale * within));
  // A box and its image with slack differ by twice the slack, and so do those of one within it.
  reach = rounding + static_cast<float>(8 * frame.scale * slack);
}

template <std::floating_point T>
BoxOverlap overlapOf(const TriangleSearch& tree, const TriangleSurface<T>& surface,
                     const OrientedBox<double>& box, std::uint32_t& node) {
  static TreeOverlap* const function = CUTWATER_BEST_OF(TreeOverlap, overlapWithTree);
  struct Context {
    QueryBox box;
    const TriangleSurface<T>& surface;
  };
  const Context context{QueryBox(box), surface};
  const auto exact = [](const void* given, std::uint32_t triangle) {
    const auto& [query, triangles] = *static_cast<const Context*>(given);
    return query.overlapWith(triangles.corners(triangle));
  };
  return function(tree, TreeBox(context.box, box.slack, tree.frame), node, {exact, &context});
}

template BoxOverlap overlapOf(const TriangleSearch&, const TriangleSurface<float>&,
                              const OrientedBox<double>&, std::uint32_t&);
template BoxOverlap overlapOf(const TriangleSearch&, const TriangleSurface<double>&,
                              const OrientedBox<double>&, std::uint32_t&);

}  // namespace cutwater
