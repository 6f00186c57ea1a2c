#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Curved/CertifiedRows.hpp>
#include <Cutwater/CutCells/Detail/Curved/CurvedTile.hpp>
#include <Cutwater/CutCells/Detail/Curved/SolidImages.hpp>
#include <Cutwater/CutCells/Detail/CutArguments.hpp>
#include <Cutwater/CutCells/Detail/Leaves/CurvedLeaves.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafAssembly.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/GaussPoints.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutAssembly.hpp>
#include <Cutwater/CutCells/Detail/Tiles/PeriodicPlanes.hpp>

namespace cutwater {

template <std::floating_point T>
SolidCutter::SolidCutter(const Solid<T>& solid, FluidSide side, const SolidCutterOptions& options)
    : options_(options) {
  require(options.points >= 1 && options.points <= kMostGaussPoints,
          "cut cells: need 1 to 6 points of a Gauss rule", Named{"points", options.points});
  require(options.tolerance > 0 && options.tolerance <= 1,
          "cut cells: need a tolerance above 0, and 1 at most",
          Named{"tolerance", options.tolerance});
  period_ = std::make_shared<const CutPeriod>(periodOf(solid, options.period));
  field_ = fluidBeside(solid, side, *period_);
}

CellPlanes SolidCutter::cellsOfPeriod(const std::array<std::vector<double>, 3>& planes,
                                      const Index3& first, const IndexBox& box) const {
  return planesOfPeriod(*period_, planes, first, box);
}

Vec3<double> SolidCutter::period() const {
  return period_->length;
}

template <std::floating_point T>
CellPlanes SolidCutter::gridOf(const GridPatch<T>& gridPatch) const {
  return planesOf(*period_, gridPatch);
}

CutCells SolidCutter::cut(const CellPlanes& grid, const CutOptions& options) const {
  checkPlanes(grid);
  return cut(*field_, grid, options);
}

CutCells SolidCutter::cutInPlane(const CellPlanes& grid, double z,
                                 const CutOptions& options) const {
  refuseInPlane(options);
  refusePeriod(*period_, "cut cells: there are no periods in a plane");
  return cut(*sectionAt(*field_, z), layerAt(grid, z), options);
}

template <std::floating_point T>
CutLeaves SolidCutter::cut(const OctreeCells<T>& mesh, const CutOptions& options) const {
  checkOptions(options);
  refusePeriod(*period_, "cut cells: there are no periods in an octree");
  const CutFrame world;
  const LeafGrid grid(mesh, world);
  std::vector<FluidClass> classes(grid.leaves().size(), FluidClass::Fluid);
  const auto tiles = cutLeafTiles(*field_, grid, options_, options, classes);
  return assembledLeaves({.grid = grid,
                          .tiles = tiles,
                          .frame = world,
                          .patchNames = field_->patchNames(),
                          .gauss = gaussPoints(options_.points)},
                         std::move(classes), options);
}

CertifiedCells SolidCutter::certified(const CutCells& cells, const CertifyOptions& options) const {
  return certifiedCells(*field_, cells, *period_, options);
}

template <std::floating_point T>
CertifiedLeaves SolidCutter::certified(const CutLeaves& leaves, const OctreeCells<T>& mesh,
                                       const CertifyOptions& options) const {
  refusePeriod(*period_, "cut cells: there are no periods in an octree");
  require(leaves.classes.size() == mesh.cells().size(), "certified: need the mesh of these leaves",
          Named{"leaves", leaves.classes.size()}, Named{"cells", mesh.cells().size()});
  std::vector<Box<double>> boxes;
  for (const auto& leaf : mesh.cells()) {
    const auto box = mesh.box(leaf);
    boxes.push_back({Vec3<double>(box.lower), Vec3<double>(box.upper)});
  }
  return certifiedLeaves(*field_, leaves, boxes, options);
}

CertifiedCells SolidCutter::certifiedInPlane(const CutCells& cells, double z,
                                             const CertifyOptions& options) const {
  requireInPrecision(*field_, z);
  return certifiedCells(*sectionAt(*field_, z), cells, {}, options);
}

CutCells SolidCutter::cut(const FluidField& field, const CellPlanes& grid,
                          const CutOptions& options) const {
  checkOptions(options);
  const CutBlocks tiles(stretchesOf(grid, *period_), *period_);
  std::vector<std::unique_ptr<const TileCut>> cuts(tiles.count());
  std::vector<char> isBody(tiles.count());
  parallelFor(tiles.count(), {.threads = options.threads, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                for (auto tile = begin; tile < end; ++tile) {
                  const auto planes = tiles.planesOf(tile);
                  const auto whole = wholeBox(field, boxOf(planes));
                  isBody[tile] = whole.isFluid ? 0 : 1;
                  if (whole.isWhole) continue;
                  cuts[tile] =
                      std::make_unique<const TileCut>(cutTile(field, planes, options_, options));
                }
              });
  const auto isBodyTile = [&](std::size_t tile) { return isBody[tile] != 0; };
  return assembledCells(grid, {tiles, cuts, isBodyTile, field.patchNames()}, options);
}

template SolidCutter::SolidCutter(const Solid<float>&, FluidSide, const SolidCutterOptions&);
template SolidCutter::SolidCutter(const Solid<double>&, FluidSide, const SolidCutterOptions&);
template CellPlanes SolidCutter::gridOf(const GridPatch<float>&) const;
template CellPlanes SolidCutter::gridOf(const GridPatch<double>&) const;
template CutLeaves SolidCutter::cut(const OctreeCells<float>&, const CutOptions&) const;
template CutLeaves SolidCutter::cut(const OctreeCells<double>&, const CutOptions&) const;
template CertifiedLeaves SolidCutter::certified(const CutLeaves&, const OctreeCells<float>&,
                                                const CertifyOptions&) const;
template CertifiedLeaves SolidCutter::certified(const CutLeaves&, const OctreeCells<double>&,
                                                const CertifyOptions&) const;

}  // namespace cutwater
