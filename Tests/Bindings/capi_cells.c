/* Cut cells through the C API: answers that are known by hand, and everything that is refused.
   Views are static where they start empty: zeros in C and in C++. */

#include "capi.h"

/* The cube in two layers of cells of half its side, the upper of which reaches above it. */
static cw_cells* cellsOfTheCube(const cw_solid* cube, int polygons) {
  static const double x[3] = {-0.25, 0.25, 0.75};
  static const double z[3] = {0.25, 0.75, 1.5};
  cw_planes planes = {{x, x, z}, {3, 3, 3}, {-1, 0, 5}};
  cw_cells* cells = NULL;
  CHECK(cw_cut_planes(cube, &planes, 0, polygons, 0, &cells) == CW_OK);
  return cells;
}

static void cutCells(void) {
  const cw_mesh arrays = cubeArrays();
  cw_solid* cube = NULL;
  cw_cells* cells = NULL;
  cw_cut_cells rows;
  cw_pieces pieces;
  cw_arcs arcs;
  cw_wall_parts walls;
  double fractions[8];
  int64_t i = 0;
  double volume = 0, area = 0, sides = 0, open = 0;
  CHECK(cw_from_mesh(&arrays, 1, &cube) == CW_OK);
  cells = cellsOfTheCube(cube, 0);
  cw_free(cube); /* the cells stay */
  CHECK(cw_cells_rows(cells, &rows) == CW_OK);
  /* All but the one in the middle of the body are cut. */
  CHECK(rows.count == 7 && rows.index[0] == -1 && rows.index[1] == 0 && rows.index[2] == 5);
  CHECK(rows.firstPiece[0] == 0 && rows.firstPiece[7] == 7);
  CHECK(rows.fluidCorners[0] == 0x77); /* all but the two over (0.25, 0.25) */
  CHECK(cw_cells_pieces(cells, &pieces) == CW_OK && pieces.count == 7 && pieces.cell[6] == 6);
  CHECK(pieces.countAround == rows.firstPiece[rows.count + rows.countAround] - 7);
  for (i = 0; i < pieces.count; ++i) volume += pieces.volume[i];
  /* Of the part of the cube in the box, 0.75 x 0.75 x 0.75, 0.25 is in the cell within. */
  CHECK(fabs(volume - (1.25 - 0.125 - (0.421875 - 0.125))) < 1e-14);
  CHECK(fabs(pieces.volume[0] - 0.09375) < 1e-15 && fabs(pieces.wallArea[0] - 0.25) < 1e-15);
  CHECK(fabs(pieces.wallVector[0] - 0.125) < 1e-15 && fabs(pieces.wallVector[2]) < 1e-15);
  CHECK(cw_cells_wall_parts(cells, &walls) == CW_OK);
  for (i = 0; i < walls.count; ++i) {
    if (walls.piece[i] >= pieces.count) continue;
    area += walls.area[i];
    if (walls.patch[i] == 1) sides += walls.area[i];
  }
  CHECK(fabs(area - 3 * 0.5625) < 1e-14 && fabs(sides - 2 * 0.5625) < 1e-14);
  CHECK(cw_cells_arcs(cells, &arcs) == CW_OK);
  for (i = 0; i < arcs.count; ++i) {
    if (arcs.axis[i] != 2 || arcs.cell[3 * i + 2] != 6) continue;
    open += arcs.area[i]; /* the fluid in the plane z = 0.75 */
    CHECK(arcs.below[i] < rows.firstPiece[3] && fabs(arcs.centroid[3 * i + 2] - 0.75) < 1e-15);
  }
  CHECK(fabs(open - (1 - 0.5625)) < 1e-14);
  CHECK(cw_fluid_fractions(cells, fractions, 8) == CW_OK);
  CHECK(fractions[3] == 0 && fabs(fractions[0] - 0.75) < 1e-14);
  CHECK(fabs(fractions[7] - 2.0 / 3) < 1e-14);
  cw_free_cells(cells);
}

