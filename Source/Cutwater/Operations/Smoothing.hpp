#pragma once

#include <concepts>
#include <cstdint>

namespace cutwater {

/// How the edge is rounded where two solids meet smoothly.
enum class SmoothKind : std::uint8_t {
  Quadratic,    ///< continuous normals
  Cubic,        ///< continuous curvature
  Circular,     ///< an arc of a circle, for surfaces at a right angle; continuous normals
  Exponential,  ///< log-sum-exp: smooth everywhere, and independent of the operands' order; costs
                ///< an exp per operand, and reaches everywhere
};

/// Parameters of a smooth union, intersection or difference.
template <std::floating_point T>
struct Smoothing {
  /// Operands whose values differ by this much or more do not affect each other; for Exponential, k
  /// in -k log(sum exp(-f / k)), whose effect fades but has no such end.
  T reach{};
  SmoothKind kind = SmoothKind::Quadratic;
};

}  // namespace cutwater
