#pragma once

#include <Cutwater/Core/Block.hpp>
#include <Cutwater/Mesh/DcelMesh.hpp>
#include <Cutwater/Mesh/GeometryFile.hpp>
#include <Cutwater/Mesh/MeshLayout.hpp>
#include <Cutwater/Mesh/TriangleSearch.hpp>
#include <Cutwater/Mesh/TriangleSurfaceSDF.hpp>

namespace cutwater {

/// A surface mesh as a signed distance function over a LinearBVH.
///
/// The magnitude is within 8 eps (|p| + |V|max) of the distance to the mesh rounded to T, and does
/// not depend on the tree. The sign is exact on closed surfaces, however close sheets and however
/// thin triangles are. Overlapping shells are a union, once the overlap is known: it is looked for
/// at probes unless findSelfIntersections asks for more, and within one that is missed the sign may
/// be that of the nearest sheet. A surface that is not closed is inside where its winding number
/// exceeds 1/2. Faces that disagree with their neighbours and shells that are inside out are turned
/// (see Shells.hpp). signReport() tells what was found and how signs are decided, guarantee() what
/// values then mean.
///
/// closestPoint() tells the polygon of the soup (face), its patch, and barycentrics that refer to
/// `triangle(id)`. Copies share one read-only block of memory.
template <std::floating_point T>
class MeshSDF final : public TriangleSurfaceSDF<T> {
 public:
  /// @throws Error(Topology) with a one-line report if the soup has no triangles, or options
  /// require a watertight surface and it is none; what DcelMesh throws for a soup that is none.
  explicit MeshSDF(const PolygonSoup& soup, const MeshSDFOptions& options = {});
  explicit MeshSDF(const DcelMesh<T>& mesh, const MeshSDFOptions& options = {});

  /// This surface after its vertices have moved, and its connections not: for bodies that deform.
  ///
  /// `positions` are those of the soup's points (of the DcelMesh's vertices) in their order, unused
  /// ones too, before the placement. The answers are, to the bit, those of a MeshSDF made from the
  /// triangles at their new places with the same options, sign report and errors included (but for
  /// bounds(), which may differ by a thousandth of the gap); polygons of more corners stay cut as
  /// they are. It takes less than half the time: the tree keeps its shape. Queries get slower as
  /// triangles that share a leaf part, or turn far from where they were; then build anew.
  ///
  /// A new surface, so that others may go on asking this one: `mesh = mesh.refitted(positions)`
  /// frees the old one if nobody does. The placement stays.
  /// @throws Error(Argument) unless there is one position for each vertex, finite and with finite
  /// squares as a double; Error(Topology) as the constructor.
  [[nodiscard]] MeshSDF refitted(std::span<const Vec3<T>> positions) const;

  /// The mesh as bytes that view() takes, placement, options and sign report included: what
  /// GeometryFile.hpp describes. They begin at a multiple of 64.
  ///
  /// `source` is kept with them: any mark of what the mesh was made from, such as the xxHash64() of
  /// a file, by which to tell later whether it still is the same; geometryFileInfo() tells it.
  [[nodiscard]] Block toBytes(std::uint64_t source = 0) const;

  /// The mesh that these bytes came from, without a copy: its answers are the same bits, whoever
  /// makes them and whatever for. The bytes may be anywhere that begins at a multiple of 64: a
  /// broadcast's buffer, a window that MPI processes share, a mapped file. They must stay as they
  /// are as long as this mesh and its copies live; refitted() makes a mesh that needs them no
  /// longer.
  /// @throws Error(File) for bytes of another format, version, precision or byte order, for those
  /// that are damaged, cut or followed by others; Error(Argument) if they begin elsewhere:
  /// alignedCopy() moves them.
  [[nodiscard]] static MeshSDF view(std::span<const std::byte> bytes,
                                    const MeshViewOptions& options = {});
  /// The same; the mesh and its copies keep the block's memory alive.
  [[nodiscard]] static MeshSDF view(const Block& bytes, const MeshViewOptions& options = {});

  /// Maps a file that save() or `cutwater prepare` wrote: processes on one node share its memory,
  /// and pages are read as they are needed. A file that is replaced by save() stays what it was for
  /// those that have mapped it; one that somebody else cuts or overwrites in place ends them by a
  /// signal or misleads them. view(alignedCopy(...)) does not depend on the file any longer.
  /// @throws Error(File) as view(), and for files that cannot be read.
  [[nodiscard]] static MeshSDF open(const std::filesystem::path& path,
                                    const MeshViewOptions& options = {});

  /// Writes toBytes() to a file that stands under its name only once it is complete.
  /// @throws Error(File) if it cannot be written.
  void save(const std::filesystem::path& path, std::uint64_t source = 0) const;

  /// The triangles with their patches, before the placement. Faces of more corners stay cut, and
  /// what was turned stays so.
  [[nodiscard]] PolygonSoup soup() const;

  /// Bytes of the block that queries use.
  [[nodiscard]] std::size_t memoryBytes() const { return block_.bytes().size(); }

 private:
  using Nearest = typename TriangleSurface<T>::Nearest;

  [[nodiscard]] Nearest nearest(const Vec3<T>& p) const override;
  [[nodiscard]] Nearest nearestWithin(const Vec3<T>& p, double reach) const override;
  void nearest(std::span<const Vec3<T>> points, std::span<Nearest> nearest) const override;
  void along(const Segment<double>& segment, TriangleVisitor visit) const override;
  [[nodiscard]] BoxOverlap overlapWith(const OrientedBox<double>& box,
                                       std::uint32_t& place) const override;
  void around(const OrientedBox<double>& box, double limit, TriangleVisitor visit) const override;
  [[nodiscard]] bool isSurrounded(const Vec3<T>& p) const override;
  [[nodiscard]] bool isDecided(const Box<double>& box) const override;
  [[nodiscard]] std::vector<std::string> localPatchNames() const override;

  MeshSDF() = default;
  /// `defects` says more about a surface that is refused.
  void build(const TriangleSurfaceData<T>& data, const TriangleTreeArrays& tree,
             std::span<const char> patchNames, FunctionRef<std::string()> defects);
  void takeBlock(Block block, const MeshLayout<T>& layout);
  [[nodiscard]] std::vector<std::byte> header(std::uint64_t source) const;
  void checkSurface(const TriangleSurfaceData<T>& data, bool needsWinding);
  void probeAmbiguity(std::size_t count, SignReport& signs) const;

  MeshSDFOptions options_;
  Block block_;
  MeshLayout<T> layout_;
  TriangleTree tree_;
  TriangleSearch search_;
  OpenWinding winding_;  // of a surface that is not closed
};

extern template class MeshSDF<float>;
extern template class MeshSDF<double>;

}  // namespace cutwater
