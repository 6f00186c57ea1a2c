#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Core/Block.hpp>
#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Surface/DcelMesh.hpp>
#include <Cutwater/Surface/Detail/ConnectedShells.hpp>
#include <Cutwater/Surface/Detail/Shells.hpp>
#include <Cutwater/Triangles/OpenEdges.hpp>
#include <Cutwater/Triangles/TriangleSurface.hpp>

#include <vector>

namespace cutwater {

/// The arrays that a TriangleSurface is a view of, made from a mesh.
template <std::floating_point T>
class TriangleSurfaceArrays {
 public:
  /// Accepts any mesh. Faces with more than three corners are triangulated, those with fewer than
  /// three distinct corners are left out, and the rest is oriented (see orientShells()).
  /// @throws Error(Topology) if no triangle is left.
  explicit TriangleSurfaceArrays(const DcelMesh<T>& mesh);

  /// The same triangles between vertices that have moved to `positions`, in the mesh's own units:
  /// everything that a mesh of those triangles would give, to the bit, without half-edges.
  /// Triangles keep their order and their neighbours; only which shells are inside out is decided
  /// anew. `signs` and `insideOut` (see ShellOrientation) are those of `before`, which must outlive
  /// this object.
  TriangleSurfaceArrays(const TriangleSurface<T>& before, const SignReport& signs,
                        std::span<const std::uint32_t> insideOut,
                        std::span<const Vec3<T>> positions);

  /// Where the arrays will lie in the block.
  struct Sections {
    Section positions, triangles, neighbours, slivers, pseudonormals, polygons, patches;
    T scale = 1;
    T size = 0;
    Box<double> box;

    /// The surface that lies in the block, once it is written.
    [[nodiscard]] TriangleSurface<T> view(const Block& block) const;
  };
  /// Adds the arrays, which must live until BlockWriter::finish().
  [[nodiscard]] Sections addTo(BlockWriter& writer) const;

  [[nodiscard]] std::span<const Vec3<T>> positions() const { return positions_; }
  /// Corners of each triangle: indices of positions().
  [[nodiscard]] std::span<const std::array<std::uint32_t, 3>> triangles() const {
    return triangles_.view();
  }
  [[nodiscard]] const ShellOrientation& orientation() const { return orientation_; }
  /// Empty if the surface is closed.
  [[nodiscard]] std::span<const OpenEdge> openEdges() const { return openEdges_; }

 private:
  using Corners = typename TriangleSurface<T>::Corners;

  /// An array of its own, or a view of another array, which is left unchanged.
  template <typename Record>
  class Kept {
   public:
    Kept() = default;
    explicit Kept(std::span<const Record> others) : others_(others) {}

    [[nodiscard]] std::span<const Record> view() const {
      return others_.empty() ? std::span<const Record>(own_) : others_;
    }
    /// The array for modification; copies a viewed array first.
    [[nodiscard]] std::vector<Record>& own() {
      if (!others_.empty()) own_.assign(others_.begin(), others_.end());
      others_ = {};
      return own_;
    }

   private:
    std::vector<Record> own_;
    std::span<const Record> others_;
  };

  void takeOriented(const DcelMesh<T>& triangles);
  void take(const DcelMesh<T>& triangles);
  void takePositions(std::span<const Vec3<T>> positions);
  /// Finds the shells that are inside out and turns them.
  void orientAgain(std::span<const Vec3<T>> positions, const SignReport& signs,
                   std::span<const std::uint32_t> wereInsideOut);
  void turnShells(const ConnectedShells& shells, std::span<const std::uint32_t> chosen);
  void findEdges();
  /// Computes what follows from triangles and positions.
  void measureTriangles();
  void markSlivers();

  std::vector<Vec3<T>> positions_;
  Kept<Corners> triangles_;
  Kept<Corners> neighbours_;
  std::vector<std::uint32_t> slivers_;
  std::vector<Vec3<T>> pseudonormals_;
  Kept<std::uint32_t> polygons_;
  Kept<std::uint32_t> patches_;
  T scale_ = 1;
  T size_ = 0;
  Box<double> box_;
  ShellOrientation orientation_;
  std::vector<OpenEdge> openEdges_;
};

extern template class TriangleSurfaceArrays<float>;
extern template class TriangleSurfaceArrays<double>;

}  // namespace cutwater
