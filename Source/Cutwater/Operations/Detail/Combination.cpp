#include <Cutwater/Core/Detail/Batches.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/Combination.hpp>
#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>
#include <array>
#include <numeric>

namespace cutwater {

namespace {

/// The guarantee of the least of two functions.
template <std::floating_point T>
Guarantee<T> united(const Guarantee<T>& a, const Guarantee<T>& b) {
  auto both = detail::common(a, b);
  // Deep inside one operand, the surface may be farther than that operand's own.
  both.inside = std::min(both.inside, Quality::LowerBound);
  return both;
}

/// Closest points are found this many at a time; few, as each nested combination has its own
/// scratch on the stack.
constexpr std::size_t kFew = 64;

BoxClass opposite(BoxClass c) {
  return c == BoxClass::Inside ? BoxClass::Outside : c == BoxClass::Outside ? BoxClass::Inside : c;
}

}  // namespace

template <std::floating_point T>
Combination<T>::Combination(Decides decides, std::vector<Solid<T>> operands,
                            const Combination* beginning)
    : Composite<T>(std::move(operands)), decides_(decides) {
  if (count() == 0) throw Error(ErrorKind::Argument, nameOf(decides) + ": need an operand");
  std::vector<detail::OperandBound<T>> bounds;
  const bool least = decides == Decides::Least;
  for (const auto& each : this->operands()) bounds.push_back(detail::boundOf(each, !least));
  guarantee_ = bounds[0].guarantee;
  boundingBox_ = operand(0).boundingBox();
  for (std::size_t i = 1; i < count(); ++i) {
    guarantee_ = united(guarantee_, bounds[i].guarantee);
    const auto box = operand(i).boundingBox();
    boundingBox_ = least ? boundingBox_.extend(box) : boundingBox_.intersection(box);
  }
  if (!least) guarantee_ = detail::swapped(guarantee_);
  if (boundingBox_.empty()) boundingBox_ = {};
  clearanceBox_ = detail::clearanceBoxOf<T>(this->operands(), least);
  tree_ = detail::OperandTree<T>(bounds, beginning != nullptr ? &beginning->tree_ : nullptr);
}

template <std::floating_point T>
auto Combination<T>::decide(const Vec3<T>& p, Interval<T> wanted) const -> Decision {
  constexpr T kInf = std::numeric_limits<T>::infinity();
  Decision least{kNone, kInf};
  const bool isAllWanted = wanted.upper == kInf;
  // Values beyond the least so far only need to be known to be so.
  const auto ask = [&](std::size_t i) {
    const T value = sidedValue(i, p, wanted);
    if (value < least.value || (value == least.value && i < least.operand)) least = {i, value};
    wanted.upper = std::min(wanted.upper, least.value);
    return wanted.upper;
  };
  const auto askFirst = [&] {
    least = {0, sidedValue(0, p, wanted)};
    wanted.upper = std::min(wanted.upper, least.value);
  };
  if (tree_.helpsAt(p)) {
    if (tree_.asksFirst()) askFirst();
    for (const auto i : tree_.alwaysButFirst()) ask(i);
    tree_.forLeastAt(p, wanted.upper, ask);
  } else {
    askFirst();
    for (std::size_t i = 1; i < count(); ++i) ask(i);
  }
  // No operand gave a number, against its promise, or all values are beyond what is wanted.
  if (least.operand == kNone && isAllWanted) askFirst();
  return {least.operand, side() * least.value};
}

template <std::floating_point T>
T Combination<T>::localSignedDistance(const Vec3<T>& p) const {
  return decide(p).value;
}

template <std::floating_point T>
T Combination<T>::localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const {
  return decide(p, decides_ == Decides::Least ? wanted : -wanted).value;
}

template <std::floating_point T>
T Combination<T>::decidingValue(const Vec3<T>& p, T ofAlwaysAsked) const {
  if (!tree_.helpsAt(p)) return decide(p).value;
  T least = side() * ofAlwaysAsked;
  tree_.forLeastAt(p, least, [&](std::size_t i) {
    const Interval<T> nearer{-std::numeric_limits<T>::infinity(), least};
    return least = std::min(least, sidedValue(i, p, nearer));
  });
  return std::isinf(least) ? decide(p).value : side() * least;
}

template <std::floating_point T>
void Combination<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                          std::span<T> distances) const {
  constexpr std::size_t kMost = 256;
  Scratch<T, kMost> scratch;
  detail::forBatches(points.size(), kMost, [&](std::size_t first, std::size_t some) {
    const auto here = points.subspan(first, some);
    const auto least = distances.subspan(first, some);
    const auto other = scratch.first(some);
    if (tree_.asksFirst()) {
      operand(0).signedDistances(here, least, {.threads = 1});
    } else {
      std::ranges::fill(least, side() * std::numeric_limits<T>::infinity());
    }
    for (const auto i : tree_.alwaysButFirst()) {
      operand(i).signedDistances(here, other, {.threads = 1});
      for (std::size_t k = 0; k < some; ++k) {
        if (side() * other[k] < side() * least[k]) least[k] = other[k];
      }
    }
    if (tree_.always().size() == count()) return;
    for (std::size_t k = 0; k < some; ++k) least[k] = decidingValue(here[k], least[k]);
  });
}

