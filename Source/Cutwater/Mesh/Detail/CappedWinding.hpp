#pragma once

#include <Cutwater/Core/Block.hpp>
#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Triangles/SurfaceLocation.hpp>
#include <Cutwater/Triangles/WindingNumber.hpp>

namespace cutwater {

/// The winding number of a surface that is not closed. Caps close its holes. The winding number of
/// both together is an integer, counted without error along a segment; the contribution of the
/// caps, which is smooth away from them, is subtracted. So the cost is that of the holes, not of
/// the surface, and nothing is approximated near its triangles.
///
/// A view of arrays in a block. Queries take the surface and a function that finds its triangles;
/// points are in its scaled units.
class CappedWinding {
 public:
  /// The threshold for inside: see WindingNumber::kThreshold.
  static constexpr double kThreshold = WindingNumber<double>::kThreshold;

  /// Whether the winding number exceeds kThreshold; decided with certainty.
  template <std::floating_point T>
  [[nodiscard]] bool isInside(const TriangleSurface<T>& surface, TrianglesAlong along,
                              const Vec3<double>& p) const;

  /// An estimate within `tolerance`; see WindingNumber::estimate().
  template <std::floating_point T>
  [[nodiscard]] WindingNumber<double>::Estimate estimate(const TriangleSurface<T>& surface,
                                                         TrianglesAlong along,
                                                         const Vec3<double>& p,
                                                         double tolerance) const;

  /// Whether isInside() certainly is the same everywhere in a box that meets no triangle of the
  /// surface.
  template <std::floating_point T>
  [[nodiscard]] bool isDecided(const TriangleSurface<T>& surface, TrianglesAlong along,
                               const Box<double>& box) const;

  /// The winding number of the surface and its caps together.
  template <std::floating_point T>
  [[nodiscard]] int closedWinding(const TriangleSurface<T>& surface, TrianglesAlong along,
                                  const Vec3<double>& p) const;
  /// The sum of the directions in which the segment passes through caps before the point, which is
  /// on it within rounding.
  [[nodiscard]] int capsPassed(const Segment<double>& segment, const Vec3<double>& p) const;
  /// The sum of those in which all of the segment does.
  [[nodiscard]] int capsAlong(const Segment<double>& segment) const;
  /// Whether a point certainly has no cap within a distance; crude.
  [[nodiscard]] bool isFarFromCaps(const Vec3<double>& p, double distance) const {
    return caps_.distanceBound(p) > distance;
  }
  /// Whether a cap may reach into a box; false is certain.
  [[nodiscard]] bool mayHoldCap(const Box<double>& box) const;
  /// The caps; without triangles if the surface is closed.
  [[nodiscard]] const TriangleSurface<double>& caps() const { return triangles_; }

  /// Whether isInside() certainly changes at the surface's triangles alone in the box, whatever
  /// winding numbers there are.
  [[nodiscard]] bool isSteady(const Box<double>& box) const {
    return capsAreFarFrom(box) || leastAtCenter(box).has_value();
  }
  /// The least closedWinding() at which isInside() is true, if that is certainly the same
  /// everywhere in the box. Then there are no caps in it.
  [[nodiscard]] std::optional<int> leastInside(const Box<double>& box) const;

  /// closedWinding() at and around a point, where the caller knows it.
  using Closed = FunctionRef<int(const Vec3<double>&)>;
  /// isInside() with that.
  [[nodiscard]] bool isInside(Closed closed, const Vec3<double>& p) const;
  /// isDecided() with that, known at a point in the box, best its centre.
  [[nodiscard]] bool isDecided(Closed closed, const Vec3<double>& p, const Box<double>& box) const;

  /// A bound on its gradient away from the surface's triangles.
  [[nodiscard]] double gradientBound(const Box<double>& box) const;

 private:
  friend class CappedWindingArrays;

  /// On an edge of a cap, which may be anywhere, its solid angle is undefined: the winding number
  /// there is that of a nearby point.
  static constexpr int kAttempts = 4;
  [[nodiscard]] static Vec3<double> nudged(const Vec3<double>& p, int attempt);

  [[nodiscard]] WindingNumber<double>::Estimate estimate(Closed closed, const Vec3<double>& p,
                                                         double tolerance) const;
  /// Whether a box holds no cap, and all contribute so little that the integer decides; crude.
  [[nodiscard]] bool capsAreFarFrom(const Box<double>& box) const {
    constexpr double kLittle = 0.499;  // less than 1 - kThreshold
    return caps_.bound(box) < kLittle;
  }
  /// leastInside() at its centre, if it certainly changes at caps alone in the box.
  [[nodiscard]] std::optional<int> leastAtCenter(const Box<double>& box) const;
  [[nodiscard]] auto alongCaps() const {
    return [this](const Segment<double>& segment, TriangleVisitor visit) {
      tree_.along(segment, visit);
    };
  }

  TriangleSurface<double> triangles_;
  WindingTree tree_;
  WindingNumber<double> caps_;
};

/// The arrays that a CappedWinding is a view of, made from a surface's holes.
class CappedWindingArrays {
 public:
  /// Empty: for a closed surface.
  CappedWindingArrays() = default;
  /// Built from the surface's positions and the open edges that findOpenEdges() finds in its
  /// triangles.
  template <std::floating_point T>
  CappedWindingArrays(std::span<const Vec3<T>> positions, std::span<const OpenEdge> edges);

  /// No point farther than this from the surface's box counts as inside.
  [[nodiscard]] double reach() const;

  /// Where the arrays will lie in the block.
  struct Sections {
    Section positions, triangles, nodes, slots, moments, edges, openEdges;
    BvhFrame frame;
    int depth = 0;

    /// Views of what lies in the block, once it is written.
    [[nodiscard]] WindingTree tree(const Block& block) const {
      return {frame, block.array<BvhNode<WindingTree::kArity>>(nodes),
              block.array<std::uint32_t>(slots), depth};
    }
    [[nodiscard]] CappedWinding view(const Block& block) const;
  };
  /// Adds the arrays, which must live until BlockWriter::finish().
  [[nodiscard]] Sections addTo(BlockWriter& writer) const;

 private:
  std::vector<Vec3<double>> positions_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  BvhFrame frame_;
  int depth_ = 0;
  std::vector<BvhNode<WindingTree::kArity>> nodes_;
  std::vector<std::uint32_t> slots_;
  WindingArrays winding_;
};

}  // namespace cutwater
