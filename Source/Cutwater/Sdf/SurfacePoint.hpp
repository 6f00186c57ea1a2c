#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace cutwater {

/// The part of a polygonal surface that a point lies on.
enum class Feature : std::uint8_t { None, Face, Edge, Vertex };

/// What the surface at a point belongs to, as far as that is known.
struct SurfaceOwner {
  std::uint32_t object = 0;    ///< operand of the outermost composite that decides there
  std::uint32_t patch = 0;     ///< index into patchNames()
  std::uint32_t face = kNone;  ///< polygon of the file, for meshes

  bool operator==(const SurfaceOwner&) const = default;
};

/// A point of the surface nearest to a query point, with what is known about it.
template <std::floating_point T>
struct SurfacePoint {
  Vec3<T> point;
  Vec3<T> normal;  ///< unit, out of the solid; at edges and vertices of a mesh the pseudonormal
  /// The value of signedDistance() at the query point; NaN if that point was not finite.
  T distance = std::numeric_limits<T>::quiet_NaN();
  /// No point of the surface is nearer than |query - point| - tolerance.
  T tolerance = std::numeric_limits<T>::infinity();
  /// Whether the tolerance is only rounding.
  bool exact = false;
  Feature feature = Feature::None;
  SurfaceOwner owner;
  std::uint32_t triangle = kNone;  ///< triangle of the mesh that `barycentric` refers to
  Vec3<T> barycentric;             ///< weights of the triangle's vertices; their sum is 1
};

/// Where a segment passes through the surface.
template <std::floating_point T>
struct Crossing {
  T parameter{};  ///< along the segment, 0 at its start, 1 at its end
  Vec3<T> point;
  Vec3<T> normal;         ///< unit, out of the solid
  bool entering = false;  ///< from outside to inside
  SurfaceOwner owner;
};

/// Called with one crossing after the other along the segment; returns whether to continue.
template <std::floating_point T>
using CrossingVisitor = FunctionRef<bool(const Crossing<T>&)>;

/// The same for many segments: called with the index of one and its next crossing.
template <std::floating_point T>
using CrossingsVisitor = FunctionRef<void(std::size_t, const Crossing<T>&)>;

/// The result of a search for crossings along a segment.
struct CrossingCount {
  std::size_t found = 0;
  /// Stretches in which the surface comes so close that an even number of further crossings cannot
  /// be excluded.
  std::size_t unresolved = 0;
};

/// The first crossing of a segment, if there is one.
template <std::floating_point T>
struct FirstHit {
  bool found = false;
  Crossing<T> crossing;        ///< only if one was found
  std::size_t unresolved = 0;  ///< as in CrossingCount, of the part searched: up to the crossing
};

/// The crossings of many segments, one segment after the other.
template <std::floating_point T>
struct CrossingLists {
  std::vector<Crossing<T>> crossings;
  std::vector<std::size_t> offsets{0};  ///< those of segment i are [offsets[i], offsets[i + 1])
  std::vector<std::size_t> unresolved;  ///< for each segment, as in CrossingCount

  /// The crossings of one segment, in order.
  [[nodiscard]] std::span<const Crossing<T>> of(std::size_t segment) const {
    return std::span(crossings).subspan(offsets[segment], offsets[segment + 1] - offsets[segment]);
  }
};

/// A flat piece of a surface: a triangle, or a single sample point, with all three corners equal.
template <std::floating_point T>
struct SurfaceFacet {
  std::array<Vec3<T>, 3> corners;
  Vec3<T> normal;  ///< unit vector, out of the solid; zero if undefined
  /// Normals of the facets across the edges from corner 0 to 1, 1 to 2 and 2 to 0. Zero for edges
  /// that cannot meet the box of the query, and where there is no facet.
  std::array<Vec3<T>, 3> across;
  SurfaceOwner owner;
};

/// Called with one facet after the other, in any order; returns whether to continue.
template <std::floating_point T>
using FacetVisitor = FunctionRef<bool(const SurfaceFacet<T>&)>;

/// @cond forward
template <std::floating_point T>
class Solid;
/// @endcond

/// Called with one surface after the other, each given by a solid that it bounds. It counts only
/// where it lies in the surface of `operand`, as the plane of a face does in that of a cuboid;
/// null: of the solid that was asked. Points of the box that are on the same side of all surfaces
/// are all in the solid, or all outside.
template <std::floating_point T>
using SurfaceVisitor = FunctionRef<void(const Solid<T>& surface, const Solid<T>* operand)>;

}  // namespace cutwater
