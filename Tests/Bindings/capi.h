/* What programs that test the C API have in common. */
#ifndef CUTWATER_TESTS_CAPI_H
#define CUTWATER_TESTS_CAPI_H

#include <cutwater.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

static void check(int ok, const char* what, int line) {
  if (!ok) {
    printf("line %d: %s; last error: %s\n", line, what, cw_last_error());
    ++failures;
  }
}
#define CHECK(condition) check((condition) ? 1 : 0, #condition, __LINE__)
#define REFUSED(call, status, text) \
  CHECK((call) == (status) && strstr(cw_last_error(), (text)) != NULL)

static const double kOrigin[3] = {0, 0, 0};

static cw_solid* unitBall(void) {
  cw_solid* ball = NULL;
  CHECK(cw_sphere(kOrigin, 1, &ball) == CW_OK);
  return ball;
}

/* The unit cube: bottom and top are patch 0, the sides patch 1. */
static const double kPoints[24] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0,
                                   0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
static const int32_t kTriangles[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2,
                                       1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3};
static const int32_t kPatches[12] = {0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
static const char* const kNames[2] = {"ends", "sides"};

static cw_mesh cubeArrays(void) {
  cw_mesh mesh;
  mesh.points = kPoints;
  mesh.pointCount = 8;
  mesh.triangles = kTriangles;
  mesh.triangleCount = 12;
  mesh.patches = kPatches;
  mesh.patchCount = 2;
  mesh.patchNames = kNames;
  return mesh;
}

#endif
