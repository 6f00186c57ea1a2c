#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafAssembly.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutAssembly.hpp>
#include <Cutwater/CutCells/Detail/Tiles/PlaneCut.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Detail/HoleCaps.hpp>
#include <Cutwater/Triangles/OpenEdges.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace cutwater {

namespace {

template <std::floating_point T>
const MeshSDF<T>& checkedMesh(const Solid<T>& solid, const CutterOptions& options) {
  const auto* const mesh = solid.template as<MeshSDF<T>>();
  require(mesh != nullptr, "cut cells: need a mesh: make one of the solid, see isosurface()");
  const auto& signs = mesh->signReport();
  if (signs.unorientable > 0) {
    throw Error(ErrorKind::Topology,
                "cut cells: need a surface with two sides: " + signs.summary());
  }
  if (!signs.isClosed() && !options.capHoles) {
    throw Error(ErrorKind::Topology,
                "cut cells: need a surface that is closed, see CutterOptions::capHoles: " +
                    signs.summary());
  }
  return *mesh;
}

/// The triangles with their vertices in the world, those in one place merged: where parts touch
/// along an edge, it is one edge.
template <std::floating_point T>
PolygonSoup placedTriangles(const Solid<T>& solid, const MeshSDF<T>& mesh) {
  auto soup = mesh.soup();
  const auto placement = solid.placement();
  if (!placement.isIdentity()) {
    for (auto& p : soup.points) p = Vec3<double>(placement.toWorld(Vec3<T>(p)));
  }
  weldExactly(soup);
  return soup;
}

void checkOptions(const CutOptions& options) {
  require(options.moments >= -1 && options.moments <= CutCells::Moments::kHighest,
          "cut cells: need a degree of moments from 0 to 4, or -1",
          Named{"moments", options.moments});
}

/// Closes the holes of triangles whose points are all different.
void addCaps(PolygonSoup& soup) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto p = soup.polygon(i);
    triangles.push_back({p[0], p[1], p[2]});
  }
  const auto edges = findOpenEdges(triangles, soup.points.size());
  const auto caps = capHoles<double>(soup.points, edges);
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  const auto patch = static_cast<std::uint32_t>(soup.patchNames.size());
  soup.patchNames.emplace_back("cap");
  soup.points.insert(soup.points.end(), caps.positions.begin(), caps.positions.end());
  for (const auto& [a, b, c] : caps.triangles) {
    soup.addPolygon(std::array{first + a, first + b, first + c});
    soup.patches.back() = patch;
  }
  weldExactly(soup);
}

template <std::floating_point T>
std::shared_ptr<const CutSurface> surfaceOf(const Solid<T>& solid, FluidSide side,
                                            const CutterOptions& options) {
  const auto& mesh = checkedMesh(solid, options);
  auto triangles = placedTriangles(solid, mesh);
  if (!mesh.signReport().isClosed()) addCaps(triangles);
  const auto open = patchesCalled(options.openPatches, triangles.patchNames);
  return std::make_shared<const CutSurface>(triangles, side, mesh.signReport().isSound(), open);
}

void checkPlanes(const CellPlanes& grid) {
  for (const auto& planes : grid.planes) {
    require(planes.size() >= 4,
            "cut cells: need two planes across each axis, and one on each side");
    for (std::size_t i = 0; i < planes.size(); ++i) {
      require(std::isfinite(planes[i]) && (i == 0 || planes[i] > planes[i - 1]),
              "cut cells: need planes that ascend", Named{"plane", planes[i]});
    }
  }
}

std::array<std::vector<double>, 3> inFrame(const CutFrame& frame, const CellPlanes& grid) {
  auto result = grid.planes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (auto& plane : result[axis]) plane = frame.toFrame(static_cast<int>(axis), plane);
  }
  return result;
}

/// Cuts the tiles that have triangles, by cutOne(tile); null for the others.
std::vector<std::unique_ptr<const TileCut>> cutAll(const CutTiles& tiles, const CutOptions& options,
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

}  // namespace

template <std::floating_point T>
CellCutter::CellCutter(const Solid<T>& solid, FluidSide side, const CutterOptions& options)
    : surface_(surfaceOf(solid, side, options)) {}

CutCells CellCutter::cut(const CellPlanes& grid, const CutOptions& options) const {
  checkPlanes(grid);
  checkOptions(options);
  const auto positions = inFrame(surface_->frame(), grid);
  const GridPlanes planes{{positions[0], positions[1], positions[2]}};
  const CutTiles tiles(*surface_, planes);
  const auto cuts = cutAll(tiles, options, [&](std::size_t tile) {
    return cutTile(*surface_, tiles.input(tile), options);
  });
  return assembledCells(grid, *surface_, tiles, cuts, options);
}

CutCells CellCutter::cutInPlane(const CellPlanes& grid, double z, const CutOptions& options) const {
  require(!options.polygons && options.moments < 0,
          "cut cells: there are no polygons and no moments in a plane");
  CellPlanes layer = grid;
  layer.planes[2] = {z - 1.5, z - 0.5, z + 0.5, z + 1.5};
  checkPlanes(layer);
  const auto& frame = surface_->frame();
  const auto positions = inFrame(frame, layer);
  const auto around = planesAround(frame.toFrame(2, z));
  const GridPlanes planes{{positions[0], positions[1], around}};
  const CutTiles tiles(*surface_, planes);
  const double thickness = positions[2][2] - positions[2][1];
  const auto cuts = cutAll(tiles, options, [&](std::size_t tile) {
    return cutTileInPlane(*surface_, tiles, tile, thickness);
  });
  return assembledCells(std::move(layer), *surface_, tiles, cuts, options);
}

template <std::floating_point T>
CutLeaves CellCutter::cut(const OctreeCells<T>& mesh, const CutOptions& options) const {
  checkOptions(options);
  const LeafGrid grid(mesh, surface_->frame());
  std::vector<FluidClass> classes(grid.leaves().size(), FluidClass::Fluid);
  const auto tiles = cutLeafTiles(*surface_, grid, options, classes);
  return assembledLeaves(*surface_, grid, tiles, std::move(classes), options);
}

template <std::floating_point T>
CellPlanes planesOf(const GridPatch<T>& gridPatch) {
  const auto& [level, box] = gridPatch;
  CellPlanes result{.planes = {}, .first = box.lo};
  for (int axis = 0; axis < 3; ++axis) {
    auto& planes = result.planes[static_cast<std::size_t>(axis)];
    auto index = box.lo;
    auto& along = axis == 0 ? index.i : axis == 1 ? index.j : index.k;
    --along;
    for (std::size_t n = 0; n < box.length(axis) + 2; ++n, ++along) {
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
template CellPlanes planesOf(const GridPatch<float>&);
template CellPlanes planesOf(const GridPatch<double>&);

}  // namespace cutwater
