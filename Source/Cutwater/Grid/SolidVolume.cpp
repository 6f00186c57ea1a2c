#include <Cutwater/Grid/Detail/VolumeSearch.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// Exceeds the rounding error of the box's volume, a quotient and a difference.
constexpr double kRoundUp = 1 + 4 * detail::kVolumeError;

}  // namespace

Interval<double> VolumeBounds::solidFraction() const {
  return {std::max(0.0, volume.lower / boxVolume / kRoundUp),
          std::min(1.0, volume.upper / boxVolume * kRoundUp)};
}

Interval<double> VolumeBounds::porosity() const {
  const auto [lower, upper] = solidFraction();
  constexpr double kError = 0x1p-52;
  return {std::max(0.0, 1 - upper - kError), std::min(1.0, 1 - lower + kError)};
}

template <std::floating_point T>
VolumeBounds solidVolume(const SignedDistanceFunction<T>& solid, const Box<T>& box,
                         const VolumeOptions& options) {
  detail::requireVolume(box);
  return detail::VolumeSearch<T>(solid, box, options).run([](const Interval<double>&) {
    return false;
  });
}

template VolumeBounds solidVolume(const SignedDistanceFunction<float>&, const Box<float>&,
                                  const VolumeOptions&);
template VolumeBounds solidVolume(const SignedDistanceFunction<double>&, const Box<double>&,
                                  const VolumeOptions&);

}  // namespace cutwater
