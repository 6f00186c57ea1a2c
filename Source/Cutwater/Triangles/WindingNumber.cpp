#include <Cutwater/Triangles/SolidAngle.hpp>
#include <Cutwater/Triangles/WindingNumber.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cutwater {

namespace {

using detail::kInverse4Pi;

/// The first threshold of isBelow(): at most points the number is near 0 or 1, and this is enough.
constexpr double kFirstThreshold = 0.02;
/// Moments in single precision are almost never this accurate: nearly all nodes are opened.
constexpr double kNegligible = 0x1p-60;
/// So few triangles are looked at one by one.
constexpr std::size_t kFew = 16;
/// Powers of two by which it falls, to kNegligible at last. Few points need more than the first
/// two, and where the sum must be nearly exact, those between only cost time.
constexpr std::array kSteps{0, -3, -9, -27, -54};

/// The sum over nodes that are far away.
///
/// A point x = c + u of a triangle adds n . g(x) dA, where g = -grad 1/r, r = |x - q|. About c, at
/// distance D, the term of degree k of its Taylor series is at most (k + 1) |u|^k / D^(k + 2). This
/// is because k! times the term is a (k + 1)-linear symmetric form, whose norm is its largest value
/// on equal arguments (Banach); along a unit vector v at the angle t from x - q the (k + 1)-th
/// derivative of 1/r is +-(k + 1)! P_(k+1)(cos t) / r^(k + 2), and no Legendre polynomial exceeds
/// 1. The terms for k = 0 and 1 are used. With |u| <= R < D the others add up to at most
///
///     sum over k >= 2 of (k + 1) |u|^k / D^(k+2)  <=  |u|^2 (3 - 2 R / D) / (D^2 (D - R)^2),
///
/// and the integral of |u|^2 turns this into a bound for the node.
class FarField {
 public:
  using Lanes = WindingMoments::Lanes;

  FarField(const Vec3<double>& q, double threshold)
      : q_(q),
        rest_(q - Vec3<double>(q_)),
        threshold_(static_cast<float>(4 * std::numbers::pi * std::min(threshold, 1e6))) {}

  /// Adds the lanes of a node, except those whose error may exceed the threshold: these get the key
  /// 0, the others kMostKey.
  void add(const WindingMoments& node, Lanes& keys) {
    Lanes value;
    Lanes error;
    evaluate(node, value, error);
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const bool enough = error[k] <= threshold_;
      keys[k] = enough ? kMostKey : 0.0F;
      value_ += enough ? double{value[k]} : 0;
      error_ += enough ? double{error[k]} : 0;
    }
  }

  [[nodiscard]] double value() const { return kInverse4Pi * value_; }
  [[nodiscard]] double error() const { return kInverse4Pi * (1 + 0x1p-20) * error_; }

 private:
  /// Computes values times 4 pi. A plain loop over 16 lanes, inlined where its results are known to
  /// overlap nothing, so that compilers vectorise it.
  ///
  /// With u = 2^-24, moments in single precision and the results computed from them here are within
  /// 60 u of area / D^2 (D > 2^-30: nothing is accepted below). The rounding of q to the tree's
  /// frame moves the field by at most 2^-53 |q| times 16 area / D^3, as D - R > D / 2; that is less
  /// than 32 u area / D^2.
  CUTWATER_INLINE void evaluate(const WindingMoments& node, Lanes& value, Lanes& error) const {
    for (std::size_t k = 0; k < value.size(); ++k) {
      const float x = (node.center[0][k] - q_.x) - rest_.x;
      const float y = (node.center[1][k] - q_.y) - rest_.y;
      const float z = (node.center[2][k] - q_.z) - rest_.z;
      const float distance = std::sqrt(x * x + y * y + z * z);
      const float gap = distance - node.radius[k];
      const float quotient = 1 / (distance * gap);
      const float inverse = gap * quotient;
      const float square = inverse * inverse;
      const float rest = node.second[k] * (1 + 2 * gap * inverse) * quotient * quotient;
      const float sum = rest + 0x1p-17F * node.area[k] * square + 0x1p-80F;
      error[k] = gap > 0.5F * distance ? sum : kMostKey;  // more than any threshold
      // The derivative of g is I / D^3 - 3 d d^T / D^5; the first moment has no trace.
      const float quadratic = node.first[0][k] * (x * x - z * z) +
                              node.first[1][k] * (y * y - z * z) + node.first[2][k] * x * y +
                              node.first[3][k] * y * z + node.first[4][k] * z * x;
      const float linear = node.normal[0][k] * x + node.normal[1][k] * y + node.normal[2][k] * z;
      value[k] = square * inverse * (linear - 3 * square * quadratic);
    }
  }

  Vec3<float> q_;  // in the tree's frame
  Vec3<float> rest_;
  float threshold_;
  double value_ = 0;
  double error_ = 0;
};

}  // namespace

/// Opens nodes whose error may exceed the threshold. Opening the same share of error costs about
/// the same anywhere, so one threshold for all nodes is nearly optimal.
template <std::floating_point T>
auto WindingNumber<T>::sum(const Vec3<double>& p, double threshold) const -> Estimate {
  FarField far(tree_.frame().toFrame(p), threshold);
  SolidAngleSum near(p);
  const auto keys = [&](const BvhNode<16>& node, BvhNode<16>::Lanes& out) {
    far.add(moments_[indexOf(node)], out);
  };
  const auto leaf = [&](std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      near.add(triangle(id));
    }
    return 0.0F;
  };
  tree_.traverse(keys, leaf, 0.0F);
  return {far.value() + near.turns(), far.error() + near.error()};
}

