! A tetrahedron from arrays and a ball, turned: distances, nearest points, boxes, a patch of a grid.
program main
  use cutwater
  implicit none

  integer, parameter :: n = 8
  real(c_double), target :: corners(3, 4) = reshape( &
    [0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0], [3, 4])
  integer(c_int32_t), target :: triangles(3, 4) = reshape( &
    [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3], [3, 4])
  real(c_double) :: points(3, 2) = reshape([0d0, 8d0, 0d0, 0.25d0, 0.125d0, -1d0], [3, 2])
  real(c_double) :: boxes(6, 2) = reshape( &
    [-0.1d0, 4.9d0, -0.1d0, 0.1d0, 5.1d0, 0.1d0, 2d0, 2d0, 2d0, 3d0, 3d0, 3d0], [6, 2])
  real(c_double) :: distances(2)
  real(c_double), target :: values(n, n, n)
  type(cw_surface_point) :: nearest(2)
  integer(c_int8_t) :: classes(2)
  type(cw_mesh) :: mesh
  type(cw_grid) :: grid
  type(c_ptr) :: tetrahedron, ball, both, solid, name, cells
  type(cw_pieces) :: pieces
  type(cw_arcs) :: arcs
  real(c_double), pointer :: volume(:), wall_vector(:, :)
  integer(c_int32_t), pointer :: below(:)
  real(c_double), target :: fractions(n, n, n)

  ! [DOCS
  mesh%points = c_loc(corners)
  mesh%point_count = 4
  mesh%triangles = c_loc(triangles)
  mesh%triangle_count = 4
  call need(cw_from_mesh(mesh, 1, tetrahedron))
  call need(cw_sphere([5d0, 0d0, 0d0], 1d0, ball))
  call need(cw_union([tetrahedron, ball], 2_c_int64_t, both))
  ! About the z axis: the ball goes to (0, 5, 0).
  call need(cw_rotated(both, 90d0, [0d0, 0d0, 1d0], [0d0, 0d0, 0d0], solid))

  call need(cw_signed_distances(solid, points, 2_c_int64_t, distances, 0))
  call need(cw_closest_points(solid, points, 2_c_int64_t, nearest, 0))
  call need(cw_classify_boxes(solid, boxes, 2_c_int64_t, classes, 0))
  grid%origin = [-2d0, 3d0, -2d0]
  grid%spacing = 0.5d0
  grid%lo = 0
  grid%hi = n - 1
  call need(cw_fill(solid, grid, 0d0, c_loc(values), c_null_ptr, 0))
  call need(cw_patch_name(solid, nearest(1)%patch, name))
  ! DOCS]

  print '(a, 2f8.4)', "distances", distances
  print '(a, 3f8.4, 2a)', "nearest point of the first", nearest(1)%point, ", patch ", cw_text(name)
  print '(a, i0)', "cells of the grid with their centre inside: ", count(values < 0)
  if (abs(distances(1) - 2) > 1d-12 .or. abs(nearest(1)%point(2) - 6) > 1d-12) error stop 1
  if (distances(2) <= 0.9d0 .or. classes(1) /= CW_INSIDE .or. classes(2) /= CW_OUTSIDE) error stop 1
  ! The value of an index is that of the point where it stands.
  points(:, 1) = grid%origin + ([2, 4, 6] + 0.5d0) * grid%spacing
  call need(cw_signed_distances(solid, points, 1_c_int64_t, distances, 0))
  if (values(3, 5, 7) /= distances(1)) error stop 1
  ! What is refused says why.
  if (cw_sphere([0d0, 0d0, 0d0], -1d0, name) /= CW_ERROR_ARGUMENT) error stop 1
  print '(2a)', "refused: ", cw_text(cw_last_error())

  ! [DOCS
  grid%origin = -0.55d0
  grid%spacing = 0.25d0
  call need(cw_cut_grid(tetrahedron, grid, 0, 0, 0, cells)) ! fluid outside, no polygons
  call need(cw_cells_pieces(cells, pieces))
  call c_f_pointer(pieces%volume, volume, [pieces%count])
  call c_f_pointer(pieces%wall_vector, wall_vector, [3_c_int64_t, pieces%count])
  call need(cw_cells_arcs(cells, arcs))
  call c_f_pointer(arcs%below, below, [arcs%count])
  call need(cw_fluid_fractions(cells, fractions, size(fractions, kind=c_int64_t)))
  ! DOCS]
  print '(a, i0, a, f8.5)', "pieces in cut cells: ", pieces%count, ", of volume ", sum(volume)
  ! The body is 1/6 of the box of 2 x 2 x 2; its wall is closed.
  if (abs((n ** 3 - sum(fractions)) * 0.25d0 ** 3 - 1d0 / 6) > 1d-12) error stop 1
  if (any(abs(sum(wall_vector, dim=2)) > 1d-12)) error stop 1
  if (.not. all(below >= 0 .or. below == CW_WHOLE_CELL)) error stop 1
  call cw_free_cells(cells)

  call cw_free(tetrahedron)
  call cw_free(ball)
  call cw_free(both)
  call cw_free(solid)

contains

  subroutine need(status)
    integer(c_int), intent(in) :: status
    if (status == CW_OK) return
    print '(a)', cw_text(cw_last_error())
    error stop 1
  end subroutine
end program
