#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Lattice/CellMappings.hpp>

namespace cutwater {

namespace {

bool isPositive(double value) {
  return value > 0 && std::isfinite(value);
}

/// Maps the unit square to the unit disc.
Vec3<double> onUnitDisc(const Vec3<double>& u) {
  const double a = 2 * u.x - 1;
  const double b = 2 * u.y - 1;
  return {a * std::sqrt(1 - b * b / 2), b * std::sqrt(1 - a * a / 2), 0};
}

/// Distance of a sphere from its tangent plane, at this distance from the point of contact. In this
/// form, the radius may be infinite.
double sag(double radius, double distance) {
  const double ratio = distance / radius;
  return distance * ratio / (1 + std::sqrt(std::max(0.0, 1 - ratio * ratio)));
}

}  // namespace

BoxMapping::BoxMapping(const Box<double>& box) : box_(box) {
  const auto size = box.size();
  require(isFinite(box) && size.x > 0 && size.y > 0 && size.z > 0,
          "BoxMapping: need a finite box with some size along each axis", Named{"lower", box.lower},
          Named{"upper", box.upper});
}

Vec3<double> BoxMapping::operator()(const Vec3<double>& u) const {
  const auto size = box_.size();
  return box_.lower + Vec3<double>{u.x * size.x, u.y * size.y, u.z * size.z};
}

PipeMapping::PipeMapping(const PipeSegment& pipe) : pipe_(pipe) {
  require(pipe.innerRadius > 0 && pipe.innerRadius < pipe.outerRadius &&
              std::isfinite(pipe.outerRadius),
          "PipeMapping: need 0 < inner radius < outer radius < infinity",
          Named{"inner", pipe.innerRadius}, Named{"outer", pipe.outerRadius});
  require(isPositive(pipe.length), "PipeMapping: need a length that is positive and finite",
          Named{"length", pipe.length});
  const double turn = pipe.toDegrees - pipe.fromDegrees;
  require(turn > 0 && turn <= 360, "PipeMapping: need angles that ascend by at most 360 degrees",
          Named{"from", pipe.fromDegrees}, Named{"to", pipe.toDegrees});
}

Vec3<double> PipeMapping::operator()(const Vec3<double>& u) const {
  const double radius = (1 - u.x) * pipe_.innerRadius + u.x * pipe_.outerRadius;
  RigidTransform<double> turn;  // multiples of 90 degrees are exact
  turn.rotate((1 - u.y) * pipe_.fromDegrees + u.y * pipe_.toDegrees, 2);
  return turn.toWorld({radius, 0, u.z * pipe_.length});
}

std::array<bool, 3> PipeMapping::closedAxes() const {
  return {false, pipe_.toDegrees - pipe_.fromDegrees == 360, false};
}

CylinderMapping::CylinderMapping(double radius, double length) : radius_(radius), length_(length) {
  require(isPositive(radius) && isPositive(length),
          "CylinderMapping: need a radius and a length that are positive and finite",
          Named{"radius", radius}, Named{"length", length});
}

Vec3<double> CylinderMapping::operator()(const Vec3<double>& u) const {
  return radius_ * onUnitDisc(u) + Vec3<double>{0, 0, u.z * length_};
}

LensMapping::LensMapping(const Lens& lens) : lens_(lens) {
  require(isPositive(lens.diameter) && isPositive(lens.centerThickness),
          "LensMapping: need a diameter and a thickness that are positive and finite",
          Named{"diameter", lens.diameter}, Named{"thickness", lens.centerThickness});
  const double rim = lens.diameter / 2;
  require(std::abs(lens.frontRadius) >= rim && std::abs(lens.backRadius) >= rim,
          "LensMapping: need radii of curvature of at least half the diameter",
          Named{"front", lens.frontRadius}, Named{"back", lens.backRadius});
  const double thickness =
      lens.centerThickness - sag(lens.frontRadius, rim) - sag(lens.backRadius, rim);
  require(thickness > 0, "LensMapping: need faces that do not meet before the rim",
          Named{"thickness there", thickness});
}

Vec3<double> LensMapping::operator()(const Vec3<double>& u) const {
  const auto place = lens_.diameter / 2 * onUnitDisc(u);
  const double distance = length(place);
  const double front = -lens_.centerThickness / 2 + sag(lens_.frontRadius, distance);
  const double back = lens_.centerThickness / 2 - sag(lens_.backRadius, distance);
  return place + Vec3<double>{0, 0, (1 - u.z) * front + u.z * back};
}

}  // namespace cutwater