/// Bound on the winding number, from the total area, for points so far away that single precision
/// might overflow; the largest double for nearer points. All triangles are within 2 of the frame's
/// origin.
template <std::floating_point T>
double WindingNumber<T>::farBound(const Vec3<double>& p) const {
  if (moments_.empty()) return 0;
  const double distance = tree_.frame().scale * length(p - tree_.frame().center) - 2;
  if (!(distance > 0x1p20)) return kLargest;
  double area = 0;
  for (const float lane : moments_.front().area) area += double{lane};
  return kInverse4Pi * area / distance / distance;
}

template <std::floating_point T>
WindingMoments::Lanes WindingNumber<T>::gapsToParts(const Vec3<double>& p) const {
  const WindingMoments& root = moments_.front();
  const Vec3<float> q(tree_.frame().toFrame(p));
  constexpr float kRounding = 0x1p-12F;  // far above that of the point and of its distances
  WindingMoments::Lanes gaps;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const float x = root.center[0][k] - q.x;
    const float y = root.center[1][k] - q.y;
    const float z = root.center[2][k] - q.z;
    const float distance = std::sqrt(x * x + y * y + z * z);
    gaps[k] = (1 - kRounding) * distance - root.radius[k] - kRounding;
  }
  return gaps;
}

template <std::floating_point T>
double WindingNumber<T>::distanceBound(const Vec3<double>& p) const {
  double least = kLargest;
  if (triangles_.size() > kFew) {
    const auto gaps = gapsToParts(p);
    constexpr double kRounding = 0x1p-40;
    return (1 - kRounding) * double{*std::ranges::min_element(gaps)} / tree_.frame().scale;
  }
  for (std::uint32_t id = 0; id < triangles_.size(); ++id) {
    const auto [a, b, c] = triangle(id);
    const auto gap = max(min(a, min(b, c)) - p, p - max(a, max(b, c)));
    least = std::min(least, maxComponent(gap));
  }
  return least;
}

template <std::floating_point T>
double WindingNumber<T>::bound(const Box<double>& box) const {
  if (moments_.empty()) return 0;
  constexpr float kOutward = 1 + 0x1p-12F;
  const auto radius = static_cast<float>(0.5 * tree_.frame().scale * box.diagonal());
  const auto gaps = gapsToParts(box.center());
  const auto& areas = moments_.front().area;
  float sum = 0;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const float gap = gaps[k] - kOutward * radius;
    const float most = gap > 0 ? areas[k] / (gap * gap) : kMostKey;
    sum += areas[k] > 0 ? std::min(most, kMostKey) : 0;
  }
  return sum < kMostKey ? detail::kInverse4Pi * kOutward * double{sum} : kLargest;
}

template <std::floating_point T>
auto WindingNumber<T>::estimate(const Vec3<double>& p, double tolerance) const -> Estimate {
  if (!isFinite(p)) return {p.x - p.x + (p.y - p.y) + (p.z - p.z), 0};
  if (const double far = farBound(p); far <= std::max(tolerance, kNegligible)) return {0, far};
  double threshold = tolerance / 16;
  while (true) {
    const Estimate result = sum(p, threshold);
    if (result.error <= tolerance || threshold < kNegligible) return result;
    threshold /= 16;
  }
}

template <std::floating_point T>
template <typename Decide>
std::optional<bool> WindingNumber<T>::decided(const Vec3<double>& p, double tolerance,
                                              const Decide& decide) const {
  std::optional<bool> decision = decide({0, farBound(p)});
  for (const int step : kSteps) {
    if (decision) break;
    const Estimate number = sum(p, std::ldexp(kFirstThreshold, step));
    decision = decide(number);
    if (number.error <= tolerance) break;
  }
  return decision;
}

template <std::floating_point T>
std::optional<bool> WindingNumber<T>::isBelow(const Vec3<double>& p, double level) const {
  if (!isFinite(p) || moments_.empty()) return 0 < level;
  if (triangles_.size() > kFew) {
    const auto certain = decided(p, 0, [&](const Estimate& number) -> std::optional<bool> {
      if (std::abs(number.value - level) > number.error) return number.value < level;
      return std::nullopt;
    });
    if (certain) return certain;
  }
  // On an edge, or so near the level that rounding decides: sums in the order of ids.
  const auto [value, error] = sumOfAll(p);
  if (error > 0.25) return std::nullopt;
  return value < level;
}

template <std::floating_point T>
std::optional<bool> WindingNumber<T>::isFarFrom(const Vec3<double>& p, double level,
                                                double distance, double tolerance) const {
  if (!isFinite(p)) return std::nullopt;
  return decided(p, tolerance, [&](const Estimate& number) -> std::optional<bool> {
    const double apart = std::abs(number.value - level);
    if (apart > distance + number.error) return true;
    if (apart + number.error <= distance) return false;
    return std::nullopt;
  });
}

template <std::floating_point T>
auto WindingNumber<T>::sumOfAll(const Vec3<double>& p) const -> Estimate {
  SolidAngleSum sum(p);
  for (std::uint32_t id = 0; id < triangles_.size(); ++id) sum.add(triangle(id));
  return {sum.turns(), sum.error()};
}

template class WindingNumber<float>;
template class WindingNumber<double>;

}  // namespace cutwater