template <std::floating_point T>
Vec3<T> Combination<T>::localGradient(const Vec3<T>& p) const {
  return operand(decide(p).operand).gradient(p);
}

template <std::floating_point T>
SurfaceOwner Combination<T>::localOwner(const Vec3<T>& p) const {
  const auto decider = decide(p).operand;
  return this->counted(operand(decider).owner(p), decider);
}

template <std::floating_point T>
SurfacePoint<T> Combination<T>::localClosestPoint(const Vec3<T>& p) const {
  const auto decision = decide(p);
  const auto found = operand(decision.operand).closestPoint(p);
  return checked(p, decision, found, localSignedDistance(found.point));
}

template <std::floating_point T>
SurfacePoint<T> Combination<T>::checked(const Vec3<T>& p, const Decision& decision,
                                        SurfacePoint<T> found, T residual) const {
  if (!(std::abs(residual) <= guarantee_.error(length(p) + length(found.point)))) {
    return SignedDistanceFunction<T>::localClosestPoint(p);
  }
  found.owner = this->counted(found.owner, decision.operand);
  found.distance = decision.value;
  detail::setTolerance(found, p, residual, guarantee_);
  return found;
}

template <std::floating_point T>
void Combination<T>::localClosestPoints(std::span<const Vec3<T>> points,
                                        std::span<SurfacePoint<T>> results) const {
  Scratch<Decision, kFew> decisions;
  Scratch<Vec3<T>, kFew> places;
  Scratch<T, kFew> residuals;
  detail::forBatches(points.size(), kFew, [&](std::size_t first, std::size_t some) {
    const auto here = points.subspan(first, some);
    const auto found = results.subspan(first, some);
    for (std::size_t k = 0; k < some; ++k) decisions[k] = decide(here[k]);
    askDeciding(here, decisions.first(some), found);
    for (std::size_t k = 0; k < some; ++k) places[k] = found[k].point;
    localSignedDistances(places.first(some), residuals.first(some));
    for (std::size_t k = 0; k < some; ++k) {
      found[k] = checked(here[k], decisions[k], found[k], residuals[k]);
    }
  });
}

template <std::floating_point T>
void Combination<T>::askDeciding(std::span<const Vec3<T>> points,
                                 std::span<const Decision> decisions,
                                 std::span<SurfacePoint<T>> found) const {
  const auto operandOf = [&](std::size_t k) { return decisions[k].operand; };
  std::array<std::size_t, kFew> byOperand;
  std::array<Vec3<T>, kFew> asked;
  std::array<SurfacePoint<T>, kFew> answers;
  const auto order = std::span(byOperand).first(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, operandOf);
  for (std::size_t begin = 0; begin < order.size();) {
    const auto decider = operandOf(order[begin]);
    std::size_t end = begin;
    for (; end < order.size() && operandOf(order[end]) == decider; ++end) {
      asked[end] = points[order[end]];
    }
    operand(decider).closestPoints(std::span<const Vec3<T>>(asked).subspan(begin, end - begin),
                                   std::span(answers).subspan(begin, end - begin), {.threads = 1});
    begin = end;
  }
  for (std::size_t i = 0; i < order.size(); ++i) found[order[i]] = answers[i];
}

