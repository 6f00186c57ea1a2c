/* The C API as a C99 program uses it: answers that are known by hand, and everything that is
   refused. C++17 compiles it, too. Prints what is wrong, and fails. */

#include "capi.h"

static void answersAboutAMesh(void) {
  const double points[9] = {0.5, 0.5, 3, -1, 0.5, 0.5, 0.5, 0.5, 0.75};
  double distances[3] = {0, 0, 0};
  cw_surface_point nearest[3];
  const cw_mesh arrays = cubeArrays();
  cw_solid* cube = NULL;
  int32_t patches = 0;
  const char* name = NULL;
  double lower[3];
  double upper[3];
  CHECK(cw_from_mesh(&arrays, 1, &cube) == CW_OK);
  CHECK(cw_signed_distances(cube, points, 3, distances, 0) == CW_OK);
  CHECK(distances[0] == 2 && distances[1] == 1 && distances[2] == -0.25);
  CHECK(cw_closest_points(cube, points, 3, nearest, 1) == CW_OK);
  CHECK(nearest[0].point[2] == 1 && nearest[0].normal[2] == 1 && nearest[0].distance == 2);
  CHECK(nearest[0].patch == 0 && (nearest[0].face == 2 || nearest[0].face == 3));
  CHECK(nearest[1].point[0] == 0 && nearest[1].normal[0] == -1 && nearest[1].patch == 1);
  CHECK(cw_patch_count(cube, &patches) == CW_OK && patches == 2);
  CHECK(cw_patch_name(cube, 1, &name) == CW_OK && strcmp(name, "sides") == 0);
  CHECK(cw_bounding_box(cube, lower, upper) == CW_OK);
  CHECK(lower[0] <= 0 && lower[0] > -1e-9 && upper[2] >= 1 && upper[2] < 1 + 1e-9);
  cw_free(cube);
}

static void answersAboutBoxes(void) {
  const double boxes[30] = {-0.1, -0.1, -0.1, 0.1, 0.1, 0.1, 2, 2, 2, 3, 3, 3, 0,   0, 0,
                            2,    2,    2,    1,   1,   1,   0, 0, 0, 0, 0, 0, NAN, 1, 1};
  const uint8_t expected[5] = {CW_INSIDE, CW_OUTSIDE, CW_CUT, CW_UNKNOWN, CW_UNKNOWN};
  uint8_t classes[5] = {9, 9, 9, 9, 9};
  cw_solid* ball = unitBall();
  CHECK(cw_classify_boxes(ball, boxes, 5, classes, 0) == CW_OK);
  CHECK(memcmp(classes, expected, 5) == 0);
  cw_free(ball);
}

static void solidsFromSolids(void) {
  const double lower[3] = {-1, -2, -2};
  const double upper[3] = {0, 2, 2};
  const double offset[3] = {0, 0, 5};
  const double axis[3] = {0, 0, 7};
  const double corner[3] = {0, 2, 0};
  const double points[12] = {3, 0, 0, -3, 0, 0, 0, 3, 0, 0, 0, 6};
  double d[4];
  cw_solid *box = NULL, *half = NULL, *both = NULL, *up = NULL, *turned = NULL, *common = NULL;
  const cw_solid* pair[2];
  cw_solid* ball = unitBall();
  CHECK(cw_box(lower, upper, &box) == CW_OK);
  CHECK(cw_difference(ball, box, &half) == CW_OK);
  CHECK(cw_translated(ball, offset, &up) == CW_OK);
  pair[0] = ball;
  pair[1] = up;
  CHECK(cw_union(pair, 2, &both) == CW_OK);
  pair[1] = box;
  CHECK(cw_intersection(pair, 2, &common) == CW_OK);
  CHECK(cw_rotated(half, 90, axis, corner, &turned) == CW_OK);
  cw_free(ball); /* what was made of them stays */
  cw_free(box);
  CHECK(cw_signed_distances(half, points, 1, d, 0) == CW_OK && d[0] == 2);
  CHECK(cw_signed_distances(both, points, 4, d, 0) == CW_OK && d[0] == 2 && d[3] == 0);
  CHECK(cw_signed_distances(common, points + 3, 1, d, 0) == CW_OK && d[0] == 2);
  /* About (0, 2, 0): the half ball's pole (1, 0, 0) turns to (2, 3, 0), the origin to (2, 2, 0). */
  CHECK(cw_signed_distances(turned, points + 6, 1, d, 0) == CW_OK);
  CHECK(fabs(d[0] - (sqrt(5.0) - 1)) < 1e-14);
  cw_free(half);
  cw_free(both);
  cw_free(common);
  cw_free(up);
  cw_free(turned);
}

