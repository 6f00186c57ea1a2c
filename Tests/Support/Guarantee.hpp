#pragma once

#include <Cutwater/Sdf/Solid.hpp>

#include <cstdint>
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

/// How much a check has looked at.
struct GuaranteeCounts {
  std::int64_t pairs = 0;      ///< of points, whose values were compared by the Lipschitz constant
  std::int64_t distances = 0;  ///< points whose values were compared with the surface's samples
  std::int64_t boxes = 0;

  GuaranteeCounts& operator+=(const GuaranteeCounts& more) {
    pairs += more.pairs;
    distances += more.distances;
    boxes += more.boxes;
    return *this;
  }
};

template <std::floating_point T>
GuaranteeCounts checkGuarantee(const Solid<T>& solid, double extent,
                               const GuaranteeOptions& options);

/// Checks, at random points of [-extent, extent]^3, all that a signed distance function promises:
/// sign, Lipschitz constant, exactness or bound against surface points that are found by the sign
/// alone, bounds and classes of boxes, gradient, closest points, crossings, batches, points and
/// boxes that are not finite, and motions.
template <SolidLike S>
GuaranteeCounts expectGuarantee(const S& shape, double extent,
                                const GuaranteeOptions& options = {}) {
  return checkGuarantee<typename S::Scalar>(shape, extent, options);
}

/// Checks that values in float keep to their rounding bound against the same function in double, at
/// points up to 10^6 sizes away.
void expectRounding(const Solid<float>& single, const Solid<double>& twice, double extent);

extern template GuaranteeCounts checkGuarantee(const Solid<float>&, double,
                                               const GuaranteeOptions&);
extern template GuaranteeCounts checkGuarantee(const Solid<double>&, double,
                                               const GuaranteeOptions&);

}  // namespace cutwater::test
