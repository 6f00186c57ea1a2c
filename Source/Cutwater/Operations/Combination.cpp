#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Combination.hpp>
#include <Cutwater/Sdf/Defaults.hpp>

#include <algorithm>
#include <array>
#include <numeric>

namespace cutwater {

namespace {

template <std::floating_point T>
Guarantee<T> swapped(Guarantee<T> g) {
  std::swap(g.inside, g.outside);
  return g;
}

/// Of the least of two functions.
template <std::floating_point T>
Guarantee<T> united(const Guarantee<T>& a, const Guarantee<T>& b) {
  Guarantee<T> both;
  both.outside = std::min(a.outside, b.outside);
  // Deep in one operand the surface may be farther than that operand's own.
  both.inside = std::min({a.inside, b.inside, Quality::LowerBound});
  if (a.lipschitz && b.lipschitz) both.lipschitz = std::max(*a.lipschitz, *b.lipschitz);
  both.continuous = a.continuous && b.continuous;
  both.domain = a.domain.intersection(b.domain);
  both.ulps = std::max(a.ulps, b.ulps);
  both.size = std::max(a.size, b.size);
  return both;
}

/// Closest points are found so many at a time: a nested combination has its own scratch on the
/// stack.
constexpr std::size_t kFew = 64;

BoxClass opposite(BoxClass c) {
  return c == BoxClass::Inside ? BoxClass::Outside : c == BoxClass::Outside ? BoxClass::Inside : c;
}

}  // namespace

template <std::floating_point T>
Combination<T>::Combination(const char* name, Decides decides, std::vector<Solid<T>> operands)
    : decides_(decides), operands_(std::move(operands)) {
  if (operands_.empty()) throw Error(ErrorKind::Argument, std::string(name) + ": need an operand");
  const bool least = decides == Decides::Least;
  const auto seen = [least](const Guarantee<T>& g) { return least ? g : swapped(g); };
  guarantee_ = seen(operands_[0].guarantee());
  boundingBox_ = operands_[0].boundingBox();
  std::size_t patches = 0;
  for (std::size_t i = 0; i < operands_.size(); ++i) {
    firstPatch_.push_back(static_cast<std::uint32_t>(patches));
    patches += operands_[i].patchNames().size();
    if (i == 0) continue;
    guarantee_ = united(guarantee_, seen(operands_[i].guarantee()));
    const auto box = operands_[i].boundingBox();
    boundingBox_ = least ? boundingBox_.extend(box) : boundingBox_.intersection(box);
  }
  require(patches < kNone, "Combination: too many patches", Named{"patches", patches});
  guarantee_ = seen(guarantee_);
  if (boundingBox_.empty()) boundingBox_ = {};
}

template <std::floating_point T>
auto Combination<T>::decide(const Vec3<T>& p) const -> Decision {
  Decision least{0, side() * operands_[0].signedDistance(p)};
  for (std::size_t i = 1; i < operands_.size(); ++i) {
    const T value = side() * operands_[i].signedDistance(p);
    if (value < least.value) least = {i, value};
  }
  return {least.operand, side() * least.value};
}

template <std::floating_point T>
T Combination<T>::localSignedDistance(const Vec3<T>& p) const {
  return decide(p).value;
}

template <std::floating_point T>
void Combination<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                          std::span<T> distances) const {
  constexpr std::size_t kMost = 256;
  std::array<T, kMost> scratch;
  for (std::size_t first = 0; first < points.size(); first += kMost) {
    const auto count = std::min(kMost, points.size() - first);
    const auto here = points.subspan(first, count);
    const auto least = distances.subspan(first, count);
    const auto other = std::span<T>(scratch).first(count);
    operands_[0].signedDistances(here, least, {.threads = 1});
    for (std::size_t i = 1; i < operands_.size(); ++i) {
      operands_[i].signedDistances(here, other, {.threads = 1});
      for (std::size_t k = 0; k < count; ++k) {
        if (side() * other[k] < side() * least[k]) least[k] = other[k];
      }
    }
  }
}

template <std::floating_point T>
Vec3<T> Combination<T>::localGradient(const Vec3<T>& p) const {
  return operands_[decide(p).operand].gradient(p);
}