static void polygonsOfCells(void) {
  const cw_mesh arrays = cubeArrays();
  cw_solid* cube = NULL;
  cw_cells *cells = NULL, *without = NULL;
  static cw_arcs arcs;
  static cw_wall_parts walls;
  static cw_polygons outlines, parts;
  const int64_t* first = NULL;
  CHECK(cw_from_mesh(&arrays, 1, &cube) == CW_OK);
  cells = cellsOfTheCube(cube, 1);
  without = cellsOfTheCube(cube, 0);
  cw_free(cube);
  CHECK(cw_cells_arcs(cells, &arcs) == CW_OK && cw_cells_wall_parts(cells, &walls) == CW_OK);
  CHECK(cw_cells_arc_polygons(cells, &outlines) == CW_OK && outlines.count == arcs.count);
  CHECK(outlines.first[1] - outlines.first[0] >= 4);
  CHECK(cw_cells_wall_polygons(cells, &parts, &first) == CW_OK);
  CHECK(first[0] == 0 && first[walls.count] == parts.count && parts.first[parts.count] >= 3);
  CHECK(cw_cells_wall_polygons(without, &parts, &first) == CW_OK);
  CHECK(parts.count == 0 && first == NULL);
  cw_free_cells(cells);
  cw_free_cells(without);
}

static void cellsFromCells(void) {
  const int32_t ratios[3] = {1, 2, 1};
  const cw_mesh arrays = cubeArrays();
  cw_solid* cube = NULL;
  cw_cells *cells = NULL, *coarse = NULL, *single = NULL;
  static cw_cut_cells rows;
  static cw_pieces pieces;
  static cw_wall_parts walls;
  CHECK(cw_from_mesh(&arrays, 1, &cube) == CW_OK);
  cells = cellsOfTheCube(cube, 0);
  CHECK(cw_coarsened(cells, ratios, &coarse) == CW_OK);
  CHECK(cw_cells_rows(coarse, &rows) == CW_OK && rows.count == 4 && rows.countAround == 0);
  /* The shares of fluid are 3/4, 3/4, 1/2 and, above the cube, two thirds and more: one is kept. */
  CHECK(cw_merged(cells, 0.9, &single) == CW_OK && cw_cells_pieces(single, &pieces) == CW_OK);
  CHECK(pieces.count == 1 && fabs(pieces.volume[0] - 0.171875) < 1e-15);
  CHECK(cw_cells_wall_parts(single, &walls) == CW_OK && walls.patch[walls.count - 1] == 2);
  cw_free(cube);
  cw_free_cells(cells);
  cw_free_cells(coarse);
  cw_free_cells(single);
}

