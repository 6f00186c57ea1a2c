#include <Cutwater/Core/Detail/Batches.hpp>
#include <Cutwater/Core/Detail/Epsilon.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Operations/Detail/Offset.hpp>
#include <Cutwater/Operations/Detail/SmoothCombination.hpp>
#include <Cutwater/Operations/Detail/SmoothMinimum.hpp>

#include <algorithm>
#include <array>
#include <optional>

namespace cutwater {

namespace {

using detail::kEps;

/// A value and its operand; ordered by both.
template <std::floating_point T>
struct Ranked {
  T value;
  std::size_t operand;

  friend bool operator<(const Ranked& a, const Ranked& b) {
    return a.value < b.value || (a.value == b.value && a.operand < b.operand);
  }
};

/// The first few, in order, of those offered one by one: a queue of fixed size, because queries
/// must not allocate.
template <std::floating_point T>
class FewLeast {
 public:
  void offer(const Ranked<T>& next) {
    if (isFull() && !(next < few_[kMost - 1])) return;
    auto* const place = std::upper_bound(few_.data(), few_.data() + size_, next);
    auto* const last = few_.data() + std::min(size_, kMost - 1);
    std::copy_backward(place, last, last + 1);
    *place = next;
    size_ = std::min(size_ + 1, kMost);
  }
  [[nodiscard]] bool isFull() const { return size_ == kMost; }
  [[nodiscard]] std::span<const Ranked<T>> all() const {
    return std::span<const Ranked<T>>(few_).first(size_);
  }

 private:
  static constexpr std::size_t kMost = 16;
  std::array<Ranked<T>, kMost> few_;
  std::size_t size_ = 0;
};

template <std::floating_point T>
constexpr T kInf = std::numeric_limits<T>::infinity();
constexpr auto kIgnore = [](std::size_t, auto) {};

/// What is known about this many operands is kept on the stack.
constexpr std::size_t kFew = 8;

}  // namespace

template <std::floating_point T>
SmoothCombination<T>::SmoothCombination(Result result, std::vector<Solid<T>> operands,
                                        const Smoothing<T>& smoothing)
    : Composite<T>(std::move(operands)), result_(result), smoothing_(smoothing) {
  require(count() > 0, "smooth combination: need an operand");
  require(smoothing.reach > 0 && std::isfinite(smoothing.reach),
          "smooth combination: need 0 < reach < infinity", Named{"reach", smoothing.reach});
  deriveGuarantee();
  deriveBoxes();
  std::vector<detail::OperandBound<T>> bounds;
  for (const auto& each : this->operands()) {
    bounds.push_back(detail::boundOf(each, result == Result::Intersection));
  }
  tree_ = detail::OperandTree<T>(bounds, nullptr);
}

template <std::floating_point T>
void SmoothCombination<T>::deriveGuarantee() {
  guarantee_ = this->operand(0).guarantee();
  for (const auto& each : this->operands())
    guarantee_ = detail::common(guarantee_, each.guarantee());
  guarantee_.outside = guarantee_.inside = detail::qualityBy(guarantee_.lipschitz);
  const T k = smoothing_.reach;
  guarantee_.size += k;
  guarantee_.ulps +=
      2 + detail::SmoothMinimum<T>::ulps(smoothing_, count()) * (k / guarantee_.size);
}

template <std::floating_point T>
void SmoothCombination<T>::deriveBoxes() {
  clearanceBox_ = detail::clearanceBoxOf<T>(this->operands(), result_ == Result::Union);
  if (result_ == Result::Intersection) {  // no larger than the plain one
    boundingBox_ = this->operand(0).boundingBox();
    for (const auto& each : this->operands()) {
      boundingBox_ = boundingBox_.intersection(each.boundingBox());
    }
  } else {
    const T most = detail::SmoothMinimum<T>::mostAdded(smoothing_, count());
    for (const auto& each : this->operands()) {
      boundingBox_.extend(Offset<T>(each, most).boundingBox());
    }
    clearanceBox_ = guarantee_.grown(clearanceBox_.grown(most));
  }
  if (boundingBox_.empty()) boundingBox_ = {};
}

template <std::floating_point T>
template <typename Ask>
void SmoothCombination<T>::forEachAt(const Vec3<T>& p, T limit, Ask&& ask) const {
  if (isExponential() || !tree_.helpsAt(p)) {
    for (std::size_t i = 0; i < count(); ++i) ask(i);
    return;
  }
  for (const auto i : tree_.always()) limit = ask(i);
  tree_.forLeastAt(p, limit, ask);
}

template <std::floating_point T>
template <typename Ask>
void SmoothCombination<T>::forEachIn(const OrientedBox<T>& box, T limit, Ask&& ask) const {
  if (isExponential() || !tree_.helpsAt(box.center, box.radius())) {
    for (std::size_t i = 0; i < count(); ++i) ask(i);
    return;
  }
  for (const auto i : tree_.always()) limit = ask(i);
  tree_.forBoundsIn(box, limit, [&](std::size_t i) { return static_cast<double>(ask(i)); });
}

template <std::floating_point T>
template <typename Each, typename Visit>
T SmoothCombination<T>::folded(Each&& each, Visit&& visit) const {
  std::optional<detail::SmoothMinimum<T>> sum;
  const auto add = [&](const Ranked<T>& next) {
    T weight = 1;
    if (sum) {
      weight = sum->add(next.value);
    } else {
      sum.emplace(smoothing_, next.value);
    }
    if (weight > 0) visit(next.operand, weight);
    return weight > 0;
  };
  if (isExponential()) {
    each(kInf<T>, [&](std::size_t operand, T value) {
      if (!std::isnan(value)) add({value, operand});
      return kInf<T>;
    });
    return sum ? sum->value() : std::numeric_limits<T>::quiet_NaN();
  }

  // Takes the first few in one pass; if all of them count, the next few in another, and so on.
  std::optional<Ranked<T>> last;
  for (T limit = kInf<T>; true; limit = sum->value() + smoothing_.reach) {
    FewLeast<T> few;
    each(limit, [&](std::size_t operand, T value) {
      const Ranked<T> next{value, operand};
      if (!std::isnan(value) && (!last || *last < next)) few.offer(next);
      return few.all().empty() ? limit : std::min(limit, few.all()[0].value + smoothing_.reach);
    });
    bool allCount = true;
    for (const auto& next : few.all()) allCount = allCount && add(next);
    if (!few.isFull() || !allCount) break;
    last = few.all().back();
  }
  return sum ? sum->value() : std::numeric_limits<T>::quiet_NaN();
}

template <std::floating_point T>
template <typename Visit>
T SmoothCombination<T>::foldedAt(const Vec3<T>& p, Visit&& visit) const {
  return side() * folded(
                      [&](T limit, auto&& ask) {
                        forEachAt(p, limit, [&](std::size_t i) {
                          return ask(i, side() * this->operand(i).signedDistance(p));
                        });
                      },
                      visit);
}

template <std::floating_point T>
T SmoothCombination<T>::localSignedDistance(const Vec3<T>& p) const {
  return foldedAt(p, kIgnore);
}

template <std::floating_point T>
void SmoothCombination<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                                std::span<T> distances) const {
  constexpr std::size_t kMost = 64;  // points at a time: operands may keep rows on the stack, too
  if (count() > kFew) {
    return SignedDistanceFunction<T>::localSignedDistances(points, distances);
  }
  std::array<Scratch<T, kMost>, kFew> rows;
  detail::forBatches(points.size(), kMost, [&](std::size_t first, std::size_t some) {
    for (std::size_t i = 0; i < count(); ++i) {
      this->operand(i).signedDistances(points.subspan(first, some), rows[i].first(some),
                                       {.threads = 1});
    }
    for (std::size_t k = 0; k < some; ++k) {
      const auto each = [&](T, auto&& ask) {
        for (std::size_t i = 0; i < count(); ++i) ask(i, side() * rows[i][k]);
      };
      distances[first + k] = side() * folded(each, kIgnore);
    }
  });
}

