#include <Cutwater/Core/Detail/Batches.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>
#include <array>
#include <optional>

// Crossings of segments with the surface of a function that has no better way to find them.

namespace cutwater::detail {

namespace {

/// Segments that are searched side by side: enough for the widest vectors, and for the stack.
constexpr std::size_t kTogether = 32;

/// A search along one segment, which stops wherever it needs a value.
template <std::floating_point T>
class CrossingSearch {
 public:
  /// `from`, `to`: the values at the ends.
  CrossingSearch(const Field<T>& field, const Segment<T>& segment, T from, T to)
      : field_(&field),
        segment_(segment),
        reach_(length(segment.end - segment.start)),
        isWithinDomain_(contains(segment.start) && contains(segment.end)),
        error_(field.guarantee.error(std::max(length(segment.start), length(segment.end)))) {
    pending_[size_++] = {0, 1, from, to, 0};
  }

  /// Goes on until the value at point() is needed; false at the end, and as soon as `visit`, which
  /// is called with each crossing, returns false.
  bool advance(CrossingVisitor<T> visit) {
    for (;;) {
      if (isBisecting_) {
        if (isMiddleWithin(now_)) return true;
        isBisecting_ = false;
        if (!report(visit)) return false;
      } else if (size_ == 0) {
        closeRun(false);
        return false;
      } else {
        now_ = pending_[--size_];
        if (isToHalve()) return true;
      }
    }
  }

  [[nodiscard]] Vec3<T> point() const { return segment_.at(middle(now_)); }
  [[nodiscard]] const CrossingCount& count() const { return count_; }

