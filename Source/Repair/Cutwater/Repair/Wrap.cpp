#include <Cutwater/Repair/Detail/AlphaWrap.hpp>
#include <Cutwater/Repair/Detail/NearestPatches.hpp>
#include <Cutwater/Repair/Detail/UnitFrame.hpp>
#include <Cutwater/Repair/Wrap.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Text/Numbers.hpp>

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

constexpr auto kNoLimit = std::numeric_limits<std::size_t>::max();

/// Triangles that a wrap has about: points are about half a gap apart on the surface, on both sides
/// of it if it is a sheet.
double expectedTriangles(double area, double gap) {
  return 8 * area / (gap * gap);
}

/// Refuses wraps that would be too large, or whose offset would be lost in rounding.
void checkSize(const PolygonSoup& soup, const WrapOptions& options, double offset, double area) {
  const auto box = soup.boundingBox();
  if (soup.polygonCount() == 0 || box.diagonal() == 0) {
    throw Error(ErrorKind::Topology, "wrap: there is nothing to wrap");
  }
  const double expected = expectedTriangles(area, options.gap);
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

double WrapEstimate::gapWithin(double most) const {
  const double rest = most - secondsAtOnce;
  if (rest <= 0) return std::numeric_limits<double>::infinity();
  const double least = gap * std::sqrt((seconds - secondsAtOnce) / rest);
  const double digit = std::pow(10, std::floor(std::log10(least)) - 1);
  return text::rounded(std::ceil(least / digit - 1e-9) * digit, 2);
}

WrapEstimate estimateWrap(const PolygonSoup& soup, const WrapOptions& options) {
  soup.validate();
  const double ratio = options.offset.value_or(options.gap / 30) / options.gap;
  check(options, ratio * options.gap);
  const double area = measure(soup).area;
  checkSize(soup, {.gap = options.gap, .mostTriangles = kNoLimit}, ratio * options.gap, area);
  // A gap of twice the width has a quarter of the triangles. What does not shrink is spent anyway.
  constexpr double kCoarse = 4000;
  const double gap = std::max(options.gap, std::sqrt(expectedTriangles(area, 1) / kCoarse));
  WrapEstimate found{.gap = options.gap};
  WrapReport reports[2];
  for (int n = 0; n < 2; ++n) {
    auto copy = soup;
    const double wide = gap * (2 - n);
    reports[n] = wrap(copy, {.gap = wide, .offset = ratio * wide, .seconds = options.seconds});
  }
  const auto& [wide, narrow] = reports;
  const double growth = (gap / options.gap) * (gap / options.gap);
  found.triangles = growth * static_cast<double>(narrow.facesAfter);
  const double share =
      std::max(narrow.seconds - wide.seconds, 0.1 * narrow.seconds) /
      std::max(1.0, static_cast<double>(narrow.facesAfter) - static_cast<double>(wide.facesAfter));
  found.secondsAtOnce =
      std::max(0.0, narrow.seconds - share * static_cast<double>(narrow.facesAfter));
  found.seconds = found.secondsAtOnce + share * found.triangles;
  return found;
}

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
      detail::alphaWrap(triangles, alpha / frame.size(), offset / frame.size(), deadline,
                        expectedTriangles(report.before.area, options.gap) / 2, options.progress);
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