static void patchesOfGrids(void) {
  cw_grid grid = {{0, 0, 0}, {0.5, 0.5, 0.5}, {-4, 0, 0}, {4, 1, 0}, {0, 0, 0}, 1};
  double values[18];
  double spread[2 * 9 * 4];
  int32_t patches[18];
  int i = 0;
  cw_solid* ball = unitBall();
  CHECK(cw_fill(ball, &grid, 0, values, NULL, 0) == CW_OK);
  CHECK(values[0] == 1 && values[4] == -1 && values[8] == 1 && values[9 + 6] == sqrt(1.25) - 1);
  CHECK(cw_fill(ball, &grid, 1, values, patches, 1) == CW_OK);
  CHECK(values[0] == 0.5 && patches[0] == -1 && values[6] == 0 && patches[6] == 0);
  for (i = 0; i < 72; ++i) spread[i] = 77;
  grid.strides[0] = 4; /* the third of four components, y fastest of the indices' strides */
  grid.strides[1] = 36;
  grid.strides[2] = 72;
  CHECK(cw_fill(ball, &grid, 0, spread + 2, NULL, 0) == CW_OK);
  CHECK(spread[2] == 1 && spread[2 + 4 * 4] == -1 && spread[2 + 36 + 4 * 6] == sqrt(1.25) - 1);
  for (i = 0; i < 72; ++i) CHECK(i % 4 == 2 ? spread[i] != 77 : spread[i] == 77);
  grid.hi[1] = -1; /* no index */
  values[0] = 77;
  CHECK(cw_fill(ball, &grid, 0, values, NULL, 0) == CW_OK && values[0] == 77);
  cw_free(ball);
}

static void refusesSurfaces(void) {
  int32_t triangles[36];
  int32_t patches[12];
  cw_mesh mesh = cubeArrays();
  cw_solid* s = NULL;
  REFUSED(cw_from_mesh(NULL, 0, &s), CW_ERROR_ARGUMENT, "cw_from_mesh: the mesh is NULL");
  REFUSED(cw_from_mesh(&mesh, 0, NULL), CW_ERROR_ARGUMENT, "the result is NULL");
  mesh.pointCount = 7;
  REFUSED(cw_from_mesh(&mesh, 0, &s), CW_ERROR_ARGUMENT, "corner = 7");
  mesh.pointCount = -1;
  REFUSED(cw_from_mesh(&mesh, 0, &s), CW_ERROR_ARGUMENT, "count = -1");
  mesh = cubeArrays();
  mesh.triangles = NULL;
  REFUSED(cw_from_mesh(&mesh, 0, &s), CW_ERROR_ARGUMENT, "triangles is NULL");
  memcpy(triangles, kTriangles, sizeof triangles);
  triangles[30] = -1;
  mesh.triangles = triangles;
  REFUSED(cw_from_mesh(&mesh, 0, &s), CW_ERROR_ARGUMENT, "triangle = 10, corner = -1");
  memcpy(patches, kPatches, sizeof patches);
  patches[3] = 2;
  mesh = cubeArrays();
  mesh.patches = patches;
  REFUSED(cw_from_mesh(&mesh, 0, &s), CW_ERROR_ARGUMENT, "triangle = 3, patch = 2");
  mesh.patchCount = 0;
  REFUSED(cw_from_mesh(&mesh, 0, &s), CW_ERROR_ARGUMENT, "patchCount = 0");
  mesh = cubeArrays();
  mesh.triangleCount = 11;
  REFUSED(cw_from_mesh(&mesh, 1, &s), CW_ERROR_TOPOLOGY, "cw_from_mesh");
  CHECK(cw_from_mesh(&mesh, 0, &s) == CW_OK);
  cw_free(s);
  mesh.triangleCount = 0;
  REFUSED(cw_from_mesh(&mesh, 0, &s), CW_ERROR_TOPOLOGY, "cw_from_mesh");
  CHECK(s == NULL);
  REFUSED(cw_read_surface("no/such.stl", 1, 0, &s), CW_ERROR_FILE, "no/such.stl");
  REFUSED(cw_read_surface(NULL, 1, 0, &s), CW_ERROR_ARGUMENT, "the path is NULL");
}

