#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <span>

/// Surfaces of simple solids as polygon meshes: closed, oriented outwards, without duplicate
/// points, with all points on the exact surface. Each is one patch, named after the solid. For
/// tests, examples and demonstrations.
///
/// The functions throw Error(Argument) for sizes that are not finite and positive and for too few
/// parts, and Error(Limit) for more than 2^32 - 2 corners.
namespace cutwater::tessellation {

/// A ball about the origin: an icosahedron whose triangles are each cut into four, `subdivisions`
/// times (at most 12): 20 * 4^subdivisions triangles.
[[nodiscard]] PolygonSoup icosphere(double radius, int subdivisions);

/// A box with n x n rectangles on each side.
[[nodiscard]] PolygonSoup box(const Vec3<double>& lower, const Vec3<double>& upper, int n = 1);

/// A torus about the z axis: n sections around the axis, m around the tube; planar quads.
/// Needs 0 < minor < major.
[[nodiscard]] PolygonSoup torus(double major, double minor, int n, int m);

/// A cylinder about the z axis from z = 0 to z = height: n planar quads, and two polygons of n
/// corners.
[[nodiscard]] PolygonSoup cylinder(double radius, double height, int n);

/// A cone about the z axis with its base at z = 0 and its tip at z = height: n triangles, and one
/// polygon of n corners.
[[nodiscard]] PolygonSoup cone(double radius, double height, int n);

/// All points within `radius` of the segment from (0, 0, 0) to (0, 0, height): n sections around
/// the axis, m from each pole to the equator; planar quads and triangles.
[[nodiscard]] PolygonSoup capsule(double radius, double height, int n, int m);

/// A point of a profile: its distance from the z axis, and its height.
struct ProfilePoint {
  double radius;
  double z;
};

/// How a profile ends.
enum class ProfileEnds {
  OnAxis,  ///< an open curve from bottom to top; its ends are poles or get flat lids
  Closed,  ///< a closed curve, counter-clockwise in the (radius, z) plane, off the axis
};

/// The body of revolution of a profile about the z axis, in n sections.
/// @throws Error(Argument) unless radii are positive (at the ends of an open profile they may be 0)
/// and there are enough points for a solid.
[[nodiscard]] PolygonSoup revolve(std::span<const ProfilePoint> profile, int n, ProfileEnds ends);

}  // namespace cutwater::tessellation
