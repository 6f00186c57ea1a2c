#pragma once

#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <algorithm>

namespace cutwater {

/// Base of shapes with one operand, whose patches are theirs, too.
template <std::floating_point T>
class UnaryOperation : public SignedDistanceFunction<T> {
 protected:
  explicit UnaryOperation(Solid<T> operand) : operand_(std::move(operand)) {}

  [[nodiscard]] const Solid<T>& operand() const { return operand_; }

  /// factor g(q), if it is within `wanted`: see localSignedDistanceWithin().
  [[nodiscard]] T operandValueWithin(const Vec3<T>& q, T factor, const Interval<T>& wanted) const;
  /// The operand's results at many points of its own frame, from within a parallel region.
  void operandValues(std::span<const Vec3<T>> points, std::span<T> distances) const {
    operand_.signedDistances(points, distances, {.threads = 1});
  }
  void operandPoints(std::span<const Vec3<T>> points, std::span<SurfacePoint<T>> results) const {
    operand_.closestPoints(points, results, {.threads = 1});
  }

  /// Maps the points into the operand's frame by image(p), and calls batch(images, index of the
  /// first) for one piece of them after the other.
  template <typename Image, typename Batch>
  static void forImages(std::span<const Vec3<T>> points, const Image& image, const Batch& batch) {
    constexpr std::size_t kMost = 256;
    Scratch<Vec3<T>, kMost> images;
    for (std::size_t first = 0; first < points.size(); first += kMost) {
      const auto some = images.first(std::min(kMost, points.size() - first));
      for (std::size_t i = 0; i < some.size(); ++i) some[i] = image(points[first + i]);
      batch(std::span<const Vec3<T>>(some), first);
    }
  }

  std::vector<std::string> localPatchNames() const override;
  void forEachOperand(FunctionRef<void(const SignedDistanceFunction<T>&)> visit) const override {
    visit(operand_);
  }

 private:
  Solid<T> operand_;
};

extern template class UnaryOperation<float>;
extern template class UnaryOperation<double>;

}  // namespace cutwater
