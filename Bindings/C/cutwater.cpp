#include "cutwater.h"

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Io/VtpSurface.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <array>

#include "Handles.hpp"

using namespace cutwater;
using namespace cutwater::binding;

namespace {

const Solid<double>& solidOf(const cw_solid* handle) {
  return handleOf(handle).solid;
}

template <typename Combine>
cw_status combine(const char* function, const cw_solid* const* solids, std::int64_t count,
                  cw_solid** result, Combine combineAll) {
  return create(function, result, [&] {
    std::vector<Solid<double>> operands;
    for (const cw_solid* handle : arrayOf("solids", solids, count)) {
      operands.push_back(solidOf(handle));
    }
    return combineAll(operands);
  });
}

MeshSDFOptions optionsOf(int requireWatertight) {
  return {.requireWatertight = requireWatertight != 0};
}

cw_surface_point toC(const SurfacePoint<double>& p) {
  return {.point = {p.point.x, p.point.y, p.point.z},
          .normal = {p.normal.x, p.normal.y, p.normal.z},
          .distance = p.distance,
          .tolerance = p.tolerance,
          .patch = static_cast<std::int32_t>(p.owner.patch),
          .face = static_cast<std::int32_t>(p.owner.face)};
}
static_assert(static_cast<std::int32_t>(kNone) == -1);

template <typename Value>
GridView<Value> viewOf(Value* data, const cw_grid& grid, const IndexBox& indices) {
  if (std::ranges::all_of(grid.strides, [](std::int64_t stride) { return stride == 0; })) {
    return GridView<Value>::contiguous(data, indices);
  }
  return {data, {grid.strides[0], grid.strides[1], grid.strides[2]}};
}

}  // namespace

const char* cw_last_error() {
  return lastError();
}

void cw_free(cw_solid* solid) {
  delete solid;
}

cw_status cw_read_surface(const char* path, double scale, int requireWatertight,
                          cw_solid** result) {
  return create("cw_read_surface", result, [&] {
    require(path != nullptr, "the path is NULL");
    const auto file = readAnySurface(path, {.scale = scale, .placement = {}});
    return MeshSDF<double>(file.soup, optionsOf(requireWatertight));
  });
}

cw_status cw_from_mesh(const cw_mesh* mesh, int requireWatertight, cw_solid** result) {
  return create("cw_from_mesh", result, [&] {
    require(mesh != nullptr, "the mesh is NULL");
    auto soup = soupOf(*mesh);
    weldExactly(soup);
    return MeshSDF<double>(soup, optionsOf(requireWatertight));
  });
}

cw_status cw_sphere(const double center[3], double radius, cw_solid** result) {
  return create("cw_sphere", result,
                [&] { return Sphere<double>(vectorOf("center", center), radius); });
}

cw_status cw_box(const double lower[3], const double upper[3], cw_solid** result) {
  return create("cw_box", result,
                [&] { return Cuboid<double>(vectorOf("lower", lower), vectorOf("upper", upper)); });
}

cw_status cw_union(const cw_solid* const* solids, int64_t count, cw_solid** result) {
  return combine("cw_union", solids, count, result,
                 [](const auto& operands) { return unionOf(operands); });
}

cw_status cw_intersection(const cw_solid* const* solids, int64_t count, cw_solid** result) {
  return combine("cw_intersection", solids, count, result,
                 [](const auto& operands) { return intersectionOf(operands); });
}

cw_status cw_difference(const cw_solid* from, const cw_solid* what, cw_solid** result) {
  return create("cw_difference", result, [&] { return solidOf(from) - solidOf(what); });
}

cw_status cw_translated(const cw_solid* solid, const double offset[3], cw_solid** result) {
  return create("cw_translated", result,
                [&] { return translated(solidOf(solid), vectorOf("offset", offset)); });
}

cw_status cw_rotated(const cw_solid* solid, double degrees, const double axis[3],
                     const double through[3], cw_solid** result) {
  return create("cw_rotated", result, [&] {
    const auto centre = through == nullptr ? Vec3<double>{} : vectorOf("through", through);
    return rotated(solidOf(solid), degrees, vectorOf("axis", axis), centre);
  });
}

cw_status cw_signed_distances(const cw_solid* solid, const double* points, int64_t count,
                              double* distances, int threads) {
  return guarded("cw_signed_distances", [&] {
    solidOf(solid).signedDistances(pointsOf("points", points, count),
                                   arrayOf("distances", distances, count), {.threads = threads});
  });
}