  /// Takes the value at point().
  void take(T value) {
    const T at = middle(now_);
    if (isBisecting_) {
      ((value < 0) == (now_.from < 0) ? now_.begin : now_.end) = at;
      return;
    }
    // Depth first, with the left half on top: at most one pending half per level.
    pending_[size_++] = {at, now_.end, value, now_.to, now_.depth + 1};
    pending_[size_++] = {now_.begin, at, now_.from, value, now_.depth + 1};
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

  static T middle(const Stretch& s) { return T(0.5) * (s.begin + s.end); }
  static bool isMiddleWithin(const Stretch& s) { return middle(s) > s.begin && middle(s) < s.end; }
  T valueAt(T parameter) const { return field_->value(segment_.at(parameter)); }
  bool contains(const Vec3<T>& p) const { return field_->guarantee.domain.contains(p); }

  /// Whether the stretch at hand must be halved. If not, it is dealt with, but for the bisection of
  /// its crossing.
  bool isToHalve() {
    const bool crosses = (now_.from < 0) != (now_.to < 0);
    if (!crosses && isFree(now_)) {
      // A run goes on where rounding alone decides whether a stretch is free.
      if (std::max(std::abs(now_.from), std::abs(now_.to)) > 4 * error_) closeRun(false);
      return false;
    }
    if (isWorthHalving(now_)) return true;
    const bool isSharp = isWithinRounding(now_);
    if (crosses && isSharp) {
      closeRun(true);
      afterCrossing_ = true;
    } else {
      inRun_ = true;
      runIsCoarse_ = runIsCoarse_ || !isSharp;
    }
    isBisecting_ = crosses;
    return false;
  }

  /// Whether there is a Lipschitz constant for the stretch: only in the guarantee's domain, a box.
  bool hasConstant(const Stretch& s) const {
    return field_->guarantee.lipschitz &&
           (isWithinDomain_ || (contains(segment_.at(s.begin)) && contains(segment_.at(s.end))));
  }
  /// The most by which the value can change along the stretch.
  T change(const Stretch& s) const {
    return *field_->guarantee.lipschitz * (s.end - s.begin) * reach_;
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
    return isMiddleWithin(s) && spent_++ < kBudget;
  }

  /// Ends a run of stretches that could neither be proven free nor halved. A run within rounding of
  /// a crossing counts as part of it.
  void closeRun(bool atCrossing) {
    const bool touchesCrossing = atCrossing || afterCrossing_;
    if (inRun_ && (runIsCoarse_ || !touchesCrossing)) ++count_.unresolved;
    inRun_ = runIsCoarse_ = afterCrossing_ = false;
  }

  bool report(CrossingVisitor<T> visit) {
    Crossing<T> crossing;
    crossing.parameter = now_.end;
    crossing.point = segment_.at(now_.end);
    crossing.normal = normalized(field_->gradient(crossing.point));
    crossing.entering = now_.to < 0;
    crossing.owner = field_->owner(crossing.point);
    ++count_.found;
    return visit(crossing);
  }

  const Field<T>* field_;
  Segment<T> segment_;
  T reach_;
  bool isWithinDomain_;
  T error_;
  CrossingCount count_;
  std::array<Stretch, kDeepest + 2> pending_;
  std::size_t size_ = 0;
  Stretch now_;
  bool isBisecting_ = false;
  int spent_ = 0;
  bool inRun_ = false;
  bool runIsCoarse_ = false;
  bool afterCrossing_ = false;
};

}  // namespace

template <std::floating_point T>
CrossingCount isolatedCrossings(const Field<T>& field, const Segment<T>& segment,
                                CrossingVisitor<T> visit) {
  CrossingSearch<T> search(field, segment, field.value(segment.at(0)), field.value(segment.at(1)));
  while (search.advance(visit)) search.take(field.value(search.point()));
  return search.count();
}

template <std::floating_point T>
void isolatedCrossings(const Field<T>& field,
                       FunctionRef<void(std::span<const Vec3<T>>, std::span<T>)> values,
                       std::span<const Segment<T>> segments, std::span<CrossingCount> counts,
                       CrossingsVisitor<T> visit) {
  forBatches(segments.size(), kTogether, [&](std::size_t first, std::size_t count) {
    Scratch<Vec3<T>, 2 * kTogether> points;
    Scratch<T, 2 * kTogether> found;
    std::array<std::optional<CrossingSearch<T>>, kTogether> searches;
    for (std::size_t i = 0; i < count; ++i) {
      points[2 * i] = segments[first + i].at(0);
      points[2 * i + 1] = segments[first + i].at(1);
    }
    values(points.first(2 * count), found.first(2 * count));
    for (std::size_t i = 0; i < count; ++i) {
      searches[i].emplace(field, segments[first + i], found[2 * i], found[2 * i + 1]);
    }
    // The searches that go on, and the points at which they need values.
    Scratch<std::size_t, kTogether> open;
    std::size_t opened = count;
    for (std::size_t i = 0; i < count; ++i) open[i] = i;
    while (opened > 0) {
      std::size_t kept = 0;
      for (std::size_t n = 0; n < opened; ++n) {
        const std::size_t i = open[n];
        auto& search = *searches[i];
        const bool goesOn = search.advance([&](const Crossing<T>& crossing) {
          visit(first + i, crossing);
          return true;
        });
        if (!goesOn) continue;
        points[kept] = search.point();
        open[kept++] = i;
      }
      opened = kept;
      if (opened > 0) values(points.first(opened), found.first(opened));
      for (std::size_t n = 0; n < opened; ++n) searches[open[n]]->take(found[n]);
    }
    for (std::size_t i = 0; i < count; ++i) counts[first + i] = searches[i]->count();
  });
}

template CrossingCount isolatedCrossings(const Field<float>&, const Segment<float>&,
                                         CrossingVisitor<float>);
template CrossingCount isolatedCrossings(const Field<double>&, const Segment<double>&,
                                         CrossingVisitor<double>);
template void isolatedCrossings(const Field<float>&,
                                FunctionRef<void(std::span<const Vec3<float>>, std::span<float>)>,
                                std::span<const Segment<float>>, std::span<CrossingCount>,
                                CrossingsVisitor<float>);
template void isolatedCrossings(const Field<double>&,
                                FunctionRef<void(std::span<const Vec3<double>>, std::span<double>)>,
                                std::span<const Segment<double>>, std::span<CrossingCount>,
                                CrossingsVisitor<double>);

}  // namespace cutwater::detail
