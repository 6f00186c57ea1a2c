#pragma once

#include <Cutwater/Surface/Cleaning/Openings.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

#include <string>

namespace cutwater {

/// Options of extendTo() and extendToBox(): names of new patches.
struct ExtendOptions {
  std::string sides = "sides";    ///< the patch of the walls below the rim
  std::string bottom = "bottom";  ///< and of the flat end
  std::string apron = "apron";    ///< and of what reaches out to the box: extendToBox() only
};

/// Makes a solid of a surface such as a terrain: its rims are extended along an axis (0, 1, 2) to
/// the plane where that coordinate is `level`, beyond the surface on either side, and closed there.
///
/// Vertical walls lead from every rim to the plane, with two triangles per edge; a hole in the
/// surface becomes a shaft. The result is closed and oriented, with its faces outward: the solid
/// lies between the surface and the plane. Of a surface of several parts, each may face either way.
/// Points of the surface do not move. If the surface met itself, it still does.
///
/// @throws Error(Argument) unless the level lies beyond all points of faces, and for a soup that
/// does not pass PolygonSoup::validate(); Error(Topology) if there is no rim, if the orientations
/// of faces disagree (run clean() first), also of parts that touch at a point; if, seen along the
/// axis, rims meet or one part lies within the rim of another and not in a hole of it; or if a wall
/// would meet the surface elsewhere than at its rim, because the surface hangs over or under a rim.
/// All of this is decided exactly. The soup is then unchanged.
OpeningReport extendTo(PolygonSoup& soup, int axis, double level,
                       const ExtendOptions& options = {});

/// One of the two ends of a box along an axis.
enum class BoxEnd : std::uint8_t { Lower, Upper };

/// The same for a surface that ends short of the sides of a domain: first an apron connects its
/// outer rim to the four sides of the box along the axis, then the whole is extended to the box's
/// end.
///
/// At each of its points on the sides, the apron is as high as the nearest point of the rim; these
/// points are about a mean edge of the rim apart. Seen along the axis, the apron lies outside the
/// rim. A surface that reaches the sides or beyond needs no apron: use extendTo(), and the domain
/// cuts off what is outside.
///
/// @throws Error as extendTo(), also where the apron would meet the surface; of kind Topology also
/// unless one rim surrounds all others and lies within the sides of the box.
OpeningReport extendToBox(PolygonSoup& soup, const Box<double>& box, int axis,
                          BoxEnd end = BoxEnd::Lower, const ExtendOptions& options = {});

}  // namespace cutwater
