#pragma once

#include <Cutwater/Mesh/MeshReport.hpp>
#include <Cutwater/Mesh/SurfaceMeasure.hpp>

#include <limits>
#include <string>

namespace cutwater {

/// Options of fillHoles().
struct HoleOptions {
  /// Rims of more edges stay open. Time grows with the cube of their number where the surface
  /// around is crumpled, and else little more than linearly.
  std::size_t mostEdges = 200;
  /// Rims whose box has a longer diagonal stay open (a length).
  double widest = std::numeric_limits<double>::infinity();
  /// The patch of the new faces; nothing: that of most faces along the rim.
  std::string patch = {};
  /// What is not filled by then stays open.
  double seconds = 60;
};

/// What fillHoles() did; a point of each rim is its place.
struct HoleReport {
  Findings<Vec3<double>> filled;
  Findings<Vec3<double>> tooLong;     ///< left: more edges than `mostEdges`
  Findings<Vec3<double>> tooWide;     ///< left: wider than `widest`
  Findings<Vec3<double>> unfillable;  ///< left: no triangles between its points would do
  Findings<Vec3<double>> late;        ///< left: the time was up
  std::size_t facesAdded = 0;
  double areaAdded = 0;
  double widestFilled = 0;  ///< a length
  /// Pairs of faces, one of them new, that meet in more than they share: the surface passes through
  /// the hole, or there is no way around it.
  std::size_t crossings = 0;
  SurfaceMeasure before;
  SurfaceMeasure after;
  double seconds = 0;

  /// How many rims stay open.
  [[nodiscard]] std::size_t left() const {
    return tooLong.count + tooWide.count + unfillable.count + late.count;
  }
  /// A line each, ended by '\n', of what there is to tell.
  [[nodiscard]] std::string text() const;
};

/// Closes small holes by triangles between the points of their rims, oriented as the faces beside
/// them: of all triangulations of the rim (or, if there is a good one among them, of those that the
/// Delaunay tetrahedra of its points offer) the one whose sharpest edge, those of the rim included,
/// is the least sharp, and of these the smallest (Liepa, "Filling holes in meshes", 2003; by CGAL).
///
/// Any soup will do. A rim follows from the orientation of faces, so clean() comes first; where
/// rims touch at a point each is filled for itself. A triangle that would repeat an edge of the
/// surface is not made; whether new faces meet others is looked at and reported. No point is added
/// or moved.
///
/// If it throws, the soup is as it was. Not to be called while other threads use CGAL, whose
/// handlers of errors it replaces meanwhile.
/// @throws Error(Argument) for a soup that does not pass PolygonSoup::validate(), `widest` not
/// positive, or `seconds` not positive.
HoleReport fillHoles(PolygonSoup& soup, const HoleOptions& options = {});

}  // namespace cutwater
