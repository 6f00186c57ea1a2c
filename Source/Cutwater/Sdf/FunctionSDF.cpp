#include <Cutwater/Sdf/FunctionSDF.hpp>

namespace cutwater::detail {

template <std::floating_point T>
void requireLimits(const char* name, const FunctionLimits<T>& limits) {
  const bool isRight = limits.lipschitz >= 0 && std::isfinite(limits.lipschitz) &&
                       limits.amplitude >= 0 && limits.ulps >= 0;
  if (isRight) return;
  const std::string message =
      std::string(name) + ": need a finite Lipschitz constant, and no limit that is negative";
  require(false, message.c_str(), Named{"lipschitz", limits.lipschitz},
          Named{"amplitude", limits.amplitude}, Named{"ulps", limits.ulps});
}

template <std::floating_point T>
Guarantee<T> guaranteeOf(const FunctionLimits<T>& limits, T atOrigin) {
  // |h(p)| is at most |h(0)| + lipschitz |p|.
  return {.lipschitz = limits.lipschitz,
          .continuous = true,
          .ulps = limits.ulps * (1 + limits.lipschitz),
          .size = std::abs(atOrigin)};
}

template void requireLimits(const char*, const FunctionLimits<float>&);
template void requireLimits(const char*, const FunctionLimits<double>&);
template Guarantee<float> guaranteeOf(const FunctionLimits<float>&, float);
template Guarantee<double> guaranteeOf(const FunctionLimits<double>&, double);

}  // namespace cutwater::detail