static void refusesSolids(void) {
  const double axis[3] = {0, 0, 0};
  const double nowhere[3] = {0, INFINITY, 0};
  const cw_solid* none[2] = {NULL, NULL};
  cw_solid* ball = unitBall();
  cw_solid* s = ball;
  REFUSED(cw_sphere(kOrigin, -1, &s), CW_ERROR_ARGUMENT, "-1");
  CHECK(s == NULL);
  REFUSED(cw_sphere(NULL, 1, &s), CW_ERROR_ARGUMENT, "center is NULL");
  REFUSED(cw_box(kOrigin, kOrigin, &s), CW_ERROR_ARGUMENT, "cw_box");
  REFUSED(cw_union(none, 2, &s), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_union(none, 0, &s), CW_ERROR_ARGUMENT, "cw_union");
  REFUSED(cw_union(none, -2, &s), CW_ERROR_ARGUMENT, "count = -2");
  REFUSED(cw_union(NULL, 2, &s), CW_ERROR_ARGUMENT, "solids is NULL");
  REFUSED(cw_intersection(NULL, 2, &s), CW_ERROR_ARGUMENT, "solids is NULL");
  REFUSED(cw_difference(ball, NULL, &s), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_translated(NULL, kOrigin, &s), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_translated(ball, nowhere, &s), CW_ERROR_ARGUMENT, "offset");
  REFUSED(cw_translated(ball, NULL, &s), CW_ERROR_ARGUMENT, "offset is NULL");
  REFUSED(cw_rotated(ball, 90, axis, NULL, &s), CW_ERROR_ARGUMENT, "axis");
  REFUSED(cw_rotated(ball, NAN, axis, NULL, &s), CW_ERROR_ARGUMENT, "degrees");
  cw_free(ball);
  cw_free(NULL);
}

