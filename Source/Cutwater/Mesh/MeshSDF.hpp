#pragma once

#include <Cutwater/Core/Block.hpp>
#include <Cutwater/Mesh/GeometryFile.hpp>
#include <Cutwater/Mesh/MeshFunction.hpp>
#include <Cutwater/Surface/DcelMesh.hpp>

namespace cutwater {

/// A surface mesh as a signed distance function over a LinearBVH.
///
/// The magnitude is within 8 eps (|p| + |V|max) of the distance to the mesh rounded to T, where V
/// are the corners of faces, and does not depend on the tree. The sign is exact on closed surfaces,
/// however close together their sheets and however thin their triangles. Overlapping shells form a
/// union: the check finds every pair of triangles that meet. (Without findSelfIntersections it
/// looks at probes only, and within a missed overlap the sign may be that of the nearest sheet.)
/// For a surface that is not closed, inside is where its winding number exceeds 1/2; boundingBox()
/// then reaches beyond the triangles, whose box is surfaceBox(). Faces that disagree with their
/// neighbours and shells that are inside out are turned (see orientFaces()). signReport() returns
/// what was found and how signs are decided, guarantee() what values then mean. Unused points may
/// be anywhere. Equal points are not shared points: see weldExactly().
///
/// closestPoint() returns the polygon of the soup (face), its patch, and barycentric coordinates
/// that refer to `triangle(id)`. Copies share everything but the placement.
template <std::floating_point T>
class MeshSDF final : public MeshFunction<T, MeshIndex<T>> {
 public:
  /// Patches that have no name in the soup are called "surface".
  /// @throws Error(Topology) with a one-line report if the soup has no triangles, or if options
  /// require a watertight surface and it is not; Error(Argument) for a patch name that contains a
  /// zero, and for a patch id from 2^20 on without a name; for an invalid soup, what DcelMesh
  /// throws.
  explicit MeshSDF(const PolygonSoup& soup, const MeshSDFOptions& options = {});
  explicit MeshSDF(const DcelMesh<T>& mesh, const MeshSDFOptions& options = {});

  /// This surface with its vertices moved and its connectivity unchanged: for bodies that deform.
  ///
  /// `positions` are those of the soup's points (of the DcelMesh's vertices) in their order, unused
  /// ones too, before the placement. Results are, to the bit, those of a MeshSDF made from the
  /// triangles at their new places with the same options, including the sign report and errors (but
  /// not bounds(), which may differ by a thousandth of the gap, nor the number of probes where
  /// triangles touch); polygons with more corners stay cut as they are. This takes less than half
  /// the time, because the tree keeps its shape. If this surface is proven sound, and less than
  /// half of the triangles move, only these are searched for self-intersections, unless the
  /// surface's largest coordinate passes a power of two. Queries become slower as triangles that
  /// share a leaf move apart or turn far from where they were; then build anew.
  ///
  /// Returns a new surface, so queries of this one may continue: `mesh = mesh.refitted(positions)`
  /// frees the old one once nobody uses it. The placement stays.
  /// @throws Error(Argument) unless there is one position for each vertex, finite and with finite
  /// squares as a double; Error(Topology) as for the constructor.
  [[nodiscard]] MeshSDF refitted(std::span<const Vec3<T>> positions) const;

  /// This surface with SignScheme::NearestFeature, of the same memory: takes no time. For the
  /// distances to a surface that is not closed, where signs do not matter: they cost less so than
  /// by winding numbers. The placement stays; refitted() keeps the scheme.
  [[nodiscard]] MeshSDF signedByNearest() const;

  /// The mesh as bytes that view() accepts, including placement, options and sign report, in the
  /// format of GeometryFile.hpp. They begin at a multiple of 64.
  ///
  /// `source` is stored with them: any mark of what the mesh was made from, such as the xxHash64()
  /// of a file, which shows later whether it is still the same. geometryFileInfo() returns it.
  [[nodiscard]] Block toBytes(std::uint64_t source = 0) const;

  /// The mesh that these bytes were made from, without a copy: its results are the same to the bit.
  /// The bytes may be in any memory that begins at a multiple of 64: the buffer of a broadcast, a
  /// window that MPI processes share, a mapped file. They must not change during the lifetime of
  /// this mesh and its copies; refitted() makes a mesh that no longer needs them.
  /// @throws Error(File) for bytes of another format, version, precision or byte order, and for
  /// bytes that are damaged, truncated or followed by others; Error(Argument) if they begin
  /// elsewhere: alignedCopy() moves them.
  [[nodiscard]] static MeshSDF view(std::span<const std::byte> bytes,
                                    const MeshViewOptions& options = {});
  /// The same; the mesh and its copies keep the block's memory alive.
  [[nodiscard]] static MeshSDF view(const Block& bytes, const MeshViewOptions& options = {});

  /// Maps a file that save() or `cutwater prepare` wrote: processes on one node share its memory,
  /// and pages are read as they are needed. When save() replaces a file, processes that have mapped
  /// it keep the old content. If it is truncated or overwritten in place by other means, they are
  /// ended by a signal or get wrong results. view(alignedCopy(...)) no longer depends on the file.
  /// @throws Error(File) as for view(), and for files that cannot be read.
  [[nodiscard]] static MeshSDF open(const std::filesystem::path& path,
                                    const MeshViewOptions& options = {});

  /// Writes toBytes() to a file that appears under its name only once it is complete.
  /// @throws Error(File) if it cannot be written.
  void save(const std::filesystem::path& path, std::uint64_t source = 0) const;

  /// The triangles with their patches, before the placement. Faces with more corners stay cut, and
  /// faces that were turned stay turned.
  [[nodiscard]] PolygonSoup soup() const;

  /// Size in bytes of the block that queries use.
  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  explicit MeshSDF(std::shared_ptr<const MeshIndex<T>> index);
};

extern template class MeshSDF<float>;
extern template class MeshSDF<double>;

}  // namespace cutwater
