#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>
#include <Cutwater/Grid/Detail/VolumeSearch.hpp>
#include <Cutwater/Operations/Detail/Combination.hpp>
#include <Cutwater/Operations/Detail/Complement.hpp>
#include <Cutwater/Operations/Detail/Labelled.hpp>
#include <Cutwater/Operations/Detail/SymmetricDifference.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

/// Appends the solids, each where it is in the world, of which one is a union or the like.
template <std::floating_point T>
void addOperands(const Solid<T>& solid, std::vector<Solid<T>>& found) {
  const auto add = [&](Solid<T> operand) {
    operand.setPlacement(RigidTransform<T>::composed(operand.placement(), solid.placement()));
    addOperands(operand, found);
  };
  if (const auto* combination = solid.template as<Combination<T>>()) {
    for (const auto& operand : combination->operands()) add(operand);
  } else if (const auto* difference = solid.template as<SymmetricDifference<T>>()) {
    for (const auto& operand : difference->operands()) add(operand);
  } else if (const auto* complement = solid.template as<Complement<T>>()) {
    add(complement->operand());
  } else if (const auto* labelled = solid.template as<Labelled<T>>()) {
    add(labelled->operand());
  } else {
    found.push_back(solid);
  }
}

template <std::floating_point T>
FluidField::Operands operandsOf(const Solid<T>& solid) {
  constexpr std::size_t kMost = 1000;  // as each is asked in each tile
  std::vector<Solid<T>> found;
  addOperands(solid, found);
  FluidField::Operands operands;
  if (found.size() < 2 || found.size() > kMost) return operands;
  for (const auto& operand : found) operands.push_back(fluidBeside(operand, FluidSide::Outside));
  return operands;
}

template <std::floating_point T>
class SolidField final : public FluidField {
 public:
  SolidField(const Solid<T>& solid, FluidSide side) : SolidField(solid, side, solid.guarantee()) {}
  SolidField(const Solid<T>& solid, FluidSide side, const Guarantee<T>& guarantee)
      : FluidField(
            {.steepness = double{guarantee.lipschitz.value_or(T(0))},
             .domain = {Vec3<double>(guarantee.domain.lower), Vec3<double>(guarantee.domain.upper)},
             .isSingle = std::is_same_v<T, float>,
             .patchNames = solid.patchNames()}),
        solid_(solid),
        roundingPerLength_(double{guarantee.ulps} * double{std::numeric_limits<T>::epsilon()}),
        size_(guarantee.size),
        sign_(side == FluidSide::Outside ? 1 : -1) {
    setOperands(operandsOf<T>(solid));
  }

  void values(std::span<const Vec3<double>> points, std::span<double> values) const override {
    constexpr std::size_t kBatch = 64;
    constexpr std::size_t kFew = 3;  // faster one by one
    if (points.size() <= kFew) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        values[i] = valueOf(solid_.signedDistance(Vec3<T>(points[i])), points[i]);
      }
      return;
    }
    Scratch<Vec3<T>, kBatch> at;
    Scratch<T, kBatch> found;
    for (std::size_t first = 0; first < points.size(); first += kBatch) {
      const auto count = std::min(kBatch, points.size() - first);
      for (std::size_t i = 0; i < count; ++i) at[i] = Vec3<T>(points[first + i]);
      solid_.signedDistances(at.first(count), found.first(count), {.threads = 1});
      for (std::size_t i = 0; i < count; ++i) {
        values[first + i] = valueOf(found[i], points[first + i]);
      }
    }
  }
  Vec3<double> gradient(const Vec3<double>& point) const override {
    return sign_ * Vec3<double>(solid_.gradient(Vec3<T>(point)));
  }
  SurfaceOwner owner(const Vec3<double>& surfacePoint) const override {
    return solid_.owner(Vec3<T>(surfacePoint));
  }
  bool mayBeCut(const Box<double>& box, BoxHint& hint) const override {
    return cutwater::mayBeCut(solid_.classify(ofSolid(box), &hint));
  }
  Interval<double> shareOf(const Box<double>& box, double width, std::size_t boxes) const override {
    constexpr int kTrials = 5;  // generations without any answer
    detail::VolumeSearch<T> search(
        solid_, ofSolid(box),
        {.fraction = width, .cells = boxes, .isEstimated = false, .threads = 1});
    Interval<double> before{};
    int idle = 0;
    const auto found = search.run([&](const Interval<double>& volume) {
      idle = volume == before ? idle + 1 : 0;
      before = volume;
      return idle >= kTrials;
    });
    return sign_ > 0 ? found.porosity() : found.solidFraction();
  }

 private:
  [[nodiscard]] static Box<T> ofSolid(const Box<double>& box) {
    return {Vec3<T>(box.lower), Vec3<T>(box.upper)};
  }
  [[nodiscard]] double valueOf(T distance, const Vec3<double>& point) const {
    const double rounding = roundingPerLength_ * (oneNorm(point) + size_);
    return std::abs(distance) <= rounding ? 0 : sign_ * double{distance};
  }

  Solid<T> solid_;
  double roundingPerLength_;
  double size_;
  double sign_;
};

