#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Sdf/FluidSide.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <queue>
#include <vector>

namespace cutwater::test {

/// What n^3 samples of a cell, at the middles of its parts, say of the fluid in it.
class SampledCell {
 public:
  SampledCell(const Solid<double>& solid, FluidSide side, const Box<double>& box, std::size_t n)
      : n_(n) {
    for (std::size_t i = 0; i < n * n * n; ++i) {
      const std::array place{i % n, i / n % n, i / (n * n)};
      auto p = box.lower;
      for (int axis = 0; axis < 3; ++axis) {
        const double middle = 0.5 + static_cast<double>(place[static_cast<std::size_t>(axis)]);
        p[axis] += middle / static_cast<double>(n) * box.size()[axis];
      }
      const double value = solid.signedDistance(p);
      isFluid_.push_back((side == FluidSide::Outside ? value : -value) >= 0 ? 1 : 0);
    }
  }

  /// The share of the samples that are in the fluid.
  [[nodiscard]] double share() const {
    return static_cast<double>(std::ranges::count(isFluid_, 1)) /
           static_cast<double>(isFluid_.size());
  }
  /// How many connected parts they form, each sample being connected with its six neighbours.
  [[nodiscard]] int parts() const {
    auto isFluid = isFluid_;
    int result = 0;
    for (std::size_t start = 0; start < isFluid.size(); ++start) {
      if (isFluid[start] == 0) continue;
      ++result;
      flood(isFluid, start);
    }
    return result;
  }

 private:
  void flood(std::vector<char>& isFluid, std::size_t start) const {
    std::queue<std::size_t> open;
    const auto take = [&](std::size_t i) {
      if (isFluid[i] == 0) return;
      isFluid[i] = 0;
      open.push(i);
    };
    take(start);
    while (!open.empty()) {
      const auto at = open.front();
      open.pop();
      for (const auto stride : {std::size_t{1}, n_, n_ * n_}) {
        const auto place = at / stride % n_;
        if (place + 1 < n_) take(at + stride);
        if (place > 0) take(at - stride);
      }
    }
  }

  std::size_t n_;
  std::vector<char> isFluid_;
};

}  // namespace cutwater::test
