#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/CutArguments.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafAssembly.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutAssembly.hpp>
#include <Cutwater/CutCells/Detail/Surface/CapAngles.hpp>
#include <Cutwater/CutCells/Detail/Surface/SurfaceOfSolid.hpp>
#include <Cutwater/CutCells/Detail/Tiles/PeriodicPlanes.hpp>
#include <Cutwater/CutCells/Detail/Tiles/PlaneCut.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace cutwater {

namespace {

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
  const CutBlocks tiles(*surface_, stretchesOf(grid, surface_->period(), surface_->frame()));
  const auto cuts = cutAll(tiles, options, [&](std::size_t tile) {
    return cutTile(*surface_, tiles.input(tile), options);
  });
  return assembledOf(grid, *surface_, tiles, cuts, options);
}

CutCells CellCutter::cutInPlane(const CellPlanes& grid, double z, const CutOptions& options) const {
  refuseInPlane(options);
  auto layer = layerAt(grid, z);
  refusePeriod(surface_->period(), "cut cells: there are no periods in a plane");
  const auto& frame = surface_->frame();
  require(!surface_->hasBaffleAt(frame.toFrame(2, z)), "cut cells: a baffle lies in the plane",
          Named{"z", z});
  auto stretches = stretchesOf(layer, surface_->period(), frame);
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
  refusePeriod(surface_->period(), "cut cells: there are no periods in an octree");
  const LeafGrid grid(mesh, surface_->frame());
  std::vector<FluidClass> classes(grid.leaves().size(), FluidClass::Fluid);
  const auto tiles = cutLeafTiles(*surface_, grid, options, classes);
  return assembledLeaves({.grid = grid,
                          .tiles = tiles,
                          .frame = surface_->frame(),
                          .patchNames = surface_->patchNames(),
                          .surface = surface_.get(),
                          .gauss = gaussOfDegree(options.quadratureDegree)},
                         std::move(classes), options);
}

CellPlanes CellCutter::cellsOfPeriod(const std::array<std::vector<double>, 3>& planes,
                                     const Index3& first, const IndexBox& box) const {
  return planesOfPeriod(surface_->period(), planes, first, box);
}

Vec3<double> CellCutter::period() const {
  return surface_->period().length;
}

template <std::floating_point T>
CellPlanes CellCutter::gridOf(const GridPatch<T>& gridPatch) const {
  return planesOf(surface_->period(), gridPatch);
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
