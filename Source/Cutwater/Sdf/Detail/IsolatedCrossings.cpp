#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>
#include <array>

// Crossings of a segment with the surface of a function that has no better way to find them.

namespace cutwater::detail {

namespace {

template <std::floating_point T>
class CrossingSearch {
 public:
  CrossingSearch(const Field<T>& field, const Segment<T>& segment, CrossingVisitor<T> visit)
      : field_(field),
        segment_(segment),
        visit_(visit),
        reach_(length(segment.end - segment.start)),
        isWithinDomain_(contains(segment.start) && contains(segment.end)),
        error_(field.guarantee.error(std::max(length(segment.start), length(segment.end)))) {}

  CrossingCount run() {
    // Depth first, with the left half on top: at most one pending half per level.
    std::array<Stretch, kDeepest + 2> pending;
    std::size_t size = 0;
    pending[size++] = {0, 1, valueAt(0), valueAt(1), 0};
    while (size > 0) {
      const Stretch s = pending[--size];
      const bool crosses = (s.from < 0) != (s.to < 0);
      if (!crosses && isFree(s)) {
        // A run goes on where rounding alone decides whether a stretch is free.
        if (std::max(std::abs(s.from), std::abs(s.to)) > 4 * error_) closeRun(false);
      } else if (isWorthHalving(s)) {
        const T middle = T(0.5) * (s.begin + s.end);
        const T value = valueAt(middle);
        pending[size++] = {middle, s.end, value, s.to, s.depth + 1};
        pending[size++] = {s.begin, middle, s.from, value, s.depth + 1};
      } else {
        const bool isSharp = isWithinRounding(s);
        if (crosses && isSharp) {
          closeRun(true);
          afterCrossing_ = true;
        } else {
          inRun_ = true;
          runIsCoarse_ = runIsCoarse_ || !isSharp;
        }
        if (crosses && !report(s)) return count_;
      }
    }
    closeRun(false);
    return count_;
  }

 private:
  static constexpr int kShallow = 4;
  static constexpr int kDepth = 12;
  static constexpr int kDeepest = 60;
  static constexpr int kBudget = 16384;  // of values beyond kDepth
  static constexpr T kClose = 1024;      // times the rounding: shorter stretches are halved anyway

  struct Stretch {
    T begin{}, end{}, from{}, to{};
    int depth = 0;
  };

  T valueAt(T parameter) const { return field_.value(segment_.at(parameter)); }
  bool contains(const Vec3<T>& p) const { return field_.guarantee.domain.contains(p); }

  /// Whether there is a Lipschitz constant for the stretch: only in the guarantee's domain, a box.
  bool hasConstant(const Stretch& s) const {
    return field_.guarantee.lipschitz &&
           (isWithinDomain_ || (contains(segment_.at(s.begin)) && contains(segment_.at(s.end))));
  }
  /// The most by which the value can change along the stretch.
  T change(const Stretch& s) const {
    return *field_.guarantee.lipschitz * (s.end - s.begin) * reach_;
  }
  bool isFree(const Stretch& s) const {
    return hasConstant(s) && std::abs(s.from) + std::abs(s.to) > change(s) + 2 * error_;
  }
  bool isWithinRounding(const Stretch& s) const { return hasConstant(s) && change(s) <= error_; }
  /// Whether the stretch lies in the surface, as far as samples tell: then halving proves nothing.
  bool isAlongSurface(const Stretch& s) const {
    const auto isZero = [this](T value) { return std::abs(value) <= error_; };
    if (!isZero(s.from) || !isZero(s.to)) return false;
    if (!hasConstant(s) || change(s) <= kClose * error_) return false;
    const auto isZeroAt = [&](T share) {
      return isZero(valueAt(s.begin + share * (s.end - s.begin)));
    };
    // Not where a periodic function is likely to be zero.
    return isZeroAt(T(0.29)) && isZeroAt(T(0.66));
  }
  bool isWorthHalving(const Stretch& s) {
    if (s.depth >= kShallow && isAlongSurface(s)) return false;
    if (s.depth < kDepth) return true;
    if (!hasConstant(s) || s.depth == kDeepest || isWithinRounding(s)) return false;
    const T middle = T(0.5) * (s.begin + s.end);
    return middle > s.begin && middle < s.end && spent_++ < kBudget;
  }

  /// Ends a run of stretches that could neither be proven free nor halved. A run within rounding of
  /// a crossing counts as part of it.
  void closeRun(bool atCrossing) {
    const bool touchesCrossing = atCrossing || afterCrossing_;
    if (inRun_ && (runIsCoarse_ || !touchesCrossing)) ++count_.unresolved;
    inRun_ = runIsCoarse_ = afterCrossing_ = false;
  }

  bool report(Stretch s) {
    while (true) {
      const T middle = T(0.5) * (s.begin + s.end);
      if (middle <= s.begin || middle >= s.end) break;
      const T value = valueAt(middle);
      ((value < 0) == (s.from < 0) ? s.begin : s.end) = middle;
    }
    Crossing<T> crossing;
    crossing.parameter = s.end;
    crossing.point = segment_.at(s.end);
    crossing.normal = normalized(field_.gradient(crossing.point));
    crossing.entering = s.to < 0;
    crossing.owner = field_.owner(crossing.point);
    ++count_.found;
    return visit_(crossing);
  }

  const Field<T>& field_;
  Segment<T> segment_;
  CrossingVisitor<T> visit_;
  T reach_;
  bool isWithinDomain_;
  T error_;
  CrossingCount count_;
  int spent_ = 0;
  bool inRun_ = false;
  bool runIsCoarse_ = false;
  bool afterCrossing_ = false;
};

}  // namespace

template <std::floating_point T>
CrossingCount isolatedCrossings(const Field<T>& field, const Segment<T>& segment,
                                CrossingVisitor<T> visit) {
  return CrossingSearch<T>(field, segment, visit).run();
}

template CrossingCount isolatedCrossings(const Field<float>&, const Segment<float>&,
                                         CrossingVisitor<float>);
template CrossingCount isolatedCrossings(const Field<double>&, const Segment<double>&,
                                         CrossingVisitor<double>);

}  // namespace cutwater::detail
