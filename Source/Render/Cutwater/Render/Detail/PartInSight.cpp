#include <Cutwater/Render/Detail/PartInSight.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace cutwater::detail {

namespace {

constexpr double kLooks = 120;  // along the longer side

/// The first and the last point of a row that see something, if any does.
struct Stretch {
  int first = 0;
  int last = -1;
};

Stretch stretchOf(std::span<const SurfaceSample> row) {
  Stretch stretch;
  for (int i = 0; i < static_cast<int>(row.size()); ++i) {
    const auto& sample = row[static_cast<std::size_t>(i)];
    if (!sample.isHit() && sample.passed == kNone) continue;
    if (stretch.last < 0) stretch.first = i;
    stretch.last = i;
  }
  return stretch;
}

}  // namespace

std::optional<Frame> partInSight(SampleTracer trace, const Frame& frame,
                                 const ParallelOptions& options) {
  const double spacing = std::max(frame.width, frame.height) / kLooks;
  const int columns = static_cast<int>(std::ceil(frame.width / spacing));
  const int rows = static_cast<int>(std::ceil(frame.height / spacing));
  const double left = frame.centerX - 0.5 * columns * spacing;
  const double top = frame.centerY - 0.5 * rows * spacing;
  std::vector<Stretch> stretches(static_cast<std::size_t>(rows));
  parallelFor(stretches.size(), options, [&](std::size_t begin, std::size_t end) {
    std::vector<PicturePoint> points(static_cast<std::size_t>(columns));
    std::vector<SurfaceSample> samples(points.size());
    for (std::size_t row = begin; row < end; ++row) {
      const double y = top + (static_cast<double>(row) + 0.5) * spacing;
      for (int i = 0; i < columns; ++i) {
        points[static_cast<std::size_t>(i)] = {left + (i + 0.5) * spacing, y};
      }
      trace(points, {.spacing = spacing}, samples);
      stretches[row] = stretchOf(samples);
    }
  });
  int x0 = columns, x1 = -1, y0 = rows, y1 = -1;
  for (int row = 0; row < rows; ++row) {
    const auto& stretch = stretches[static_cast<std::size_t>(row)];
    if (stretch.last < 0) continue;
    x0 = std::min(x0, stretch.first);
    x1 = std::max(x1, stretch.last);
    y0 = std::min(y0, row);
    y1 = row;
  }
  if (x1 < 0) return {};
  // The visible part may end anywhere before the next point.
  return Frame{left + 0.5 * (x0 + x1 + 1) * spacing, top + 0.5 * (y0 + y1 + 1) * spacing,
               (x1 - x0 + 2) * spacing, (y1 - y0 + 2) * spacing};
}

template <std::floating_point T>
std::optional<Frame> partOfFacets(const SignedDistanceFunction<T>& solid, const Camera& camera,
                                  const Frame& frame) {
  std::array<Interval<double>, 2> part;
  part.fill({std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()});
  const bool areAll = solid.facetsIn(solid.boundingBox(), [&](const SurfaceFacet<T>& facet) {
    for (const auto& corner : facet.corners) {
      const auto at = camera.project(Vec3<double>(corner));
      for (std::size_t i = 0; i < 2; ++i) {
        part[i] = {std::min(part[i].lower, at[i]), std::max(part[i].upper, at[i])};
      }
    }
    return true;
  });
  const std::array<double, 2> center{frame.centerX, frame.centerY};
  const std::array<double, 2> size{frame.width, frame.height};
  for (std::size_t i = 0; i < 2; ++i) {
    part[i] = {std::max(part[i].lower, center[i] - 0.5 * size[i]),
               std::min(part[i].upper, center[i] + 0.5 * size[i])};
    if (!areAll || !(part[i].lower < part[i].upper)) return {};
  }
  const auto& [x, y] = part;
  return Frame{0.5 * (x.lower + x.upper), 0.5 * (y.lower + y.upper), x.upper - x.lower,
               y.upper - y.lower};
}

template std::optional<Frame> partOfFacets(const SignedDistanceFunction<float>&, const Camera&,
                                           const Frame&);
template std::optional<Frame> partOfFacets(const SignedDistanceFunction<double>&, const Camera&,
                                           const Frame&);

}  // namespace cutwater::detail
