#include <Cutwater/Repair/Detail/AlphaWrap.hpp>
#include <Cutwater/Repair/Detail/NearestPatches.hpp>
#include <Cutwater/Repair/Detail/UnitFrame.hpp>
#include <Cutwater/Repair/Wrap.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cutwater {
namespace {

void check(const WrapOptions& options, double offset) {
  require(options.gap > 0 && std::isfinite(options.gap), "wrap: need 0 < gap < infinity",
          Named{"gap", options.gap});
  require(offset > 0 && std::isfinite(offset), "wrap: need 0 < offset < infinity",
          Named{"offset", offset});
}

/// Refuses wraps that would be too large, or whose offset would be lost in rounding.
void checkSize(const PolygonSoup& soup, const WrapOptions& options, double offset, double area) {
  const auto box = soup.boundingBox();
  if (soup.polygonCount() == 0 || box.diagonal() == 0) {
    throw Error(ErrorKind::Topology, "wrap: there is nothing to wrap");
  }
  // Points are about half a gap apart on the surface, on both sides of it if it is a sheet.
  const double expected = 8 * area / (options.gap * options.gap);
  if (expected > static_cast<double>(options.mostTriangles)) {
    throw Error(ErrorKind::Limit,
                "wrap: a gap of " + detail::toText(options.gap) + " on a surface of area " +
                    detail::toText(area) + " would make about " + detail::toText(expected) +
                    " triangles, at most " +
                    detail::toText(static_cast<long long>(options.mostTriangles)) +
                    " are allowed: take a larger gap");
  }
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    farthest = std::max({farthest, std::abs(box.lower[axis]), std::abs(box.upper[axis])});
  }
  if (offset < 1e4 * std::numeric_limits<double>::epsilon() * farthest) {
    throw Error(ErrorKind::Limit, "wrap: an offset of " + detail::toText(offset) +
                                      " is lost in the rounding of coordinates of " +
                                      detail::toText(farthest));
  }
}

}  // namespace

WrapReport wrap(PolygonSoup& soup, const WrapOptions& options) {
  soup.validate();
  const detail::Deadline deadline("wrap", options.seconds);
  const double offset = options.offset.value_or(options.gap / 30);
  check(options, offset);
  WrapReport report;
  report.facesBefore = soup.polygonCount();
  report.offset = offset;
  report.before = measure(soup);
  checkSize(soup, options, offset, report.before.area);

  auto triangles = triangulated(soup);
  const detail::UnitFrame frame(soup.boundingBox());
  frame.moveInside(triangles);
  const double alpha = options.gap / 2;
  auto wrapped =
      detail::alphaWrap(triangles, alpha / frame.size(), offset / frame.size(), deadline);
  frame.moveOutside(wrapped);

  const auto range = detail::takeNearestPatches(wrapped, soup);
  report.nearest = range.least;
  report.farthest = range.greatest;
  report.facesAfter = wrapped.polygonCount();
  report.after = measure(wrapped);
  soup = std::move(wrapped);
  report.seconds = deadline.elapsed();
  return report;
}

}  // namespace cutwater
