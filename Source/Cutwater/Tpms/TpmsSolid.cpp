#include <Cutwater/Core/Detail/Batches.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Tpms/Detail/LevelDistances.hpp>
#include <Cutwater/Tpms/Detail/NumericalGradient.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

namespace cutwater {

namespace {

/// In the order of TpmsPart.
template <std::floating_point T>
constexpr std::array<detail::PartTerms<T>, 6> kTerms{{
    {.absolute = 1, .plain = 0, .level = -1, .half = 0},
    {.absolute = -1, .plain = 0, .level = 1, .half = 0},
    {.absolute = 0, .plain = -1, .level = 1, .half = 0},
    {.absolute = 0, .plain = 1, .level = 1, .half = 0},
    {.absolute = 1, .plain = 0, .level = -1, .half = -1},
    {.absolute = 1, .plain = 0, .level = -1, .half = 1},
}};
constexpr std::array<const char*, 6> kNames{"Wall",      "Channels",  "Channel A",
                                            "Channel B", "Wall in A", "Wall in B"};

template <std::floating_point T>
const detail::PartTerms<T>& termsOf(TpmsPart part) {
  return kTerms<T>[static_cast<std::size_t>(part)];
}

/// Levels between which the part is intact.
template <std::floating_point T>
Interval<T> levelsOf(TpmsPart part, const TpmsField<T>& field) {
  const auto a = static_cast<T>(field.pinch(TpmsChannel::A));
  const auto b = static_cast<T>(field.pinch(TpmsChannel::B));
  switch (part) {
    case TpmsPart::ChannelA:
      return {-b, a};
    case TpmsPart::ChannelB:
      return {-a, b};
    case TpmsPart::WallInA:
      return {0, a};
    case TpmsPart::WallInB:
      return {0, b};
    default:
      return {0, std::min(a, b)};
  }
}

/// Where F = h: the function is as smooth as F, while distances to a part follow from F and its
/// gradient. It changes no faster than they do.
template <std::floating_point T>
class LevelSurface final : public SignedDistanceFunction<T> {
 public:
  /// `guarantee`: of distances to such a surface.
  LevelSurface(TpmsField<T> field, T level, const Guarantee<T>& guarantee)
      : field_(std::move(field)),
        level_(level),
        scale_(1 / field_.steepness()),
        guarantee_(guarantee) {}

 private:
  T localSignedDistance(const Vec3<T>& p) const override {
    return scale_ * (level_ - field_.value(p));
  }
  Vec3<T> localGradient(const Vec3<T>& p) const override { return -scale_ * field_.gradient(p); }
  Guarantee<T> localGuarantee() const override { return guarantee_; }

  TpmsField<T> field_;
  T level_;
  T scale_;
  Guarantee<T> guarantee_;
};

}  // namespace

template <std::floating_point T>
TpmsSolid<T>::TpmsSolid(TpmsField<T> field, TpmsPart part, GradedValue<T> level)
    : field_(std::move(field)),
      part_(part),
      level_(std::move(level)),
      guarantee_(field_.guarantee(level_)) {
  require(level_.guarantee().domain == Box<T>::everywhere(),
          "TpmsSolid: need levels that are known everywhere");
  const auto allowed = levelsOf(part, field_);
  require(level_.least() > allowed.lower && level_.most() < allowed.upper,
          "TpmsSolid: need levels between those at which a wall vanishes or a channel breaks up",
          Named{"least level", level_.least()}, Named{"most level", level_.most()},
          Named{"from", allowed.lower}, Named{"to", allowed.upper});
}

template <std::floating_point T>
T TpmsSolid<T>::localSignedDistance(const Vec3<T>& p) const {
  return field_.distance(termsOf<T>(part_), level_, p);
}

template <std::floating_point T>
void TpmsSolid<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                        std::span<T> distances) const {
  constexpr std::size_t kMost = detail::LevelBatch<T>::kMost;
  detail::forBatches(points.size(), kMost, [&](std::size_t first, std::size_t count) {
    field_.distances(termsOf<T>(part_), level_, points.subspan(first, count),
                     distances.subspan(first, count));
  });
}

template <std::floating_point T>
Vec3<T> TpmsSolid<T>::localGradient(const Vec3<T>& p) const {
  const auto value = [this](const Vec3<T>& q) { return localSignedDistance(q); };
  return detail::numericalGradient(value, p, field_.map().size());
}

template <std::floating_point T>
bool TpmsSolid<T>::localSurfacesIn(const OrientedBox<T>&, SurfaceVisitor<T> visit) const {
  if (!field_.isUniform() || !level_.isConstant()) return false;
  const T level = level_.least();
  const auto add = [&](T h) {
    const Solid<T> side = LevelSurface<T>(field_, h, guarantee_);
    visit(side, nullptr);
  };
  switch (part_) {
    case TpmsPart::ChannelA:
      add(level);
      break;
    case TpmsPart::ChannelB:
      add(-level);
      break;
    case TpmsPart::WallInA:
      add(0);
      add(level);
      break;
    case TpmsPart::WallInB:
      add(0);
      add(-level);
      break;
    default:
      add(level);
      add(-level);
  }
  return true;
}

template <std::floating_point T>
Interval<T> TpmsSolid<T>::localBounds(const OrientedBox<T>& box, BoxHint* hint) const {
  const auto around = SignedDistanceFunction<T>::localBounds(box, hint);
  if (!field_.isUniform() || around.lower > 0 || around.upper < 0) return around;
  const auto within = field_.distancesIn(termsOf<T>(part_), level_, box);
  return {std::max(around.lower, within.lower), std::min(around.upper, within.upper)};
}

template <std::floating_point T>
std::string TpmsSolid<T>::localName() const {
  return std::string(kNames[static_cast<std::size_t>(part_)]) + " of a " + field_.name();
}

template class TpmsSolid<float>;
template class TpmsSolid<double>;

}  // namespace cutwater
