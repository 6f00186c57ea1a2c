// Cut cells for C.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>

#include <algorithm>
#include <array>
#include <limits>

#include "Arguments.hpp"
#include "Handles.hpp"

using namespace cutwater;
using namespace cutwater::binding;

struct cw_cells {
  explicit cw_cells(CutCells cells) : rows(std::move(cells)) {
    const auto most = std::max({rows.cells.index.size(), rows.pieces.cell.size(),
                                rows.arcs.area.size(), rows.wallParts.area.size()});
    if (most > std::numeric_limits<std::int32_t>::max()) {
      throw Error(ErrorKind::Limit, "more than 2^31 - 1 rows: cut smaller boxes");
    }
  }

  CutCells rows;
};

namespace {

const CutCells& rowsOf(const cw_cells* handle) {
  require(handle != nullptr, "the cells are NULL");
  return handle->rows;
}

FluidSide sideOf(int fluidInside) {
  return fluidInside != 0 ? FluidSide::Inside : FluidSide::Outside;
}

const CellCutter& cutterOf(const cw_cutter* handle) {
  require(handle != nullptr, "the cutter is NULL");
  return handle->cutter;
}

/// `array`: what the caller calls it. `missing`: what is wrong if one is NULL.
std::vector<std::string> patchesOf(const char* array, const char* const* names, std::int64_t count,
                                   const char* missing) {
  std::vector<std::string> result;
  for (const auto* name : arrayOf(array, names, count)) {
    require(name != nullptr, missing, Named{"number", result.size()});
    result.emplace_back(name);
  }
  return result;
}

CutterOptions optionsOf(const cw_cutter_options& given) {
  return {.capHoles = given.capHoles != 0,
          .openPatches = patchesOf("openPatches", given.openPatches, given.openPatchCount,
                                   "the name of an open patch is NULL"),
          .baffles = patchesOf("baffles", given.baffles, given.baffleCount,
                               "the name of a baffle is NULL"),
          .period = {given.period[0], given.period[1], given.period[2]}};
}

CutOptions optionsOf(int polygons, int threads) {
  return {.polygons = polygons != 0, .threads = threads};
}

/// Cells around the box have indices, too.
void requireIndices(int axis, std::int32_t first, std::int64_t last) {
  using Limits = std::numeric_limits<std::int32_t>;
  require(first > Limits::min() && last < Limits::max(),
          "need cells whose neighbours have indices of 32 bits", Named{"axis", axis},
          Named{"first", first}, Named{"last", last});
}

std::vector<double> planesAcross(const cw_planes& planes, int axis) {
  constexpr std::array kNames{"across[0]", "across[1]", "across[2]"};
  const auto across =
      arrayOf(kNames.at(static_cast<std::size_t>(axis)), planes.across[axis], planes.counts[axis]);
  requireIndices(axis, planes.first[axis],
                 std::int64_t{planes.first[axis]} + std::ssize(across) - 2);
  return {across.begin(), across.end()};
}

GridPatch<double> cellsOf(const cw_grid* grid) {
  require(grid != nullptr, "the grid is NULL");
  for (int axis = 0; axis < 3; ++axis) requireIndices(axis, grid->lo[axis], grid->hi[axis]);
  auto unstrided = *grid;
  std::ranges::fill(unstrided.strides, 0);
  return gridPatchOf(unstrided);
}

CellPlanes cellPlanesOf(const cw_planes& planes) {
  return cellsBetween({planesAcross(planes, 0), planesAcross(planes, 1), planesAcross(planes, 2)},
                      {planes.first[0], planes.first[1], planes.first[2]});
}

/// The array as C has it: unsigned integers as signed ones of the same size, which may alias, and
/// vectors as numbers in a row.
template <typename Number, typename Record>
const Number* numbersOf(const std::vector<Record>& records) {
  static_assert(sizeof(Record) % sizeof(Number) == 0 && alignof(Record) == alignof(Number));
  return reinterpret_cast<const Number*>(records.data());
}
static_assert(static_cast<std::int32_t>(CutCells::kWholeCell) == CW_WHOLE_CELL);
static_assert(static_cast<std::int32_t>(CutCells::kBeyond) == CW_BEYOND);
static_assert(sizeof(Index3) == 3 * sizeof(std::int32_t));

template <typename Record>
std::int64_t countOf(const std::vector<Record>& records) {
  return static_cast<std::int64_t>(records.size());
}

/// Calls make(rows) and writes what it returns where the caller wants it.
template <typename Rows, typename Make>
cw_status tell(const char* function, const cw_cells* cells, Rows* result, Make make) {
  return guarded(function, [&] {
    const auto& rows = rowsOf(cells);
    require(result != nullptr, "the result is NULL");
    *result = make(rows);
  });
}

cw_polygons polygonsOf(const CutCells::Polygons& polygons) {
  return {.count = static_cast<std::int64_t>(polygons.count()),
          .first = numbersOf<std::int64_t>(polygons.first),
          .points = numbersOf<double>(polygons.points)};
}

}  // namespace

