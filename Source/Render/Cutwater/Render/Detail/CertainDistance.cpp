#include <Cutwater/Render/Detail/CertainDistance.hpp>

#include <algorithm>

namespace cutwater::detail {

template <std::floating_point T>
CertainDistance<T>::CertainDistance(const Guarantee<T>& guarantee, const Box<double>& box,
                                    bool sheets)
    : guarantee_(guarantee),
      sheets_(sheets),
      exact_(sheets || guarantee.outside == Quality::Exact) {
  const auto& domain = guarantee.domain;
  if (sheets) {
    factor_ = 1;
  } else if (domain.contains(Vec3<T>(box.lower)) && domain.contains(Vec3<T>(box.upper))) {
    if (guarantee.outside != Quality::SignOnly) factor_ = 1;
    if (guarantee.lipschitz && *guarantee.lipschitz > 0) {
      factor_ = std::max(factor_, 1 / static_cast<double>(*guarantee.lipschitz));
    }
  }
}

template class CertainDistance<float>;
template class CertainDistance<double>;

}  // namespace cutwater::detail
