#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/Detail/Combination.hpp>
#include <Cutwater/Operations/Detail/Labelled.hpp>
#include <Cutwater/Render/Detail/CertainDistance.hpp>
#include <Cutwater/Render/Detail/SolidParts.hpp>

#include <algorithm>
#include <array>

namespace cutwater::detail {

namespace {

/// How rays find a surface.
enum class RaySearch : std::uint8_t { Facets, Distances, Signs };

/// Operands of a union with the same search, and the numbers of their patches in the whole.
template <std::floating_point T>
struct OperandGroup {
  std::vector<Solid<T>> operands;
  std::vector<std::uint32_t> patches;
};

template <std::floating_point T>
bool isFlat(const SignedDistanceFunction<T>& solid, const Box<double>& box) {
  return solid.facetsIn({Vec3<T>(box.lower), Vec3<T>(box.upper)},
                        [](const auto&) { return false; });
}

/// Sorts the operands of a union.
template <std::floating_point T>
class OperandSorter {
 public:
  using Groups = std::array<OperandGroup<T>, 3>;

  explicit OperandSorter(const Box<double>& box) : box_(box) {}

  /// Adds a solid or, if it is a union, its operands, in order.
  void add(const Solid<T>& solid) {
    const auto placed = [&](Solid<T> inner) {
      inner.setPlacement(RigidTransform<T>::composed(inner.placement(), solid.placement()));
      return inner;
    };
    if (const auto* const labelled = solid.template as<Labelled<T>>()) {
      add(placed(labelled->operand()));  // its patches have other names, but the same numbers
      return;
    }
    const auto* const combination = solid.template as<Combination<T>>();
    if (combination != nullptr && combination->decides() == Combination<T>::Decides::Least) {
      for (const auto& operand : combination->operands()) add(placed(operand));
      return;
    }
    auto& group = groups_[static_cast<std::size_t>(searchFor(solid))];
    group.operands.push_back(solid);
    for (auto count = solid.patchNames().size(); count > 0; --count) {
      group.patches.push_back(patches_++);
    }
  }

  [[nodiscard]] Groups take() { return std::move(groups_); }

 private:
  [[nodiscard]] RaySearch searchFor(const Solid<T>& solid) const {
    const CertainDistance<T> distance(solid.guarantee(), box_, /*sheets=*/false);
    if (!distance.isKnown()) return RaySearch::Signs;
    return distance.isExact() && isFlat(solid, box_) ? RaySearch::Facets : RaySearch::Distances;
  }

  Box<double> box_;
  Groups groups_;
  std::uint32_t patches_ = 0;
};

}  // namespace

template <std::floating_point T>
std::vector<SolidPart<T>> partsOf(const SignedDistanceFunction<T>& solid, const Box<double>& box,
                                  bool sheets, int threads) {
  std::vector<SolidPart<T>> parts;
  if (const auto* const sum = dynamic_cast<const Solid<T>*>(&solid); sum != nullptr && !sheets) {
    OperandSorter<T> sorter(box);
    sorter.add(*sum);
    for (auto& group : sorter.take()) {
      if (group.operands.empty()) continue;
      parts.push_back({std::make_shared<const Solid<T>>(unionOf(group.operands)),
                       std::move(group.patches), std::nullopt});
    }
  }
  if (parts.size() < 2) {
    // The solid itself, with no owner.
    const std::shared_ptr<const SignedDistanceFunction<T>> whole(std::shared_ptr<void>(), &solid);
    parts.assign(1, {whole, {}, std::nullopt});
  }
  for (auto& part : parts) part.facets = FacetRays::of(*part.solid, box, threads);
  return parts;
}

template std::vector<SolidPart<float>> partsOf(const SignedDistanceFunction<float>&,
                                               const Box<double>&, bool, int);
template std::vector<SolidPart<double>> partsOf(const SignedDistanceFunction<double>&,
                                                const Box<double>&, bool, int);

}  // namespace cutwater::detail
