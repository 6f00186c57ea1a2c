#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Triangles/WindingMoments.hpp>

#include <limits>
#include <numbers>
#include <optional>

namespace cutwater {

namespace detail {

/// The winding number that a solid angle of 1 is.
inline constexpr double kInverse4Pi = 0.25 / std::numbers::pi;

}  // namespace detail

/// The generalised winding number of arbitrary triangles: the solid angle that they span at a
/// point, signed by their orientation, over 4 pi. For a closed surface it is 1 inside and 0 outside
/// (n within n shells). With holes or overlaps it varies smoothly, except for a jump of 1 at every
/// triangle (Jacobson, Kavan and Sorkine-Hornung 2013, "Robust inside-outside segmentation using
/// generalized winding numbers").
///
/// It is computed over a tree, as in Barill et al. 2018, "Fast winding numbers for soups and
/// clouds", but with bounds for everything that is left out or rounded, so decisions are certain. A
/// view of arrays owned elsewhere. Positions must be scaled by a power of two so that the largest
/// coordinate is about 1; points and boxes are in these units. Queries allocate nothing.
template <std::floating_point T>
class WindingNumber {
 public:
  /// Corners of a triangle: indices of positions.
  using Corners = std::array<std::uint32_t, 3>;

  /// |winding number - value| <= error, rounding included.
  struct Estimate {
    double value = 0;
    double error = 0;
  };

  /// Points with a larger winding number count as inside: slightly more than half. In the plane of
  /// a flat hole the winding number is exactly 1/2, and grids tend to have points there; no sum
  /// resolves such a tie before the last triangle. This moves the sheet that closes a hole by about
  /// a 2000th of the hole's radius.
  static constexpr double kThreshold = 0.5 + 0x1p-12;

  WindingNumber() = default;
  /// The last three are made from the others by buildWindingMoments().
  WindingNumber(std::span<const Vec3<T>> positions, std::span<const Corners> triangles,
                const WindingTree& tree, std::span<const WindingMoments> moments,
                std::span<const WindingEdges> edges, std::span<const OpenEdge> openEdges)
      : positions_(positions),
        triangles_(triangles),
        tree_(tree),
        moments_(moments),
        edges_(edges),
        openEdges_(openEdges) {}

  /// Returns an estimate within `tolerance`, or as close to it as double precision allows: about
  /// 4e-15 per triangle, and 1/2 for each triangle on whose edge the point lies. Each digit costs
  /// several times as much; below 1e-5 almost every triangle is evaluated. NaN at a point that is
  /// not finite.
  [[nodiscard]] Estimate estimate(const Vec3<double>& p, double tolerance) const;

  /// Whether the winding number is less than `level`: certified, and the same for any tree. Returns
  /// nothing where estimate() cannot decide.
  [[nodiscard]] std::optional<bool> isBelow(const Vec3<double>& p, double level) const;
  /// Whether it differs from `level` by more than `distance`: certain. Returns nothing where an
  /// estimate within `tolerance`, or as close to it as estimate() comes, does not tell.
  [[nodiscard]] std::optional<bool> isFarFrom(const Vec3<double>& p, double level, double distance,
                                              double tolerance) const;
  [[nodiscard]] bool isInside(const Vec3<double>& p) const {
    return isBelow(p, kThreshold) == false;
  }

  /// A lower bound on the distance of a point within 16 from any triangle, cheap and crude: by
  /// their boxes if they are few, else by spheres around the parts of the tree. May be negative.
  [[nodiscard]] double distanceBound(const Vec3<double>& p) const;

  /// A bound on its size at all points of a box, cheap and crude: the area of each part of the tree
  /// over 4 pi times its least squared distance. The largest double if the box may hold a triangle.
  [[nodiscard]] double bound(const Box<double>& box) const;

  /// The sum over all triangles, in the order of their ids.
  [[nodiscard]] double exactSum(const Vec3<double>& p) const { return sumOfAll(p).value; }

  /// A bound on the winding number's gradient where the box meets no triangle. By the Biot-Savart
  /// law, the gradient is 1/(4 pi) times the integral of dx cross (x - p) / |x - p|^3 along the
  /// open edges, each times its multiplicity. 0 for a closed surface; the largest double where the
  /// box touches (the box of a small piece of) an open edge. The smaller the box, the cruder the
  /// bound: edges far away by which the number changes little within the box are not told apart.
  [[nodiscard]] double gradientBound(const Box<double>& box) const;

  /// Another bound, from the triangles' area: at most 2 dA / (4 pi r^3). It is the better one where
  /// edges are open everywhere, as with triangles that share no vertices: the contributions of such
  /// edges cancel, except for the cracks between them. The largest double where the box touches the
  /// box of a triangle.
  [[nodiscard]] double gradientBoundByArea(const Box<double>& box) const;

 private:
  /// Stands for "no bound".
  static constexpr double kLargest = std::numeric_limits<double>::max();

  [[nodiscard]] std::array<Vec3<double>, 3> triangle(std::uint32_t id) const {
    const auto& v = triangles_[id];
    return {Vec3<double>(positions_[v[0]]), Vec3<double>(positions_[v[1]]),
            Vec3<double>(positions_[v[2]])};
  }
  [[nodiscard]] std::size_t indexOf(const BvhNode<16>& node) const {
    return static_cast<std::size_t>(&node - tree_.nodes().data());
  }
  [[nodiscard]] std::span<const OpenEdge> edgesOf(std::size_t node) const;
  [[nodiscard]] double farBound(const Vec3<double>& p) const;
  /// Lower bounds on the distance of a point from the triangles below each lane of the root, in the
  /// tree's frame; may be negative.
  [[nodiscard]] WindingMoments::Lanes gapsToParts(const Vec3<double>& p) const;
  /// The first decision on estimates that become closer, down to `tolerance`; nothing if there is
  /// none.
  template <typename Decide>
  [[nodiscard]] std::optional<bool> decided(const Vec3<double>& p, double tolerance,
                                            const Decide& decide) const;
  [[nodiscard]] Estimate sum(const Vec3<double>& p, double threshold) const;
  [[nodiscard]] Estimate sumOfAll(const Vec3<double>& p) const;
  [[nodiscard]] double inverseSquare(const OpenEdge& edge, const Box<double>& box) const;

  std::span<const Vec3<T>> positions_;
  std::span<const Corners> triangles_;
  WindingTree tree_;
  std::span<const WindingMoments> moments_;
  std::span<const WindingEdges> edges_;
  std::span<const OpenEdge> openEdges_;
};

extern template class WindingNumber<float>;
extern template class WindingNumber<double>;

}  // namespace cutwater
