#include "Arguments.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>

namespace cutwater::binding {

namespace {

// Of fixed size: running out of memory can be reported too, and nothing remains after the thread.
constinit thread_local std::array<char, 1024> message{};

void append(std::size_t& length, const char* text) noexcept {
  const std::size_t added = std::min(std::strlen(text), message.size() - 1 - length);
  std::memcpy(message.data() + length, text, added);
  length += added;
  message[length] = '\0';
}

cw_status statusOf(ErrorKind kind) noexcept {
  switch (kind) {
    case ErrorKind::Argument:
      return CW_ERROR_ARGUMENT;
    case ErrorKind::File:
      return CW_ERROR_FILE;
    case ErrorKind::Topology:
      return CW_ERROR_TOPOLOGY;
    case ErrorKind::Limit:
      return CW_ERROR_LIMIT;
  }
  return CW_ERROR_INTERNAL;
}

cw_status keep(const char* function, const char* what, cw_status status) noexcept {
  std::size_t length = 0;
  append(length, function);
  append(length, ": ");
  append(length, what);
  return status;
}

// The caller's doubles are read as the library's plain aggregates of the same layout.
static_assert(sizeof(Vec3<double>) == 3 * sizeof(double));
static_assert(sizeof(Box<double>) == 6 * sizeof(double));
static_assert(alignof(Vec3<double>) == alignof(double) && alignof(Box<double>) == alignof(double));
static_assert(std::is_standard_layout_v<Box<double>> && std::is_trivially_copyable_v<Box<double>>);

template <typename Record>
std::span<const Record> recordsOf(const char* name, const double* data, std::int64_t count) {
  requireArray(name, data, count, sizeof(Record));
  return {reinterpret_cast<const Record*>(data), static_cast<std::size_t>(count)};
}

std::vector<std::string> patchNamesOf(const cw_mesh& mesh) {
  require(mesh.patchCount >= 0 && (mesh.patchCount > 0 || mesh.patches == nullptr),
          "triangles have patches, and there are none", Named{"patchCount", mesh.patchCount});
  if (mesh.patchCount == 0) return {"surface"};
  std::vector<std::string> names;
  for (std::int32_t i = 0; i < mesh.patchCount; ++i) {
    if (mesh.patchNames == nullptr) {
      names.push_back("patch " + std::to_string(i));
      continue;
    }
    require(mesh.patchNames[i] != nullptr, "the name of a patch is NULL", Named{"patch", i});
    names.emplace_back(mesh.patchNames[i]);
  }
  return names;
}

std::array<std::uint32_t, 3> cornersOf(const cw_mesh& mesh, std::int64_t triangle) {
  std::array<std::uint32_t, 3> corners{};
  for (std::size_t j = 0; j < 3; ++j) {
    const std::int32_t corner = mesh.triangles[3 * static_cast<std::size_t>(triangle) + j];
    require(corner >= 0 && corner < mesh.pointCount, "a triangle's corner is not a point",
            Named{"triangle", triangle}, Named{"corner", corner});
    corners[j] = static_cast<std::uint32_t>(corner);
  }
  return corners;
}

std::uint32_t patchOf(const cw_mesh& mesh, std::int64_t triangle, std::size_t patches) {
  const std::int32_t patch = mesh.patches == nullptr ? 0 : mesh.patches[triangle];
  require(patch >= 0 && static_cast<std::size_t>(patch) < patches,
          "a triangle's patch is out of range", Named{"triangle", triangle}, Named{"patch", patch});
  return static_cast<std::uint32_t>(patch);
}

}  // namespace

cw_status statusOf(const char* function, const std::exception_ptr& error) noexcept {
  try {
    std::rethrow_exception(error);
  } catch (const Error& e) {
    return keep(function, e.what(), statusOf(e.kind()));
  } catch (const std::bad_alloc&) {
    return keep(function, "out of memory", CW_ERROR_MEMORY);
  } catch (const std::exception& e) {
    return keep(function, e.what(), CW_ERROR_INTERNAL);
  } catch (...) {
    return keep(function, "an exception of unknown type", CW_ERROR_INTERNAL);
  }
}

const char* lastError() noexcept {
  return message.data();
}

void requireArray(const char* name, const void* data, std::int64_t count, std::size_t bytes) {
  const auto most = std::numeric_limits<std::ptrdiff_t>::max() / static_cast<std::ptrdiff_t>(bytes);
  if (count >= 0 && count <= most && (data != nullptr || count == 0)) return;
  const char* const why =
      data == nullptr && count > 0 ? " is NULL" : " cannot have so many elements";
  throw Error(ErrorKind::Argument,
              name + std::string(why) + " (count = " + std::to_string(count) + ")");
}

std::span<const Vec3<double>> pointsOf(const char* name, const double* data, std::int64_t count) {
  return recordsOf<Vec3<double>>(name, data, count);
}

std::span<const Box<double>> boxesOf(const char* name, const double* data, std::int64_t count) {
  return recordsOf<Box<double>>(name, data, count);
}

Vec3<double> vectorOf(const char* name, const double* data) {
  return pointsOf(name, data, 1).front();
}

PolygonSoup soupOf(const cw_mesh& mesh) {
  const auto points = pointsOf("points", mesh.points, mesh.pointCount);
  requireArray("triangles", mesh.triangles, mesh.triangleCount,
               sizeof(std::array<std::int32_t, 3>));
  PolygonSoup soup;
  soup.points.assign(points.begin(), points.end());
  soup.patchNames = patchNamesOf(mesh);
  for (std::int64_t i = 0; i < mesh.triangleCount; ++i) {
    soup.addPolygon(cornersOf(mesh, i), patchOf(mesh, i, soup.patchNames.size()));
  }
  soup.validate();
  return soup;
}

GridPatch<double> gridPatchOf(const cw_grid& grid) {
  const Level<double> level(vectorOf("origin", grid.origin), vectorOf("spacing", grid.spacing),
                            grid.nodes != 0 ? Centering::Node : Centering::Cell);
  const IndexBox indices{{grid.lo[0], grid.lo[1], grid.lo[2]},
                         {grid.hi[0], grid.hi[1], grid.hi[2]}};
  if (indices.length(0) == 0 || indices.length(1) == 0 || indices.length(2) == 0) {
    return {level, indices};
  }
  const bool contiguous = std::ranges::all_of(grid.strides, [](auto s) { return s == 0; });
  double values = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto length = indices.length(axis);
    values *= static_cast<double>(length);
    require(contiguous || length == 1 || grid.strides[axis] != 0,
            "a stride is 0 along an axis of several indices", Named{"axis", axis});
  }
  require(values * sizeof(double) < 0x1p63, "more indices than memory can hold",
          Named{"indices", values});
  return {level, indices};
}

}  // namespace cutwater::binding
