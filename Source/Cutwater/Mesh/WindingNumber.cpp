#include <Cutwater/Mesh/SolidAngle.hpp>
#include <Cutwater/Mesh/WindingNumber.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace cutwater {

namespace {

constexpr double kInverse4Pi = 0.25 / std::numbers::pi;

/// Beyond this all triangles together span less than kFarAngle: 2^32 of them, of area 4 at most.
constexpr double kFar = 0x1p60;
constexpr double kFarAngle = 0x1p-80;

/// isBelow() starts with it: most points see nearly 0 or 1, and need no better.
constexpr double kFirstThreshold = 0.01;
/// A node in single precision is never that good unless it is far away: all others are opened.
constexpr double kNegligible = 0x1p-60;

/// The sum over nodes that are seen from afar.
///
/// A point x = c + u of a triangle adds n . g(x) dA, where g = -grad 1/r, r = |x - q|. About c, at
/// distance D, the term of degree k of its Taylor series is at most (k + 1) |u|^k / D^(k + 2): for
/// k! times it is a (k + 1)-linear symmetric form, whose norm is its largest value on equal
/// arguments (Banach); along a unit vector v at the angle t from x - q the (k + 1)-th derivative of
/// 1/r is +-(k + 1)! P_(k+1)(cos t) / r^(k + 2), and no Legendre polynomial exceeds 1. Used are k =
/// 0 and 1. With |u| <= R < D the others add up to at most
///
///     sum over k >= 2 of (k + 1) |u|^k / D^(k+2)  <=  |u|^2 (3 - 2 R / D) / (D^2 (D - R)^2),
///
/// of which the integral of |u|^2 leaves a bound for the node.
class FarField {
 public:
  FarField(const Vec3<double>& q, double threshold)
      : q_(q), shift_(0x1p-44 * length(q)), threshold_(threshold) {}

  /// Adds the node, unless that could be wrong by more than the threshold.
  bool add(const WindingMoments& node) {
    const Vec3<double> d = Vec3<double>(node.center) - q_;
    const double distance = length(d);
    const double gap = distance - double{node.radius};
    if (!(gap > 0.2 * distance)) return false;
    const double quotient = 1 / (distance * gap);
    const double inverse = gap * quotient;
    // Moments in single precision, and M's entries added up, are worth 9 * 2^-24 of area / D^2; the
    // rounding of q moves it by 2^-53 |q|, at most 250 times that over D, as D - R > D / 5.
    const double rounding = double{node.area} * (0x1p-20 + shift_ * inverse) * inverse * inverse;
    const double rest = double{node.second} * (1 + 2 * gap * inverse) * quotient * quotient;
    const double error = kInverse4Pi * (rest + rounding);
    if (!(error <= threshold_)) return false;

    const auto& m = node.first;
    const double cube = inverse * inverse * inverse;
    // The derivative of g is I / D^3 - 3 d d^T / D^5; the first moment has no trace.
    const double quadratic = double{m[0]} * (d.x * d.x - d.z * d.z) +
                             double{m[1]} * (d.y * d.y - d.z * d.z) + double{m[2]} * d.x * d.y +
                             double{m[3]} * d.y * d.z + double{m[4]} * d.z * d.x;
    value_ += cube * (dot(Vec3<double>(node.normal), d) - 3 * inverse * inverse * quadratic);
    error_ += error;
    return true;
  }

  [[nodiscard]] double value() const { return kInverse4Pi * value_; }
  [[nodiscard]] double error() const { return error_; }

 private:
  Vec3<double> q_;  // in the tree's frame
  double shift_;
  double threshold_;
  double value_ = 0;
  double error_ = 0;
};

Vec3<double> gapBetween(const Box<double>& a, const Box<double>& b) {
  return max(max(a.lower - b.upper, b.lower - a.upper), Vec3<double>{});
}

constexpr double kLargest = std::numeric_limits<double>::max();

/// In the tree's frame, grown by more than the rounding.
Box<double> toFrame(const Box<double>& box, const BvhFrame& frame) {
  const Vec3<double> lower = frame.scale * (box.lower - frame.center);
  const Vec3<double> upper = frame.scale * (box.upper - frame.center);
  return Box<double>{lower, upper}.grown(0x1p-50 * maxComponent(max(abs(lower), abs(upper))));
}

}  // namespace

template <std::floating_point T>
std::array<Vec3<double>, 3> WindingNumber<T>::triangle(std::uint32_t id) const {
  const auto& v = triangles_[id];
  return {Vec3<double>(positions_[v[0]]), Vec3<double>(positions_[v[1]]),
          Vec3<double>(positions_[v[2]])};
}

/// Opens nodes that could be wrong by more than the threshold. Opening the same share of error
/// costs about the same anywhere, so one threshold for all nodes is near the best.
template <std::floating_point T>
auto WindingNumber<T>::sum(const Vec3<double>& p, double threshold) const -> Estimate {
  const auto& frame = tree_.frame();
  FarField far(frame.scale * (p - frame.center), threshold);
  SolidAngleSum near(p);
  const auto keys = [&](const BvhNode<16>& node, BvhNode<16>::Lanes& out) {
    out.fill(0);
    for (std::uint32_t rest = node.nodeMask; rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      if (far.add(moments_[node.nodeIndex(lane)])) {
        out[static_cast<std::size_t>(lane)] = WindingTree::kNoLimit;
      }
    }
  };
  const auto leaf = [&](std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      near.add(triangle(id));
    }
    return 0.0F;
  };
  if (!far.add(moments_.front())) tree_.traverse(keys, leaf, 0.0F);
  return {far.value() + near.turns(), far.error() + near.error()};
}

