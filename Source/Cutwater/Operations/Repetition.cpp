#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Repetition.hpp>
#include <Cutwater/Sdf/Defaults.hpp>

#include <algorithm>

namespace cutwater {

namespace {

template <std::floating_point T>
constexpr T kInf = std::numeric_limits<T>::infinity();

/// a * b, component by component.
template <std::floating_point T>
Vec3<T> times(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

}  // namespace

template <std::floating_point T>
Repetition<T>::Repetition(Solid<T> operand, const Repeats<T>& repeats)
    : UnaryOperation<T>(std::move(operand)),
      repeats_(repeats),
      box_(this->operand().boundingBox()) {
  checkArguments();
  deriveGuarantee();
}

template <std::floating_point T>
void Repetition<T>::checkArguments() const {
  const auto& period = repeats_.period;
  require(isFinite(period) && period.x >= 0 && period.y >= 0 && period.z >= 0 &&
              maxComponent(period) > 0,
          "repeated: need finite periods, none negative and one positive", Named{"period", period});
  double overlapping = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto count = repeats_.count[static_cast<std::size_t>(axis)];
    require(isRepeated(axis) || count <= 1, "repeated: need a period for several copies",
            Named{"axis", axis}, Named{"count", count});
    if (!isRepeated(axis) || count == 1 || box_.empty()) continue;
    const T size = box_.upper[axis] - box_.lower[axis];
    require(std::isfinite(size), "repeated: need a bounding box that is finite along the axis",
            Named{"axis", axis});
    overlapping *=
        1 + std::min(double{size / period[axis]}, count > 0 ? static_cast<double>(count) : 1e300);
  }
  constexpr double kMost = 1e5;
  if (overlapping > kMost) {
    throw Error(ErrorKind::Limit, "repeated: too many copies overlap at one point");
  }
}

template <std::floating_point T>
void Repetition<T>::deriveGuarantee() {
  guarantee_ = this->operand().guarantee();
  isClamped_ = guarantee_.outside != Quality::Exact;
  if (guarantee_.outside == Quality::SignOnly) {
    if (guarantee_.lipschitz) {
      stretch_ = std::max(*guarantee_.lipschitz, T(1));
    } else {
      guarantee_.continuous = false;
    }
  }
  if (isClamped_ && guarantee_.lipschitz) {
    guarantee_.lipschitz = std::max(*guarantee_.lipschitz, T(1));
  }
  if (guarantee_.domain != Box<T>::everywhere()) guarantee_.domain = {};

  // A point seen from the nearest copy is no farther from it than the point is, or a period.
  T size = 0;
  for (int axis = 0; axis < 3 && !box_.empty(); ++axis) {
    const T period = repeats_.period[axis];
    const auto count = repeats_.count[static_cast<std::size_t>(axis)];
    size += period * static_cast<T>(count + 1);
    for (const T side : {box_.lower[axis], box_.upper[axis]}) {
      if (std::isfinite(side)) size += 2 * std::abs(side);
    }
    const T gap = period - (box_.upper[axis] - box_.lower[axis]);
    if (isRepeated(axis) && count != 1 && !(gap > 4 * guarantee_.error(size))) {
      guarantee_.inside = std::min(guarantee_.inside, Quality::LowerBound);
    }
  }
  guarantee_.ulps = guarantee_.ulps * stretch_ + 3 * guarantee_.lipschitz.value_or(T(1)) + 1;
  guarantee_.size += size;
}

template <std::floating_point T>
bool Repetition<T>::isWithin(int axis, T index) const {
  if (!isRepeated(axis)) return index == 0;
  const auto count = repeats_.count[static_cast<std::size_t>(axis)];
  return count == 0 || (index >= 0 && index < static_cast<T>(count));
}

template <std::floating_point T>
Vec3<T> Repetition<T>::seenFrom(const Vec3<T>& copy, const Vec3<T>& p) const {
  return p - times(copy, repeats_.period);
}

template <std::floating_point T>
Vec3<T> Repetition<T>::gaps(const Vec3<T>& local) const {
  return max(max(box_.lower - local, local - box_.upper), Vec3<T>{});
}

template <std::floating_point T>
Vec3<T> Repetition<T>::central(const Vec3<T>& p) const {
  Vec3<T> copy;
  for (int axis = 0; axis < 3; ++axis) {
    const auto count = repeats_.count[static_cast<std::size_t>(axis)];
    if (!isRepeated(axis) || count == 1) continue;
    const T center = box_.empty() ? T(0) : box_.center()[axis];
    const T nearest = std::floor((p[axis] - center) / repeats_.period[axis] + T(0.5));
    copy[axis] = count == 0 ? nearest : std::clamp(nearest, T(0), static_cast<T>(count - 1));
  }
  return copy;
}

template <std::floating_point T>
T Repetition<T>::valueFrom(const Vec3<T>& local, T value) const {
  if (!isClamped_ || box_.empty()) return value;
  const T gap = length(gaps(local));
  return gap > 0 && value < gap ? gap : value;
}

template <std::floating_point T>
template <typename Visit>
void Repetition<T>::outwards(int axis, T start, Visit&& visit) const {
  visit(start);
  for (const T step : {T(1), T(-1)}) {
    for (T index = start + step; isWithin(axis, index); index += step) {
      if (!visit(index) || index + step == index) break;
    }
  }
}

template <std::floating_point T>
auto Repetition<T>::decide(const Vec3<T>& p, const Decision& central) const -> Decision {
  Decision best = central;
  if (box_.empty()) return best;
  const Vec3<T> start = seenFrom(central.copy, p);
  const T farthest = stretch_ * length(max(abs(start - box_.lower), abs(box_.upper - start)));
  // Whether a copy at least so far away may have the least value, but for rounding.
  const auto mayDecide = [&](T gapSquared) {
    const T limit = std::max(std::min(best.value, farthest), T(0));
    return gapSquared <= limit * limit;
  };
  const auto gapSquared = [&](int axis, T index) {
    const T local = p[axis] - index * repeats_.period[axis];
    const T gap = std::max({box_.lower[axis] - local, local - box_.upper[axis], T(0)});
    return gap * gap;
  };
  outwards(0, central.copy.x, [&](T x) {
    const T alongX = gapSquared(0, x);
    if (!mayDecide(alongX)) return false;
    outwards(1, central.copy.y, [&](T y) {
      const T alongXY = alongX + gapSquared(1, y);
      if (!mayDecide(alongXY)) return false;
      outwards(2, central.copy.z, [&](T z) {
        if (!mayDecide(alongXY + gapSquared(2, z))) return false;
        const Vec3<T> copy{x, y, z};
        if (copy == central.copy) return true;
        const auto local = seenFrom(copy, p);
        const T value = valueFrom(local, this->operand().signedDistance(local));
        if (value < best.value) best = {copy, value};
        return true;
      });
      return true;
    });
    return true;
  });
  return best;
}

template <std::floating_point T>
auto Repetition<T>::decide(const Vec3<T>& p) const -> Decision {
  const auto copy = central(p);
  const auto local = seenFrom(copy, p);
  return decide(p, {copy, valueFrom(local, this->operand().signedDistance(local))});
}

template <std::floating_point T>
T Repetition<T>::localSignedDistance(const Vec3<T>& p) const {
  return decide(p).value;
}

template <std::floating_point T>
void Repetition<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                         std::span<T> distances) const {
  const auto local = [this](const Vec3<T>& p) { return seenFrom(central(p), p); };
  this->forImages(points, local, [&](std::span<const Vec3<T>> locals, std::size_t first) {
    const auto here = points.subspan(first, locals.size());
    const auto values = distances.subspan(first, locals.size());
    this->operandValues(locals, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const T value = valueFrom(locals[i], values[i]);
      values[i] = decide(here[i], {central(here[i]), value}).value;
    }
  });
}