void cw_free_cells(cw_cells* cells) {
  delete cells;
}

void cw_free_cutter(cw_cutter* cutter) {
  delete cutter;
}

cw_status cw_make_cutter(const cw_solid* solid, const cw_cutter_options* options,
                         cw_cutter** result) {
  return create("cw_make_cutter", result, [&] {
    const auto& handle = handleOf(solid);
    const auto given = options != nullptr ? *options : cw_cutter_options{};
    return CellCutter(handle.solid, sideOf(given.fluidInside), optionsOf(given));
  });
}

cw_status cw_cut_grid(const cw_solid* solid, const cw_grid* grid, int fluidInside, int polygons,
                      int threads, cw_cells** result) {
  return create("cw_cut_grid", result, [&] {
    const auto& handle = handleOf(solid);
    const auto gridPatch = cellsOf(grid);
    return handle.cutter(sideOf(fluidInside)).cut(gridPatch, optionsOf(polygons, threads));
  });
}

cw_status cw_cutter_grid(const cw_cutter* cutter, const cw_grid* grid, int polygons, int threads,
                         cw_cells** result) {
  return create("cw_cutter_grid", result, [&] {
    const auto& cut = cutterOf(cutter);
    return cut.cut(cellsOf(grid), optionsOf(polygons, threads));
  });
}

cw_status cw_cutter_planes(const cw_cutter* cutter, const cw_planes* planes, int polygons,
                           int threads, cw_cells** result) {
  return create("cw_cutter_planes", result, [&] {
    const auto& cut = cutterOf(cutter);
    require(planes != nullptr, "the planes are NULL");
    const auto grid = cellPlanesOf(*planes);
    if (cut.period() == Vec3<double>{}) return cut.cut(grid, optionsOf(polygons, threads));
    std::array<std::vector<double>, 3> own;
    for (std::size_t a = 0; a < 3; ++a) {
      own[a].assign(grid.planes[a].begin() + 1, grid.planes[a].end() - 1);
    }
    return cut.cut(cut.cellsOfPeriod(own, grid.first, grid.indices()),
                   optionsOf(polygons, threads));
  });
}

cw_status cw_cut_planes(const cw_solid* solid, const cw_planes* planes, int fluidInside,
                        int polygons, int threads, cw_cells** result) {
  return create("cw_cut_planes", result, [&] {
    const auto& handle = handleOf(solid);
    require(planes != nullptr, "the planes are NULL");
    const auto grid = cellPlanesOf(*planes);
    return handle.cutter(sideOf(fluidInside)).cut(grid, optionsOf(polygons, threads));
  });
}

cw_status cw_coarsened(const cw_cells* cells, const int32_t ratios[3], cw_cells** result) {
  return create("cw_coarsened", result, [&] {
    const auto& rows = rowsOf(cells);
    const auto by = arrayOf("ratios", ratios, 3);
    return coarsened(rows, {by[0], by[1], by[2]});
  });
}

cw_status cw_merged(const cw_cells* cells, double smallest, cw_cells** result) {
  return create("cw_merged", result,
                [&] { return merged(rowsOf(cells), {.smallest = smallest}).cells; });
}

cw_status cw_save_cells(const cw_cells* cells, const char* path) {
  return guarded("cw_save_cells", [&] {
    const auto& rows = rowsOf(cells);
    require(path != nullptr, "the path is NULL");
    saveCutCells(path, rows);
  });
}

cw_status cw_load_cells(const char* path, cw_cells** result) {
  return create("cw_load_cells", result, [&] {
    require(path != nullptr, "the path is NULL");
    return loadCutCells(path);
  });
}

cw_status cw_fluid_fractions(const cw_cells* cells, double* fractions, int64_t count) {
  return guarded("cw_fluid_fractions", [&] {
    const auto& rows = rowsOf(cells);
    const auto out = arrayOf("fractions", fractions, count);
    const auto box = rows.grid.indices();
    require(out.size() == box.count(), "need as many fractions as cells", Named{"count", count},
            Named{"cells", box.count()});
    std::ranges::fill(out, 1.0);
    for (const auto& [first, last] : rows.bodyRuns) {
      std::ranges::fill(out.subspan(first, last - first), 0.0);
    }
    for (std::size_t row = 0; row < rows.cellCount; ++row) {
      const auto& cell = rows.cells.index[row];
      const auto along = [](std::int32_t at, std::int32_t lo) {
        return static_cast<std::size_t>(std::int64_t{at} - lo);
      };
      const auto place =
          (along(cell.k, box.lo.k) * box.length(1) + along(cell.j, box.lo.j)) * box.length(0) +
          along(cell.i, box.lo.i);
      double sum = 0;
      for (auto p = rows.cells.firstPiece[row]; p < rows.cells.firstPiece[row + 1]; ++p) {
        sum += rows.volumeFraction(p);
      }
      out[place] = std::min(sum, 1.0);
    }
  });
}

