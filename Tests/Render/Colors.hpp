#pragma once

#include <Cutwater/Render/Image.hpp>

#include <cstdlib>

namespace cutwater::test {

inline constexpr Rgb kWhite{255, 255, 255};
inline constexpr Rgb kBlack{0, 0, 0};

inline int difference(const Rgb& a, const Rgb& b) {
  return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
}

}  // namespace cutwater::test
