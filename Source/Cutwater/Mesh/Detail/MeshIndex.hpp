#pragma once

#include <Cutwater/Mesh/Detail/FrontWindings.hpp>
#include <Cutwater/Mesh/Detail/MeshLayout.hpp>
#include <Cutwater/Mesh/Detail/SignCells.hpp>
#include <Cutwater/Mesh/Detail/SignedSurface.hpp>
#include <Cutwater/Surface/Detail/ContactSearch.hpp>
#include <Cutwater/Triangles/Search/BoxSearch.hpp>

namespace cutwater {

/// Everything behind a MeshSDF, immutable and shared by its copies: one block of arrays, and the
/// searches that find triangles in them. What follows once they are found is in PointAnswers,
/// SegmentAnswers and BoxAnswers.
///
/// MeshLayout says where in the block these lie:
///
///     TriangleSurface  from TriangleSurfaceArrays  corners, neighbours, normals, owners
///     TriangleTree     from TriangleTreeArrays     a tree over the triangles' boxes
///     TrianglePacket   from packTriangles()        the triangles of a leaf in single precision
///     ChildHulls       from HullArrays             tighter bounds for nodes of slivers
///     CappedWinding    from CappedWindingArrays    caps over the holes of a surface that is open
///     FrontWindings    from findFrontWindings()    winding numbers beside triangles, unless it is
///                                                  sound
///     SignCells        from findSignCells()        signs in the cells of a coarse grid, if it is
///                                                  open
///
/// Those on the left are records in the block or views of it; what they come from owns the arrays
/// until the block is written. KernelTriangles and TriangleSearch are plain pointers to surface and
/// tree, for kernels: code that is compiled once per instruction set.
///
/// Points, segments and boxes are in the surface's scaled units.
template <std::floating_point T>
class MeshIndex final : public SignedSurface<T> {
 public:
  using typename SignedSurface<T>::Nearest;
  using SignedSurface<T>::surface;

  /// Names are characters; each name is ended by a zero.
  /// `before`: an index of the same triangles between other points, which spares the search for
  /// self-intersections where these have not moved; or null.
  MeshIndex(const TriangleSurfaceArrays<T>& arrays, const TriangleTreeArrays& tree,
            std::span<const char> patchNames, const MeshSDFOptions& options,
            const MeshIndex* before = nullptr);
  /// Of a block that an index has filled: `signs` are its own.
  MeshIndex(Block block, const MeshLayout<T>& layout, const SignReport& signs,
            const MeshSDFOptions& options);

  [[nodiscard]] const Block& block() const { return block_; }
  [[nodiscard]] const MeshLayout<T>& layout() const { return layout_; }
  [[nodiscard]] const MeshSDFOptions& options() const { return options_; }
  [[nodiscard]] const TriangleTree& tree() const { return tree_; }
  [[nodiscard]] std::vector<std::string> patchNames() const;

  /// The triangle nearest to `p`, of equally near ones that with the lowest id, and whatever ties
  /// with it.
  [[nodiscard]] Nearest nearest(const Vec3<T>& p) const {
    return nearestWithin(p, TriangleSearch::kAnywhere);
  }
  /// The same if its distance is at most `reach`; otherwise any triangle or none.
  [[nodiscard]] Nearest nearestWithin(const Vec3<T>& p, double reach) const {
    auto best = surface().nothing(p);
    search_.nearest(surface(), p, best, reach);
    return best;
  }
  /// The same for each of the points.
  void nearest(std::span<const Vec3<T>> points, std::span<Nearest> nearest) const;
  void nearestWithin(std::span<const Vec3<T>> points, std::span<Nearest> nearest,
                     double reach) const;

  /// A TrianglesAlong.
  [[nodiscard]] auto trianglesAlong() const {
    return [this](const Segment<double>& segment, TriangleVisitor visit) {
      tree_.along(segment, visit);
    };
  }

  /// The most certain of the results of QueryBox for the triangles. `place` records where the
  /// triangles are that boxes within this one meet; 0 at first.
  [[nodiscard]] BoxOverlap overlapWith(const OrientedBox<double>& box, std::uint32_t& place) const {
    return overlapOf(search_, surface(), box, place);
  }
  /// Passes to `visit` at least all triangles that are no farther from the box than the value it
  /// last returned (at first `limit`), and none once that is 0. Ids end at the first kNone.
  void around(const OrientedBox<double>& box, double limit, TriangleVisitor visit) const {
    tree_.nearest(box, limit, visit);
  }

  /// The winding number of the surface, and of its caps if it is open, at `p`, which is not on the
  /// surface; if it is known near the nearest triangle.
  [[nodiscard]] std::optional<int> windingBeside(const Vec3<T>& p, const Nearest& nearest) const;

  // The winding number of a surface that is not closed: whether it exceeds 1/2 at the point;
  // whether it certainly does so everywhere or nowhere in a box that meets no triangle; and whether
  // that certainly changes at triangles alone in a box that may meet some.
  [[nodiscard]] bool isSurrounded(const Vec3<T>& p, const Nearest& nearest) const;
  [[nodiscard]] bool isDecided(const Box<double>& box) const {
    return signCells_.leastInside(box) || winding_.isDecided(surface(), trianglesAlong(), box);
  }
  [[nodiscard]] bool isSteady(const Box<double>& box) const {
    return signCells_.leastInside(box) || winding_.isSteady(box);
  }
  /// The least winding number, of the surface and its caps if it is open, of points that count as
  /// inside: if it is certainly the same everywhere in the box, and there are no caps in it.
  [[nodiscard]] std::optional<int> leastInside(const Box<double>& box) const {
    if (this->signs().isClosed()) return 1;
    const auto known = signCells_.leastInside(box);
    return known ? known : winding_.leastInside(box);
  }
  /// What is known beforehand; of a surface that is not closed.
  [[nodiscard]] const SignCells& signCells() const { return signCells_; }
  /// The winding number itself; null for an index that takes only closed surfaces.
  [[nodiscard]] const CappedWinding* winding() const { return &winding_; }

 private:
  /// Makes the rest of the arrays and copies all of them into one block, and checks the signs.
  void fill(const TriangleSurfaceArrays<T>& arrays, const TriangleTreeArrays& tree,
            std::span<const char> patchNames, const MeshIndex* before);
  void take(Block block, const MeshLayout<T>& layout);
  [[nodiscard]] SurfaceContacts contacts(const MeshIndex* before) const;
  /// By how much the winding number of the surface and its caps at the start of a segment exceeds
  /// that at its end.
  [[nodiscard]] int windingAlong(const Segment<double>& segment) const;
  [[nodiscard]] std::vector<std::uint8_t> frontWindings() const;
  [[nodiscard]] std::vector<std::uint8_t> bytesOfSignCells() const;
  /// Estimates winding numbers all over the box of a surface that is not closed.
  void probeAmbiguity(SignReport& signs) const;

  MeshSDFOptions options_;
  Block block_;
  MeshLayout<T> layout_;
  TriangleTree tree_;
  TriangleSearch search_;
  CappedWinding winding_;  // of a surface that is not closed
  FrontWindings fronts_;
  SignCells signCells_;
};

extern template class MeshIndex<float>;
extern template class MeshIndex<double>;

}  // namespace cutwater
