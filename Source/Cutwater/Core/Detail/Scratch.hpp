#pragma once

#include <Cutwater/Core/Detail/Inline.hpp>

#include <array>
#include <span>
#include <type_traits>

namespace cutwater {

/// Memory for values that are written before they are read: a `std::array` without the
/// initialisation, which would take longer than a small batch takes to process.
template <typename Value, std::size_t kCount>
union Scratch {
 public:
  static_assert(std::is_trivially_copyable_v<Value>);

  CUTWATER_INLINE Scratch() {}  // NOLINT(modernize-use-equals-default): that would be deleted

  /// As in std::array.
  CUTWATER_INLINE Value& operator[](std::size_t i) { return values_[i]; }
  CUTWATER_INLINE const Value& operator[](std::size_t i) const { return values_[i]; }
  CUTWATER_INLINE std::span<Value> first(std::size_t count) {
    return std::span<Value>(values_).first(count);
  }

 private:
  std::array<Value, kCount> values_;
};

}  // namespace cutwater