template <std::floating_point T>
Vec3<T> Repetition<T>::localGradient(const Vec3<T>& p) const {
  const auto decision = decide(p);
  const auto local = seenFrom(decision.copy, p);
  if (isClamped_ && !box_.empty() && decision.value == length(gaps(local)) && decision.value > 0) {
    return normalized(local - max(box_.lower, min(box_.upper, local)));
  }
  return this->operand().gradient(local);
}

template <std::floating_point T>
SurfacePoint<T> Repetition<T>::localClosestPoint(const Vec3<T>& p) const {
  const auto decision = decide(p);
  auto found = this->operand().closestPoint(seenFrom(decision.copy, p));
  found.point += times(decision.copy, repeats_.period);
  const T residual = localSignedDistance(found.point);
  if (!(std::abs(residual) <= guarantee_.error(length(p) + length(found.point)))) {
    return SignedDistanceFunction<T>::localClosestPoint(p);
  }
  found.distance = decision.value;
  detail::rate(found, p, residual, guarantee_);
  return found;
}

template <std::floating_point T>
SurfaceOwner Repetition<T>::localOwner(const Vec3<T>& p) const {
  return this->operand().owner(seenFrom(decide(p).copy, p));
}

template <std::floating_point T>
Box<T> Repetition<T>::localBoundingBox() const {
  auto result = box_;
  if (result.empty()) return result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto count = repeats_.count[static_cast<std::size_t>(axis)];
    if (!isRepeated(axis) || count == 1) continue;
    if (count == 0) {
      result.lower[axis] = -kInf<T>;
      result.upper[axis] = kInf<T>;
    } else {
      result.upper[axis] += static_cast<T>(count - 1) * repeats_.period[axis];
    }
  }
  return guarantee_.grown(result);
}

template <std::floating_point T>
Box<T> Repetition<T>::localClearanceBox() const {
  // Values less than the distance to a copy's bounding box are not taken.
  return box_.empty() ? Box<T>::everywhere() : localBoundingBox();
}

template class Repetition<float>;
template class Repetition<double>;

}  // namespace cutwater
