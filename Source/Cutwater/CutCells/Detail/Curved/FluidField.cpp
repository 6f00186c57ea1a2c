#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>
#include <Cutwater/CutCells/Detail/Curved/SolidImages.hpp>
#include <Cutwater/Grid/Detail/VolumeSearch.hpp>
#include <Cutwater/Shapes/Plane.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace cutwater {

namespace {

template <std::floating_point T>
class SolidField final : public FluidField {
 public:
  SolidField(const Solid<T>& solid, FluidSide side, std::vector<std::string> patchNames)
      : SolidField(solid, side, std::move(patchNames), solid.guarantee()) {}
  SolidField(const Solid<T>& solid, FluidSide side, std::vector<std::string> patchNames,
             const Guarantee<T>& guarantee)
      : FluidField(
            {.steepness = double{guarantee.lipschitz.value_or(T(0))},
             .domain = {Vec3<double>(guarantee.domain.lower), Vec3<double>(guarantee.domain.upper)},
             .isSingle = std::is_same_v<T, float>,
             .isFlat = solid.template as<Plane<T>>() != nullptr,
             .patchNames = std::move(patchNames)}),
        solid_(solid),
        roundingPerLength_(double{guarantee.ulps} * double{std::numeric_limits<T>::epsilon()}),
        size_(guarantee.size),
        sign_(side == FluidSide::Outside ? 1 : -1) {}

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
    auto owner = solid_.owner(Vec3<T>(surfacePoint));
    // Images have the patches of the solid, one image after the other.
    const auto patches = static_cast<std::uint32_t>(patchNames().size());
    if (patches > 0) owner.patch %= patches;
    return owner;
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
  Surfaces surfacesIn(const Box<double>& box, std::size_t most) const override {
    Surfaces found;
    solid_.surfacesIn(ofSolid(box), [&](const Solid<T>& surface, const Solid<T>* operand) {
      if (&surface == &solid_ || found.size() > most) return;
      found.push_back({fluidBeside(surface, FluidSide::Outside), nullptr});
      if (operand != &surface) found.back().operand = fluidBeside(*operand, FluidSide::Outside);
    });
    return found;
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

class PlaneSection final : public FluidField {
 public:
  PlaneSection(const FluidField& field, double z)
      : FluidField(factsAt(field, z)), field_(field), z_(z) {}
  /// Of a field that it owns.
  PlaneSection(std::shared_ptr<const FluidField> field, double z) : PlaneSection(*field, z) {
    owned_ = std::move(field);
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
  Surfaces surfacesIn(const Box<double>& box, std::size_t most) const override {
    auto found = field_.surfacesIn(inPlane(box), most);
    const auto section = [&](std::shared_ptr<const FluidField>& field) {
      if (field) field = std::make_shared<const PlaneSection>(std::move(field), z_);
    };
    for (auto& surface : found) {
      section(surface.field);
      section(surface.operand);
    }
    return found;
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

  std::shared_ptr<const FluidField> owned_;
  const FluidField& field_;
  double z_;
};

constexpr std::size_t kMostInTile = 4000;
constexpr std::size_t kMostInRegion = 8 * kMostInTile;

/// The surfaces near a box are those in a region around it, which follows from the box alone: so
/// what is found of a face is the same in all tiles.
class FieldOfSurfaces final : public FluidField {
 public:
  explicit FieldOfSurfaces(const FluidField& field) : FluidField(field.facts()), field_(field) {}

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
  Surfaces surfacesIn(const Box<double>& box, std::size_t most) const override {
    return field_.surfacesIn(box, most);
  }
  bool knowsSurfaces() const override { return true; }
  std::vector<const FluidField*> surfacesNear(const Box<double>& box) const override {
    for (const auto& region : {blockAround(box, 2), blockAround(box, 0), box}) {
      const auto& surfaces = inRegion(region);
      if (surfaces.empty()) continue;
      std::vector<const FluidField*> near;
      for (const auto& surface : surfaces) {
        if (surface.mayMeet(box)) near.push_back(surface.field.get());
      }
      return near;
    }
    return {&field_};
  }

 private:
  using Region = std::array<double, 6>;  // lower and upper bounds

  /// A cube that holds the middle of a box, and what is around it. It is 2^wider to 2^(wider + 1)
  /// times as wide as the box's diagonal; so many boxes share it.
  [[nodiscard]] static Box<double> blockAround(const Box<double>& box, int wider) {
    constexpr double kLeast = 1e-12;  // of coordinates, so that blocks can be counted
    constexpr double kSmallest = 1e-100;
    const auto middle = box.center();
    const double least = std::max(kLeast * maxComponent(abs(middle)), kSmallest);
    const int exponent = std::ilogb(std::max(box.diagonal(), least)) + 1;
    const double width = std::ldexp(1.0, exponent + wider);
    Box<double> block;
    for (int axis = 0; axis < 3; ++axis) {
      const double n = std::floor(middle[axis] / width);
      block.lower[axis] = n * width;
      block.upper[axis] = (n + 1) * width;
    }
    return block.grown(std::ldexp(1.0, wider > 0 ? exponent : exponent - 1));
  }

  /// In an order of their own. None if the field tells none, or too many: a block is larger than
  /// the box for which fieldIn() was asked.
  [[nodiscard]] const Surfaces& inRegion(const Box<double>& box) const {
    const auto& [lower, upper] = box;
    const auto [known, isNew] =
        regions_.try_emplace({lower.x, lower.y, lower.z, upper.x, upper.y, upper.z});
    auto& surfaces = known->second;
    if (!isNew) return surfaces;
    surfaces = field_.surfacesIn(box, kMostInRegion);
    if (surfaces.size() > kMostInRegion) surfaces.clear();
    const auto key = [](const FluidField::Surface& surface) {
      return std::pair(surface.field->value({}), surface.field->value({1, 2, -3}));
    };
    std::ranges::sort(surfaces, {}, key);
    return surfaces;
  }

  const FluidField& field_;
  mutable std::map<Region, Surfaces> regions_;  // those that were asked for
};

}  // namespace

std::unique_ptr<const FluidField> fieldIn(const FluidField& field, const Box<double>& box) {
  const auto surfaces = field.surfacesIn(box, kMostInTile);
  if (surfaces.empty() || surfaces.size() > kMostInTile) return nullptr;
  return std::make_unique<const FieldOfSurfaces>(field);
}

std::unique_ptr<const FluidField> sectionAt(const FluidField& field, double z) {
  return std::make_unique<const PlaneSection>(field, z);
}

template <std::floating_point T>
std::shared_ptr<const FluidField> fluidBeside(const Solid<T>& solid, FluidSide side) {
  return std::make_shared<const SolidField<T>>(solid, side, solid.patchNames());
}

template <std::floating_point T>
std::shared_ptr<const FluidField> fluidBeside(const Solid<T>& solid, FluidSide side,
                                              const CutPeriod& period) {
  return std::make_shared<const SolidField<T>>(withImages(solid, period), side, solid.patchNames());
}

template std::shared_ptr<const FluidField> fluidBeside(const Solid<float>&, FluidSide);
template std::shared_ptr<const FluidField> fluidBeside(const Solid<double>&, FluidSide);
template std::shared_ptr<const FluidField> fluidBeside(const Solid<float>&, FluidSide,
                                                       const CutPeriod&);
template std::shared_ptr<const FluidField> fluidBeside(const Solid<double>&, FluidSide,
                                                       const CutPeriod&);

}  // namespace cutwater
