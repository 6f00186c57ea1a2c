#pragma once

#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Core/Segment.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <array>

namespace cutwater {

// Signs of small determinants of coordinates, always correct: J. R. Shewchuk, "Adaptive precision
// floating-point arithmetic and fast robust geometric predicates", Discrete Comput. Geom. 18
// (1997). A filter in double decides nearly all cases, then twice the precision, then exact
// expansions; or whole numbers, if a coordinate has bits below 2^-340, so that products of three
// would underflow.
//
// Coordinates must be scaled by a power of two so that the surface's largest is about 1; they may
// be up to 2^60, and as small as doubles can be.

/// 1 if `p` lies on the side of the plane of (a, b, c) to which (b - a) x (c - a) points, -1 if on
/// the other side, 0 if in the plane, or if a, b, c are collinear.
[[nodiscard]] int orientation(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c,
                              const Vec3<double>& p);

/// The sign of one component of (b - a) x (d - c). With c = a: orientation in the projection along
/// that axis.
[[nodiscard]] int crossSign(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c,
                            const Vec3<double>& d, int axis);

/// How the directed segment passes through the triangle: 1 from back to front, that is, along the
/// normal (b - a) x (c - a); -1 from front to back; 0 if it does not.
///
/// There are no degenerate cases: the result is that for the segment moved by (e, e^2, e^3), e > 0
/// smaller than anything else (simulation of simplicity; Edelsbrunner and Muecke, ACM Trans. Graph.
/// 9 (1990)). So a segment through an edge or a vertex of a closed surface passes through each
/// sheet exactly once, and never through one in whose plane it lies.
[[nodiscard]] int passage(const Segment<double>& segment,
                          const std::array<Vec3<double>, 3>& triangle);

/// The side of the triangle's plane on which the point lies, moved as passage() moves segments:
/// like orientation(), but 0 only for triangles without area.
[[nodiscard]] int sideOf(const Vec3<double>& point, const std::array<Vec3<double>, 3>& triangle);

/// Whether the point lies on the closed triangle; false for triangles without area.
[[nodiscard]] bool isOnTriangle(const Vec3<double>& point,
                                const std::array<Vec3<double>, 3>& triangle);

/// Without bits below 2^-340, so that products of three do not underflow.
[[nodiscard]] double coarse(double x);

/// a - b, exactly if both are coarse: what the determinants below are made of.
[[nodiscard]] DoubleDouble exactDifference(double a, double b);

/// The sign of the determinant of three rows. Entries are results of exactDifference(), or doubles.
[[nodiscard]] int determinantSign(const std::array<DoubleDouble3, 3>& rows);

/// The sign of a d - b c.
[[nodiscard]] int determinantSign(DoubleDouble a, DoubleDouble b, DoubleDouble c, DoubleDouble d);

}  // namespace cutwater
