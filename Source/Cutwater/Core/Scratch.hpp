#pragma once

#include <Cutwater/Core/Inline.hpp>

#include <array>
#include <span>
#include <type_traits>

namespace cutwater {

/// Room for values that are written before they are read: a `std::array` that does not set them to
/// their defaults first, which takes longer than what a small batch does with them.
template <typename Value, std::size_t kCount>
union Scratch {
 public:
  static_assert(std::is_trivially_copyable_v<Value>);

  CUTWATER_INLINE Scratch() {}  // NOLINT(modernize-use-equals-default): that would be deleted

  /// As a std::array has them.
  CUTWATER_INLINE Value& operator[](std::size_t i) { return values_[i]; }
  CUTWATER_INLINE const Value& operator[](std::size_t i) const { return values_[i]; }
  CUTWATER_INLINE std::span<Value> first(std::size_t count) {
    return std::span<Value>(values_).first(count);
  }

 private:
  std::array<Value, kCount> values_;
};

}  // namespace cutwater
