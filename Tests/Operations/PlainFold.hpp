#pragma once

#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <utility>
#include <vector>

namespace cutwater::test {

/// What Combination documents, asked of every operand in order: no tree.
template <typename T>
class PlainFold final : public SignedDistanceFunction<T> {
 public:
  PlainFold(const std::vector<Solid<T>>& operands, bool least, const Guarantee<T>& guarantee)
      : operands_(operands), side_(least ? T(1) : T(-1)), guarantee_(guarantee) {}

 private:
  std::pair<std::size_t, T> decide(const Vec3<T>& p) const {
    std::pair<std::size_t, T> best{0, operands_[0].signedDistance(p)};
    for (std::size_t i = 1; i < operands_.size(); ++i) {
      const T value = operands_[i].signedDistance(p);
      if (side_ * value < side_ * best.second) best = {i, value};
    }
    return best;
  }
  SurfaceOwner counted(SurfaceOwner owner, std::size_t operand) const {
    for (std::size_t i = 0; i < operand; ++i) {
      owner.patch += static_cast<std::uint32_t>(operands_[i].patchNames().size());
    }
    owner.object = static_cast<std::uint32_t>(operand);
    return owner;
  }
  T localSignedDistance(const Vec3<T>& p) const override { return decide(p).second; }
  Vec3<T> localGradient(const Vec3<T>& p) const override {
    return operands_[decide(p).first].gradient(p);
  }
  SurfaceOwner localOwner(const Vec3<T>& p) const override {
    const auto operand = decide(p).first;
    return counted(operands_[operand].owner(p), operand);
  }
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override {
    const auto [operand, value] = decide(p);
    auto result = operands_[operand].closestPoint(p);
    const T residual = localSignedDistance(result.point);
    if (!(std::abs(residual) <= guarantee_.error(length(p) + length(result.point)))) {
      return SignedDistanceFunction<T>::localClosestPoint(p);
    }
    result.owner = counted(result.owner, operand);
    result.distance = value;
    detail::setTolerance(result, p, residual, guarantee_);
    return result;
  }
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint*) const override {
    auto result = this->boundsOf(operands_[0], box);
    for (const auto& operand : operands_) {
      const auto other = this->boundsOf(operand, box);
      result = side_ > 0 ? Interval<T>{std::min(result.lower, other.lower),
                                       std::min(result.upper, other.upper)}
                         : Interval<T>{std::max(result.lower, other.lower),
                                       std::max(result.upper, other.upper)};
    }
    return result;
  }
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override {
    const auto kept = side_ > 0 ? BoxClass::Inside : BoxClass::Outside;
    const auto free = side_ > 0 ? BoxClass::Outside : BoxClass::Inside;
    std::size_t frees = 0;
    std::size_t cuts = 0;
    for (const auto& operand : operands_) {
      const auto c = this->classOf(operand, box);
      if (c == kept) return kept;
      frees += c == free;
      cuts += c == BoxClass::Cut;
    }
    if (frees == operands_.size()) return free;
    if (cuts == 1 && frees + 1 == operands_.size()) return BoxClass::Cut;
    return SignedDistanceFunction<T>::localClassify(box, hint);
  }
  Guarantee<T> localGuarantee() const override { return guarantee_; }

  const std::vector<Solid<T>>& operands_;
  T side_;
  Guarantee<T> guarantee_;
};

}  // namespace cutwater::test
