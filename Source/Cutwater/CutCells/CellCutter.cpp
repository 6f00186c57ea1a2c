#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/CutArguments.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafAssembly.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutAssembly.hpp>
#include <Cutwater/CutCells/Detail/Surface/CapAngles.hpp>
#include <Cutwater/CutCells/Detail/Surface/SurfaceOfSolid.hpp>
#include <Cutwater/CutCells/Detail/Tiles/PlaneCut.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace cutwater {

namespace {

void refuseQuadrature(const CutOptions& options) {
  require(!options.quadrature, "cut cells: there is no quadrature of meshes, see SolidCutter");
}

void refusePeriod(const CutPeriod& period, const char* message) {
  require(!period.isOnAny(), message, Named{"period", period.length});
}

/// The planes between cells [first, last] and around them, of a grid with these planes.
std::vector<double> planesFrom(const std::vector<double>& planes, std::int64_t first,
                               std::int64_t last, int axis) {
  const auto all = cellsBetween({planes, planes, planes}).planes[0];
  require(first >= 0 && last + 2 <= std::ssize(planes),
          "cut cells: need a box between the planes along axes without a period",
          Named{"axis", axis}, Named{"first", first}, Named{"last", last});
  return {all.begin() + first, all.begin() + last + 4};
}

/// The same, of planes that repeat.
std::vector<double> repeatedFrom(const CutPeriod& period, const std::vector<double>& planes,
                                 std::int64_t first, std::int64_t last, int axis) {
  const auto cells = std::ssize(planes) - 1;
  const double length = period.length[axis];
  const double rounding = 1e-9 * length;
  require(cells >= 2 && std::abs(planes.back() - planes.front() - length) <= rounding,
          "cut cells: need two cells or more that together are as long as the period",
          Named{"axis", axis}, Named{"cells", cells}, Named{"period", length});
  std::vector<double> result;
  for (auto n = first - 1; n <= last + 2; ++n) {
    const auto periods = n / cells - (n % cells < 0 ? 1 : 0);
    const auto within = static_cast<std::size_t>(n - periods * cells);
    result.push_back(period.rounded(planes[within]) + static_cast<double>(periods) * length);
    require(period.has(result.back()), "cut cells: need a box that is less far away",
            Named{"axis", axis}, Named{"plane", result.back()});
  }
  return result;
}

/// Cuts the tiles that have triangles, by cutOne(tile); null for the others.
std::vector<std::unique_ptr<const TileCut>> cutAll(const CutBlocks& tiles,
                                                   const CutOptions& options,
                                                   FunctionRef<TileCut(std::size_t)> cutOne) {
  std::vector<std::uint32_t> touched;
  for (std::uint32_t tile = 0; tile < tiles.count(); ++tile) {
    if (!tiles.triangles(tile).empty()) touched.push_back(tile);
  }
  std::vector<std::unique_ptr<const TileCut>> cuts(tiles.count());
  parallelFor(touched.size(), {.threads = options.threads, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                for (auto i = begin; i < end; ++i) {
                  cuts[touched[i]] = std::make_unique<const TileCut>(cutOne(touched[i]));
                }
              });
  return cuts;
}

CutCells assembledOf(CellPlanes grid, const CutSurface& surface, const CutBlocks& tiles,
                     std::span<const std::unique_ptr<const TileCut>> cuts,
                     const CutOptions& options) {
  const auto isBody = [&](std::size_t tile) { return tiles.winding(tile) > 0; };
  return assembledCells(std::move(grid), {tiles, cuts, isBody, surface.patchNames(), &surface},
                        options);
}

}  // namespace

template <std::floating_point T>
CellCutter::CellCutter(const Solid<T>& solid, FluidSide side, const CutterOptions& options) {
  HoleCaps caps;
  surface_ = surfaceOf(solid, side, options, caps);
  if (!caps.triangles.empty()) {
    caps_ = std::make_shared<const CapAngles>(caps, surface_->frame());
  }
}

CutCells CellCutter::cut(const CellPlanes& grid, const CutOptions& options) const {
  checkPlanes(grid);
  checkOptions(options);
  refuseQuadrature(options);
  const CutBlocks tiles(*surface_, stretchesOf(*surface_, grid));
  const auto cuts = cutAll(tiles, options, [&](std::size_t tile) {
    return cutTile(*surface_, tiles.input(tile), options);
  });
  return assembledOf(grid, *surface_, tiles, cuts, options);
}

