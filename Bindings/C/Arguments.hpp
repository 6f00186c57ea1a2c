#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

#include <cstdint>
#include <exception>
#include <limits>
#include <span>
#include <type_traits>

#include "cutwater.h"

/// Checks arguments from C and converts them to the library's types; reports errors back to C.
namespace cutwater::binding {

/// Stores the error's message for this thread and returns its status.
cw_status statusOf(const char* function, const std::exception_ptr& error) noexcept;

/// The last message stored in this thread.
const char* lastError() noexcept;

/// Runs the body of a function of the interface and lets no exception escape.
template <typename Body>
cw_status guarded(const char* function, Body body) noexcept {
  try {
    body();
    return CW_OK;
  } catch (...) {
    return statusOf(function, std::current_exception());
  }
}

/// @throws Error if count is negative or exceeds the number of elements of size `bytes` that memory
/// can hold, or if the array is missing and count is not 0.
void requireArray(const char* name, const void* data, std::int64_t count, std::size_t bytes);

template <typename Value>
std::span<Value> arrayOf(const char* name, Value* data, std::int64_t count) {
  requireArray(name, data, count, sizeof(Value));  // NOLINT(bugprone-sizeof-expression)
  return {data, static_cast<std::size_t>(count)};
}

std::span<const Vec3<double>> pointsOf(const char* name, const double* data, std::int64_t count);
std::span<const Box<double>> boxesOf(const char* name, const double* data, std::int64_t count);
Vec3<double> vectorOf(const char* name, const double* data);

/// @throws Error if an array is missing, or an index or patch is out of range.
PolygonSoup soupOf(const cw_mesh& mesh);

/// @throws Error also for strides that map different indices along an axis to the same element.
GridPatch<double> gridPatchOf(const cw_grid& grid);

}  // namespace cutwater::binding
