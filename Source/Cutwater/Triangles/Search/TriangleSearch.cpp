#include <Cutwater/Simd/InstructionSet.hpp>
#include <Cutwater/Triangles/Search/TriangleSearch.hpp>

namespace cutwater {

namespace {

template <std::floating_point T>
using NearestTriangle = void(const TriangleSearch&, const KernelTriangles<T>&, const Vec3<T>&,
                             typename TriangleSurface<T>::Nearest&, double);
template <std::floating_point T>
using NearestTriangles = void(const TriangleSearch&, const KernelTriangles<T>&, const Vec3<T>*,
                              typename TriangleSurface<T>::Nearest*, std::size_t);
template <std::floating_point T>
using NearestTrianglesWithin = void(const TriangleSearch&, const KernelTriangles<T>&,
                                    const Vec3<T>*, typename TriangleSurface<T>::Nearest*,
                                    std::size_t, double);

}  // namespace

#define CUTWATER_DECLARE_FOR(T)                                                                 \
  void nearestTriangle(const TriangleSearch&, const KernelTriangles<T>&, const Vec3<T>&,        \
                       TriangleSurface<T>::Nearest&, double);                                   \
  void nearestTriangles(const TriangleSearch&, const KernelTriangles<T>&, const Vec3<T>*,       \
                        TriangleSurface<T>::Nearest*, std::size_t);                             \
  void nearestTrianglesWithin(const TriangleSearch&, const KernelTriangles<T>&, const Vec3<T>*, \
                              TriangleSurface<T>::Nearest*, std::size_t, double);
#define CUTWATER_DECLARE(set)  \
  namespace set {              \
  CUTWATER_DECLARE_FOR(float)  \
  CUTWATER_DECLARE_FOR(double) \
  }
CUTWATER_FOR_INSTRUCTION_SETS(CUTWATER_DECLARE)
#undef CUTWATER_DECLARE
#undef CUTWATER_DECLARE_FOR

template <std::floating_point T>
Vec3<T> KernelTriangles<T>::closestPoint(std::uint32_t id, const Vec3<T>& p) const {
  const auto t = triangle(id);
  const auto weights = closestBarycentric(p, t, triangleDistance(p, t).part);
  return weights.x * t.a + weights.y * t.b + weights.z * t.c;
}

template struct KernelTriangles<float>;
template struct KernelTriangles<double>;

namespace {

constexpr std::size_t kSmall = std::size_t{1} << 20;

}  // namespace

TriangleSearch::TriangleSearch(const TriangleTree& tree, std::span<const TrianglePacket> leaves,
                               std::span<const ChildHulls> childHulls,
                               std::span<const std::uint32_t> ofNode)
    : nodes(tree.nodes().data()),
      slots(tree.slots().data()),
      packets(leaves.data()),
      hulls(childHulls.data()),
      hullsOfNode(ofNode.empty() ? nullptr : ofNode.data()),
      frame(tree.frame()),
      isSmall(leaves.size_bytes() <= kSmall) {}

template <std::floating_point T>
void TriangleSearch::nearest(const TriangleSurface<T>& surface, const Vec3<T>& p,
                             typename TriangleSurface<T>::Nearest& best, double reach) const {
  static NearestTriangle<T>* const function = CUTWATER_BEST_OF(NearestTriangle<T>, nearestTriangle);
  function(*this, KernelTriangles<T>(surface), p, best, reach);
}

template <std::floating_point T>
void TriangleSearch::nearest(const TriangleSurface<T>& surface, std::span<const Vec3<T>> points,
                             std::span<typename TriangleSurface<T>::Nearest> bests) const {
  static NearestTriangles<T>* const function =
      CUTWATER_BEST_OF(NearestTriangles<T>, nearestTriangles);
  function(*this, KernelTriangles<T>(surface), points.data(), bests.data(), points.size());
}

template <std::floating_point T>
void TriangleSearch::nearest(const TriangleSurface<T>& surface, std::span<const Vec3<T>> points,
                             std::span<typename TriangleSurface<T>::Nearest> bests,
                             double reach) const {
  static NearestTrianglesWithin<T>* const function =
      CUTWATER_BEST_OF(NearestTrianglesWithin<T>, nearestTrianglesWithin);
  function(*this, KernelTriangles<T>(surface), points.data(), bests.data(), points.size(), reach);
}

template void TriangleSearch::nearest(const TriangleSurface<float>&, const Vec3<float>&,
                                      TriangleSurface<float>::Nearest&, double) const;
template void TriangleSearch::nearest(const TriangleSurface<float>&, std::span<const Vec3<float>>,
                                      std::span<TriangleSurface<float>::Nearest>) const;
template void TriangleSearch::nearest(const TriangleSurface<double>&, const Vec3<double>&,
                                      TriangleSurface<double>::Nearest&, double) const;
template void TriangleSearch::nearest(const TriangleSurface<double>&, std::span<const Vec3<double>>,
                                      std::span<TriangleSurface<double>::Nearest>) const;
template void TriangleSearch::nearest(const TriangleSurface<float>&, std::span<const Vec3<float>>,
                                      std::span<TriangleSurface<float>::Nearest>, double) const;
template void TriangleSearch::nearest(const TriangleSurface<double>&, std::span<const Vec3<double>>,
                                      std::span<TriangleSurface<double>::Nearest>, double) const;

}  // namespace cutwater
