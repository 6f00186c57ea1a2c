#pragma once

#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <limits>
#include <string>

namespace cutwater {

/// Options of fillHoles().
struct HoleOptions {
  /// Rims with more edges stay open. Time grows with the cube of their number where the surrounding
  /// surface is crumpled, otherwise little more than linearly.
  std::size_t mostEdges = 200;
  /// Rims whose box has a longer diagonal stay open (a length).
  double widest = std::numeric_limits<double>::infinity();
  /// The patch of the new faces; empty: that of most faces along the rim.
  std::string patch = {};
  /// Holes not filled within this time stay open.
  double seconds = 60;
};

/// What fillHoles() did; each rim is located by one of its points.
struct HoleReport {
  Findings<Vec3<double>> filled;
  Findings<Vec3<double>> tooLong;     ///< left: more edges than `mostEdges`
  Findings<Vec3<double>> tooWide;     ///< left: wider than `widest`
  Findings<Vec3<double>> unfillable;  ///< left: no valid triangulation of its points
  Findings<Vec3<double>> late;        ///< left: out of time
  std::size_t facesAdded = 0;
  double areaAdded = 0;
  double widestFilled = 0;  ///< a length
  /// Pairs of faces, one of them new, that intersect beyond shared points and edges: the surface
  /// passes through the hole, or there is no way around it.
  std::size_t crossings = 0;
  SurfaceMeasure before;
  SurfaceMeasure after;
  double seconds = 0;

  /// Number of rims that stay open.
  [[nodiscard]] std::size_t left() const {
    return tooLong.count + tooWide.count + unfillable.count + late.count;
  }
  /// The findings, each on a line that ends with '\n'.
  [[nodiscard]] std::string text() const;
};

/// Closes small holes with triangles between the points of their rims, oriented as the faces beside
/// them. Of all triangulations of the rim (or only of those made of faces of the Delaunay
/// tetrahedra of its points, if one of them is good), chooses the one whose sharpest edge, rim
/// included, is the least sharp, and of these the smallest (Liepa, "Filling holes in meshes", 2003;
/// by CGAL).
///
/// Accepts any soup. Rims follow from the orientation of faces, so call clean() first. Rims that
/// touch at a point are filled separately. No triangle repeats an edge of the surface;
/// intersections of new faces with others are detected and reported. No point is added or moved.
///
/// If it throws, the soup is unchanged. Do not call while other threads use CGAL, whose error
/// handlers it replaces meanwhile.
/// @throws Error(Argument) for a soup that does not pass PolygonSoup::validate(), `widest` not
/// positive, or `seconds` not positive.
HoleReport fillHoles(PolygonSoup& soup, const HoleOptions& options = {});

}  // namespace cutwater
