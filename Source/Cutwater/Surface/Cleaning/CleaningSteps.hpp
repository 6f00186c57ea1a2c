#pragma once

#include <Cutwater/Surface/Cleaning/CleanReport.hpp>

// The steps of clean(), for those who choose them one by one.
namespace cutwater {

/// Removes the points that no polygon uses; the others keep their order. Linear time.
Correction removeUnusedPoints(PolygonSoup& soup);

/// Merges points that are within `tolerance` (a length) of one another.
///
/// Points are processed in order: each joins the first of the kept points within the tolerance, or,
/// if there is none, is kept where it is. So no point moves by more than the tolerance, chains of
/// close points do not contract, kept points are farther apart than the tolerance, and welding
/// again changes nothing. The tolerance should be well below the length of the edges that matter:
/// shorter ones vanish. Faces may be left with repeated corners; see removeDegenerateFaces().
///
/// Near-linear time, with a grid of cells of twice the tolerance. The correction counts the points
/// merged away and holds how far the farthest of them moved.
/// @throws Error(Argument) unless 0 < tolerance < infinity, or for a point that is not finite.
Correction weldWithin(PolygonSoup& soup, double tolerance);

/// Closes cracks between surfaces that were meshed separately: a point of one rim that lies on an
/// edge of another rim, or within `tolerance` (a length) of it, becomes part of that edge, so it is
/// no longer a T-junction. Triangles with the edge are cut, larger polygons get another corner; no
/// point moves.
///
/// A rim consists of edges with an odd number of faces. A point is inserted into an edge only if it
/// is farther than the tolerance from both of its ends, and nearer to each than they are to each
/// other. Weld first, so that closer points are one.
///
/// The correction counts the points inserted, with the distance of the farthest. n log n for n
/// corners.
/// @throws Error(Argument) unless 0 < tolerance < infinity.
Correction splitJunctions(PolygonSoup& soup, double tolerance);

/// Removes faces without area or without three distinct corners, and corners that repeat another.
///
/// This opens nothing: along every edge, the number of polygons that run one way minus that of
/// those that run the other way stays the same. A corner that repeats the one before is removed,
/// and so is a spike (a b a). A polygon that passes a corner twice becomes triangles. The corners
/// of a face without area lie on a line; its longer edges are passed to and fro, and the faces
/// across them get the corners in between: the neighbour of a needle is cut in two at the needle's
/// third corner.
///
/// Whether a face has area is decided as by check(): exactly, except for a rounding of 2^-98 of the
/// product of its sides. The correction counts faces that were removed or lost corners.
///
/// Corners must be indices of points. At most n log n for n corners, times the number of needles
/// that lean on one another.
Correction removeDegenerateFaces(PolygonSoup& soup);

/// The treatment of two faces with the same corners and opposite orientations.
enum class OppositeFaces : std::uint8_t {
  Cancel,  ///< both are removed: together they bound nothing
  Keep,    ///< both stay: sheets of no thickness, such as baffles with a face on either side
};

/// Removes faces with the same cycle of corners and the same orientation as an earlier face.
///
/// Orientations may still be wrong. So of two faces with opposite orientations, the later one is a
/// duplicate, too, if more than half of their edges have an odd number of faces: the surface needs
/// one of them there. Where it needs none or both, see cancelOppositeFaces().
///
/// Polygons with repeated corners are skipped: see removeDegenerateFaces(). n log n for n corners,
/// times the number of duplicates of that kind that lie side by side.
Correction removeDuplicateFaces(PolygonSoup& soup);

/// Removes pairs of faces with the same cycle of corners and opposite orientations; both faces are
/// counted. Of several equal faces, the last ones are removed first. Skips the same polygons;
/// linear time.
Correction cancelOppositeFaces(PolygonSoup& soup);

/// How shells inside other closed shells are oriented.
enum class NestedShells : std::uint8_t {
  /// A shell oriented opposite to the one around it is a cavity and stays one.
  AsTheyAre,
  /// Alternating: the outermost are solids, a shell within one shell is a cavity, within two a
  /// solid.
  Cavities,
  /// All face outward: parts of an assembly, whose union is meant.
  Solids,
};

/// What orientFaces() turned.
struct OrientationCorrections {
  Correction faces;              ///< turned to agree with their neighbours
  Correction shells;             ///< turned as a whole: the middle of the first face of each
  std::size_t unorientable = 0;  ///< parts like a Moebius strip
};

/// Turns faces so that the surface faces outward. Faces connected across edges of exactly two faces
/// are made to agree; the majority decides. Faces connected across edges of any kind then form a
/// shell and are judged together. Points, corners and their order within a face stay the same,
/// except for the direction.
///
/// A closed shell is inside out if its volume is negative and it is not a cavity, that is, not
/// within any other closed shell (decided exactly, for one of its vertices). It is turned together
/// with the shells within it, so its cavities stay cavities. An open shell is judged by the volume
/// that it encloses together with fans from the middle of its rim. But if its rim is longer than
/// the root of its area and it would enclose less than a tenth of a sphere of the same area, it is
/// a sheet and stays as it is. This holds for NestedShells::AsTheyAre; otherwise, whether a shell
/// is turned depends on how many closed shells it lies within, or not even on that.
/// @throws Error(Argument) as DcelMesh does.
OrientationCorrections orientFaces(PolygonSoup& soup,
                                   NestedShells nested = NestedShells::AsTheyAre);

}  // namespace cutwater
