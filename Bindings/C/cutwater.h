#ifndef CUTWATER_H
#define CUTWATER_H

#include <stdint.h>

/// Cutwater for C, C++17 and Fortran hosts: solids as handles, and what solvers ask of them.
///
/// Negative inside, positive outside; normals point out of the solid. Lengths are in the units of
/// the surface's coordinates, angles in degrees. Points are three doubles in a row (x, y, z).
///
/// Every function but cw_last_error() and cw_free() returns CW_OK or what went wrong, and then has
/// made no handle; output arrays may be written in part. A handle never changes: any number of
/// threads may use it at once, as long as none frees it. Batches and cw_fill() use `threads`
/// threads, 0 meaning as many as OpenMP would, and one where the caller is in a parallel region;
/// their answers are the same bits with any number. NULL is refused wherever nothing else is said.

#ifdef __cplusplus
extern "C" {
#endif

/// What all functions return that can fail; cw_last_error() has the words.
typedef enum cw_status {
  CW_OK = 0,
  CW_ERROR_ARGUMENT = 1,  ///< an argument is NULL or outside its documented range
  CW_ERROR_FILE = 2,      ///< a file is missing, truncated or malformed
  CW_ERROR_TOPOLOGY = 3,  ///< a surface is not what was asked for, e.g. not closed
  CW_ERROR_LIMIT = 4,     ///< a stated limit of size is exceeded
  CW_ERROR_MEMORY = 5,    ///< out of memory
  CW_ERROR_INTERNAL = 6   ///< a defect of the library: please report it
} cw_status;

/// What is wrong, where, and with which value, of the last call that failed in this thread; empty
/// if none has. Calls that succeed leave it. At most 1023 bytes; valid until the next failure in
/// this thread.
const char* cw_last_error(void);

/// A solid. Handles made of others share their geometry, and stay when those are freed.
typedef struct cw_solid cw_solid;

/// Frees a handle; nothing is done about NULL.
void cw_free(cw_solid* solid);

// Surfaces and shapes. `requireWatertight` other than 0 refuses surfaces that do not bound a solid,
// as far as a check can tell; else they are inside where their winding number exceeds one half.

/// Reads STL, OBJ, PLY, OFF or legacy VTK, also gzip-compressed; coordinates are multiplied by
/// `scale` > 0 (0.001: a file in millimetres, a model in metres).
cw_status cw_read_surface(const char* path, double scale, int requireWatertight, cw_solid** result);

/// A triangle mesh in the caller's arrays, which are copied. Points with equal coordinates are one.
typedef struct cw_mesh {
  const double* points;  ///< 3 * pointCount
  int64_t pointCount;
  const int32_t* triangles;  ///< 3 * triangleCount indices of points, from 0
  int64_t triangleCount;
  const int32_t* patches;  ///< per triangle, in [0, patchCount); NULL: all are of patch 0
  int32_t patchCount;
  const char* const* patchNames;  ///< patchCount names; NULL: "patch 0", "patch 1", ...
} cw_mesh;
cw_status cw_from_mesh(const cw_mesh* mesh, int requireWatertight, cw_solid** result);

/// A ball of radius > 0.
cw_status cw_sphere(const double center[3], double radius, cw_solid** result);
/// An axis-aligned box with lower < upper in every coordinate; cw_rotated() turns it.
cw_status cw_box(const double lower[3], const double upper[3], cw_solid** result);

// Solids from solids.

/// All points of any of `count` > 0 solids; of many in one call, which are searched by a tree.
cw_status cw_union(const cw_solid* const* solids, int64_t count, cw_solid** result);
/// All points that are in each of `count` > 0 solids.
cw_status cw_intersection(const cw_solid* const* solids, int64_t count, cw_solid** result);
/// All points of `from` that are not in `what`.
cw_status cw_difference(const cw_solid* from, const cw_solid* what, cw_solid** result);

/// A moved copy, a new handle: the price of a transform. Moves follow each other in call order.
cw_status cw_translated(const cw_solid* solid, const double offset[3], cw_solid** result);
/// Right-handed, about the axis of any length through a point; NULL: through the origin.
cw_status cw_rotated(const cw_solid* solid, double degrees, const double axis[3],
                     const double through[3], cw_solid** result);

// Queries. A point that is not finite has the distance NaN, and neither patch nor face.

/// Signed distances of `count` points.
cw_status cw_signed_distances(const cw_solid* solid, const double* points, int64_t count,
                              double* distances, int threads);

/// A point of the surface nearest to a query point.
typedef struct cw_surface_point {
  double point[3];
  double normal[3];  ///< unit, out of the solid; the pseudonormal at edges and vertices
  double distance;   ///< signed, of the query point
  double tolerance;  ///< no point of the surface is nearer than |query - point| - tolerance
  int32_t patch;     ///< see cw_patch_name(); -1: the query point is not finite
  int32_t face;      ///< polygon of the file or triangle of the arrays; -1: not of a mesh
} cw_surface_point;
cw_status cw_closest_points(const cw_solid* solid, const double* points, int64_t count,
                            cw_surface_point* nearest, int threads);

/// Where a closed box lies; all but CW_UNKNOWN are certain.
typedef enum cw_box_class {
  CW_INSIDE = 0,   ///< no surface in the box, and it is solid
  CW_OUTSIDE = 1,  ///< no surface in the box, and it is free
  CW_CUT = 2,      ///< some surface in the box
  CW_UNKNOWN = 3   ///< neither proven, or not a finite box: refine, or treat as cut
} cw_box_class;

/// One cw_box_class for each box of six doubles (lower x, y, z, upper x, y, z); neighbours are best
/// close to each other in space.
cw_status cw_classify_boxes(const cw_solid* solid, const double* boxes, int64_t count,
                            uint8_t* classes, int threads);

/// All indices from lo to hi, both included, of a level of cells or nodes; none if a hi is below
/// its lo. Cells stand at origin + (index + 1/2) spacing, nodes at origin + index spacing.
typedef struct cw_grid {
  double origin[3];
  double spacing[3];
  int32_t lo[3];
  int32_t hi[3];
  /// Between neighbours along each axis, in elements of the arrays, from lo; all 0: x fastest,
  /// without gaps. No two indices may share an element.
  int64_t strides[3];
  int32_t nodes;  ///< 0: cells, else nodes
} cw_grid;

/// Evaluates the solid at all indices of a patch of a grid. `band` > 0 is the half-width of the
/// band around the surface in which values are told, in cells of the smallest spacing h: beyond,
/// they are exactly +band h or -band h; 0: values everywhere. `patches` gets the patch of the
/// nearest surface point, -1 beyond the band. Either array may be NULL; both point at the value of
/// index lo.
cw_status cw_fill(const cw_solid* solid, const cw_grid* grid, double band, double* distances,
                  int32_t* patches, int threads);

/// Encloses the solid; may be infinite.
cw_status cw_bounding_box(const cw_solid* solid, double lower[3], double upper[3]);

/// How many patches the solid's surface has.
cw_status cw_patch_count(const cw_solid* solid, int32_t* count);
/// The name is valid as long as the handle.
cw_status cw_patch_name(const cw_solid* solid, int32_t patch, const char** name);

#ifdef __cplusplus
}
#endif

#endif