template <std::floating_point T>
auto WindingNumber<T>::estimate(const Vec3<double>& p, double tolerance) const -> Estimate {
  if (!isFinite(p)) return {p.x - p.x + (p.y - p.y) + (p.z - p.z), 0};
  if (moments_.empty()) return {0, 0};
  if (maxComponent(abs(p)) >= kFar) return {0, kFarAngle};
  for (double threshold = tolerance / 16;; threshold /= 16) {
    const Estimate result = sum(p, threshold);
    if (result.error <= tolerance || threshold < kNegligible) return result;
  }
}

template <std::floating_point T>
std::optional<bool> WindingNumber<T>::isBelow(const Vec3<double>& p, double level) const {
  if (!isFinite(p) || moments_.empty() || maxComponent(abs(p)) >= kFar) return 0 < level;
  for (double threshold = kFirstThreshold; threshold > kNegligible; threshold /= 8) {
    const auto [value, error] = sum(p, threshold);
    if (std::abs(value - level) > error) return value < level;
  }
  // On an edge, or so near to the level that rounding decides: in the order of ids.
  SolidAngleSum sum(p);
  for (std::uint32_t id = 0; id < triangles_.size(); ++id) sum.add(triangle(id));
  if (sum.error() > 0.25) return std::nullopt;
  return sum.turns() < level;
}

template <std::floating_point T>
double WindingNumber<T>::exactSum(const Vec3<double>& p) const {
  SolidAngleSum sum(p);
  for (std::uint32_t id = 0; id < triangles_.size(); ++id) sum.add(triangle(id));
  return sum.turns();
}

template <std::floating_point T>
std::span<const OpenEdge> WindingNumber<T>::edgesOf(std::size_t node) const {
  const auto begin = moments_[node].firstEdge;
  const auto end = node + 1 < moments_.size() ? moments_[node + 1].firstEdge : openEdges_.size();
  return openEdges_.subspan(begin, end - begin);
}

/// Bounds the integral of 1 / |x - p|^2 along the edge, for all p in the box. An edge that is long
/// for its distance is taken in pieces.
template <std::floating_point T>
double WindingNumber<T>::inverseSquare(const OpenEdge& edge, const Box<double>& box) const {
  constexpr int kPieces = 16;
  const Vec3<double> start(positions_[edge.lower]);
  const Vec3<double> end(positions_[edge.upper]);
  const double edgeLength = length(end - start);
  if (!(edgeLength > 0)) return 0;
  const auto boundFor = [&](int pieces) {
    double result = 0;
    Vec3<double> from = start;
    for (int i = 1; i <= pieces; ++i) {
      const Vec3<double> to = start + (static_cast<double>(i) / pieces) * (end - start);
      const Box<double> piece = Box<double>{min(from, to), max(from, to)}.grown(
          0x1p-50 * maxComponent(max(abs(start), abs(end))));
      result += edgeLength / pieces / lengthSquared(gapBetween(piece, box));
      from = to;
    }
    return result;
  };
  const double whole = boundFor(1);
  return whole * edgeLength < 1 ? whole : boundFor(kPieces);
}

template <std::floating_point T>
double WindingNumber<T>::gradientBound(const Box<double>& box) const {
  if (openEdges_.empty()) return 0;
  const Box<double> local = toFrame(box, tree_.frame());
  double nearEdges = 0;
  double farEdges = 0;  // in the tree's frame
  const auto keys = [&](const BvhNode<16>& node, BvhNode<16>::Lanes& out) {
    out.fill(WindingTree::kNoLimit);
    for (const auto& edge : edgesOf(static_cast<std::size_t>(&node - tree_.nodes().data()))) {
      nearEdges += std::abs(edge.multiplicity) * inverseSquare(edge, box);
    }
    for (std::uint32_t rest = node.nodeMask; rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      const auto k = static_cast<std::size_t>(lane);
      const double openLength{moments_[node.nodeIndex(lane)].openLength};
      if (!(openLength > 0)) continue;
      const Box<double> child{{node.lower[0][k], node.lower[1][k], node.lower[2][k]},
                              {node.upper[0][k], node.upper[1][k], node.upper[2][k]}};
      const double gapSquared = lengthSquared(gapBetween(child, local));
      // Opened, it would be less by a factor of at most 2.25.
      if (gapSquared > 4 * lengthSquared(child.size())) {
        farEdges += openLength / gapSquared;
      } else {
        out[k] = 0;
      }
    }
  };
  tree_.traverse(
      keys, [](std::span<const std::uint32_t>) { return 0.0F; }, 0.0F);
  const double bound = kInverse4Pi * (1 + 0x1p-30) * (nearEdges + tree_.frame().scale * farEdges);
  return bound < kLargest ? bound : kLargest;
}

template class WindingNumber<float>;
template class WindingNumber<double>;

}  // namespace cutwater
