#include <Cutwater/Operations/Detail/Complement.hpp>
#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Operations/Detail/OperandTree.hpp>

#include <algorithm>
#include <cassert>
#include <numeric>

namespace cutwater::detail {

namespace {

/// From this many operands, the search costs no more than evaluating all, even if they are spheres,
/// which are the cheapest to evaluate.
constexpr std::size_t kFewest = 16;

}  // namespace

template <std::floating_point T>
OperandBound<T> boundOf(const Solid<T>& operand, bool isNegated) {
  if (!isNegated) return {operand.guarantee(), operand.clearanceBox()};
  // The negative of a complement is positive outside the complement's operand.
  const auto* const rest = operand.template as<Complement<T>>();
  return {swapped(operand.guarantee()),
          rest != nullptr ? operand.placement().toWorld(rest->operand().clearanceBox())
                          : Box<T>::everywhere()};
}

template <std::floating_point T>
bool OperandTree<T>::isBounded(const OperandBound<T>& operand) {
  const auto& promise = operand.guarantee;
  const auto& box = operand.box;
  return promise.lipschitz && *promise.lipschitz <= 1 && promise.continuous &&
         promise.domain == Box<T>::everywhere() && promise.size < kFarthest &&
         promise.ulps < 1 / std::numeric_limits<T>::epsilon() && !box.empty() &&
         maxComponent(max(abs(box.lower), abs(box.upper))) < kFarthest;
}

template <std::floating_point T>
bool OperandTree<T>::isWorthKeepingFor(std::span<const OperandBound<T>> operands) const {
  const auto known = ids_.size() + always_.size();
  assert(known <= operands.size());
  const auto more = std::ranges::count_if(operands.subspan(known), isBounded);
  return !ids_.empty() && late_ + static_cast<std::size_t>(more) < kFewest;
}

template <std::floating_point T>
OperandTree<T>::OperandTree(std::span<const OperandBound<T>> operands,
                            const OperandTree* beginning) {
  if (beginning == nullptr || !beginning->isWorthKeepingFor(operands)) {
    build(operands);
    return;
  }
  *this = *beginning;
  for (auto i = ids_.size() + always_.size(); i < operands.size(); ++i) {
    always_.push_back(static_cast<std::uint32_t>(i));
    late_ += isBounded(operands[i]) ? 1 : 0;
  }
}

template <std::floating_point T>
void OperandTree<T>::build(std::span<const OperandBound<T>> operands) {
  std::vector<Box<double>> boxes;
  for (std::uint32_t i = 0; i < operands.size(); ++i) {
    const auto& [promise, box] = operands[i];
    if (!isBounded(operands[i])) {
      always_.push_back(i);
      continue;
    }
    ids_.push_back(i);
    boxes.push_back({Vec3<double>(box.lower), Vec3<double>(box.upper)});
    ulps_ = std::max(ulps_, promise.ulps);
    size_ = std::max(size_, promise.size);
  }
  if (ids_.size() < kFewest) {
    ids_.clear();
    always_.resize(operands.size());
    std::iota(always_.begin(), always_.end(), 0U);
  } else {
    constexpr std::size_t kMany = 4096;  // fewer take less time than waking threads
    arrays_ = buildBvh<16, 4>(boxes, boxes.size() < kMany ? 1 : 0);
  }
}

template OperandBound<float> boundOf(const Solid<float>&, bool);
template OperandBound<double> boundOf(const Solid<double>&, bool);
template class OperandTree<float>;
template class OperandTree<double>;

}  // namespace cutwater::detail
