#pragma once

#include <Cutwater/Core/OrientedBox.hpp>

#include <array>
#include <cstdint>
#include <type_traits>

namespace cutwater {

/// Where a closed box lies. The surface is the boundary of {value < 0}.
enum class BoxClass : std::uint8_t {
  Inside,   ///< certainly no surface in the box, which is all solid
  Outside,  ///< certainly no surface in the box, which is all free space
  Cut,      ///< certainly some surface in the box
  Unknown,  ///< nothing proven: refine, or treat as Cut
};

/// Whether the surface certainly or possibly meets a box of this class.
[[nodiscard]] constexpr bool mayBeCut(BoxClass kind) {
  return kind == BoxClass::Cut || kind == BoxClass::Unknown;
}

/// What a box query has learned about a box, for reuse in queries about boxes within it. Start with
/// a default-constructed one. It holds indices only, so it can be copied as bytes and is valid on
/// every process that has the same geometry. Answers are the same with and without it.
struct BoxHint {
  std::array<std::uint32_t, 16> words{};
};
static_assert(std::is_trivially_copyable_v<BoxHint> && sizeof(BoxHint) <= 64);

}  // namespace cutwater
