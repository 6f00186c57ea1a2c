#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <vector>

namespace cutwater::detail {

/// Known properties of one function among several whose least value is sought.
template <std::floating_point T>
struct OperandBound {
  Guarantee<T> guarantee;
  Box<T> box;  ///< outside it, a value is at least the distance to it: see clearanceBox()
};

/// The bound of the operand's own function, or of its negative.
template <std::floating_point T>
[[nodiscard]] OperandBound<T> boundOf(const Solid<T>& operand, bool isNegated);

/// Finds the functions that may have the least value at a point, or may matter to it in a box, by a
/// tree over their boxes.
///
/// The tree holds functions whose values are at least the distance to a box, as exact distances and
/// the lower bounds of most operators are. All others, e.g. affine images, planes and anything
/// infinite, are always evaluated; so are all functions if there are few.
///
/// Skipped functions could not have changed the result by a single bit. For boxes, this holds if
/// bounds() and classify() of the functions are no worse than the defaults of
/// SignedDistanceFunction.
template <std::floating_point T>
class OperandTree {
 public:
  OperandTree() = default;
  /// `beginning`: the tree of the first of these operands, or null. It is reused, and operands
  /// added since are always evaluated, until there are enough of them to be worth a new tree: a
  /// chain of a | b | c ... does not build a tree at every step.
  OperandTree(std::span<const OperandBound<T>> operands, const OperandTree* beginning);

  /// Operands to be evaluated wherever the point is, in order.
  [[nodiscard]] std::span<const std::uint32_t> always() const { return always_; }

  [[nodiscard]] bool asksFirst() const { return !always_.empty() && always_.front() == 0; }
  [[nodiscard]] std::span<const std::uint32_t> alwaysButFirst() const {
    return always().subspan(asksFirst() ? 1 : 0);
  }

  /// Whether the tree can be used for points within `radius` of p: it is not empty, and squares of
  /// distances do not overflow.
  [[nodiscard]] bool helpsAt(const Vec3<T>& p, T radius = 0) const {
    return !ids_.empty() && maxComponent(abs(p)) + radius < kFarthest;
  }

  /// Calls ask(operand) for every operand in the tree whose value at p may be as low as the least,
  /// nearest boxes first. `least` is the least value of the other operands; ask() returns the least
  /// so far.
  template <typename Ask>
  void forLeastAt(const Vec3<T>& p, T least, Ask&& ask) const {
    // Twice what the guarantees allow for.
    const double error = 2 * rounding(p, T(0), ulps_);
    visit(p, least, error,
          [&](std::uint32_t operand) { return static_cast<double>(ask(operand)); });
  }

  /// Calls ask(operand) for every operand in the tree whose lower bound in the box may be as low as
  /// a limit; for all others the bound is certainly above it. The limit is `limit` at first, then
  /// what ask() returned last (kStopTraversal: no more operands are wanted).
  ///
  /// By default, that bound is value - radius at the centre, less the rounding of the value, of
  /// what the interval encloses, and of the box as it passes through nested frames, each of which
  /// adds to the ulps of the guarantee. In sum, this is less than 8 times what the guarantee allows
  /// for.
  template <typename Ask>
  void forBoundsIn(const OrientedBox<T>& box, double limit, Ask&& ask) const {
    const T radius = box.radius();
    const double error = 16 * rounding(box.center, radius, ulps_ > 8 ? ulps_ : T(8));
    const double reach{radius};
    visit(box.center, limit + reach, error, [&](std::uint32_t operand) {
      const double next = ask(operand);
      return next == kStopTraversal ? kStopTraversal : next + reach;
    });
  }

 private:
  /// Squares of sums of a few numbers of this size are finite.
  static constexpr T kFarthest = sizeof(T) == sizeof(float) ? T(0x1p60) : T(0x1p500);

  [[nodiscard]] static bool isBounded(const OperandBound<T>& operand);
  [[nodiscard]] bool isWorthKeepingFor(std::span<const OperandBound<T>> operands) const;
  void build(std::span<const OperandBound<T>> operands);

  [[nodiscard]] double rounding(const Vec3<T>& p, T radius, T ulps) const {
    // The second term is where squares begin to underflow.
    const double size = length(Vec3<double>(p)) + double{radius} + double{size_};
    return double{ulps} * double{std::numeric_limits<T>::epsilon()} * size +
           4 * std::sqrt(double{std::numeric_limits<T>::min()});
  }

  template <typename Ask>
  void visit(const Vec3<T>& p, double best, double error, Ask&& ask) const {
    arrays_.tree().nearest(Vec3<double>(p), best, error, [&](std::span<const std::uint32_t> slots) {
      double limit = best;
      for (const auto slot : slots) {
        if (slot == kNone) break;
        limit = ask(ids_[slot]);
        if (limit == kStopTraversal) break;
      }
      return limit;
    });
  }

  std::vector<std::uint32_t> always_;
  std::vector<std::uint32_t> ids_;  // operands by their place in the tree
  BvhArrays<16, 4> arrays_;
  std::size_t late_ = 0;  // bounded operands in always_: those added since the tree was built
  T ulps_ = 0;            // the largest in the tree
  T size_ = 0;
};

extern template class OperandTree<float>;
extern template class OperandTree<double>;

}  // namespace cutwater::detail