cw_status cw_cells_rows(const cw_cells* cells, cw_cut_cells* rows) {
  return tell("cw_cells_rows", cells, rows, [](const CutCells& all) -> cw_cut_cells {
    const auto own = static_cast<std::int64_t>(all.cellCount);
    return {.count = own,
            .countAround = countOf(all.cells.index) - own,
            .index = numbersOf<std::int32_t>(all.cells.index),
            .firstPiece = numbersOf<std::int32_t>(all.cells.firstPiece),
            .fluidCorners = all.cells.fluidCorners.data(),
            .meets = all.cells.meets.data(),
            .wallFaces = all.cells.wallFaces.data()};
  });
}

cw_status cw_cells_pieces(const cw_cells* cells, cw_pieces* rows) {
  return tell("cw_cells_pieces", cells, rows, [](const CutCells& all) -> cw_pieces {
    const auto own = static_cast<std::int64_t>(all.pieceCount);
    return {.count = own,
            .countAround = countOf(all.pieces.cell) - own,
            .cell = numbersOf<std::int32_t>(all.pieces.cell),
            .volume = all.pieces.volume.data(),
            .centroid = numbersOf<double>(all.pieces.centroid),
            .wallArea = all.pieces.wallArea.data(),
            .wallVector = numbersOf<double>(all.pieces.wallVector),
            .wallCentroid = numbersOf<double>(all.pieces.wallCentroid),
            .wallFaces = all.pieces.wallFaces.data()};
  });
}

cw_status cw_cells_arcs(const cw_cells* cells, cw_arcs* rows) {
  return tell("cw_cells_arcs", cells, rows, [](const CutCells& all) -> cw_arcs {
    return {.count = countOf(all.arcs.area),
            .below = numbersOf<std::int32_t>(all.arcs.below),
            .above = numbersOf<std::int32_t>(all.arcs.above),
            .area = all.arcs.area.data(),
            .centroid = numbersOf<double>(all.arcs.centroid),
            .cell = numbersOf<std::int32_t>(all.arcs.cell),
            .axis = all.arcs.axis.data()};
  });
}

cw_status cw_cells_open_arcs(const cw_cells* cells, cw_open_arcs* rows) {
  return tell("cw_cells_open_arcs", cells, rows, [](const CutCells& all) -> cw_open_arcs {
    return {.count = countOf(all.openArcs.arc),
            .arc = numbersOf<std::int32_t>(all.openArcs.arc),
            .patch = numbersOf<std::int32_t>(all.openArcs.patch)};
  });
}

cw_status cw_cells_patch_count(const cw_cells* cells, int32_t* count) {
  return tell("cw_cells_patch_count", cells, count,
              [](const CutCells& all) { return static_cast<std::int32_t>(all.patchNames.size()); });
}

cw_status cw_cells_patch_name(const cw_cells* cells, int32_t patch, const char** name) {
  return tell("cw_cells_patch_name", cells, name, [&](const CutCells& all) {
    require(patch >= 0 && patch < std::ssize(all.patchNames), "there is no such patch",
            Named{"patch", patch});
    return all.patchNames[static_cast<std::size_t>(patch)].c_str();
  });
}

cw_status cw_cells_wall_parts(const cw_cells* cells, cw_wall_parts* rows) {
  return tell("cw_cells_wall_parts", cells, rows, [](const CutCells& all) -> cw_wall_parts {
    return {.count = countOf(all.wallParts.area),
            .piece = numbersOf<std::int32_t>(all.wallParts.piece),
            .patch = numbersOf<std::int32_t>(all.wallParts.patch),
            .area = all.wallParts.area.data(),
            .vector = numbersOf<double>(all.wallParts.vector),
            .centroid = numbersOf<double>(all.wallParts.centroid)};
  });
}

cw_status cw_cells_arc_polygons(const cw_cells* cells, cw_polygons* polygons) {
  return tell("cw_cells_arc_polygons", cells, polygons,
              [](const CutCells& all) { return polygonsOf(all.arcPolygons); });
}

cw_status cw_cells_wall_polygons(const cw_cells* cells, cw_polygons* polygons,
                                 const int64_t** firstOfPart) {
  return guarded("cw_cells_wall_polygons", [&] {
    const auto& all = rowsOf(cells);
    require(polygons != nullptr && firstOfPart != nullptr, "the result is NULL");
    const auto& first = all.firstWallPolygon;
    *polygons = polygonsOf(all.wallPolygons);
    *firstOfPart = first.empty() ? nullptr : numbersOf<std::int64_t>(first);
  });
}