static void cutters(void) {
  const double x[2] = {-0.5, 1.5};
  const char* const names[1] = {"ends"};
  const char* const unknown[1] = {"doors"};
  const char* const missing[1] = {NULL};
  const cw_mesh arrays = cubeArrays();
  const char* name = NULL;
  cw_planes planes = {{x, x, NULL}, {2, 2, 2}, {0, 0, 0}};
  const double z[2] = {0, 1};
  cw_cutter_options options = {1, 0, names, 1, {0, 0, 0}, NULL, 0};
  cw_solid* cube = NULL;
  cw_cutter *cutter = NULL, *none = NULL;
  cw_cells* cells = NULL;
  cw_open_arcs open;
  cw_arcs arcs;
  cw_pieces pieces;
  int32_t count = 0;
  planes.across[2] = z;
  CHECK(cw_from_mesh(&arrays, 1, &cube) == CW_OK);
  CHECK(cw_make_cutter(cube, &options, &cutter) == CW_OK);
  /* In the cube, which is open at both ends: its sides alone are walls. */
  CHECK(cw_cutter_planes(cutter, &planes, 0, 0, &cells) == CW_OK);
  CHECK(cw_cells_pieces(cells, &pieces) == CW_OK && pieces.count == 1);
  CHECK(fabs(pieces.volume[0] - 1) < 1e-15 && fabs(pieces.wallArea[0] - 4) < 1e-14);
  CHECK(pieces.wallFaces[0] == 0);
  CHECK(cw_cells_open_arcs(cells, &open) == CW_OK && open.count == 2);
  CHECK(open.patch[0] == 0 && open.patch[1] == 0);
  CHECK(cw_cells_arcs(cells, &arcs) == CW_OK && arcs.count == 2);
  CHECK(arcs.below[open.arc[0]] == CW_BEYOND && arcs.above[open.arc[1]] == CW_BEYOND);
  CHECK(fabs(arcs.area[0] - 1) < 1e-15);
  CHECK(cw_cells_patch_count(cells, &count) == CW_OK && count == 2);
  CHECK(cw_cells_patch_name(cells, 1, &name) == CW_OK && strcmp(name, "sides") == 0);
  REFUSED(cw_cells_patch_name(cells, 2, &name), CW_ERROR_ARGUMENT, "patch = 2");
  REFUSED(cw_cells_patch_name(cells, -1, &name), CW_ERROR_ARGUMENT, "patch = -1");
  cw_free_cells(cells);
  planes.across[2] = x;
  REFUSED(cw_cutter_planes(cutter, &planes, 0, 0, &cells), CW_ERROR_TOPOLOGY, "\"ends\"");
  REFUSED(cw_cutter_planes(cutter, NULL, 0, 0, &cells), CW_ERROR_ARGUMENT, "the planes are NULL");
  REFUSED(cw_cutter_grid(cutter, NULL, 0, 0, &cells), CW_ERROR_ARGUMENT, "the grid is NULL");
  REFUSED(cw_cutter_planes(NULL, &planes, 0, 0, &cells), CW_ERROR_ARGUMENT, "the cutter is NULL");
  cw_free_cutter(cutter);
  cw_free_cutter(NULL);
  CHECK(cw_make_cutter(cube, NULL, &cutter) == CW_OK); /* fluid outside, all are walls */
  CHECK(cw_cutter_planes(cutter, &planes, 0, 0, &cells) == CW_OK);
  CHECK(cw_cells_pieces(cells, &pieces) == CW_OK && fabs(pieces.volume[0] - 7) < 1e-14);
  cw_free_cells(cells);
  cw_free_cutter(cutter);
  options.openPatches = unknown;
  REFUSED(cw_make_cutter(cube, &options, &none), CW_ERROR_ARGUMENT, "\"doors\"");
  options.openPatches = missing;
  REFUSED(cw_make_cutter(cube, &options, &none), CW_ERROR_ARGUMENT, "number = 0");
  options.openPatches = NULL;
  REFUSED(cw_make_cutter(cube, &options, &none), CW_ERROR_ARGUMENT, "openPatches is NULL");
  REFUSED(cw_make_cutter(NULL, NULL, &none), CW_ERROR_ARGUMENT, "the solid is NULL");
  cw_free(cube);
}

/* The cube with a square in it, from (0.5, 0.25, 0.25) to (0.5, 0.75, 0.75). */
static cw_solid* cubeWithSail(void) {
  static const char* const all[3] = {"ends", "sides", "sail"};
  static const double square[12] = {0.5, 0.25, 0.25, 0.5, 0.75, 0.25,
                                    0.5, 0.75, 0.75, 0.5, 0.25, 0.75};
  static const int32_t halves[6] = {8, 9, 10, 8, 10, 11};
  double points[36];
  int32_t triangles[42];
  int32_t patches[14];
  cw_mesh mesh = cubeArrays();
  cw_solid* solid = NULL;
  memcpy(points, kPoints, sizeof kPoints);
  memcpy(points + 24, square, sizeof square);
  memcpy(triangles, kTriangles, sizeof kTriangles);
  memcpy(triangles + 36, halves, sizeof halves);
  memcpy(patches, kPatches, sizeof kPatches);
  patches[12] = patches[13] = 2;
  mesh.points = points;
  mesh.pointCount = 12;
  mesh.triangles = triangles;
  mesh.triangleCount = 14;
  mesh.patches = patches;
  mesh.patchCount = 3;
  mesh.patchNames = all;
  CHECK(cw_from_mesh(&mesh, 0, &solid) == CW_OK);
  return solid;
}

