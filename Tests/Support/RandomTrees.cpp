#include "Support/RandomTrees.hpp"

#include <Cutwater/Shapes/BoxFrame.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/CappedTorus.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cone.hpp>
#include <Cutwater/Shapes/ConeSphere.hpp>
#include <Cutwater/Shapes/ConvexPolyhedron.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Ellipsoid.hpp>
#include <Cutwater/Shapes/Extrusion.hpp>
#include <Cutwater/Shapes/HexagonalPrism.hpp>
#include <Cutwater/Shapes/InfiniteCone.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Link.hpp>
#include <Cutwater/Shapes/Octahedron.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Pyramid.hpp>
#include <Cutwater/Shapes/Revolution.hpp>
#include <Cutwater/Shapes/RoundedBox.hpp>
#include <Cutwater/Shapes/RoundedCylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <array>

#include "Support/CountedSolid.hpp"

namespace cutwater::test {

template <std::floating_point T>
Vec3<T> RandomTrees<T>::point(double extent) {
  const T x = number(-extent, extent);
  const T y = number(-extent, extent);
  return {x, y, number(-extent, extent)};
}

template <std::floating_point T>
Vec3<T> RandomTrees<T>::direction() {
  if (below(3) > 0) return point(1) + Vec3<T>{0, 0, T(1.25)};
  Vec3<T> axis;
  axis[below(3)] = below(2) == 0 ? T(1) : T(-1);
  return axis;
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::roundShape(int kind) {
  const auto a = point(0.4);
  const auto b = a + number(0.5, 1.25) * normalized(direction());
  const T radius = number(0.2, 0.6);
  switch (kind) {
    case 0:
      return Sphere<T>(a, 2 * radius);
    case 1:
      return Torus<T>(a, direction(), number(0.5, 0.75), T(0.75) * radius);
    case 2:
      return Cylinder<T>(a, b, radius);
    case 3:
      return Capsule<T>(a, b, radius);
    case 4:
      return ConeSphere<T>(a, b, radius, number(0, 0.5));
    case 5:
      return CappedCone<T>(a, b, radius, number(0, 0.5));
    case 6:
      return Cone<T>(a, b, radius);
    default:
      return RoundedCylinder<T>(a, b, radius, number(0.25, 0.95) * std::min(radius, T(0.25)));
  }
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::centredShape(int kind) {
  const T size = number(0.5, 1);
  const T thin = number(0.125, 0.25) * size;
  const Vec3<T> half{size, number(0.5, 1), number(0.5, 1)};
  switch (kind) {
    case 0:
      return Ellipsoid<T>({}, half);
    case 1:
      return BoxFrame<T>({-half, half}, thin);
    case 2:
      return CappedTorus<T>(size, thin, number(10, 85));
    case 3:
      return Link<T>(number(0.25, 1), size, thin);
    case 4:
      return HexagonalPrism<T>(size, half.y);
    case 5:
      return Octahedron<T>(size);
    case 6:
      return Pyramid<T>(size, half.y);
    case 7:
      return ConvexPolyhedron<T>({{{half.x, 0, 0}, {1, 0, 0}},
                                  {{-half.x, 0, 0}, {-1, 0, T(0.25)}},
                                  {{0, half.y, 0}, {T(0.25), 1, 0}},
                                  {{0, -half.y, 0}, {0, -1, 0}},
                                  {{0, 0, half.z}, {T(0.25), 0, 1}},
                                  {{0, 0, -half.z}, {0, T(0.5), -1}}});
    default: {
      // An L, as a bar or about the axis.
      const Polygon<T> section(
          {{thin, -size}, {half.y, -size}, {half.y, thin - size}, {2 * thin, size}, {thin, size}});
      if (kind == 8) return Extrusion<T>(section, -half.z, half.z);
      return Revolution<T>(section);
    }
  }
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::unboundedShape(int kind) {
  const auto a = point(0.5);
  switch (kind) {
    case 0:
      return Plane<T>(a, direction());
    case 1:
      return InfiniteCylinder<T>(a, direction(), number(0.25, 0.75));
    case 2:
      return InfiniteCone<T>(a, direction(), number(10, 70));
    default: {
      // A gyroid of gradient at most 1.
      const T k = number(2, 4);
      const auto value = [k, a](const Vec3<T>& p) {
        const auto q = k * (p - a);
        const T sum = std::sin(q.x) * std::cos(q.y) + std::sin(q.y) * std::cos(q.z) +
                      std::sin(q.z) * std::cos(q.x);
        return sum / (2 * k);
      };
      const auto bound = Quality::LowerBound;
      return FunctionSDF(value, Guarantee<T>{.outside = bound,
                                             .inside = bound,
                                             .lipschitz = T(1),
                                             .continuous = true,
                                             .ulps = 16,
                                             .size = 2});
    }
  }
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::shape() {
  ++leaves_;
  if (asked_ == nullptr) return anyShape();
  return CountedSolid<T>(anyShape(), asked_);
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::anyShape() {
  const int kind = below(26);
  if (kind >= 16) return translated(centredShape(kind - 16), point(0.4));
  if (kind < 8) return roundShape(kind);
  if (kind < 12) return unboundedShape(kind - 8);
  const auto lower = point(0.75);
  const auto upper = lower + Vec3<T>{number(0.25, 1.5), number(0.25, 1.5), number(0.25, 1.5)};
  if (kind < 14) return Cuboid<T>(lower, upper);
  return RoundedBox<T>(lower, upper, number(0.02, 0.12));
}

template <std::floating_point T>
Smoothing<T> RandomTrees<T>::smoothing() {
  const auto kind = static_cast<SmoothKind>(below(4));
  const double most = kind == SmoothKind::Exponential ? 0.2 : 0.75;
  return {.reach = number(0.02, most), .kind = kind};
}

template <std::floating_point T>
AffineMap<T> RandomTrees<T>::map() {
  AffineMap<T> result;
  for (int i = 0; i < 3; ++i) {
    auto& column = result.columns[static_cast<std::size_t>(i)];
    column = below(2) == 0 ? Vec3<T>{} : point(0.3);
    column[i] += number(0.75, 1.5) * (below(4) == 0 ? T(-1) : T(1));
  }
  result.offset = point(0.25);
  return result;
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::combination(int depth) {
  const auto a = first(depth);
  const auto b = other(depth);
  switch (below(6)) {
    case 0:
      return a | b;
    case 1:
      return a & b;
    case 2:
      return a - b;
    case 3:
      return b - a;
    case 4:
      return a ^ b;
    default:
      return blended(a, b, number(0, 1));
  }
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::smoothCombination(int depth) {
  const auto a = first(depth);
  const auto b = other(depth);
  switch (below(5)) {
    case 0:
      return smoothUnion(a, b, smoothing());
    case 1:
      return smoothIntersection(a, b, smoothing());
    case 2:
      return smoothDifference(a, b, smoothing());
    case 3:
      return smoothUnionOf(std::vector<Solid<T>>{a, b, other(depth)}, smoothing());
    default:
      return smoothIntersectionOf(std::vector<Solid<T>>{a, b, other(depth)}, smoothing());
  }
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::manyOperands(int depth) {
  // Enough for a tree over their boxes, few enough that describe() tells all.
  const auto a = first(depth);
  std::vector<Solid<T>> all{named(a, "first")};
  for (int i = 1; i < 16; ++i) {
    all.push_back(translated(Solid<T>(Sphere<T>(point(0.25), number(0.05, 0.35))), point(1)));
    ++leaves_;
  }
  switch (below(3)) {
    case 0:
      return unionOf(all);
    case 1:
      return smoothUnionOf(all, smoothing());
    default: {
      for (std::size_t i = 1; i < all.size(); ++i) all[i] = ~all[i];
      return intersectionOf(all);
    }
  }
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::motion(int depth) {
  const auto a = first(depth);
  switch (below(5)) {
    case 0:
      return translated(a, point(0.5));
    case 1:
      return rotated(a, number(-180, 180), below(3));
    case 2:
      return rotated(a, T(90), below(3));
    case 3:
      return rotated(a, number(-180, 180), direction(), point(0.5));
    default:
      return named(translated(rotated(a, number(-180, 180), below(3)), point(0.5)), "moved");
  }
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::image(int depth) {
  const auto a = first(depth);
  const auto factor = number(0.5, 1.75);
  switch (below(4)) {
    case 0:
      return scaled(a, below(3) == 0 ? -factor : factor);
    case 1:
      return mirrored(a, direction(), point(0.5));
    case 2:
      return inverted(a);
    default:
      return transformed(a, map());
  }
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::grown(int depth) {
  const auto a = first(depth);
  switch (below(4)) {
    case 0:
      return offset(a, number(-0.15, 0.3));
    case 1:
      return offset(a, number(0.02, 0.2));
    case 2:
      return ~a;
    default:
      return shell(a, number(0.05, 0.2));
  }
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::pointMap(int depth) {
  const int before = leaves_;
  const auto a = first(depth);
  switch (below(3)) {
    case 0:
      return elongated(a, abs(point(0.5)));
    case 1:
      return folded(a, direction(), point(0.5));
    default: {
      leaves_ += leaves_ - before;
      return unfolded(a, direction(), point(0.5));
    }
  }
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::repetition(int depth) {
  const auto a = first(depth);
  const auto box = a.boundingBox();
  Repeats<T> repeats;
  for (int axis = 0; axis < 3; ++axis) {
    const T size = box.upper[axis] - box.lower[axis];
    if (!(size > T(1e-3)) || !std::isfinite(size) || below(3) == 0) continue;
    repeats.period[axis] = number(0.7, 1.5) * size;
    repeats.count[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(below(4));
  }
  if (repeats.period == Vec3<T>{}) return ~a;
  return repeated(a, repeats);
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::userFunction(int depth) {
  const auto a = first(depth);
  const T frequency = number(1, 5);
  const T amplitude = number(0.01, 0.15);
  const T slope = amplitude * frequency * T(1.0001);
  if (below(2) == 0) {
    ++leaves_;
    const auto h = [=](const Vec3<T>& p) { return amplitude * std::sin(frequency * p.x); };
    return displaced(a, h, {.lipschitz = slope, .amplitude = amplitude});
  }
  const auto v = [=](const Vec3<T>& p) {
    return Vec3<T>{amplitude * std::sin(frequency * p.z), 0, 0};
  };
  return warped(a, v, {.lipschitz = slope, .amplitude = amplitude});
}

template <std::floating_point T>
Solid<T> RandomTrees<T>::tree(int depth) {
  if (depth == 0) return shape();
  static constexpr std::array<Maker, 9> kMakers{
      &RandomTrees::combination, &RandomTrees::smoothCombination,
      &RandomTrees::motion,      &RandomTrees::manyOperands,
      &RandomTrees::image,       &RandomTrees::grown,
      &RandomTrees::pointMap,    &RandomTrees::repetition,
      &RandomTrees::userFunction};
  return (this->*kMakers[static_cast<std::size_t>(below(9))])(depth);
}

template class RandomTrees<float>;
template class RandomTrees<double>;

}  // namespace cutwater::test
