/* A keel and a ball from C: distances, nearest points, classes of boxes, a patch of a grid and
   cut cells. */

#include <cutwater.h>
#include <stdio.h>
#include <stdlib.h>

static void need(cw_status status) {
  if (status == CW_OK) return;
  fprintf(stderr, "%s\n", cw_last_error());
  exit(1);
}

/* In the cells of a grid of 512, some of which an octahedron cuts. */
static double fluidAroundOctahedron(const cw_grid grid) {
  const double tips[18] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  const int32_t faces[24] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                             2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  const cw_mesh octahedron = {
      .points = tips, .pointCount = 6, .triangles = faces, .triangleCount = 8};
  double fractions[8 * 8 * 8];
  cw_solid* hull = NULL;
  need(cw_from_mesh(&octahedron, 1, &hull));

  /* [DOCS */
  cw_cells* cells = NULL;
  cw_pieces pieces;
  double volume = 0;
  need(cw_cut_grid(hull, &grid, 0, 0, 0, &cells)); /* fluid outside, no polygons */
  need(cw_cells_pieces(cells, &pieces));
  for (int64_t p = 0; p < pieces.count; ++p) volume += pieces.volume[p];
  need(cw_fluid_fractions(cells, fractions, 512)); /* of all cells, x fastest */
  /* DOCS] */

  double fluid = 0; /* in the box of 4 x 4 x 4, less the octahedron's 4/3 */
  for (int i = 0; i < 512; ++i) fluid += fractions[i] * 0.125;
  printf("%lld pieces of fluid in cut cells, of volume %g; in all cells %g\n",
         (long long)pieces.count, volume, fluid);

  cw_free(hull);
  cw_free_cells(cells);
  return fluid;
}

int main(void) {
  /* [README */
  const double center[3] = {0, 0, 0};
  const double lower[3] = {-2, -0.25, -2};
  const double upper[3] = {2, 0.25, 0};
  const double points[6] = {3, 0, 0, 0, 0, 0.5};
  double distances[2];
  cw_solid *ball = NULL, *keel = NULL, *body = NULL;
  need(cw_sphere(center, 1, &ball)); /* a surface from a file: cw_read_surface() */
  need(cw_box(lower, upper, &keel));
  const cw_solid* parts[2] = {ball, keel};
  need(cw_union(parts, 2, &body));
  need(cw_signed_distances(body, points, 2, distances, 0)); /* 1 and -0.5; negative is inside */
  /* README] */

  /* [DOCS */
  const double boxes[12] = {-0.1, -0.1, -0.1, 0.1, 0.1, 0.1, 0.9, -0.1, 0.1, 1.1, 0.1, 0.3};
  uint8_t classes[2];
  cw_surface_point nearest[2];
  double values[8 * 8 * 8];
  const cw_grid grid = {.origin = {-2, -2, -2},
                        .spacing = {0.5, 0.5, 0.5},
                        .lo = {0, 0, 0},
                        .hi = {7, 7, 7}}; /* cells, x fastest */
  need(cw_closest_points(body, points, 2, nearest, 0));
  need(cw_classify_boxes(body, boxes, 2, classes, 0));
  need(cw_fill(body, &grid, 0, values, NULL, 0));
  /* DOCS] */

  const double fluid = fluidAroundOctahedron(grid);

  int inside = 0;
  for (int i = 0; i < 8 * 8 * 8; ++i) inside += values[i] < 0;
  printf("distances %g and %g, nearest point (%g, %g, %g)\n", distances[0], distances[1],
         nearest[0].point[0], nearest[0].point[1], nearest[0].point[2]);
  printf("boxes: %s and %s; %d of 512 cells have their centre inside\n",
         classes[0] == CW_INSIDE ? "inside" : "not inside",
         classes[1] == CW_CUT ? "cut" : "not cut", inside);

  cw_free(ball);
  cw_free(keel);
  cw_free(body);
  const int right = distances[0] == 1 && distances[1] == -0.5 && nearest[0].point[0] == 2;
  if (fluid < 64 - 4.0 / 3 - 1e-12 || fluid > 64 - 4.0 / 3 + 1e-12) return 1;
  return right && classes[0] == CW_INSIDE && classes[1] == CW_CUT ? 0 : 1;
}
