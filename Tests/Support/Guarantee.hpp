#pragma once

#include <Cutwater/Sdf/Solid.hpp>

#include <functional>

namespace cutwater::test {

struct GuaranteeOptions {
  /// Whether a point is inside, known independently of the function; not asked within rounding of
  /// the surface.
  std::function<bool(const Vec3<double>&)> inside = {};
  /// Points at which a check runs, for the cheap checks; others run on a fraction. The environment
  /// variable CUTWATER_TEST_SCALE multiplies it.
  int probes = 10000;
  /// Lines per axis and direction that the surface is sampled by.
  int lines = 32;
  /// No surface point is farther from a sample than this many spacings of the lines. More for
  /// sharp tips and thin parts, which lines miss.
  double covering = 2.5;
  /// The nearest surface point is found by a search by sign alone, and the value must agree.
  bool polish = true;
  /// The surface passes through [-extent, extent]^3. False for solids that may be empty.
  bool hasSurface = true;
  unsigned seed = 1;
};

template <std::floating_point T>
void checkGuarantee(const Solid<T>& solid, double extent, const GuaranteeOptions& options);

/// Checks, at random points of [-extent, extent]^3, all that a signed distance function promises:
/// sign, Lipschitz constant, exactness or bound against surface points that are found by the sign
/// alone, bounds and classes of boxes, gradient, closest points, crossings, batches, points and
/// boxes that are not finite, and motions.
template <SolidLike S>
void expectGuarantee(const S& shape, double extent, const GuaranteeOptions& options = {}) {
  checkGuarantee<typename S::Scalar>(shape, extent, options);
}

/// Checks that values in float keep to their rounding bound against the same function in double, at
/// points up to 10^6 sizes away.
void expectRounding(const Solid<float>& single, const Solid<double>& twice, double extent);

extern template void checkGuarantee(const Solid<float>&, double, const GuaranteeOptions&);
extern template void checkGuarantee(const Solid<double>&, double, const GuaranteeOptions&);

}  // namespace cutwater::test