static void refusesQueries(void) {
  double d[6] = {0, 0, 0, 0, 0, 0};
  uint8_t classes[1];
  int32_t count = 0;
  const char* name = NULL;
  cw_surface_point nearest[1];
  cw_grid grid = {{0, 0, 0}, {1, 1, 1}, {0, 0, 0}, {1, 1, 1}, {1, 2, 0}, 0};
  cw_solid* ball = unitBall();
  REFUSED(cw_signed_distances(NULL, d, 1, d, 0), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_signed_distances(ball, NULL, 1, d, 0), CW_ERROR_ARGUMENT, "points is NULL");
  REFUSED(cw_signed_distances(ball, d, 1, NULL, 0), CW_ERROR_ARGUMENT, "distances is NULL");
  REFUSED(cw_signed_distances(ball, d, -1, d, 0), CW_ERROR_ARGUMENT, "count = -1");
  REFUSED(cw_signed_distances(ball, d, INT64_MAX, d, 0), CW_ERROR_ARGUMENT, "so many");
  REFUSED(cw_signed_distances(ball, d, 1, d, -1), CW_ERROR_ARGUMENT, "threads = -1");
  CHECK(cw_signed_distances(ball, NULL, 0, NULL, 0) == CW_OK);
  REFUSED(cw_closest_points(NULL, d, 1, nearest, 0), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_closest_points(ball, d, 1, NULL, 0), CW_ERROR_ARGUMENT, "nearest is NULL");
  CHECK(cw_closest_points(ball, NULL, 0, NULL, 0) == CW_OK);
  REFUSED(cw_classify_boxes(NULL, d, 1, classes, 0), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_classify_boxes(ball, NULL, 1, classes, 0), CW_ERROR_ARGUMENT, "boxes is NULL");
  REFUSED(cw_classify_boxes(ball, d, 1, NULL, 0), CW_ERROR_ARGUMENT, "classes is NULL");
  REFUSED(cw_fill(NULL, &grid, 0, d, NULL, 0), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_fill(ball, NULL, 0, d, NULL, 0), CW_ERROR_ARGUMENT, "the grid is NULL");
  REFUSED(cw_fill(ball, &grid, 0, NULL, NULL, 0), CW_ERROR_ARGUMENT, "both arrays are NULL");
  REFUSED(cw_fill(ball, &grid, 0, d, NULL, 0), CW_ERROR_ARGUMENT, "axis = 2");
  grid.spacing[1] = 0;
  REFUSED(cw_fill(ball, &grid, 0, d, NULL, 0), CW_ERROR_ARGUMENT, "spacing");
  grid.spacing[1] = 1;
  grid.strides[2] = 4;
  REFUSED(cw_fill(ball, &grid, -1, d, NULL, 0), CW_ERROR_ARGUMENT, "band");
  grid.hi[0] = grid.hi[1] = grid.hi[2] = INT32_MAX;
  REFUSED(cw_fill(ball, &grid, 0, d, NULL, 0), CW_ERROR_ARGUMENT, "more indices");
  REFUSED(cw_classify_cells(NULL, &grid, classes, 0), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_classify_cells(ball, NULL, classes, 0), CW_ERROR_ARGUMENT, "the grid is NULL");
  REFUSED(cw_classify_cells(ball, &grid, NULL, 0), CW_ERROR_ARGUMENT, "classes is NULL");
  REFUSED(cw_bounding_box(NULL, d, d + 3), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_bounding_box(ball, d, NULL), CW_ERROR_ARGUMENT, "upper is NULL");
  REFUSED(cw_patch_count(NULL, &count), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_patch_count(ball, NULL), CW_ERROR_ARGUMENT, "the count is NULL");
  REFUSED(cw_patch_name(ball, 1, &name), CW_ERROR_ARGUMENT, "patch = 1");
  REFUSED(cw_patch_name(ball, -1, &name), CW_ERROR_ARGUMENT, "patch = -1");
  REFUSED(cw_patch_name(NULL, 0, &name), CW_ERROR_ARGUMENT, "the solid is NULL");
  REFUSED(cw_patch_name(ball, 0, NULL), CW_ERROR_ARGUMENT, "the name is NULL");
  cw_free(ball);
}

static void messagesAreCut(void) {
  char path[3000];
  cw_solid* s = NULL;
  memset(path, 'x', sizeof path);
  path[sizeof path - 1] = '\0';
  CHECK(cw_read_surface(path, 1, 0, &s) == CW_ERROR_FILE);
  CHECK(strlen(cw_last_error()) == 1023);
}

int main(void) {
  CHECK(cw_last_error()[0] == '\0');
  answersAboutAMesh();
  answersAboutBoxes();
  solidsFromSolids();
  patchesOfGrids();
  CHECK(cw_last_error()[0] == '\0');
  refusesSurfaces();
  refusesSolids();
  refusesQueries();
  messagesAreCut();
  printf("%d failures\n", failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
