// A user's own arithmetic with the library's types, under the user's own flags. None of it may end
// up as a function that the linker could take for the library's: see Core/Inline.hpp. The result
// depends on the flags, so it is not printed.

#include <Cutwater/Bvh/LinearBVH.hpp>
#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Core/Segment.hpp>
#include <Cutwater/Lattice/Beam.hpp>

#include <array>

using cutwater::Box;
using cutwater::Interval;
using cutwater::Segment;
using cutwater::Vec3;

namespace {

template <typename T>
T everyOperation(Vec3<T> a, const Vec3<T>& b, T s) {
  a += s * b - b / s;
  a -= cross(a, b) * dot(a, b);
  a *= lengthSquared(a) - length(b);
  const Vec3<T> middle = Segment<T>{normalized(a), min(a, b)}.at(s);
  Box<T> box{max(-a, b), abs(b)};
  box.extend(middle).extend(Box<T>{a, b});
  box = box.grown(s).intersection({b, a});
  const Interval<T> interval = -Interval<T>{a.x, b.y}.grown(s);
  const bool known = isFinite(box) && box.contains(a) && interval.contains(s) && !box.empty();
  return known ? box.diagonal() : maxComponent(box.center() + box.size() + box.corner(5));
}

/// A primitive of the user's in the library's tree.
template <typename T>
struct Ball {
  Vec3<T> center;
  T radius;

  Box<T> boundingBox() const { return Box<T>{center, center}.grown(radius); }
  T distance(const Vec3<T>& p) const { return length(p - center) - radius; }
  bool crosses(const Segment<T>& s) const { return distance(s.at(T(0.5))) < 0; }
};

template <typename T>
T everyTreeQuery(const Vec3<T>& a, const Vec3<T>& b) {
  cutwater::LinearBVH<T, Ball<T>> balls({{a, 1}, {b, 2}});
  T sum = balls.nearest(a + b).distance;
  balls.refit({{b, 1}, {a, 2}});
  std::array<typename cutwater::LinearBVH<T, Ball<T>>::Nearest, 2> both;
  sum += static_cast<T>(balls.nearest(a + b, both)) * both[0].distance;
  const auto add = [&](const auto&) { return ++sum > 0; };
  balls.within(a, 3, add);
  balls.along({a, b}, add);
  balls.allHits({a, b}, add);
  sum += balls.anyHit({a, b}) ? T(1) : T(0);
  balls.overlapping({a, b}, [&](std::uint32_t ball) {
    sum += balls.primitives()[ball].radius;
    return true;
  });
  return sum;
}

/// A primitive of the library's: its trees are the library's, too.
template <typename Beam, typename T>
T everyQueryOf(std::vector<Beam> beams, const Vec3<T>& a) {
  cutwater::LinearBVH<T, Beam> tree(std::move(beams));
  tree.refit(tree.primitives());
  std::array<cutwater::NearestPrimitive<T>, 2> both;
  T sum = tree.nearest(a).distance + static_cast<T>(tree.nearest(a, both)) * both[0].distance;
  const auto add = [&](const auto&) { return ++sum > 0; };
  tree.within(a, 3, add);
  tree.along({a, both[0].distance * a}, add);
  tree.overlapping({a, a}, add);
  return sum;
}

template <typename T>
T everyBeam(const Vec3<T>& a, const Vec3<T>& b) {
  using namespace cutwater;
  return everyQueryOf<CapsuleBeam<T>>({{a, b, 1}, {b, a, 2}}, a) +
         everyQueryOf<ConeSphereBeam<T>>({{a, b, 1, 2}, {b, a, 2, 3}}, a) +
         everyQueryOf<CappedConeBeam<T>>({{a, b, 1, 2}, {b, a, 2, 3}}, a);
}

}  // namespace

float arithmetic(const Vec3<float>& a, const Vec3<float>& b) {
  return everyOperation(a, b, 0.5F) + everyTreeQuery(a, b) + everyBeam(a, b);
}
double arithmetic(const Vec3<double>& a, const Vec3<double>& b) {
  return everyOperation(a, b, 0.5) + everyTreeQuery(a, b) + everyBeam(a, b);
}
