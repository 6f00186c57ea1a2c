#include <Cutwater/Core/Detail/DomainUnder.hpp>

#include <algorithm>

namespace cutwater::detail {

template <std::floating_point T>
Box<T> domainUnder(const AffineMap<T>& map, const AffineMap<T>& inverse, const Box<T>& domain) {
  if (domain == Box<T>::everywhere()) return domain;
  const Vec3<T> half = T(0.5) * domain.upper - T(0.5) * domain.lower;
  if (domain.empty() || !isFinite(half)) return {};
  const auto reach = [](const AffineMap<T>& m, const Vec3<T>& v) {
    return v.x * abs(m.columns[0]) + v.y * abs(m.columns[1]) + v.z * abs(m.columns[2]);
  };
  const Vec3<T> around = reach(map, half);
  const Vec3<T> back = reach(inverse, around);
  T shrink = 1;
  for (int i = 0; i < 3; ++i) shrink = std::min(shrink, half[i] / back[i]);
  if (!(shrink >= 0)) return {};
  const Vec3<T> center = map(domain.center());
  return {center - shrink * around, center + shrink * around};
}

template Box<float> domainUnder(const AffineMap<float>&, const AffineMap<float>&,
                                const Box<float>&);
template Box<double> domainUnder(const AffineMap<double>&, const AffineMap<double>&,
                                 const Box<double>&);

}  // namespace cutwater::detail
