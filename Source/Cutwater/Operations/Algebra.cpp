#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Detail/Affine.hpp>
#include <Cutwater/Operations/Detail/Blend.hpp>
#include <Cutwater/Operations/Detail/Combination.hpp>
#include <Cutwater/Operations/Detail/Complement.hpp>
#include <Cutwater/Operations/Detail/Displacement.hpp>
#include <Cutwater/Operations/Detail/Elongation.hpp>
#include <Cutwater/Operations/Detail/Fold.hpp>
#include <Cutwater/Operations/Detail/Inversion.hpp>
#include <Cutwater/Operations/Detail/Labelled.hpp>
#include <Cutwater/Operations/Detail/Mirror.hpp>
#include <Cutwater/Operations/Detail/Offset.hpp>
#include <Cutwater/Operations/Detail/Repetition.hpp>
#include <Cutwater/Operations/Detail/Scale.hpp>
#include <Cutwater/Operations/Detail/Shell.hpp>
#include <Cutwater/Operations/Detail/SmoothCombination.hpp>
#include <Cutwater/Operations/Detail/SymmetricDifference.hpp>
#include <Cutwater/Operations/Detail/Warp.hpp>

namespace cutwater::detail {

namespace {

template <std::floating_point T>
using Decides = typename Combination<T>::Decides;

/// Operands that are combinations of the same kind are replaced by their own operands: a long chain
/// of `|` is one wide union, not a deep one. A moved combination stays as it is, so that moving
/// changes no digit.
template <std::floating_point T>
Solid<T> combined(Decides<T> decides, const std::vector<Solid<T>>& operands) {
  const auto asSameKind = [decides](const Solid<T>& operand) {
    const auto* const same =
        operand.placement().isIdentity() ? operand.template as<Combination<T>>() : nullptr;
    return same != nullptr && same->decides() == decides ? same : nullptr;
  };
  std::vector<Solid<T>> flat;
  for (const auto& operand : operands) {
    if (const auto* const same = asSameKind(operand)) {
      flat.insert(flat.end(), same->operands().begin(), same->operands().end());
    } else {
      flat.push_back(operand);
    }
  }
  return Combination<T>(decides, std::move(flat),
                        operands.empty() ? nullptr : asSameKind(operands.front()));
}

}  // namespace

template <std::floating_point T>
Solid<T> unite(const std::vector<Solid<T>>& operands) {
  return combined(Decides<T>::Least, operands);
}

template <std::floating_point T>
Solid<T> intersect(const std::vector<Solid<T>>& operands) {
  return combined(Decides<T>::Greatest, operands);
}

template <std::floating_point T>
Solid<T> complementOf(Solid<T> a) {
  return Complement<T>(std::move(a));
}

template <std::floating_point T>
Solid<T> xorOf(Solid<T> a, Solid<T> b) {
  return SymmetricDifference<T>(std::move(a), std::move(b));
}

namespace {

template <std::floating_point T>
bool isPlain(const std::vector<Solid<T>>& operands, const Smoothing<T>& smoothing) {
  return operands.size() < 2 || smoothing.reach == 0;
}

}  // namespace

template <std::floating_point T>
Solid<T> uniteSmoothly(const std::vector<Solid<T>>& operands, const Smoothing<T>& smoothing) {
  if (isPlain(operands, smoothing)) return unite(operands);
  return SmoothCombination<T>(SmoothCombination<T>::Result::Union, operands, smoothing);
}

template <std::floating_point T>
Solid<T> intersectSmoothly(const std::vector<Solid<T>>& operands, const Smoothing<T>& smoothing) {
  if (isPlain(operands, smoothing)) return intersect(operands);
  return SmoothCombination<T>(SmoothCombination<T>::Result::Intersection, operands, smoothing);
}

/// Subtracting a constant commutes with least and greatest values, to the bit; under a complement
/// it changes sign. Done operand by operand, it keeps the bounding box finite where only the
/// operands' values are exact, e.g. outside a difference.
template <std::floating_point T>
Solid<T> offsetOf(const Solid<T>& a, T distance) {
  std::optional<Solid<T>> result;
  if (const auto* all = a.template as<Combination<T>>()) {
    auto operands = all->operands();
    for (auto& operand : operands) operand = offsetOf(operand, distance);
    result = combined(all->decides(), operands);
  } else if (const auto* rest = a.template as<Complement<T>>()) {
    result = complementOf(offsetOf(rest->operand(), -distance));
  } else {
    return Offset<T>(a, distance);
  }
  result->setPlacement(a.placement());
  return *result;
}

template <std::floating_point T>
Solid<T> scaledBy(Solid<T> a, T factor) {
  return Scale<T>(std::move(a), factor);
}

template <std::floating_point T>
Solid<T> mirrorOf(Solid<T> a, const Vec3<T>& point, const Vec3<T>& normal) {
  const Mirror<T> image(a, point, normal);
  const auto* const before = a.placement().isIdentity() ? a.template as<Mirror<T>>() : nullptr;
  if (before != nullptr && before->plane() == image.plane()) return before->operand();
  return image;
}

template <std::floating_point T>
Solid<T> affineImageOf(Solid<T> a, const AffineMap<T>& map) {
  return Affine<T>(std::move(a), map);
}

template <std::floating_point T>
Solid<T> shellOf(Solid<T> a, T halfThickness) {
  return Shell<T>(std::move(a), halfThickness);
}

template <std::floating_point T>
Solid<T> elongationOf(Solid<T> a, const Vec3<T>& half) {
  return Elongation<T>(std::move(a), half);
}

template <std::floating_point T>
Solid<T> blendOf(Solid<T> a, Solid<T> b, T t) {
  return Blend<T>(std::move(a), std::move(b), t);
}

template <std::floating_point T>
Solid<T> foldOf(Solid<T> a, const Vec3<T>& point, const Vec3<T>& normal) {
  return Fold<T>(std::move(a), point, normal);
}

/// A complement is inverted as the complement of its operand's image, which may be bounded.
template <std::floating_point T>
Solid<T> inversionOf(const Solid<T>& a) {
  const auto* const rest = a.template as<Complement<T>>();
  if (rest == nullptr) return Inversion<T>(a);
  auto leftOut = rest->operand();
  leftOut.setPlacement(RigidTransform<T>::composed(leftOut.placement(), a.placement()));
  return complementOf(inversionOf(leftOut));
}

template <std::floating_point T>
Solid<T> repetitionOf(Solid<T> a, const Repeats<T>& repeats) {
  return Repetition<T>(std::move(a), repeats);
}

template <std::floating_point T>
Solid<T> displacementOf(Solid<T> a, Solid<T> h, const FunctionLimits<T>& limits) {
  return Displacement<T>(std::move(a), std::move(h), limits.amplitude);
}

template <std::floating_point T>
Solid<T> warpOf(Solid<T> a, PointShift<T> v, const FunctionLimits<T>& limits) {
  return Warp<T>(std::move(a), std::move(v), limits);
}

template <std::floating_point T>
Solid<T> labelled(Solid<T> a, std::string name) {
  return Labelled<T>(std::move(a), std::move(name));
}

template Solid<float> unite(const std::vector<Solid<float>>&);
template Solid<double> unite(const std::vector<Solid<double>>&);
template Solid<float> intersect(const std::vector<Solid<float>>&);
template Solid<double> intersect(const std::vector<Solid<double>>&);
template Solid<float> complementOf(Solid<float>);
template Solid<double> complementOf(Solid<double>);
template Solid<float> xorOf(Solid<float>, Solid<float>);
template Solid<double> xorOf(Solid<double>, Solid<double>);
template Solid<float> uniteSmoothly(const std::vector<Solid<float>>&, const Smoothing<float>&);
template Solid<float> intersectSmoothly(const std::vector<Solid<float>>&, const Smoothing<float>&);
template Solid<double> uniteSmoothly(const std::vector<Solid<double>>&, const Smoothing<double>&);
template Solid<double> intersectSmoothly(const std::vector<Solid<double>>&,
                                         const Smoothing<double>&);
template Solid<float> offsetOf(const Solid<float>&, float);
template Solid<double> offsetOf(const Solid<double>&, double);
template Solid<float> scaledBy(Solid<float>, float);
template Solid<double> scaledBy(Solid<double>, double);
template Solid<float> mirrorOf(Solid<float>, const Vec3<float>&, const Vec3<float>&);
template Solid<float> affineImageOf(Solid<float>, const AffineMap<float>&);
template Solid<double> mirrorOf(Solid<double>, const Vec3<double>&, const Vec3<double>&);
template Solid<double> affineImageOf(Solid<double>, const AffineMap<double>&);
template Solid<float> shellOf(Solid<float>, float);
template Solid<float> elongationOf(Solid<float>, const Vec3<float>&);
template Solid<float> blendOf(Solid<float>, Solid<float>, float);
template Solid<float> foldOf(Solid<float>, const Vec3<float>&, const Vec3<float>&);
template Solid<double> shellOf(Solid<double>, double);
template Solid<double> elongationOf(Solid<double>, const Vec3<double>&);
template Solid<double> blendOf(Solid<double>, Solid<double>, double);
template Solid<double> foldOf(Solid<double>, const Vec3<double>&, const Vec3<double>&);
template Solid<float> inversionOf(const Solid<float>&);
template Solid<double> inversionOf(const Solid<double>&);
template Solid<float> repetitionOf(Solid<float>, const Repeats<float>&);
template Solid<double> repetitionOf(Solid<double>, const Repeats<double>&);
template Solid<float> displacementOf(Solid<float>, Solid<float>, const FunctionLimits<float>&);
template Solid<double> displacementOf(Solid<double>, Solid<double>, const FunctionLimits<double>&);
template Solid<float> warpOf(Solid<float>, PointShift<float>, const FunctionLimits<float>&);
template Solid<double> warpOf(Solid<double>, PointShift<double>, const FunctionLimits<double>&);
template Solid<float> labelled(Solid<float>, std::string);
template Solid<double> labelled(Solid<double>, std::string);

}  // namespace cutwater::detail
