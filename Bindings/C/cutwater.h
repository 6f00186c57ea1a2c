#ifndef CUTWATER_H
#define CUTWATER_H

#include <stdint.h>

/// Cutwater for programs in C, C++17 and Fortran: solids as handles, and the queries of solvers.
///
/// Distances are negative inside and positive outside; normals point out of the solid. Lengths are
/// in the units of the surface's coordinates, angles in degrees. A point is three consecutive
/// doubles (x, y, z).
///
/// Every function except cw_last_error() and those that free returns CW_OK or an error status.
/// After an error it has created no handle, but may have written part of the output arrays. A
/// handle never changes: any number of threads may use it at once, provided that none frees it.
/// Batches and grids use `threads` threads (0: as many as OpenMP would), but only one if the caller
/// is in a parallel region; answers are the same to the bit with any number. NULL is refused unless
/// stated otherwise.

#ifdef __cplusplus
extern "C" {
#endif

/// Status of all functions that can fail; cw_last_error() gives the message.
typedef enum cw_status {
  CW_OK = 0,
  CW_ERROR_ARGUMENT = 1,  ///< an argument is NULL or outside its documented range
  CW_ERROR_FILE = 2,      ///< a file is missing, truncated or malformed
  CW_ERROR_TOPOLOGY = 3,  ///< a surface lacks what was required, e.g. is not closed
  CW_ERROR_LIMIT = 4,     ///< a stated limit of size is exceeded
  CW_ERROR_MEMORY = 5,    ///< out of memory
  CW_ERROR_INTERNAL = 6   ///< a defect of the library: please report it
} cw_status;

/// States what was wrong, where, and with which value, in the last call that failed in this thread;
/// empty if none has. Successful calls leave it unchanged. At most 1023 bytes; valid until the next
/// failure in this thread.
const char* cw_last_error(void);

/// A solid. Handles made from others share their geometry and stay valid when those are freed.
typedef struct cw_solid cw_solid;

/// Frees a handle; NULL is ignored.
void cw_free(cw_solid* solid);

// Surfaces and shapes. If `requireWatertight` is not 0, surfaces that do not bound a solid are
// refused, as far as a check can tell; otherwise inside is where their winding number exceeds 1/2.

/// Reads STL, OBJ, PLY, OFF, legacy VTK or VTP, also gzip-compressed. Coordinates are multiplied by
/// `scale` > 0 (0.001 for a file in millimetres and a model in metres).
cw_status cw_read_surface(const char* path, double scale, int requireWatertight, cw_solid** result);

/// A triangle mesh in the caller's arrays, which are copied. Equal points are merged.
typedef struct cw_mesh {
  const double* points;  ///< 3 * pointCount
  int64_t pointCount;
  const int32_t* triangles;  ///< 3 * triangleCount indices of points, from 0
  int64_t triangleCount;
  const int32_t* patches;  ///< per triangle, in [0, patchCount); NULL: all have patch 0
  int32_t patchCount;
  const char* const* patchNames;  ///< patchCount names; NULL: "patch 0", "patch 1", ...
} cw_mesh;
cw_status cw_from_mesh(const cw_mesh* mesh, int requireWatertight, cw_solid** result);

/// A ball of radius > 0.
cw_status cw_sphere(const double center[3], double radius, cw_solid** result);
/// An axis-aligned box with lower < upper in every coordinate; use cw_rotated() to turn it.
cw_status cw_box(const double lower[3], const double upper[3], cw_solid** result);

// Solids made from solids.

/// All points in any of `count` > 0 solids. Pass many in one call: they are searched by a tree.
cw_status cw_union(const cw_solid* const* solids, int64_t count, cw_solid** result);
/// All points in each of `count` > 0 solids.
cw_status cw_intersection(const cw_solid* const* solids, int64_t count, cw_solid** result);
/// All points of `from` that are not in `what`.
cw_status cw_difference(const cw_solid* from, const cw_solid* what, cw_solid** result);

/// A moved copy as a new handle, which costs only a transform. Motions apply in the order of calls.
cw_status cw_translated(const cw_solid* solid, const double offset[3], cw_solid** result);
/// Rotated right-handed about `axis`, of any length, through a point; NULL: through the origin.
cw_status cw_rotated(const cw_solid* solid, double degrees, const double axis[3],
                     const double through[3], cw_solid** result);

// Queries. A point that is not finite has the distance NaN and neither patch nor face.

/// Signed distances at `count` points.
cw_status cw_signed_distances(const cw_solid* solid, const double* points, int64_t count,
                              double* distances, int threads);

/// A point of the surface nearest to a query point.
typedef struct cw_surface_point {
  double point[3];
  double normal[3];  ///< unit, out of the solid; the pseudonormal at edges and vertices
  double distance;   ///< signed, at the query point
  double tolerance;  ///< no point of the surface is nearer than |query - point| - tolerance
  int32_t patch;     ///< see cw_patch_name(); -1 if the query point is not finite
  int32_t face;      ///< polygon of the file or triangle of the arrays; -1 if not on a mesh
} cw_surface_point;
cw_status cw_closest_points(const cw_solid* solid, const double* points, int64_t count,
                            cw_surface_point* nearest, int threads);

/// Where a closed box lies; all but CW_UNKNOWN are certain.
typedef enum cw_box_class {
  CW_INSIDE = 0,   ///< no surface in the box, which is all solid
  CW_OUTSIDE = 1,  ///< no surface in the box, which is all free space
  CW_CUT = 2,      ///< some surface in the box
  CW_UNKNOWN = 3   ///< nothing proven, or not a finite box: refine, or treat as cut
} cw_box_class;

/// One cw_box_class for each box of six doubles (lower x, y, z, upper x, y, z). Neighbours in the
/// array should be close to each other in space.
cw_status cw_classify_boxes(const cw_solid* solid, const double* boxes, int64_t count,
                            uint8_t* classes, int threads);

/// All indices from lo to hi, both included, on a level of cells or nodes; none if any hi is below
/// its lo. Cells are centred at origin + (index + 1/2) spacing, nodes at origin + index spacing.
typedef struct cw_grid {
  double origin[3];
  double spacing[3];
  int32_t lo[3];
  int32_t hi[3];
  /// Distance between neighbours along each axis, in elements of the arrays, starting from lo; all
  /// 0: x fastest, without gaps. No two indices may share an element.
  int64_t strides[3];
  int32_t nodes;  ///< 0: cells, otherwise nodes
} cw_grid;

/// Evaluates the solid at all indices of a grid patch. `band` > 0 limits values to a band of
/// this half-width around the surface, in cells of the smallest spacing h: beyond it they are
/// exactly +band h or -band h. 0: values everywhere. `patches` receives the patch of the nearest
/// surface point, -1 beyond the band. Either array may be NULL; both point at the value of lo.
cw_status cw_fill(const cw_solid* solid, const cw_grid* grid, double band, double* distances,
                  int32_t* patches, int threads);

/// One cw_box_class for each index of a grid patch, at the same places as cw_fill() would write:
/// that of its closed cell, or of the control volume around its node.
cw_status cw_classify_cells(const cw_solid* solid, const cw_grid* grid, uint8_t* classes,
                            int threads);

/// A box that encloses the solid; may be infinite.
cw_status cw_bounding_box(const cw_solid* solid, double lower[3], double upper[3]);

/// The number of patches of the solid's surface.
cw_status cw_patch_count(const cw_solid* solid, int32_t* count);
/// The name of a patch, valid as long as the handle.
cw_status cw_patch_name(const cw_solid* solid, int32_t patch, const char** name);

// Cut cells: how a closed surface cuts the cells of a grid, exactly. The solid must be a mesh,
// moved anyhow, that is closed and does not meet itself. Lengths, areas and volumes are in the
// units of its coordinates. The first call for a solid and a side takes as long as cutting some ten
// thousand cells more; further ones, and those of other threads, share what it has made.

/// The cut cells of a box of cells. It refers to nothing, and stays valid when the solid is freed.
typedef struct cw_cells cw_cells;
/// Frees a handle; NULL is ignored.
void cw_free_cells(cw_cells* cells);

/// The cells between planes, for a grid whose cells grow.
typedef struct cw_planes {
  const double* across[3];  ///< across each axis, ascending, one more than cells along it
  int64_t counts[3];        ///< how many, at least 2
  int32_t first[3];         ///< the index of the lowest cell
} cw_planes;

/// Cuts the cells of a grid patch; the control volumes of nodes, if it has these. Strides do not
/// count. The fluid is outside the solid, or inside if `fluidInside` is not 0; polygons are kept
/// if `polygons` is not 0.
cw_status cw_cut_grid(const cw_solid* solid, const cw_grid* grid, int fluidInside, int polygons,
                      int threads, cw_cells** result);
/// Cuts the cells between planes.
cw_status cw_cut_planes(const cw_solid* solid, const cw_planes* planes, int fluidInside,
                        int polygons, int threads, cw_cells** result);

/// What cuts cells by a solid, with options; cw_cut_grid() and cw_cut_planes() have none. Make one
/// for many boxes. It stays valid when the solid is freed.
typedef struct cw_cutter cw_cutter;
/// Frees a handle; NULL is ignored.
void cw_free_cutter(cw_cutter* cutter);

/// How to make one; see CutterOptions.
typedef struct cw_cutter_options {
  int32_t fluidInside;  ///< not 0: the fluid is inside the solid
  int32_t capHoles;     ///< not 0: holes of an open surface are closed, by a patch named "cap"
  /// Names of patches that are no walls but open, such as inlets; in planes of the grid. NULL if
  /// there are none.
  const char* const* openPatches;
  int64_t openPatchCount;
  /// The period of the body along each axis; 0: none. Grids have cells of a period then.
  double period[3];
  /// Names of patches that are baffles: sheets with fluid and a wall on both sides. NULL if there
  /// are none.
  const char* const* baffles;
  int64_t baffleCount;
} cw_cutter_options;

/// `options` may be NULL: then all are 0.
cw_status cw_make_cutter(const cw_solid* solid, const cw_cutter_options* options,
                         cw_cutter** result);
/// As cw_cut_grid().
cw_status cw_cutter_grid(const cw_cutter* cutter, const cw_grid* grid, int polygons, int threads,
                         cw_cells** result);
/// As cw_cut_planes(); along axes with a period, the planes are those of one.
cw_status cw_cutter_planes(const cw_cutter* cutter, const cw_planes* planes, int polygons,
                           int threads, cw_cells** result);

/// As many cells along each axis joined to one: see coarsened(). The ratios divide the index of the
/// lowest cell and the number of cells.
cw_status cw_coarsened(const cw_cells* cells, const int32_t ratios[3], cw_cells** result);
/// One piece a cell: the largest is kept and the others covered, and so are pieces with less than
/// the share `smallest` of their cell, from 0 to 1: see merged().
cw_status cw_merged(const cw_cells* cells, double smallest, cw_cells** result);

/// Writes all of them to a file, and reads it again: the same rows to the bit.
cw_status cw_save_cells(const cw_cells* cells, const char* path);
cw_status cw_load_cells(const char* path, cw_cells** result);

/// Shares of the box's cells that are fluid, from 0 to 1: `count` of them, which must be the number
/// of cells, x fastest.
cw_status cw_fluid_fractions(const cw_cells* cells, double* fractions, int64_t count);

// Rows in arrays that stay valid as long as the handle. Cells are sorted by k, then j, then i;
// pieces by cell; parts of walls by piece and patch; arcs by the cell above them and by axis. Rows
// are counted from 0, vectors are three doubles in a row.

/// Cells that are cut: `count` of the box, then those around it to which arcs lead.
typedef struct cw_cut_cells {
  int64_t count;
  int64_t countAround;
  const int32_t* index;         ///< i, j, k
  const int32_t* firstPiece;    ///< for each cell the row of its first piece; then their number
  const uint8_t* fluidCorners;  ///< bit n: the corner at (bit 0, bit 1, bit 2) of n is in the fluid
  const uint8_t* meets;         ///< 1 where the surface meets itself in the cell, see meets
  /// Bit 2 axis + side (0: low, 1: high): a part of the wall lies in that face, exactly.
  const uint8_t* wallFaces;
} cw_cut_cells;
cw_status cw_cells_rows(const cw_cells* cells, cw_cut_cells* rows);

/// Connected parts of the fluid in these cells.
typedef struct cw_pieces {
  int64_t count;
  int64_t countAround;
  const int32_t* cell;  ///< row of the cell
  const double* volume;
  const double* centroid;
  const double* wallArea;
  const double* wallVector;    ///< the integral of the wall's normal out of the fluid
  const double* wallCentroid;  ///< the piece's where there is no wall
  const uint8_t* wallFaces;    ///< of this piece's wall, as of cells
} cw_pieces;
cw_status cw_cells_pieces(const cw_cells* cells, cw_pieces* rows);

/// In place of the row of a piece beside an arc.
enum {
  CW_WHOLE_CELL = -2,  ///< all of the cell there is fluid
  CW_BEYOND = -3       ///< the cell there is not known, or fluid goes on beyond an open patch
};

/// Open parts of the faces between cells.
typedef struct cw_arcs {
  int64_t count;
  const int32_t* below;  ///< the piece on this side, CW_WHOLE_CELL or CW_BEYOND
  const int32_t* above;
  const double* area;
  const double* centroid;
  const int32_t* cell;  ///< i, j, k of the cell above the face
  const uint8_t* axis;  ///< across the face: 0, 1 or 2
} cw_arcs;
cw_status cw_cells_arcs(const cw_cells* cells, cw_arcs* rows);

/// The arcs that are parts of open patches, in ascending order; on one side, they have CW_BEYOND.
typedef struct cw_open_arcs {
  int64_t count;
  const int32_t* arc;    ///< its row
  const int32_t* patch;  ///< see cw_cells_patch_name()
} cw_open_arcs;
cw_status cw_cells_open_arcs(const cw_cells* cells, cw_open_arcs* rows);

/// What each patch of the surface has of a piece's wall.
typedef struct cw_wall_parts {
  int64_t count;
  const int32_t* piece;
  const int32_t* patch;  ///< see cw_cells_patch_name()
  const double* area;
  const double* vector;  ///< as of pieces
  const double* centroid;
} cw_wall_parts;
cw_status cw_cells_wall_parts(const cw_cells* cells, cw_wall_parts* rows);

/// The number of patches that these rows name: those of the solid, then "cap" if holes were closed,
/// then "covered" of cw_merged().
cw_status cw_cells_patch_count(const cw_cells* cells, int32_t* count);
/// The name of one of them, valid as long as the handle.
cw_status cw_cells_patch_name(const cw_cells* cells, int32_t patch, const char** name);

/// Polygons: polygon n has the points from first[n] up to that before first[n + 1].
typedef struct cw_polygons {
  int64_t count;  ///< 0 if polygons were not kept
  const int64_t* first;
  const double* points;
} cw_polygons;
/// The outline of each arc, counterclockwise as seen against its axis.
cw_status cw_cells_arc_polygons(const cw_cells* cells, cw_polygons* polygons);
/// Those of walls, with normals into the fluid: part n of the wall has the polygons from
/// firstOfPart[n] up to that before firstOfPart[n + 1]; NULL if polygons were not kept.
cw_status cw_cells_wall_polygons(const cw_cells* cells, cw_polygons* polygons,
                                 const int64_t** firstOfPart);

#ifdef __cplusplus
}
#endif

#endif
