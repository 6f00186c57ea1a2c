! Interfaces to Cutwater's C API; cutwater.h documents every function. An argument of type c_ptr that
! C declares as an array is passed with c_loc(), or c_null_ptr where C allows NULL.
module cutwater
  use, intrinsic :: iso_c_binding
  implicit none

  enum, bind(c)
    enumerator :: CW_OK = 0, CW_ERROR_ARGUMENT, CW_ERROR_FILE, CW_ERROR_TOPOLOGY, CW_ERROR_LIMIT, &
                  CW_ERROR_MEMORY, CW_ERROR_INTERNAL
  end enum
  enum, bind(c)
    enumerator :: CW_INSIDE = 0, CW_OUTSIDE, CW_CUT, CW_UNKNOWN
  end enum

  type, bind(c) :: cw_mesh
    type(c_ptr) :: points = c_null_ptr
    integer(c_int64_t) :: point_count = 0
    type(c_ptr) :: triangles = c_null_ptr
    integer(c_int64_t) :: triangle_count = 0
    type(c_ptr) :: patches = c_null_ptr
    integer(c_int32_t) :: patch_count = 0
    type(c_ptr) :: patch_names = c_null_ptr
  end type

  type, bind(c) :: cw_surface_point
    real(c_double) :: point(3), normal(3), distance, tolerance
    integer(c_int32_t) :: patch, face
  end type

  type, bind(c) :: cw_grid
    real(c_double) :: origin(3), spacing(3)
    integer(c_int32_t) :: lo(3), hi(3)
    integer(c_int64_t) :: strides(3) = 0
    integer(c_int32_t) :: nodes = 0
  end type

  ! In place of the row of a piece beside an arc.
  integer(c_int32_t), parameter :: CW_WHOLE_CELL = -2, CW_BEYOND = -3

  type, bind(c) :: cw_planes
    type(c_ptr) :: across(3) = c_null_ptr
    integer(c_int64_t) :: counts(3) = 0
    integer(c_int32_t) :: first(3) = 0
  end type

  ! The names of open patches are an array of c_loc() of texts that end in c_null_char.
  type, bind(c) :: cw_cutter_options
    integer(c_int32_t) :: fluid_inside = 0, cap_holes = 0
    type(c_ptr) :: open_patches = c_null_ptr
    integer(c_int64_t) :: open_patch_count = 0
    real(c_double) :: period(3) = 0
    type(c_ptr) :: baffles = c_null_ptr
    integer(c_int64_t) :: baffle_count = 0
  end type

  ! Rows of cut cells: their arrays become Fortran's by c_f_pointer().
  type, bind(c) :: cw_cut_cells
    integer(c_int64_t) :: count = 0, count_around = 0
    type(c_ptr) :: index, first_piece, fluid_corners, meets, wall_faces
  end type

  type, bind(c) :: cw_pieces
    integer(c_int64_t) :: count = 0, count_around = 0
    type(c_ptr) :: cell, volume, centroid, wall_area, wall_vector, wall_centroid, wall_faces
  end type

  type, bind(c) :: cw_arcs
    integer(c_int64_t) :: count = 0
    type(c_ptr) :: below, above, area, centroid, cell, axis
  end type

  type, bind(c) :: cw_open_arcs
    integer(c_int64_t) :: count = 0
    type(c_ptr) :: arc, patch
  end type

  type, bind(c) :: cw_wall_parts
    integer(c_int64_t) :: count = 0
    type(c_ptr) :: piece, patch, area, vector, centroid
  end type

  type, bind(c) :: cw_polygons
    integer(c_int64_t) :: count = 0
    type(c_ptr) :: first, points
  end type

  interface
    subroutine cw_free(solid) bind(c)
      import :: c_ptr
      type(c_ptr), value :: solid
    end subroutine

    integer(c_int) function cw_read_surface(path, scale, require_watertight, solid) bind(c)
      import :: c_ptr, c_int, c_double, c_char
      character(kind=c_char), intent(in) :: path(*)
      real(c_double), value :: scale
      integer(c_int), value :: require_watertight
      type(c_ptr), intent(out) :: solid
    end function

    integer(c_int) function cw_from_mesh(mesh, require_watertight, solid) bind(c)
      import :: c_ptr, c_int, cw_mesh
      type(cw_mesh), intent(in) :: mesh
      integer(c_int), value :: require_watertight
      type(c_ptr), intent(out) :: solid
    end function

    integer(c_int) function cw_sphere(center, radius, solid) bind(c)
      import :: c_ptr, c_int, c_double
      real(c_double), intent(in) :: center(3)
      real(c_double), value :: radius
      type(c_ptr), intent(out) :: solid
    end function

    integer(c_int) function cw_box(lower, upper, solid) bind(c)
      import :: c_ptr, c_int, c_double
      real(c_double), intent(in) :: lower(3), upper(3)
      type(c_ptr), intent(out) :: solid
    end function

    integer(c_int) function cw_union(solids, count, solid) bind(c)
      import :: c_ptr, c_int, c_int64_t
      type(c_ptr), intent(in) :: solids(*)
      integer(c_int64_t), value :: count
      type(c_ptr), intent(out) :: solid
    end function

    integer(c_int) function cw_intersection(solids, count, solid) bind(c)
      import :: c_ptr, c_int, c_int64_t
      type(c_ptr), intent(in) :: solids(*)
      integer(c_int64_t), value :: count
      type(c_ptr), intent(out) :: solid
    end function

    integer(c_int) function cw_difference(from, what, solid) bind(c)
      import :: c_ptr, c_int
      type(c_ptr), value :: from, what
      type(c_ptr), intent(out) :: solid
    end function

    integer(c_int) function cw_translated(solid, offset, moved) bind(c)
      import :: c_ptr, c_int, c_double
      type(c_ptr), value :: solid
      real(c_double), intent(in) :: offset(3)
      type(c_ptr), intent(out) :: moved
    end function

    integer(c_int) function cw_rotated(solid, degrees, axis, through, moved) bind(c)
      import :: c_ptr, c_int, c_double
      type(c_ptr), value :: solid
      real(c_double), value :: degrees
      real(c_double), intent(in) :: axis(3), through(3)
      type(c_ptr), intent(out) :: moved
    end function

    integer(c_int) function cw_signed_distances(solid, points, count, distances, threads) bind(c)
      import :: c_ptr, c_int, c_int64_t, c_double
      type(c_ptr), value :: solid
      real(c_double), intent(in) :: points(3, *)
      integer(c_int64_t), value :: count
      real(c_double), intent(out) :: distances(*)
      integer(c_int), value :: threads
    end function

    integer(c_int) function cw_closest_points(solid, points, count, nearest, threads) bind(c)
      import :: c_ptr, c_int, c_int64_t, c_double, cw_surface_point
      type(c_ptr), value :: solid
      real(c_double), intent(in) :: points(3, *)
      integer(c_int64_t), value :: count
      type(cw_surface_point), intent(out) :: nearest(*)
      integer(c_int), value :: threads
    end function

    integer(c_int) function cw_classify_boxes(solid, boxes, count, classes, threads) bind(c)
      import :: c_ptr, c_int, c_int64_t, c_int8_t, c_double
      type(c_ptr), value :: solid
      real(c_double), intent(in) :: boxes(6, *)
      integer(c_int64_t), value :: count
      integer(c_int8_t), intent(out) :: classes(*)
      integer(c_int), value :: threads
    end function

    integer(c_int) function cw_fill(solid, grid, band, distances, patches, threads) bind(c)
      import :: c_ptr, c_int, c_double, cw_grid
      type(c_ptr), value :: solid, distances, patches
      type(cw_grid), intent(in) :: grid
      real(c_double), value :: band
      integer(c_int), value :: threads
    end function

    integer(c_int) function cw_classify_cells(solid, grid, classes, threads) bind(c)
      import :: c_ptr, c_int, c_int8_t, cw_grid
      type(c_ptr), value :: solid
      type(cw_grid), intent(in) :: grid
      integer(c_int8_t), intent(out) :: classes(*)
      integer(c_int), value :: threads
    end function

    integer(c_int) function cw_bounding_box(solid, lower, upper) bind(c)
      import :: c_ptr, c_int, c_double
      type(c_ptr), value :: solid
      real(c_double), intent(out) :: lower(3), upper(3)
    end function

    integer(c_int) function cw_patch_count(solid, count) bind(c)
      import :: c_ptr, c_int, c_int32_t
      type(c_ptr), value :: solid
      integer(c_int32_t), intent(out) :: count
    end function

    integer(c_int) function cw_patch_name(solid, patch, name) bind(c)
      import :: c_ptr, c_int, c_int32_t
      type(c_ptr), value :: solid
      integer(c_int32_t), value :: patch
      type(c_ptr), intent(out) :: name
    end function

    subroutine cw_free_cells(cells) bind(c)
      import :: c_ptr
      type(c_ptr), value :: cells
    end subroutine

    integer(c_int) function cw_cut_grid(solid, grid, fluid_inside, polygons, threads, cells) bind(c)
      import :: c_ptr, c_int, cw_grid
      type(c_ptr), value :: solid
      type(cw_grid), intent(in) :: grid
      integer(c_int), value :: fluid_inside
      integer(c_int), value :: polygons
      integer(c_int), value :: threads
      type(c_ptr), intent(out) :: cells
    end function

    integer(c_int) function cw_cut_planes(solid, planes, fluid_inside, polygons, threads, cells) bind(c)
      import :: c_ptr, c_int, cw_planes
      type(c_ptr), value :: solid
      type(cw_planes), intent(in) :: planes
      integer(c_int), value :: fluid_inside
      integer(c_int), value :: polygons
      integer(c_int), value :: threads
      type(c_ptr), intent(out) :: cells
    end function

    subroutine cw_free_cutter(cutter) bind(c)
      import :: c_ptr
      type(c_ptr), value :: cutter
    end subroutine

    integer(c_int) function cw_make_cutter(solid, options, cutter) bind(c)
      import :: c_ptr, c_int, cw_cutter_options
      type(c_ptr), value :: solid
      type(cw_cutter_options), intent(in) :: options
      type(c_ptr), intent(out) :: cutter
    end function

    integer(c_int) function cw_cutter_grid(cutter, grid, polygons, threads, cells) bind(c)
      import :: c_ptr, c_int, cw_grid
      type(c_ptr), value :: cutter
      type(cw_grid), intent(in) :: grid
      integer(c_int), value :: polygons
      integer(c_int), value :: threads
      type(c_ptr), intent(out) :: cells
    end function

    integer(c_int) function cw_cutter_planes(cutter, planes, polygons, threads, cells) bind(c)
      import :: c_ptr, c_int, cw_planes
      type(c_ptr), value :: cutter
      type(cw_planes), intent(in) :: planes
      integer(c_int), value :: polygons
      integer(c_int), value :: threads
      type(c_ptr), intent(out) :: cells
    end function

    integer(c_int) function cw_coarsened(cells, ratios, coarse) bind(c)
      import :: c_ptr, c_int, c_int32_t
      type(c_ptr), value :: cells
      integer(c_int32_t), intent(in) :: ratios(3)
      type(c_ptr), intent(out) :: coarse
    end function

    integer(c_int) function cw_merged(cells, smallest, single) bind(c)
      import :: c_ptr, c_int, c_double
      type(c_ptr), value :: cells
      real(c_double), value :: smallest
      type(c_ptr), intent(out) :: single
    end function

    integer(c_int) function cw_save_cells(cells, path) bind(c)
      import :: c_ptr, c_int, c_char
      type(c_ptr), value :: cells
      character(kind=c_char), intent(in) :: path(*)
    end function

    integer(c_int) function cw_load_cells(path, cells) bind(c)
      import :: c_ptr, c_int, c_char
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), intent(out) :: cells
    end function

    integer(c_int) function cw_fluid_fractions(cells, fractions, count) bind(c)
      import :: c_ptr, c_int, c_int64_t, c_double
      type(c_ptr), value :: cells
      real(c_double), intent(out) :: fractions(*)
      integer(c_int64_t), value :: count
    end function

    integer(c_int) function cw_cells_rows(cells, rows) bind(c)
      import :: c_ptr, c_int, cw_cut_cells
      type(c_ptr), value :: cells
      type(cw_cut_cells), intent(out) :: rows
    end function

    integer(c_int) function cw_cells_pieces(cells, rows) bind(c)
      import :: c_ptr, c_int, cw_pieces
      type(c_ptr), value :: cells
      type(cw_pieces), intent(out) :: rows
    end function

    integer(c_int) function cw_cells_arcs(cells, rows) bind(c)
      import :: c_ptr, c_int, cw_arcs
      type(c_ptr), value :: cells
      type(cw_arcs), intent(out) :: rows
    end function

    integer(c_int) function cw_cells_open_arcs(cells, rows) bind(c)
      import :: c_ptr, c_int, cw_open_arcs
      type(c_ptr), value :: cells
      type(cw_open_arcs), intent(out) :: rows
    end function

    integer(c_int) function cw_cells_patch_count(cells, count) bind(c)
      import :: c_ptr, c_int, c_int32_t
      type(c_ptr), value :: cells
      integer(c_int32_t), intent(out) :: count
    end function

    integer(c_int) function cw_cells_patch_name(cells, patch, name) bind(c)
      import :: c_ptr, c_int, c_int32_t
      type(c_ptr), value :: cells
      integer(c_int32_t), value :: patch
      type(c_ptr), intent(out) :: name
    end function

    integer(c_int) function cw_cells_wall_parts(cells, rows) bind(c)
      import :: c_ptr, c_int, cw_wall_parts
      type(c_ptr), value :: cells
      type(cw_wall_parts), intent(out) :: rows
    end function

    integer(c_int) function cw_cells_arc_polygons(cells, rows) bind(c)
      import :: c_ptr, c_int, cw_polygons
      type(c_ptr), value :: cells
      type(cw_polygons), intent(out) :: rows
    end function

    integer(c_int) function cw_cells_wall_polygons(cells, polygons, first_of_part) bind(c)
      import :: c_ptr, c_int, cw_polygons
      type(c_ptr), value :: cells
      type(cw_polygons), intent(out) :: polygons
      type(c_ptr), intent(out) :: first_of_part
    end function

    type(c_ptr) function cw_last_error() bind(c)
      import :: c_ptr
    end function

    integer(c_size_t) function cw_text_length(text) bind(c, name="strlen")
      import :: c_ptr, c_size_t
      type(c_ptr), value :: text
    end function
  end interface

contains

  ! What cw_last_error() and cw_patch_name() point at.
  function cw_text(pointer) result(text)
    type(c_ptr), intent(in) :: pointer
    character(len=:), allocatable :: text
    character(kind=c_char), pointer :: characters(:)
    integer :: i
    call c_f_pointer(pointer, characters, [cw_text_length(pointer)])
    allocate (character(len=size(characters)) :: text)
    do i = 1, size(characters)
      text(i:i) = characters(i)
    end do
  end function
end module
