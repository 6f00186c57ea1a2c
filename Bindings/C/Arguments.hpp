#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Mesh/PolygonSoup.hpp>

#include <cstdint>
#include <exception>
#include <limits>
#include <span>
#include <type_traits>

#include "cutwater.h"

/// What C hands over, checked and as the library has it; and errors on their way back to C.
namespace cutwater::binding {

/// Keeps the error's message for this thread, and gives its status.
cw_status statusOf(const char* function, const std::exception_ptr& error) noexcept;

/// The message kept last in this thread.
const char* lastError() noexcept;

/// Runs the body of a function of the interface, which no exception may leave.
template <typename Body>
cw_status guarded(const char* function, Body body) noexcept {
  try {
    body();
    return CW_OK;
  } catch (...) {
    return statusOf(function, std::current_exception());
  }
}

/// @throws Error unless count is not negative, and no more than memory can hold of what `bytes` is
/// the size of, and there is an array if it is not 0.
void requireArray(const char* name, const void* data, std::int64_t count, std::size_t bytes);

template <typename Value>
std::span<Value> arrayOf(const char* name, Value* data, std::int64_t count) {
  requireArray(name, data, count, sizeof(Value));
  return {data, static_cast<std::size_t>(count)};
}

std::span<const Vec3<double>> pointsOf(const char* name, const double* data, std::int64_t count);
std::span<const Box<double>> boxesOf(const char* name, const double* data, std::int64_t count);
Vec3<double> vectorOf(const char* name, const double* data);

/// @throws Error for an array that is missing, or an index or patch out of range.
PolygonSoup soupOf(const cw_mesh& mesh);

/// @throws Error also for strides that put indices on top of each other along an axis.
Patch<double> patchOf(const cw_grid& grid);

}  // namespace cutwater::binding
