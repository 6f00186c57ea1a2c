#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>

#include <algorithm>

namespace cutwater::detail {

template <std::floating_point T>
Guarantee<T> common(const Guarantee<T>& a, const Guarantee<T>& b) {
  Guarantee<T> both;
  both.outside = std::min(a.outside, b.outside);
  both.inside = std::min(a.inside, b.inside);
  if (a.lipschitz && b.lipschitz) both.lipschitz = std::max(*a.lipschitz, *b.lipschitz);
  both.continuous = a.continuous && b.continuous;
  both.domain = a.domain.intersection(b.domain);
  both.ulps = std::max(a.ulps, b.ulps);
  both.size = std::max(a.size, b.size);
  return both;
}

template <std::floating_point T>
Guarantee<T> swapped(Guarantee<T> g) {
  std::swap(g.inside, g.outside);
  return g;
}

template <std::floating_point T>
Box<T> clearanceBoxOf(std::span<const Solid<T>> operands, bool least) {
  Box<T> result = operands[0].clearanceBox();
  for (const auto& operand : operands.subspan(1)) {
    const auto box = operand.clearanceBox();
    if (least) {
      result.extend(box);
    } else if (box.diagonal() < result.diagonal()) {
      result = box;
    }
  }
  return result;
}

template Guarantee<float> common(const Guarantee<float>&, const Guarantee<float>&);
template Guarantee<double> common(const Guarantee<double>&, const Guarantee<double>&);
template Guarantee<float> swapped(Guarantee<float>);
template Guarantee<double> swapped(Guarantee<double>);
template Box<float> clearanceBoxOf(std::span<const Solid<float>>, bool);
template Box<double> clearanceBoxOf(std::span<const Solid<double>>, bool);

}  // namespace cutwater::detail
