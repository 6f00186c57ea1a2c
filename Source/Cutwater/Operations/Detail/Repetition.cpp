#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/Images.hpp>
#include <Cutwater/Operations/Detail/Repetition.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
Repetition<T>::Repetition(Solid<T> operand, const Repeats<T>& repeats)
    : UnaryOperation<T>(std::move(operand)), copies_(repeats, this->operand().boundingBox()) {
  checkArguments();
  deriveReach();
  deriveGuarantee();
}

template <std::floating_point T>
void Repetition<T>::checkArguments() const {
  const auto& [period, counts] = copies_.repeats();
  const auto& box = copies_.box();
  require(isFinite(period) && period.x >= 0 && period.y >= 0 && period.z >= 0 &&
              maxComponent(period) > 0,
          "repeated: need finite periods, none negative and one positive", Named{"period", period});
  for (int axis = 0; axis < 3; ++axis) {
    const auto count = counts[static_cast<std::size_t>(axis)];
    require(copies_.isRepeated(axis) || count <= 1, "repeated: need a period for several copies",
            Named{"axis", axis}, Named{"count", count});
    if (!copies_.isRepeated(axis) || count == 1 || box.empty()) continue;
    require(std::isfinite(box.upper[axis] - box.lower[axis]),
            "repeated: need a bounding box that is finite along the axis", Named{"axis", axis});
  }
  constexpr double kMost = 1e5;
  if (!box.empty() && copies_.mostWithin(0) > kMost) {
    throw Error(ErrorKind::Limit, "repeated: too many copies overlap at one point");
  }
}

template <std::floating_point T>
void Repetition<T>::deriveReach() {
  reach_ = copies_.ofNearest();
  const auto& box = copies_.box();
  if (this->operand().guarantee().outside == Quality::Exact || box.empty()) return;
  T shortest = Box<T>::kInf;
  diagonal_ = 0;  // of the finite sides
  for (int axis = 0; axis < 3; ++axis) {
    const T side = box.upper[axis] - box.lower[axis];
    if (std::isfinite(side)) diagonal_ = std::hypot(diagonal_, side);
    if (copies_.isRepeated(axis)) shortest = std::min(shortest, copies_.repeats().period[axis]);
  }
  diagonal_ = std::max(diagonal_, T(0.5) * shortest);
  // The square of the most that f may be exceeds that of E by up to 64/7 D^2, where E = 24/7 D.
  constexpr T kRadii = T(3.03);
  const double most = std::max(1000.0, 2 * copies_.mostWithin(T(0)));
  while (copies_.mostWithin(kRadii * diagonal_) > most) diagonal_ /= 2;
  reach_ = copies_.ofBoxesWithin(kRadii * diagonal_);
}

template <std::floating_point T>
void Repetition<T>::deriveGuarantee() {
  guarantee_ = this->operand().guarantee();
  if (guarantee_.outside == Quality::SignOnly) {
    if (guarantee_.lipschitz) {
      stretch_ = std::max(*guarantee_.lipschitz, T(1));
    } else {
      guarantee_.continuous = false;
    }
  }
  if (isLimited() && guarantee_.lipschitz) {
    guarantee_.lipschitz = std::max(*guarantee_.lipschitz, T(1));
  }
  if (copies_.box().empty()) {  // neighbours are not compared
    guarantee_.lipschitz.reset();
    guarantee_.continuous = false;
  }
  if (guarantee_.domain != Box<T>::everywhere()) guarantee_.domain = {};

  // In the nearest copy's frame, the point is no farther from the origin than before, or than a
  // period.
  const auto& box = copies_.box();
  T size = 0;
  for (int axis = 0; axis < 3 && !box.empty(); ++axis) {
    const T period = copies_.repeats().period[axis];
    const auto count = copies_.repeats().count[static_cast<std::size_t>(axis)];
    size += period * (static_cast<T>(count) + 1);
    for (const T side : {box.lower[axis], box.upper[axis]}) {
      if (std::isfinite(side)) size += 2 * std::abs(side);
    }
    const T gap = period - (box.upper[axis] - box.lower[axis]);
    if (copies_.isRepeated(axis) && count != 1 && !(gap > 4 * guarantee_.error(size))) {
      guarantee_.inside = std::min(guarantee_.inside, Quality::LowerBound);
    }
  }
  // Rounding moves the point in the copy's frame, and the place where another copy becomes the
  // nearest; another three are for distances to boxes.
  guarantee_.ulps = guarantee_.ulps * stretch_ + 7 * guarantee_.lipschitz.value_or(T(1)) + 4;
  guarantee_.size += size;
}

template <std::floating_point T>
auto Repetition<T>::startAt(const Vec3<T>& p) const -> Start {
  const auto copy = copies_.central(p);
  const auto local = copies_.seenFrom(copy, p);
  return {copy, local, isLimited() ? gapOf(local) : T(0)};
}