static void baffles(void) {
  static const double x[3] = {-0.5, 0.4, 1.5};
  static cw_cutter_options options;
  static const char* const names[1] = {"sail"};
  static const char* const unknown[1] = {"flag"};
  static const char* const missing[1] = {NULL};
  const cw_planes planes = {{x, x, x}, {3, 3, 3}, {0, 0, 0}};
  cw_solid* cube = cubeWithSail();
  cw_cutter *cutter = NULL, *none = NULL;
  cw_cells* cells = NULL;
  static cw_pieces pieces;
  static cw_wall_parts walls;
  int64_t i = 0;
  double volume = 0, area = 0, sail = 0;
  options.fluidInside = 1;
  REFUSED(cw_make_cutter(cube, &options, &none), CW_ERROR_TOPOLOGY, "closed");
  options.baffles = names;
  options.baffleCount = 1;
  CHECK(cw_make_cutter(cube, &options, &cutter) == CW_OK);
  CHECK(cw_cutter_planes(cutter, &planes, 0, 0, &cells) == CW_OK);
  CHECK(cw_cells_pieces(cells, &pieces) == CW_OK);
  for (i = 0; i < pieces.count; ++i) volume += pieces.volume[i];
  CHECK(cw_cells_wall_parts(cells, &walls) == CW_OK);
  for (i = 0; i < walls.count; ++i) {
    if (walls.piece[i] >= pieces.count) continue;
    area += walls.area[i];
    if (walls.patch[i] == 2) sail += walls.area[i];
  }
  /* All of the cube, and both sides of the square. */
  CHECK(fabs(volume - 1) < 1e-14 && fabs(area - 6.5) < 1e-13 && fabs(sail - 0.5) < 1e-14);
  cw_free_cells(cells);
  cw_free_cutter(cutter);
  options.baffles = unknown;
  REFUSED(cw_make_cutter(cube, &options, &none), CW_ERROR_ARGUMENT, "\"flag\"");
  options.baffles = missing;
  REFUSED(cw_make_cutter(cube, &options, &none), CW_ERROR_ARGUMENT, "baffle is NULL (number = 0)");
  options.baffles = NULL;
  REFUSED(cw_make_cutter(cube, &options, &none), CW_ERROR_ARGUMENT, "baffles is NULL");
  options.baffles = names;
  options.period[0] = 2;
  CHECK(cw_make_cutter(cube, &options, &cutter) == CW_OK);
  cw_free_cutter(cutter);
  cw_free(cube);
}

