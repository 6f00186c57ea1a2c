#include <Cutwater/Bvh/Detail/LeafOrder.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/Detail/NeighborLimits.hpp>
#include <Cutwater/Lattice/PackedBed.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

template <std::floating_point T>
class PackedBed<T>::Tree {
 public:
  explicit Tree(std::span<const Ball<T>> balls)
      : size_(balls.size()), balls_(balls, boxesOf(balls)) {}

  [[nodiscard]] std::size_t size() const { return size_; }

  /// The ball with the least value, the first one where values tie; found sooner if that value is
  /// not above `limit`. `error`: that of a value.
  [[nodiscard]] Nearest nearest(const Vec3<T>& p, T limit, T error) const {
    Nearest best{.value = limit};
    balls_.nearest(Vec3<double>(p), double{limit}, 2 * double{error},
                   [&](std::span<const Ball<T>> balls, std::span<const std::uint32_t> ids) {
                     for (std::size_t i = 0; i < balls.size(); ++i) {
                       const T value = length(p - balls[i].center) - balls[i].radius;
                       if (value < best.value || (value == best.value && ids[i] < best.ball)) {
                         best = {ids[i], balls[i].center, value};
                       }
                     }
                     return double{best.value};
                   });
    if (best.ball == kNone && limit < Box<T>::kInf) return nearest(p, Box<T>::kInf, error);
    best.value += T(0);
    return best;
  }

  template <typename Visit>
  void forBallsIn(const Box<T>& box, const Visit& visit) const {
    const Box<double> query{Vec3<double>(box.lower), Vec3<double>(box.upper)};
    balls_.overlapping(OrientedBox<double>::of(query), visit);
  }

 private:
  static std::vector<Box<double>> boxesOf(std::span<const Ball<T>> balls) {
    require(!balls.empty(), "PackedBed: need a ball");
    std::vector<Box<double>> boxes;
    boxes.reserve(balls.size());
    for (const auto& [center, radius] : balls) {
      const Vec3<double> middle(center);
      const auto box = Box<double>{middle, middle}.grown(double{radius});
      require(radius > 0 && isFinite(box), "PackedBed: need finite centres and radii above 0",
              Named{"ball", boxes.size()}, Named{"center", center}, Named{"radius", radius});
      boxes.push_back(box);
    }
    return boxes;
  }

  std::size_t size_;
  detail::LeafOrder<Ball<T>> balls_;
};

template <std::floating_point T>
PackedBed<T>::PackedBed(std::span<const Ball<T>> balls)
    : tree_(std::make_shared<const Tree>(balls)), guarantee_(Guarantee<T>::exact(0)) {
  guarantee_.inside = Quality::LowerBound;
  for (const auto& [center, radius] : balls) {
    guarantee_.size = std::max(guarantee_.size, length(center) + radius);
    box_.extend(Box<T>{center, center}.grown(radius));
  }
  box_ = guarantee_.grown(box_);
}

template <std::floating_point T>
std::size_t PackedBed<T>::size() const {
  return tree_->size();
}

template <std::floating_point T>
auto PackedBed<T>::localNearest(const Vec3<T>& p) const -> Nearest {
  return tree_->nearest(p, Box<T>::kInf, guarantee_.error(length(p)));
}

template <std::floating_point T>
T PackedBed<T>::localSignedDistance(const Vec3<T>& p) const {
  return localNearest(p).value;
}

template <std::floating_point T>
void PackedBed<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                        std::span<T> distances) const {
  detail::valuesInTurn(points, distances, guarantee_, [this](const Vec3<T>& p, T limit) {
    return tree_->nearest(p, limit, guarantee_.error(length(p))).value;
  });
}

template <std::floating_point T>
Vec3<T> PackedBed<T>::localGradient(const Vec3<T>& p) const {
  return normalized(p - localNearest(p).center);
}

template <std::floating_point T>
SurfacePoint<T> PackedBed<T>::localClosestPoint(const Vec3<T>& p) const {
  const auto nearest = localNearest(p);
  auto found =
      detail::steppedPoint<T>([this](const Vec3<T>& q) { return localSignedDistance(q); }, p,
                              nearest.value, normalized(p - nearest.center), guarantee_);
  if (!found) return SignedDistanceFunction<T>::localClosestPoint(p);
  found->owner.face = nearest.ball;
  return *found;
}

template <std::floating_point T>
SurfaceOwner PackedBed<T>::localOwner(const Vec3<T>& p) const {
  return {.face = localNearest(p).ball};
}

template <std::floating_point T>
bool PackedBed<T>::localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const {
  const auto around = box.bounds();
  tree_->forBallsIn(around, [&](const Ball<T>& ball) {
    if (!around.overlaps(Box<T>{ball.center, ball.center}.grown(ball.radius))) return;
    const Solid<T> sphere = Sphere<T>(ball.center, ball.radius);
    visit(sphere, &sphere);
  });
  return true;
}

template class PackedBed<float>;
template class PackedBed<double>;

}  // namespace cutwater