/// Calls ask(operand) for all operands except those whose lower bound in the box is certainly above
/// the limit that ask() returns.
template <std::floating_point T>
template <typename Ask>
void Combination<T>::forEachNear(const OrientedBox<T>& box, double limit, Ask&& ask) const {
  const bool helps = tree_.helpsAt(box.center, box.radius());
  const std::size_t first = helps ? tree_.always().size() : count();
  for (std::size_t i = 0; i < first; ++i) {
    limit = ask(helps ? tree_.always()[i] : i);
    if (limit == kStopTraversal) return;
  }
  if (helps) tree_.forBoundsIn(box, limit, ask);
}

template <std::floating_point T>
Interval<T> Combination<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  const bool least = decides_ == Decides::Least;
  const auto decided = [least](T a, T b) { return least ? std::min(a, b) : std::max(a, b); };
  std::optional<Interval<T>> found;
  // Returns the limit up to which another operand's bound would change the result.
  const auto ask = [&](std::size_t i) {
    const auto other = this->boundsOf(operand(i), box);
    const auto before = found.value_or(other);
    const Interval<T> result{decided(before.lower, other.lower),
                             decided(before.upper, other.upper)};
    found = result;
    return static_cast<double>(least ? result.upper : -result.lower);
  };
  forEachNear(box, std::numeric_limits<double>::infinity(), ask);
  return {found->lower + T(0), found->upper + T(0)};  // -0 becomes +0
}

template <std::floating_point T>
bool Combination<T>::localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const {
  bool areAll = true;
  bool goesOn = true;
  forEachNear(box, 0, [&](std::size_t i) {
    areAll &= this->facetsOf(operand(i), box, [&](SurfaceFacet<T> facet) {
      facet.owner = this->counted(facet.owner, i);
      return goesOn = visit(facet);
    });
    return goesOn ? 0.0 : kStopTraversal;
  });
  return areAll;
}

template <std::floating_point T>
bool Combination<T>::localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const {
  forEachNear(box, 0, [&](std::size_t i) {
    if (mayBeCut(this->classOf(operand(i), box))) this->surfacesOf(operand(i), box, visit);
    return 0.0;
  });
  return true;
}

template <std::floating_point T>
BoxClass Combination<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  const auto seen = [this](BoxClass c) { return decides_ == Decides::Least ? c : opposite(c); };
  const auto around = box.bounds();
  std::size_t reaching = 0;  // operands not outside the box
  std::size_t cut = 0;
  bool isInside = false;
  const auto ask = [&](std::size_t i) {
    // If there are two, it only matters whether another one contains the box.
    if (reaching >= 2 && !mayContain(i, around)) return 0.0;
    const auto c = seen(this->classOf(operand(i), box));
    reaching += c != BoxClass::Outside;
    cut += c == BoxClass::Cut;
    isInside = isInside || c == BoxClass::Inside;
    return isInside ? kStopTraversal : 0.0;
  };
  forEachNear(box, 0, ask);
  if (isInside) return seen(BoxClass::Inside);
  if (reaching == 0) return seen(BoxClass::Outside);
  // As all others are outside, the surface of the one that cuts is that of the whole.
  if (reaching == 1 && cut == 1) return BoxClass::Cut;
  if (reaching == 1) return SignedDistanceFunction<T>::localClassify(box, hint);
  if (!box.isWithin(guarantee_.domain)) return BoxClass::Unknown;
  return this->holdsNearestPoint(box) || this->holdsBothSides(box) ? BoxClass::Cut
                                                                   : this->classOfUndecided(box);
}

template <std::floating_point T>
bool Combination<T>::mayContain(std::size_t i, const Box<T>& box) const {
  if (decides_ == Decides::Greatest) return true;
  return operand(i).boundingBox().covers(box);
}

template class Combination<float>;
template class Combination<double>;

}  // namespace cutwater
