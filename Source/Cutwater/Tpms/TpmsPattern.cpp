#include <Cutwater/Tpms/Detail/PatternBatch.hpp>

#include <numbers>

namespace cutwater {

/// In the order of TpmsKind. Third derivatives: F is a sum of waves |c| cos(k x + phase), whose
/// third derivatives in the direction u add up to at most sum |c| |k u|^3; the constant is the
/// greatest of this over all u. As the derivative is symmetric, it is no greater in three different
/// directions. Bounds are given as they were found; their proof leaves a margin, which is added
/// where they are used.
struct detail::PatternConstants {
  const char* name;
  double lipschitz;
  double slopeAlongAxis;
  double curvature;
  double thirdDerivative;
  double leastSlope;
  double meanSlope;
  Interval<double> range;
  std::array<double, 2> pinch;
  std::array<double, 2> inscribedRadius;  // in radians
};

namespace {

constexpr std::array<detail::PatternConstants, 10> kConstants{{
    {"gyroid",
     1.732051,
     1.41422,
     2,
     2.31,
     1.41,
     1.533,
     {-1.5, 1.5},
     {1.41421, 1.41421},
     {1.44, 1.44}},
    {"Schwarz P", 1.732051, 1, 1, 1.001, 0.999, 1.339, {-3, 3}, {1, 1}, {2.72, 2.72}},
    {"Schwarz D",
     1.224745,
     1,
     1.4142,
     2.05,
     0.999,
     1.059,
     {-1, 1},
     {0.70711, 0.70711},
     {1.36, 1.36}},
    {"Schwarz D, 4 terms",
     1.732051,
     1.41422,
     2,
     2.89,
     1.41,
     1.498,
     {-1.41422, 1.41422},
     {1, 1},
     {1.36, 1.36}},
    {"lidinoid",
     2.598076,
     2.0627,
     6,
     15.1,
     0.48,
     1.54,
     {-1.35, 1.15},
     {0.93683, 0.17394},
     {0.86, 0.76}},
    {"split-P",
     3.620074,
     2.4351,
     7.6,
     18.3,
     1.26,
     2.38,
     {-1.8, 1.81},
     {1.37047, 0.97047},
     {1.03, 0.78}},
    {"Neovius", 7, 7, 7, 7.79, 0.999, 2.89, {-13, 13}, {0.75, 0.75}, {2.60, 2.60}},
    {"Schoen IWP", 5.196152, 5.1962, 8, 12.01, 3.37, 4.35, {-5, 3}, {3, 3}, {1.79, 1.34}},
    {"Schoen F-RD", 7.04069, 7.0407, 12, 24.3, 2.54, 3.74, {-7, 2}, {1, 1.09821}, {1.75, 1.36}},
    {"Fischer-Koch S",
     2.443973,
     2.1852,
     4.44,
     11.6,
     1.2,
     1.80,
     {-1.41422, 1.41422},
     {0.74917, 0.74917},
     {0.95, 0.95}},
}};

}  // namespace

TpmsPattern TpmsPattern::gyroid() {
  return TpmsPattern(detail::TpmsKind::Gyroid);
}
TpmsPattern TpmsPattern::schwarzP() {
  return TpmsPattern(detail::TpmsKind::SchwarzP);
}
TpmsPattern TpmsPattern::schwarzD() {
  return TpmsPattern(detail::TpmsKind::SchwarzD);
}
TpmsPattern TpmsPattern::schwarzD4() {
  return TpmsPattern(detail::TpmsKind::SchwarzD4);
}
TpmsPattern TpmsPattern::lidinoid() {
  return TpmsPattern(detail::TpmsKind::Lidinoid);
}
TpmsPattern TpmsPattern::splitP() {
  return TpmsPattern(detail::TpmsKind::SplitP);
}
TpmsPattern TpmsPattern::neovius() {
  return TpmsPattern(detail::TpmsKind::Neovius);
}
TpmsPattern TpmsPattern::iwp() {
  return TpmsPattern(detail::TpmsKind::Iwp);
}
TpmsPattern TpmsPattern::frd() {
  return TpmsPattern(detail::TpmsKind::Frd);
}
TpmsPattern TpmsPattern::fischerKochS() {
  return TpmsPattern(detail::TpmsKind::FischerKochS);
}

std::vector<TpmsPattern> TpmsPattern::all() {
  return {gyroid(), schwarzP(), schwarzD(), schwarzD4(), lidinoid(),
          splitP(), neovius(),  iwp(),      frd(),       fischerKochS()};
}

const detail::PatternConstants& TpmsPattern::constants() const {
  return kConstants[static_cast<std::size_t>(kind_)];
}

std::string TpmsPattern::name() const {
  return constants().name;
}

template <std::floating_point T>
T TpmsPattern::value(const Vec3<T>& inCells) const {
  return detail::samplePattern(kind_, inCells).value;
}

template <std::floating_point T>
TpmsSample<T> TpmsPattern::sample(const Vec3<T>& inCells) const {
  return detail::samplePattern(kind_, inCells);
}

double TpmsPattern::lipschitz() const {
  // Branch and bound ends within 6e-6 of the maximum, for IWP within 1e-4.
  return constants().lipschitz + (kind_ == detail::TpmsKind::Iwp ? 1e-4 : 7e-6);
}

double TpmsPattern::slopeAlongAxis() const {
  return std::min(constants().slopeAlongAxis + 1e-4, lipschitz());
}

double TpmsPattern::curvature() const {
  return 1.05 * constants().curvature;  // certain to 4 %
}

Interval<double> TpmsPattern::range() const {
  return constants().range;
}

double TpmsPattern::thirdDerivative() const {
  return constants().thirdDerivative;
}

double TpmsPattern::leastSlope() const {
  return constants().leastSlope;
}

double TpmsPattern::meanSlope() const {
  return constants().meanSlope;
}

double TpmsPattern::pinch(TpmsChannel channel) const {
  return constants().pinch[static_cast<std::size_t>(channel)];
}

double TpmsPattern::inscribedRadius(TpmsChannel channel) const {
  return constants().inscribedRadius[static_cast<std::size_t>(channel)] / (2 * std::numbers::pi);
}

template float TpmsPattern::value(const Vec3<float>&) const;
template double TpmsPattern::value(const Vec3<double>&) const;
template TpmsSample<float> TpmsPattern::sample(const Vec3<float>&) const;
template TpmsSample<double> TpmsPattern::sample(const Vec3<double>&) const;

}  // namespace cutwater
