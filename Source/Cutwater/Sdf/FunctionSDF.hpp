#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <concepts>
#include <utility>

namespace cutwater {

/// What can be asked for a number at a point.
template <typename F, typename T>
concept PointFunction = std::is_invocable_r_v < T,
        const F&, const Vec3<T>
& > ;

/// A function of the user's own as a solid: {function < 0}, with what its values promise.
///
///     const FunctionSDF bumpy([](const Vec3<double>& p) { return ...; },
///                             Guarantee<double>{.lipschitz = 1.5, .continuous = true});
///
/// Everything else follows from values and guarantee: closest points, crossings, bounds and classes
/// of boxes. The promise is taken as given. With a Lipschitz constant boxes can be classified at
/// all; state `ulps` and `size` such that error() bounds the function's rounding. The function is
/// called from several threads at once and must not throw.
///
/// @throws Error if the Lipschitz constant or the rounding is negative or not a number.
template <std::floating_point T, PointFunction<T> Function>
class FunctionSDF final : public SignedDistanceFunction<T> {
 public:
  /// `boundingBox`: encloses where the function is not positive, if that is known.
  FunctionSDF(Function function, const Guarantee<T>& guarantee,
              const Box<T>& boundingBox = Box<T>::everywhere())
      : function_(std::move(function)), guarantee_(guarantee), boundingBox_(boundingBox) {
    require(!guarantee.lipschitz || *guarantee.lipschitz >= 0,
            "FunctionSDF: need a Lipschitz constant that is not negative",
            Named{"lipschitz", guarantee.lipschitz ? *guarantee.lipschitz : T(0)});
    require(guarantee.ulps >= 0 && guarantee.size >= 0,
            "FunctionSDF: need a rounding that is not negative", Named{"ulps", guarantee.ulps},
            Named{"size", guarantee.size});
  }

 private:
  [[nodiscard]] T localSignedDistance(const Vec3<T>& p) const override { return function_(p); }
  void localSignedDistances(std::span<const Vec3<T>> points,
                            std::span<T> distances) const override {
    for (std::size_t i = 0; i < points.size(); ++i) distances[i] = function_(points[i]);
  }
  [[nodiscard]] Guarantee<T> localGuarantee() const override { return guarantee_; }
  [[nodiscard]] Box<T> localBoundingBox() const override { return boundingBox_; }

  Function function_;
  Guarantee<T> guarantee_;
  Box<T> boundingBox_;
};

/// What is known of a function of the user's own that changes a solid.
template <std::floating_point T>
struct FunctionLimits {
  /// |h(p) - h(q)| <= lipschitz |p - q|.
  T lipschitz{};
  /// |h(p)| <= amplitude everywhere. Without it the changed solid's bounding box is infinite.
  T amplitude = Box<T>::kInf;
  /// The function's rounding: at most ulps eps (|p| + |h(p)|).
  T ulps = 8;
};

}  // namespace cutwater