class Section final : public FluidField {
 public:
  Section(const FluidField& field, double z) : FluidField(factsAt(field, z)), field_(field), z_(z) {
    Operands operands;
    for (const auto& operand : field.operands()) {
      operands.push_back(std::make_shared<const Section>(*operand, z));
    }
    setOperands(std::move(operands));
  }

  void values(std::span<const Vec3<double>> points, std::span<double> values) const override {
    constexpr std::size_t kBatch = 64;
    Scratch<Vec3<double>, kBatch> at;
    for (std::size_t first = 0; first < points.size(); first += kBatch) {
      const auto count = std::min(kBatch, points.size() - first);
      for (std::size_t i = 0; i < count; ++i) at[i] = inPlane(points[first + i]);
      field_.values(at.first(count), values.subspan(first, count));
    }
  }
  Vec3<double> gradient(const Vec3<double>& point) const override {
    auto result = field_.gradient(inPlane(point));
    result.z = 0;
    return result;
  }
  SurfaceOwner owner(const Vec3<double>& surfacePoint) const override {
    return field_.owner(inPlane(surfacePoint));
  }
  bool mayBeCut(const Box<double>& box, BoxHint& hint) const override {
    return field_.mayBeCut(inPlane(box), hint);
  }
  Interval<double> shareOf(const Box<double>& box, double width, std::size_t boxes) const override {
    return field_.shareOf(inPlane(box), width, boxes);
  }

 private:
  static Facts factsAt(const FluidField& field, double z) {
    auto facts = field.facts();
    auto& [lower, upper] = facts.domain;
    if (!(lower.z <= z && z <= upper.z)) facts.steepness = 0;
    lower.z = -Box<double>::kInf;
    upper.z = Box<double>::kInf;
    return facts;
  }
  [[nodiscard]] Vec3<double> inPlane(const Vec3<double>& p) const { return {p.x, p.y, z_}; }
  [[nodiscard]] Box<double> inPlane(const Box<double>& box) const {
    return {inPlane(box.lower), inPlane(box.upper)};
  }

  const FluidField& field_;
  double z_;
};

class FieldInBox final : public FluidField {
 public:
  FieldInBox(const FluidField& field, const Box<double>& box)
      : FluidField(field.facts()), field_(field) {
    Operands near;
    field.forOperandsNear(box, [&](const auto& operand) { near.push_back(operand); });
    if (near.size() > 1) setOperands(std::move(near));
  }

  void values(std::span<const Vec3<double>> points, std::span<double> values) const override {
    field_.values(points, values);
  }
  Vec3<double> gradient(const Vec3<double>& point) const override { return field_.gradient(point); }
  SurfaceOwner owner(const Vec3<double>& surfacePoint) const override {
    return field_.owner(surfacePoint);
  }
  bool mayBeCut(const Box<double>& box, BoxHint& hint) const override {
    return field_.mayBeCut(box, hint);
  }
  Interval<double> shareOf(const Box<double>& box, double width, std::size_t boxes) const override {
    return field_.shareOf(box, width, boxes);
  }

 private:
  const FluidField& field_;
};

}  // namespace

std::unique_ptr<const FluidField> fieldIn(const FluidField& field, const Box<double>& box) {
  return std::make_unique<const FieldInBox>(field, box);
}

std::unique_ptr<const FluidField> sectionAt(const FluidField& field, double z) {
  return std::make_unique<const Section>(field, z);
}

template <std::floating_point T>
std::shared_ptr<const FluidField> fluidBeside(const Solid<T>& solid, FluidSide side) {
  return std::make_shared<const SolidField<T>>(solid, side);
}

template std::shared_ptr<const FluidField> fluidBeside(const Solid<float>&, FluidSide);
template std::shared_ptr<const FluidField> fluidBeside(const Solid<double>&, FluidSide);

}  // namespace cutwater
