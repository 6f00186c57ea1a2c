#include <Cutwater/Core/AffineMap.hpp>
#include <Cutwater/Core/Detail/UnitVector.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/RigidTransform.hpp>

#include <numbers>

namespace cutwater {

namespace {

struct SineCosine {
  double sine;
  double cosine;
};

/// Sine and cosine of an angle in degrees; exactly 0 and +-1 at multiples of 90.
SineCosine sineCosine(double degrees) {
  const double turned = std::remainder(degrees, 360.0);  // exact, in [-180, 180]
  const double quarters = std::round(turned / 90.0);     // -2 .. 2
  const double rest = (turned - 90.0 * quarters) * (std::numbers::pi / 180.0);
  const double s = rest == 0 ? 0.0 : std::sin(rest);
  const double c = rest == 0 ? 1.0 : std::cos(rest);
  switch (static_cast<int>(quarters)) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case -1:
      return {-c, s};
    default:
      return {-s, -c};
  }
}

template <std::floating_point T>
Vec3<T> times(const std::array<Vec3<T>, 3>& columns, const Vec3<T>& v) {
  return v.x * columns[0] + v.y * columns[1] + v.z * columns[2];
}

/// Rodrigues' formula: R = c I + s [u]x + (1 - c) u u^T, column by column.
std::array<Vec3<double>, 3> rotationAbout(const Vec3<double>& u, double degrees) {
  const auto turn = sineCosine(degrees);
  const double s = turn.sine;  // not a structured binding: clang 14 cannot capture one
  const double c = turn.cosine;
  const auto column = [&](const Vec3<double>& e) {
    return c * e + s * cross(u, e) + (1 - c) * dot(u, e) * u;
  };
  return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

/// One Newton step towards the nearest orthogonal matrix, R (3 I - R^T R) / 2. Keeps the product of
/// thousands of small rotations orthogonal, and leaves a matrix that is already orthogonal
/// unchanged.
std::array<Vec3<double>, 3> orthonormalized(const std::array<Vec3<double>, 3>& r) {
  std::array<Vec3<double>, 3> result;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3<double> gram{dot(r[0], r[j]), dot(r[1], r[j]), dot(r[2], r[j])};
    result[j] = 1.5 * r[j] - 0.5 * times(r, gram);
  }
  return result;
}

template <typename To, typename From>
std::array<Vec3<To>, 3> cast(const std::array<Vec3<From>, 3>& m) {
  return {Vec3<To>(m[0]), Vec3<To>(m[1]), Vec3<To>(m[2])};
}

}  // namespace

template <std::floating_point T>
RigidTransform<T>::RigidTransform(const std::array<Vec3<T>, 3>& axes, const Vec3<T>& offset)
    : column_(axes), offset_(offset), rotated_(column_ != kUnrotated) {
  constexpr T kTolerance = 16 * std::numeric_limits<T>::epsilon();
  const auto is = [](T value, T wanted) { return std::abs(value - wanted) <= kTolerance; };
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& next = axes[(i + 1) % 3];
    require(is(lengthSquared(axes[i]), 1) && is(dot(axes[i], next), 0) &&
                is(dot(cross(axes[i], next), axes[(i + 2) % 3]), 1),
            "RigidTransform: need right-handed, orthonormal axes", Named{"axis", axes[i]},
            Named{"next", next});
  }
  require(isFinite(offset), "RigidTransform: need a finite offset", Named{"offset", offset});
}

template <std::floating_point T>
void RigidTransform<T>::translate(const Vec3<T>& offset) {
  require(isFinite(offset), "translate: need a finite offset", Named{"offset", offset});
  moveTo("translate", offset_ + offset);
}

template <std::floating_point T>
void RigidTransform<T>::rotate(T degrees, int axis) {
  require(axis >= 0 && axis <= 2, "rotate: need axis 0, 1 or 2", Named{"axis", axis});
  Vec3<T> direction;
  direction[axis] = 1;
  rotate(degrees, direction);
}

template <std::floating_point T>
void RigidTransform<T>::rotate(T degrees, const Vec3<T>& axis, const Vec3<T>& through) {
  require(std::isfinite(degrees), "rotate: need a finite angle", Named{"degrees", degrees});
  require(isFinite(through), "rotate: need a finite point", Named{"through", through});
  const auto direction = detail::unitVector("rotate", "axis", Vec3<double>(axis));
  const auto turn = rotationAbout(direction, static_cast<double>(degrees));
  auto turned = *this;  // stays as it was if the motion is refused
  turned.offset_ -= through;
  turned.applyRotation(cast<T>(turn));
  turned.moveTo("rotate", turned.offset_ + through);
  *this = turned;
}

template <std::floating_point T>
void RigidTransform<T>::moveTo(const char* motion, const Vec3<T>& offset) {
  if (!isFinite(offset)) {
    const std::string message =
        std::string(motion) + ": the motions add up to an offset that is not finite";
    require(false, message.c_str(), Named{"offset", offset});
  }
  offset_ = offset;
}

template <std::floating_point T>
void RigidTransform<T>::applyRotation(const Matrix& columns) {
  const auto turn = cast<double>(columns);
  auto product = cast<double>(column_);
  for (auto& column : product) column = times(turn, column);
  column_ = cast<T>(orthonormalized(product));
  offset_ = Vec3<T>(times(turn, Vec3<double>(offset_)));
  rotated_ = column_ != kUnrotated;
}

template <std::floating_point T>
Vec3<T> RigidTransform<T>::toLocal(const Vec3<T>& world) const {
  return directionToLocal(world - offset_);
}

template <std::floating_point T>
void RigidTransform<T>::toLocal(std::span<const Vec3<T>> world, std::span<Vec3<T>> local) const {
  for (std::size_t i = 0; i < world.size(); ++i) local[i] = world[i] - offset_;
  if (!rotated_) return;
  for (auto& p : local) p = directionToLocal(p);
}

template <std::floating_point T>
Vec3<T> RigidTransform<T>::toWorld(const Vec3<T>& local) const {
  return directionToWorld(local) + offset_;
}

template <std::floating_point T>
Vec3<T> RigidTransform<T>::directionToLocal(const Vec3<T>& world) const {
  if (!rotated_) return world;
  return {dot(column_[0], world), dot(column_[1], world), dot(column_[2], world)};
}

template <std::floating_point T>
Vec3<T> RigidTransform<T>::directionToWorld(const Vec3<T>& local) const {
  return rotated_ ? times(column_, local) : local;
}

template <std::floating_point T>
Box<T> RigidTransform<T>::toWorld(const Box<T>& local) const {
  return isIdentity() ? local : AffineMap<T>{column_, offset_}(local);
}

template <std::floating_point T>
RigidTransform<T> RigidTransform<T>::composed(const RigidTransform& first,
                                              const RigidTransform& second) {
  RigidTransform result = first;
  if (second.rotated_) result.applyRotation(second.column_);
  result.moveTo("composed", result.offset_ + second.offset_);
  return result;
}

template class RigidTransform<float>;
template class RigidTransform<double>;

}  // namespace cutwater