template <std::floating_point T>
SurfaceOwner Combination<T>::counted(SurfaceOwner owner, std::size_t operand) const {
  owner.object = static_cast<std::uint32_t>(operand);
  owner.patch += firstPatch_[operand];
  return owner;
}

template <std::floating_point T>
SurfaceOwner Combination<T>::localOwner(const Vec3<T>& p) const {
  const auto operand = decide(p).operand;
  return counted(operands_[operand].owner(p), operand);
}

template <std::floating_point T>
SurfacePoint<T> Combination<T>::localClosestPoint(const Vec3<T>& p) const {
  const auto decision = decide(p);
  const auto found = operands_[decision.operand].closestPoint(p);
  return checked(p, decision, found, localSignedDistance(found.point));
}

template <std::floating_point T>
SurfacePoint<T> Combination<T>::checked(const Vec3<T>& p, const Decision& decision,
                                        SurfacePoint<T> found, T residual) const {
  if (!(std::abs(residual) <= guarantee_.error(length(p) + length(found.point)))) {
    return SignedDistanceFunction<T>::localClosestPoint(p);
  }
  found.owner = counted(found.owner, decision.operand);
  found.distance = decision.value;
  detail::rate(found, p, residual, guarantee_);
  return found;
}

template <std::floating_point T>
void Combination<T>::localClosestPoints(std::span<const Vec3<T>> points,
                                        std::span<SurfacePoint<T>> results) const {
  std::array<Decision, kFew> decisions;
  std::array<Vec3<T>, kFew> places;
  std::array<T, kFew> residuals;
  for (std::size_t first = 0; first < points.size(); first += kFew) {
    const auto count = std::min(kFew, points.size() - first);
    const auto here = points.subspan(first, count);
    const auto found = results.subspan(first, count);
    for (std::size_t k = 0; k < count; ++k) decisions[k] = decide(here[k]);
    askDeciding(here, std::span(decisions).first(count), found);
    for (std::size_t k = 0; k < count; ++k) places[k] = found[k].point;
    localSignedDistances(std::span<const Vec3<T>>(places).first(count),
                         std::span(residuals).first(count));
    for (std::size_t k = 0; k < count; ++k) {
      found[k] = checked(here[k], decisions[k], found[k], residuals[k]);
    }
  }
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
    const auto operand = operandOf(order[begin]);
    std::size_t end = begin;
    for (; end < order.size() && operandOf(order[end]) == operand; ++end) {
      asked[end] = points[order[end]];
    }
    operands_[operand].closestPoints(std::span<const Vec3<T>>(asked).subspan(begin, end - begin),
                                     std::span(answers).subspan(begin, end - begin),
                                     {.threads = 1});
    begin = end;
  }
  for (std::size_t i = 0; i < order.size(); ++i) found[order[i]] = answers[i];
}

template <std::floating_point T>
Interval<T> Combination<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  const bool least = decides_ == Decides::Least;
  const auto decided = [least](T a, T b) { return least ? std::min(a, b) : std::max(a, b); };
  auto result = this->boundsOf(operands_[0], box);
  for (std::size_t i = 1; i < operands_.size(); ++i) {
    const auto other = this->boundsOf(operands_[i], box);
    result = {decided(result.lower, other.lower), decided(result.upper, other.upper)};
  }
  return result;
}

template <std::floating_point T>
BoxClass Combination<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  const auto seen = [this](BoxClass c) { return decides_ == Decides::Least ? c : opposite(c); };
  std::size_t outside = 0;
  std::size_t cut = 0;
  for (const auto& operand : operands_) {
    const auto c = seen(this->classOf(operand, box));
    if (c == BoxClass::Inside) return seen(c);
    outside += c == BoxClass::Outside;
    cut += c == BoxClass::Cut;
  }
  if (outside == operands_.size()) return seen(BoxClass::Outside);
  // With all others away, the surface of the one that cuts is that of the whole.
  if (cut == 1 && outside + 1 == operands_.size()) return BoxClass::Cut;
  return SignedDistanceFunction<T>::localClassify(box, hint);
}

template <std::floating_point T>
std::vector<std::string> Combination<T>::localPatchNames() const {
  std::vector<std::string> names;
  for (const auto& operand : operands_) {
    for (auto& name : operand.patchNames()) names.push_back(std::move(name));
  }
  return names;
}

template class Combination<float>;
template class Combination<double>;

}  // namespace cutwater