CutCells CellCutter::cutInPlane(const CellPlanes& grid, double z, const CutOptions& options) const {
  require(!options.polygons && options.moments < 0,
          "cut cells: there are no polygons and no moments in a plane");
  refuseQuadrature(options);
  auto layer = layerAt(grid, z);
  refusePeriod(surface_->period(), "cut cells: there are no periods in a plane");
  const auto& frame = surface_->frame();
  require(!surface_->hasBaffleAt(frame.toFrame(2, z)), "cut cells: a baffle lies in the plane",
          Named{"z", z});
  auto stretches = stretchesOf(*surface_, layer);
  auto& heights = stretches[2].front().positions;
  const double thickness = heights[2] - heights[1];
  const auto around = planesAround(frame.toFrame(2, z));
  heights.assign(around.begin(), around.end());
  const CutBlocks tiles(*surface_, std::move(stretches));
  const auto cuts = cutAll(tiles, options, [&](std::size_t tile) {
    return cutTileInPlane(*surface_, tiles, tile, thickness);
  });
  return assembledOf(std::move(layer), *surface_, tiles, cuts, options);
}

template <std::floating_point T>
CutLeaves CellCutter::cut(const OctreeCells<T>& mesh, const CutOptions& options) const {
  checkOptions(options);
  refuseQuadrature(options);
  refusePeriod(surface_->period(), "cut cells: there are no periods in an octree");
  const LeafGrid grid(mesh, surface_->frame());
  std::vector<FluidClass> classes(grid.leaves().size(), FluidClass::Fluid);
  const auto tiles = cutLeafTiles(*surface_, grid, options, classes);
  return assembledLeaves({grid, tiles, surface_->frame(), surface_->patchNames(), surface_.get()},
                         std::move(classes), options);
}

CellPlanes CellCutter::cellsOfPeriod(const std::array<std::vector<double>, 3>& planes,
                                     const Index3& first, const IndexBox& box) const {
  const auto& period = surface_->period();
  CellPlanes result{.planes = {}, .first = box.lo};
  const std::array from{std::int64_t{box.lo.i} - first.i, std::int64_t{box.lo.j} - first.j,
                        std::int64_t{box.lo.k} - first.k};
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    const auto last = from[a] + static_cast<std::int64_t>(box.length(axis)) - 1;
    require(planes[a].size() >= 2, "cut cells: need two planes across each axis",
            Named{"axis", axis});
    result.planes[a] = period.isOn(axis) ? repeatedFrom(period, planes[a], from[a], last, axis)
                                         : planesFrom(planes[a], from[a], last, axis);
    if (period.isOn(axis)) {
      result.period[a] = static_cast<std::int32_t>(planes[a].size() - 1);
    }
  }
  return result;
}

Vec3<double> CellCutter::period() const {
  return surface_->period().length;
}

template <std::floating_point T>
CellPlanes CellCutter::gridOf(const GridPatch<T>& gridPatch) const {
  auto result = planesOf(gridPatch);
  const auto& period = surface_->period();
  const std::array first{result.first.i, result.first.j, result.first.k};
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    if (!period.isOn(axis)) continue;
    const auto spacing = double{gridPatch.level.spacing()[axis]};
    constexpr double kMost = 0x1p26;
    const auto cells = std::llround(std::min(period.length[axis] / spacing, kMost));
    std::vector<double> planes;
    for (std::int32_t n = 0; n <= cells; ++n) {
      Index3 index;
      along(index, axis) = n;
      planes.push_back(double{gridPatch.level.cell(index).lower[axis]});
    }
    const auto last = first[a] + static_cast<std::int64_t>(gridPatch.indices.length(axis)) - 1;
    result.planes[a] = repeatedFrom(period, planes, first[a], last, axis);
    result.period[a] = static_cast<std::int32_t>(cells);
  }
  return result;
}

template <std::floating_point T>
CellPlanes planesOf(const GridPatch<T>& gridPatch) {
  const auto& [level, box] = gridPatch;
  CellPlanes result{.planes = {}, .first = box.lo};
  for (int axis = 0; axis < 3; ++axis) {
    auto& planes = result.planes[static_cast<std::size_t>(axis)];
    auto index = box.lo;
    auto& number = along(index, axis);
    --number;
    for (std::size_t n = 0; n < box.length(axis) + 2; ++n, ++number) {
      planes.push_back(double{level.cell(index).lower[axis]});
    }
    planes.push_back(double{level.cell(index).lower[axis]});
  }
  return result;
}

template CellCutter::CellCutter(const Solid<float>&, FluidSide, const CutterOptions&);
template CellCutter::CellCutter(const Solid<double>&, FluidSide, const CutterOptions&);
template CutLeaves CellCutter::cut(const OctreeCells<float>&, const CutOptions&) const;
template CutLeaves CellCutter::cut(const OctreeCells<double>&, const CutOptions&) const;
template CellPlanes CellCutter::gridOf(const GridPatch<float>&) const;
template CellPlanes CellCutter::gridOf(const GridPatch<double>&) const;
template CellPlanes planesOf(const GridPatch<float>&);
template CellPlanes planesOf(const GridPatch<double>&);

}  // namespace cutwater
