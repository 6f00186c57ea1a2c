#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/MortonCode.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cutwater {

template <std::floating_point T>
OctreeDomain<T>::OctreeDomain(const Vec3<T>& origin, T spacing, const Index3& roots)
    : origin_(origin), spacing_(spacing), roots_(roots) {
  require(isFinite(origin), "OctreeDomain: need a finite origin", Named{"origin", origin});
  require(spacing > 0 && std::isfinite(spacing), "OctreeDomain: need a positive, finite spacing",
          Named{"spacing", spacing});
  for (const auto count : {roots.i, roots.j, roots.k}) {
    require(0 < count && count < 1 << detail::kMortonBits,
            "OctreeDomain: need at least one root and fewer than 2^21 along each axis",
            Named{"roots", count});
  }
}

template <std::floating_point T>
Level<T> OctreeDomain<T>::level(int level) const {
  const T spacing = std::ldexp(spacing_, -level);
  return {origin_, {spacing, spacing, spacing}};
}

template <std::floating_point T>
IndexBox OctreeDomain<T>::indices(int level) const {
  return IndexBox::ofSize(roots_.i << level, roots_.j << level, roots_.k << level);
}

template <std::floating_point T>
int OctreeDomain<T>::deepest() const {
  const auto most = static_cast<unsigned>(std::max({roots_.i, roots_.j, roots_.k}));
  return detail::kMortonBits - static_cast<int>(std::bit_width(most - 1));
}

template <std::floating_point T>
Box<T> OctreeDomain<T>::box() const {
  const auto first = level(0).cell({0, 0, 0});
  const auto last = level(0).cell({roots_.i - 1, roots_.j - 1, roots_.k - 1});
  return {first.lower, last.upper};
}

template class OctreeDomain<float>;
template class OctreeDomain<double>;

}  // namespace cutwater