cw_status cw_closest_points(const cw_solid* solid, const double* points, int64_t count,
                            cw_surface_point* nearest, int threads) {
  return guarded("cw_closest_points", [&] {
    const auto& shape = solidOf(solid);
    const auto queries = pointsOf("points", points, count);
    const auto answers = arrayOf("nearest", nearest, count);
    // In pieces large enough for many threads, and small compared with the caller's own arrays.
    constexpr std::size_t kPiece = 1U << 16U;
    std::vector<SurfacePoint<double>> found(std::min(kPiece, queries.size()));
    for (std::size_t first = 0; first < queries.size(); first += kPiece) {
      const auto piece = queries.subspan(first, std::min(kPiece, queries.size() - first));
      shape.closestPoints(piece, std::span(found).first(piece.size()), {.threads = threads});
      std::transform(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(piece.size()),
                     answers.begin() + static_cast<std::ptrdiff_t>(first), toC);
    }
  });
}

cw_status cw_classify_boxes(const cw_solid* solid, const double* boxes, int64_t count,
                            uint8_t* classes, int threads) {
  return guarded("cw_classify_boxes", [&] {
    const auto& shape = solidOf(solid);
    const auto queries = boxesOf("boxes", boxes, count);
    const auto answers = arrayOf("classes", classes, count);
    std::vector<BoxClass> found(queries.size());
    shape.classify(queries, found, {}, {.threads = threads});
    std::ranges::transform(found, answers.begin(),
                           [](BoxClass c) { return static_cast<std::uint8_t>(c); });
  });
}
static_assert(static_cast<int>(BoxClass::Inside) == CW_INSIDE);
static_assert(static_cast<int>(BoxClass::Outside) == CW_OUTSIDE);
static_assert(static_cast<int>(BoxClass::Cut) == CW_CUT);
static_assert(static_cast<int>(BoxClass::Unknown) == CW_UNKNOWN);

cw_status cw_fill(const cw_solid* solid, const cw_grid* grid, double band, double* distances,
                  int32_t* patches, int threads) {
  return guarded("cw_fill", [&] {
    const auto& shape = solidOf(solid);
    require(grid != nullptr, "the grid is NULL");
    require(distances != nullptr || patches != nullptr, "both arrays are NULL");
    const auto gridPatch = gridPatchOf(*grid);
    // Signed and unsigned integers of the same size may alias: kNone is -1.
    auto* const ids = reinterpret_cast<std::uint32_t*>(patches);
    fill(shape, gridPatch,
         {.distance = viewOf(distances, *grid, gridPatch.indices),
          .patch = viewOf(ids, *grid, gridPatch.indices)},
         {.band = band, .threads = threads});
  });
}

cw_status cw_classify_cells(const cw_solid* solid, const cw_grid* grid, uint8_t* classes,
                            int threads) {
  return guarded("cw_classify_cells", [&] {
    const auto& shape = solidOf(solid);
    require(grid != nullptr, "the grid is NULL");
    require(classes != nullptr, "classes is NULL");
    const auto gridPatch = gridPatchOf(*grid);
    auto* const kinds = reinterpret_cast<BoxClass*>(classes);
    fill(shape, gridPatch, {.boxClass = viewOf(kinds, *grid, gridPatch.indices)},
         {.threads = threads});
  });
}

cw_status cw_bounding_box(const cw_solid* solid, double lower[3], double upper[3]) {
  return guarded("cw_bounding_box", [&] {
    const auto box = solidOf(solid).boundingBox();
    const auto lowest = arrayOf("lower", lower, 3);
    const auto highest = arrayOf("upper", upper, 3);
    std::ranges::copy(std::array{box.lower.x, box.lower.y, box.lower.z}, lowest.begin());
    std::ranges::copy(std::array{box.upper.x, box.upper.y, box.upper.z}, highest.begin());
  });
}

cw_status cw_patch_count(const cw_solid* solid, int32_t* count) {
  return guarded("cw_patch_count", [&] {
    const auto& names = handleOf(solid).patchNames;
    require(count != nullptr, "the count is NULL");
    *count = static_cast<std::int32_t>(names.size());
  });
}

cw_status cw_patch_name(const cw_solid* solid, int32_t patch, const char** name) {
  return guarded("cw_patch_name", [&] {
    const auto& names = handleOf(solid).patchNames;
    require(name != nullptr, "the name is NULL");
    require(patch >= 0 && static_cast<std::size_t>(patch) < names.size(), "no such patch",
            Named{"patch", patch}, Named{"patches", names.size()});
    *name = names[static_cast<std::size_t>(patch)].c_str();
  });
}
