#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <variant>

namespace cutwater {

/// A named array of a VTK file: a number or a vector for each cell or node.
struct VtkArray {
  std::string name;
  std::variant<std::span<const float>, std::span<const double>, std::span<const std::int32_t>,
               std::span<const std::uint32_t>, std::span<const std::uint64_t>,
               std::span<const std::uint8_t>, std::span<const Vec3<float>>,
               std::span<const Vec3<double>>>
      values;
};

}  // namespace cutwater
