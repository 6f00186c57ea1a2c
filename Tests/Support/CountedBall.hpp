#pragma once

#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater::test {

/// The unit ball; counts how often its value is asked for.
template <std::floating_point T>
Solid<T> countedBall(std::size_t& calls) {
  return FunctionSDF(
      [&calls](const Vec3<T>& p) {
        ++calls;
        return length(p) - T(1);
      },
      Guarantee<T>::exact(1));
}

}  // namespace cutwater::test
