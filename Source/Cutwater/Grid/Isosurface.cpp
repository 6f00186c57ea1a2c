#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/TileTriangles.hpp>
#include <Cutwater/Grid/Isosurface.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

using detail::Triangle;

void addTriangles(const std::vector<Triangle>& triangles, PolygonSoup& soup) {
  if (triangles.size() >= kNone || soup.points.size() >= kNone) {
    throw Error(ErrorKind::Limit, "isosurface: more than 2^32 - 2 triangles or points");
  }
  soup.patches.assign(triangles.size(), 0);
  soup.offsets.reserve(triangles.size() + 1);
  soup.corners.reserve(3 * triangles.size());
  for (const auto& triangle : triangles) {
    soup.corners.insert(soup.corners.end(), triangle.begin(), triangle.end());
    soup.offsets.push_back(soup.corners.size());
  }
}

/// Gives the first `count` triangles the patches of the solid, and the others a patch of their own.
template <std::floating_point T>
void setPatches(const SignedDistanceFunction<T>& solid, PolygonSoup& soup, std::size_t count,
                int threads) {
  if (soup.patchNames.size() > 1) {
    parallelFor(count, {.threads = threads, .grain = 256}, [&](std::size_t begin, std::size_t end) {
      for (auto n = begin; n < end; ++n) {
        const auto corner = [&](std::size_t i) { return soup.points[soup.polygon(n)[i]]; };
        const auto middle = (1.0 / 3) * (corner(0) + corner(1) + corner(2));
        soup.patches[n] = solid.owner(Vec3<T>(middle)).patch;
      }
    });
  }
  if (count == soup.patches.size()) return;
  const auto ends = static_cast<std::uint32_t>(soup.patchNames.size());
  soup.patchNames.emplace_back("end of grid");
  std::fill(soup.patches.begin() + static_cast<std::ptrdiff_t>(count), soup.patches.end(), ends);
}

}  // namespace

template <std::floating_point T>
PolygonSoup isosurface(const SignedDistanceFunction<T>& solid, const GridPatch<T>& nodes,
                       const IsosurfaceOptions& options) {
  require(nodes.level.centering() == Centering::Node, "isosurface: need a level of nodes");
  for (int axis = 0; axis < 3; ++axis) {
    require(nodes.indices.length(axis) >= 2, "isosurface: need two nodes along each axis",
            Named{"axis", axis});
    if (nodes.indices.length(axis) > std::size_t{1} << 31U) {
      throw Error(ErrorKind::Limit, "isosurface: more than 2^31 nodes along an axis");
    }
  }
  require(options.tolerance >= 1e-9 && options.tolerance <= 0.5,
          "isosurface: need 1e-9 <= tolerance <= 0.5", Named{"tolerance", options.tolerance});
  require(options.featureAngle > 0, "isosurface: need featureAngle > 0",
          Named{"featureAngle", options.featureAngle});
  require(options.threads >= 0, "isosurface: need threads >= 0", Named{"threads", options.threads});

  const detail::SurfaceGrid<T> grid{solid, nodes, options.tolerance};
  const ParallelOptions parallel{.threads = options.threads, .progress = options.progress};
  detail::SurfaceTiles<T> tiles(grid, parallel);
  PolygonSoup result;
  tiles.takePoints(result.points);

  const detail::SharpFeatures<T> features(solid, options.featureAngle);
  auto triangles =
      detail::tileTriangles(grid, tiles, features, result.points, {.threads = options.threads});
  const std::size_t count = triangles.size();
  detail::closeGridEnds(grid, tiles, result.points, triangles);
  addTriangles(triangles, result);
  result.patchNames = solid.patchNames();
  setPatches(solid, result, count, options.threads);
  return result;
}

template <std::floating_point T>
GridPatch<T> nodesAround(const Box<T>& box, T spacing) {
  require(!box.empty() && isFinite(box.lower) && isFinite(box.upper),
          "nodesAround: need a box that is finite and not empty");
  require(spacing > 0 && std::isfinite(spacing), "nodesAround: need a positive, finite spacing",
          Named{"spacing", spacing});
  std::array<std::int32_t, 3> count{};
  Vec3<T> origin;
  for (int axis = 0; axis < 3; ++axis) {
    const T cells = std::ceil(box.size()[axis] / spacing) + 2;
    require(cells < T(0x1p31) - 128, "nodesAround: need less than 2^31 nodes along each axis",
            Named{"axis", axis}, Named{"spacing", spacing});
    count[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(cells) + 1;
    origin[axis] = box.center()[axis] - T(0.5) * cells * spacing;
  }
  return {Level<T>(origin, {spacing, spacing, spacing}, Centering::Node),
          IndexBox::ofSize(count[0], count[1], count[2])};
}

template PolygonSoup isosurface(const SignedDistanceFunction<float>&, const GridPatch<float>&,
                                const IsosurfaceOptions&);
template PolygonSoup isosurface(const SignedDistanceFunction<double>&, const GridPatch<double>&,
                                const IsosurfaceOptions&);
template GridPatch<float> nodesAround(const Box<float>&, float);
template GridPatch<double> nodesAround(const Box<double>&, double);

}  // namespace cutwater
