#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Combination.hpp>
#include <Cutwater/Sdf/Defaults.hpp>

#include <algorithm>
#include <array>

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

BoxClass opposite(BoxClass c) {
  return c == BoxClass::Inside ? BoxClass::Outside : c == BoxClass::Outside ? BoxClass::Inside : c;
}

/// Batches are decided in pieces of this many points at most.
constexpr std::size_t kBatch = 256;
/// Closest points in smaller ones: a nested combination has its own scratch on the stack.
constexpr std::size_t kFewer = 64;

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
  std::array<std::uint32_t, kBatch> deciding;
  for (std::size_t first = 0; first < points.size(); first += kBatch) {
    const auto count = std::min(kBatch, points.size() - first);
    decide(points.subspan(first, count), distances.subspan(first, count),
           std::span(deciding).first(count));
  }
}

template <std::floating_point T>
void Combination<T>::decide(std::span<const Vec3<T>> points, std::span<T> values,
                            std::span<std::uint32_t> operands) const {
  std::array<T, kBatch> scratch;
  const auto other = std::span<T>(scratch).first(points.size());
  operands_[0].signedDistances(points, values, {.threads = 1});
  std::ranges::fill(operands, 0U);
  for (std::uint32_t i = 1; i < operands_.size(); ++i) {
    operands_[i].signedDistances(points, other, {.threads = 1});
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!(side() * other[k] < side() * values[k])) continue;
      values[k] = other[k];
      operands[k] = i;
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
void Combination<T>::localClosestPoints(std::span<const Vec3<T>> points,
                                        std::span<SurfacePoint<T>> results) const {
  std::array<T, kFewer> values;
  std::array<T, kFewer> residuals;
  std::array<std::uint32_t, kFewer> deciding;
  std::array<Vec3<T>, kFewer> places;
  for (std::size_t first = 0; first < points.size(); first += kFewer) {
    const auto count = std::min(kFewer, points.size() - first);
    const auto here = points.subspan(first, count);
    const auto found = results.subspan(first, count);
    const auto operands = std::span(deciding).first(count);
    decide(here, std::span(values).first(count), operands);
    askDeciding(here, operands, found);
    for (std::size_t k = 0; k < count; ++k) places[k] = found[k].point;
    localSignedDistances(std::span<const Vec3<T>>(places).first(count),
                         std::span(residuals).first(count));
    for (std::size_t k = 0; k < count; ++k) {
      found[k] = checked(here[k], {operands[k], values[k]}, found[k], residuals[k]);
    }
  }
}

template <std::floating_point T>
void Combination<T>::askDeciding(std::span<const Vec3<T>> points,
                                 std::span<const std::uint32_t> operands,
                                 std::span<SurfacePoint<T>> found) const {
  std::array<std::size_t, kFewer> places;
  std::array<Vec3<T>, kFewer> asked;
  std::array<SurfacePoint<T>, kFewer> answers;
  for (std::uint32_t i = 0; i < operands_.size(); ++i) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (operands[k] != i) continue;
      places[count] = k;
      asked[count++] = points[k];
    }
    if (count == 0) continue;
    operands_[i].closestPoints(std::span<const Vec3<T>>(asked).first(count),
                               std::span(answers).first(count), {.threads = 1});
    for (std::size_t n = 0; n < count; ++n) found[places[n]] = answers[n];
  }
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