template <std::floating_point T>
Vec3<T> SmoothCombination<T>::localGradient(const Vec3<T>& p) const {
  Vec3<T> gradient;
  static_cast<void>(foldedAt(p, [&](std::size_t i, T weight) {
    gradient = (1 - weight) * gradient + weight * this->operand(i).gradient(p);
  }));
  return gradient;
}

template <std::floating_point T>
SurfaceOwner SmoothCombination<T>::localOwner(const Vec3<T>& p) const {
  Ranked<T> least{kInf<T>, 0};
  forEachAt(p, kInf<T>, [&](std::size_t i) {
    least = std::min(least, Ranked<T>{side() * this->operand(i).signedDistance(p), i});
    return least.value;
  });
  return this->counted(this->operand(least.operand).owner(p), least.operand);
}

template <std::floating_point T>
Interval<T> SmoothCombination<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  // Each of a few operands is asked once for both ends: in a chain of n smooth combinations, twice
  // would be 2^n times.
  std::array<std::optional<Interval<T>>, kFew> known;
  const auto rangeOf = [&](std::size_t i) {
    if (i >= kFew) return this->boundsOf(this->operand(i), box);
    if (!known[i]) known[i] = this->boundsOf(this->operand(i), box);
    return *known[i];
  };
  // The smooth minimum grows with each of its arguments.
  const auto end = [&](bool isLower) {
    const auto each = [&](T limit, auto&& ask) {
      forEachIn(box, limit, [&](std::size_t i) {
        const auto range = rangeOf(i);
        return ask(i, isLower == (side() > 0) ? side() * range.lower : side() * range.upper);
      });
    };
    const T value = folded(each, kIgnore);
    if (!std::isfinite(value)) return value;
    const T rounding = 2 * kEps<T> *
                       (3 * std::abs(value) +
                        detail::SmoothMinimum<T>::ulps(smoothing_, count()) * smoothing_.reach);
    return isLower ? value - rounding : value + rounding;
  };
  const Interval<T> range{end(true), end(false)};
  if (std::isnan(range.lower) || std::isnan(range.upper)) return Interval<T>::everything();
  return side() > 0 ? range : -range;
}

template class SmoothCombination<float>;
template class SmoothCombination<double>;

}  // namespace cutwater