static void refusesCells(void) {
  const double x[3] = {0, 1, 2};
  const double back[2] = {1, 0};
  const int32_t ratios[3] = {2, 1, 3};
  double fractions[8];
  cw_planes planes = {{x, x, x}, {3, 3, 3}, {0, 0, 0}};
  cw_grid grid = {{0, 0, 0}, {1, 1, 1}, {0, 0, 0}, {1, 1, 1}, {0, 0, 0}, 0};
  cw_mesh mesh = cubeArrays();
  cw_solid *cube = NULL, *open = NULL;
  cw_solid* ball = unitBall();
  cw_cells* cells = NULL;
  cw_cells* none = NULL;
  cw_cut_cells rows;
  cw_polygons polygons;
  CHECK(cw_from_mesh(&mesh, 1, &cube) == CW_OK);
  mesh.triangleCount = 11;
  CHECK(cw_from_mesh(&mesh, 0, &open) == CW_OK);
  REFUSED(cw_cut_grid(ball, &grid, 0, 0, 0, &none), CW_ERROR_ARGUMENT, "need a mesh");
  REFUSED(cw_cut_grid(open, &grid, 0, 0, 0, &none), CW_ERROR_TOPOLOGY, "closed");
  REFUSED(cw_cut_grid(NULL, &grid, 0, 0, 0, &none), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_cut_grid(cube, NULL, 0, 0, 0, &none), CW_ERROR_ARGUMENT, "the grid is NULL");
  REFUSED(cw_cut_grid(cube, &grid, 0, 0, 0, NULL), CW_ERROR_ARGUMENT, "the result is NULL");
  REFUSED(cw_cut_grid(cube, &grid, 0, 0, -1, &none), CW_ERROR_ARGUMENT, "threads = -1");
  grid.hi[2] = -1;
  REFUSED(cw_cut_grid(cube, &grid, 0, 0, 0, &none), CW_ERROR_ARGUMENT, "cut cells");
  grid.hi[2] = INT32_MAX;
  REFUSED(cw_cut_grid(cube, &grid, 0, 0, 0, &none), CW_ERROR_ARGUMENT, "axis = 2");
  REFUSED(cw_cut_planes(cube, NULL, 0, 0, 0, &none), CW_ERROR_ARGUMENT, "the planes are NULL");
  planes.counts[1] = -1;
  REFUSED(cw_cut_planes(cube, &planes, 0, 0, 0, &none), CW_ERROR_ARGUMENT, "across[1] cannot");
  planes.counts[1] = 1;
  REFUSED(cw_cut_planes(cube, &planes, 0, 0, 0, &none), CW_ERROR_ARGUMENT, "axis = 1");
  planes.counts[1] = 2;
  planes.across[1] = back;
  REFUSED(cw_cut_planes(cube, &planes, 0, 0, 0, &none), CW_ERROR_ARGUMENT, "ascend");
  planes.across[1] = NULL;
  REFUSED(cw_cut_planes(cube, &planes, 0, 0, 0, &none), CW_ERROR_ARGUMENT, "across[1] is NULL");
  planes.across[1] = x;
  planes.first[2] = INT32_MIN;
  REFUSED(cw_cut_planes(cube, &planes, 0, 0, 0, &none), CW_ERROR_ARGUMENT, "axis = 2");
  planes.first[2] = 0;
  CHECK(none == NULL && cw_cut_planes(cube, &planes, 1, 0, 0, &cells) == CW_OK);
  REFUSED(cw_coarsened(cells, ratios, &none), CW_ERROR_ARGUMENT, "axis = 2");
  REFUSED(cw_coarsened(cells, NULL, &none), CW_ERROR_ARGUMENT, "ratios is NULL");
  REFUSED(cw_merged(NULL, 0, &none), CW_ERROR_ARGUMENT, "the cells are NULL");
  REFUSED(cw_merged(cells, 2, &none), CW_ERROR_ARGUMENT, "smallest = 2");
  REFUSED(cw_fluid_fractions(cells, fractions, 7), CW_ERROR_ARGUMENT, "count = 7, cells = 4");
  REFUSED(cw_fluid_fractions(cells, NULL, 4), CW_ERROR_ARGUMENT, "fractions is NULL");
  REFUSED(cw_cells_rows(NULL, &rows), CW_ERROR_ARGUMENT, "the cells are NULL");
  REFUSED(cw_cells_rows(cells, NULL), CW_ERROR_ARGUMENT, "the result is NULL");
  REFUSED(cw_cells_wall_polygons(cells, &polygons, NULL), CW_ERROR_ARGUMENT, "result is NULL");
  REFUSED(cw_save_cells(cells, NULL), CW_ERROR_ARGUMENT, "the path is NULL");
  REFUSED(cw_save_cells(cells, "no/such/folder"), CW_ERROR_FILE, "no/such/folder");
  REFUSED(cw_load_cells("no/such.cells", &none), CW_ERROR_FILE, "no/such.cells");
  REFUSED(cw_load_cells(NULL, &none), CW_ERROR_ARGUMENT, "the path is NULL");
  cw_free_cells(cells);
  cw_free_cells(NULL);
  cw_free(cube);
  cw_free(open);
  cw_free(ball);
}

int main(void) {
  cutCells();
  polygonsOfCells();
  cellsFromCells();
  CHECK(cw_last_error()[0] == '\0');
  refusesCells();
  cutters();
  baffles();
  printf("%d failures\n", failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