template <std::floating_point T>
auto Repetition<T>::decide(const Vec3<T>& p, const Start& start, T value) const -> Decision {
  if (isFar(start)) return {start.copy, start.gap};
  Decision best{start.copy, valueFrom(value, start.gap)};
  const auto& box = copies_.box();
  if (box.empty()) return best;
  const T farthest =
      stretch_ * length(max(abs(start.local - box.lower), abs(box.upper - start.local)));
  const T most = mostAt(start.gap);
  // A copy farther away than this has not the least value, apart from rounding.
  const auto limit = [&] { return std::max(std::min(best.value, std::min(farthest, most)), T(0)); };
  const auto mayDecide = [&](T gapSquared) { return gapSquared <= limit() * limit(); };
  const auto ask = [&](const Vec3<T>& copy) {
    if (copy == start.copy) return;
    const auto local = copies_.seenFrom(copy, p);
    const T gap = isLimited() ? gapOf(local) : T(0);
    const T there = valueFrom(this->operand().signedDistance(local), gap);
    if (there < best.value) best = {copy, there};
  };
  if (!copies_.isAloneWithin(limit(), p, start.local)) {
    copies_.outwards(p, start.copy, reach_, mayDecide, ask);
  }
  best.value = std::min(best.value, most);
  // Only values of an empty operand are larger; the copies asked about then depend on the point.
  if (guarantee_.lipschitz) best.value = std::min(best.value, farthest);
  return best;
}

template <std::floating_point T>
auto Repetition<T>::decide(const Vec3<T>& p) const -> Decision {
  const auto start = startAt(p);
  if (isFar(start)) return {start.copy, start.gap};
  return decide(p, start, this->operand().signedDistance(start.local));
}

template <std::floating_point T>
T Repetition<T>::localSignedDistance(const Vec3<T>& p) const {
  return decide(p).value;
}

template <std::floating_point T>
void Repetition<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                         std::span<T> distances) const {
  const auto local = [this](const Vec3<T>& p) { return copies_.seenFrom(copies_.central(p), p); };
  detail::forImages(points, local, [&](std::span<const Vec3<T>> locals, std::size_t first) {
    const auto here = points.subspan(first, locals.size());
    const auto values = distances.subspan(first, locals.size());
    this->operandValues(locals, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = decide(here[i], startAt(here[i]), values[i]).value;
    }
  });
}

template <std::floating_point T>
Vec3<T> Repetition<T>::localGradient(const Vec3<T>& p) const {
  const auto decision = decide(p);
  const auto local = copies_.seenFrom(decision.copy, p);
  if (isLimited() && decision.value > 0) {
    const auto& box = copies_.box();
    const auto fromBox = [&box](const Vec3<T>& q) { return q - max(box.lower, min(box.upper, q)); };
    if (decision.value == gapOf(local)) return normalized(fromBox(local));
    const auto start = startAt(p);
    if (decision.value == mostAt(start.gap)) return T(0.75) * normalized(fromBox(start.local));
  }
  return this->operand().gradient(local);
}

template <std::floating_point T>
SurfacePoint<T> Repetition<T>::localClosestPoint(const Vec3<T>& p) const {
  const auto decision = decide(p);
  auto found = this->operand().closestPoint(copies_.seenFrom(decision.copy, p));
  found.point += copies_.placeOf(decision.copy);
  const T residual = localSignedDistance(found.point);
  if (!(std::abs(residual) <= guarantee_.error(length(p) + length(found.point)))) {
    return SignedDistanceFunction<T>::localClosestPoint(p);
  }
  found.distance = decision.value;
  detail::setTolerance(found, p, residual, guarantee_);
  return found;
}

template <std::floating_point T>
SurfaceOwner Repetition<T>::localOwner(const Vec3<T>& p) const {
  return this->operand().owner(copies_.seenFrom(decide(p).copy, p));
}

/// Those of the copies near the box, if these are not very many: as many copies as fit in, with as
/// many surfaces as the one in the middle has, which may be of copies, too.
template <std::floating_point T>
bool Repetition<T>::localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const {
  constexpr double kMost = 4000;
  const auto around = guarantee_.grown(box.bounds());
  const auto middle = around.center();
  const T radius = T(0.5) * around.diagonal();
  if (copies_.box().empty()) return false;
  const auto central = copies_.central(middle);
  const auto surfacesOfCopy = [&](const Vec3<T>& copy, SurfaceVisitor<T> visitOfCopy) {
    auto moved = this->operand();
    moved.translate(copies_.placeOf(copy));
    this->surfacesOf(moved, box, visitOfCopy);
  };
  double ofCopy = 0;
  surfacesOfCopy(central, [&](const Solid<T>&, const Solid<T>*) { ++ofCopy; });
  if (!(std::max(1.0, ofCopy) * copies_.mostWithin(radius) <= kMost)) return false;
  const auto isNear = [&](T gapSquared) { return gapSquared <= radius * radius; };
  copies_.outwards(middle, central, copies_.ofBoxesWithin(radius), isNear,
                   [&](const Vec3<T>& copy) { surfacesOfCopy(copy, visit); });
  return true;
}

template <std::floating_point T>
Box<T> Repetition<T>::localBoundingBox() const {
  return guarantee_.grown(copies_.boxOfAll());
}

template <std::floating_point T>
Box<T> Repetition<T>::localClearanceBox() const {
  // Values less than the distance to a copy's bounding box are replaced by it.
  return copies_.box().empty() ? Box<T>::everywhere() : localBoundingBox();
}

template class Repetition<float>;
template class Repetition<double>;

}  // namespace cutwater
