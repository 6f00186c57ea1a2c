#pragma once

#include <Cutwater/Core/OrientedBox.hpp>

#include <array>
#include <cstdint>
#include <type_traits>

namespace cutwater {

/// Where a closed box lies. The surface is the boundary of {value < 0}.
enum class BoxClass : std::uint8_t {
  Inside,   ///< certainly no surface in the box, and it is solid
  Outside,  ///< certainly no surface in the box, and it is free
  Cut,      ///< certainly some surface in the box
  Unknown,  ///< neither proven: refine, or treat as Cut
};

/// Whether the surface meets a box of this kind, certainly or possibly.
[[nodiscard]] constexpr bool mayBeCut(BoxClass kind) {
  return kind == BoxClass::Cut || kind == BoxClass::Unknown;
}

/// What a box query has learned about a box, for queries about boxes within it. Start with a
/// default-constructed one. Holds indices only: it can be copied as bytes, and is valid on every
/// process that has the same geometry. Answers are the same with and without it.
struct BoxHint {
  std::array<std::uint32_t, 16> words{};
};
static_assert(std::is_trivially_copyable_v<BoxHint> && sizeof(BoxHint) <= 64);

}  // namespace cutwater
