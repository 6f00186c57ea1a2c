/* The installed C API: an answer, and an error that is thrown in one library and caught in another.
 */

#include <cutwater.h>
#include <string.h>

int main(void) {
  const double center[3] = {1, 2, 3};
  double distance = 0;
  cw_solid* ball = NULL;
  cw_solid* surface = NULL;
  if (cw_sphere(center, 0.5, &ball) != CW_OK) return 1;
  if (cw_signed_distances(ball, center, 1, &distance, 0) != CW_OK || distance != -0.5) return 2;
  if (cw_read_surface("no/such.stl", 1, 0, &surface) != CW_ERROR_FILE) return 3;
  if (surface != NULL || strstr(cw_last_error(), "no/such.stl") == NULL) return 4;
  cw_free(ball);
  return 0;
}
