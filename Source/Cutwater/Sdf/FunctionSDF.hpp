#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <concepts>
#include <memory>
#include <utility>

namespace cutwater {

/// A callable that returns a number for a point.
template <typename F, typename T>
concept PointFunction = std::is_invocable_r_v < T,
        const F&, const Vec3<T>
& > ;

/// A user-defined function as a solid, {function < 0}, with a guarantee about its values.
///
///     const FunctionSDF bumpy([](const Vec3<double>& p) { return ...; },
///                             Guarantee<double>{.lipschitz = 1.5, .continuous = true});
///
/// Everything else follows from values and guarantee: closest points, crossings, bounds and classes
/// of boxes. The guarantee is not checked. Boxes can be classified only with a Lipschitz constant;
/// choose `ulps` and `size` such that error() bounds the function's rounding. The function is
/// called from several threads at once and must not throw.
///
/// @throws Error if the Lipschitz constant or the rounding is negative or not a number.
template <std::floating_point T, PointFunction<T> Function>
class FunctionSDF final : public SignedDistanceFunction<T> {
 public:
  /// `boundingBox`: encloses the points where the function is not positive, if such a box is known.
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
  T localSignedDistance(const Vec3<T>& p) const override { return function_(p); }
  void localSignedDistances(std::span<const Vec3<T>> points,
                            std::span<T> distances) const override {
    for (std::size_t i = 0; i < points.size(); ++i) distances[i] = function_(points[i]);
  }
  Guarantee<T> localGuarantee() const override { return guarantee_; }
  Box<T> localBoundingBox() const override { return boundingBox_; }

  Function function_;
  Guarantee<T> guarantee_;
  Box<T> boundingBox_;
};

/// What is known about a user-defined function that modifies a solid.
template <std::floating_point T>
struct FunctionLimits {
  /// |h(p) - h(q)| <= lipschitz |p - q|.
  T lipschitz{};
  /// |h(p)| <= amplitude everywhere. Without it the bounding box of the modified solid is infinite.
  T amplitude = Box<T>::kInf;
  /// The function's rounding: at most ulps eps (|p| + |h(p)|).
  T ulps = 8;
};

namespace detail {

/// Any callable that takes a point and returns a vector. Copies share it.
template <std::floating_point T>
class PointShift {
 public:
  template <typename Function>
  explicit PointShift(Function function)
      : function_(std::make_shared<const Function>(std::move(function))),
        call_([](const void* f, const Vec3<T>& p) -> Vec3<T> {
          return (*static_cast<const Function*>(f))(p);
        }) {}

  [[nodiscard]] Vec3<T> operator()(const Vec3<T>& p) const { return call_(function_.get(), p); }

 private:
  std::shared_ptr<const void> function_;
  Vec3<T> (*call_)(const void* function, const Vec3<T>& p);
};

/// @throws Error, as from the operator `name`, unless the Lipschitz constant is finite and no limit
/// is negative.
template <std::floating_point T>
void requireLimits(const char* name, const FunctionLimits<T>& limits);

/// Guarantee, as a solid, of a function within these limits that has this value at the origin.
template <std::floating_point T>
[[nodiscard]] Guarantee<T> guaranteeOf(const FunctionLimits<T>& limits, T atOrigin);

}  // namespace detail

}  // namespace cutwater
