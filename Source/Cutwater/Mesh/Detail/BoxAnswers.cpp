#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Mesh/Detail/BoxAnswers.hpp>
#include <Cutwater/Mesh/Detail/DcelIndex.hpp>
#include <Cutwater/Mesh/Detail/MeshIndex.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

// Words of a hint: the class plus one of all boxes within; the location of their triangles.
constexpr std::size_t kKnown = 0;
constexpr std::size_t kPlace = 1;

}  // namespace

template <std::floating_point T, typename Index>
auto BoxAnswers<T, Index>::scaled(const OrientedBox<T>& box) const
    -> std::optional<OrientedBox<double>> {
  constexpr double kTooLarge = 0x1p20;
  const double scale{surface().scale};
  OrientedBox<double> result;
  result.center = scale * Vec3<double>(box.center);
  for (std::size_t i = 0; i < 3; ++i) {
    result.halfAxis[i] = scale * Vec3<double>(box.halfAxis[i]);
  }
  result.slack = scale * double{box.slack};
  const double far = maxComponent(abs(result.center));
  // Cheaper than the radius, which is smaller.
  double size = result.slack;
  for (const auto& half : result.halfAxis) size += 2 * maxComponent(abs(half));
  if (far + size < kTooLarge) return result;
  if (!(far + result.radius() < kTooLarge)) return {};
  return result;
}

template <std::floating_point T, typename Index>
bool BoxAnswers<T, Index>::isJumpFree(const Box<double>& box) const {
  if (!index_.signJumps()) return true;
  // Where the sign flips as another triangle becomes the nearest is not known.
  return signs().scheme == SignScheme::WindingNumber && index_.isDecided(box);
}

template <std::floating_point T, typename Index>
bool BoxAnswers<T, Index>::isSteady(const Box<T>& box) const {
  if (!index_.signJumps()) return true;
  return signs().scheme == SignScheme::WindingNumber && index_.isSteady(scaled(box));
}

template <std::floating_point T, typename Index>
double BoxAnswers<T, Index>::gapTo(const OrientedBox<double>& box, double limit) const {
  const QueryBox query(box);
  double least = limit;
  index_.around(box, limit, [&](std::span<const std::uint32_t> ids) {
    for (const auto id : ids) {
      if (id == kNone) break;
      least = std::min(least, query.gap(query.toBox(surface().corners(id)), least));
    }
    return least;
  });
  return least;
}

template <std::floating_point T, typename Index>
Interval<T> BoxAnswers<T, Index>::bounds(const OrientedBox<T>& box) const {
  // The distance to the triangles changes at most as fast as the point moves, and is at most that
  // to any one of their points; the sign is whatever its own bound allows.
  auto promise = points_.guarantee();
  promise.lipschitz = T(1);
  const auto hit = points_.closestPoint(box.center);
  const auto range = detail::boundsAround(hit.distance, box, promise);
  T least = std::max({T(0), range.lower, -range.upper});
  T most = std::max(-range.lower, range.upper);
  if (const auto q = scaled(box)) {
    const double scale{surface().scale};
    const T rounding = 4 * promise.error(length(box.center) + box.radius());
    const auto reaches = q->distancesFrom(scale * Vec3<double>(hit.point));
    most = std::min(most, static_cast<T>(reaches.upper / scale) + rounding);
    const T distance = std::abs(hit.distance) + rounding;
    // Farther away the ball around the box is as good, and more triangles would compete.
    constexpr T kFar = 4;
    if (distance > box.innerRadius() && distance < kFar * box.radius()) {
      least =
          std::max(least, static_cast<T>(gapTo(*q, scale * double{distance}) / scale) - rounding);
    }
  }
  if (least > 0 && isJumpFree(scaled(box.bounds()))) {
    return hit.distance < 0 ? Interval<T>{-most, -least} : Interval<T>{least, most};
  }
  if (index_.signJumps()) return {-most, most};
  return {std::max(range.lower, -most), std::min(range.upper, most)};
}

template <std::floating_point T, typename Index>
std::optional<BoxClass> BoxAnswers<T, Index>::classUnlessClear(const OrientedBox<T>& box,
                                                               BoxHint* hint,
                                                               DefaultClass byDefault) const {
  BoxHint none;
  auto& words = (hint != nullptr ? hint : &none)->words;
  if (words[kKnown] != 0) return static_cast<BoxClass>(words[kKnown] - 1);
  const auto q = scaled(box);
  const auto overlap = q ? index_.overlapWith(*q, words[kPlace]) : BoxOverlap::Possible;
  if (overlap == BoxOverlap::Certain && signs().isSound()) return BoxClass::Cut;
  if (overlap == BoxOverlap::None && isJumpFree(q->bounds())) return {};
  if (overlap == BoxOverlap::Possible && q && signs().isSound() && QueryBox(*q).hasInside()) {
    return BoxClass::Unknown;  // only touched, within rounding: no value in it could tell more
  }
  return byDefault(box, hint);
}

template <std::floating_point T, typename Index>
BoxClass BoxAnswers<T, Index>::classOfClear(const OrientedBox<T>& box, const Vec3<T>& p,
                                            const Nearest& nearest, BoxHint* hint) const {
  const auto found = points_.side(p, nearest) < 0 ? BoxClass::Inside : BoxClass::Outside;
  if (hint == nullptr || index_.signJumps()) return found;
  // Boxes within this one get the same class if there is room even for their rounding.
  const auto q = scaled(box);
  const double room = std::sqrt(double{nearest.distanceSquared}) - 8 * double{nearest.error};
  const double rounding = 4 * q->slack + 0x1p-40 * (1 + maxComponent(abs(q->center)));
  if (room > 1.01 * q->radius() + rounding) {
    hint->words[kKnown] = static_cast<std::uint32_t>(found) + 1;
  }
  return found;
}

template <std::floating_point T, typename Index>
BoxClass BoxAnswers<T, Index>::classOf(const OrientedBox<T>& box, BoxHint* hint,
                                       DefaultClass byDefault) const {
  if (const auto known = classUnlessClear(box, hint, byDefault)) return *known;
  const Vec3<T> p = points_.scaled(box.center);
  return classOfClear(box, p, index_.nearest(p), hint);
}

template <std::floating_point T, typename Index>
void BoxAnswers<T, Index>::classesOf(std::span<const OrientedBox<T>> boxes,
                                     std::span<BoxClass> classes, std::span<BoxHint> hints,
                                     DefaultClass byDefault) const {
  const auto hint = [&](std::size_t i) { return hints.empty() ? nullptr : &hints[i]; };
  // Boxes that no triangle meets; their signs are queried together.
  Scratch<std::size_t, kBatch> clear;
  Scratch<Vec3<T>, kBatch> p;
  Scratch<Nearest, kBatch> nearest;
  for (std::size_t begin = 0; begin < boxes.size(); begin += kBatch) {
    const auto end = std::min(begin + kBatch, boxes.size());
    std::size_t count = 0;
    for (auto i = begin; i < end; ++i) {
      if (const auto known = classUnlessClear(boxes[i], hint(i), byDefault)) {
        classes[i] = *known;
      } else {
        clear[count] = i;
        p[count++] = points_.scaled(boxes[i].center);
      }
    }
    index_.nearest(p.first(count), nearest.first(count));
    for (std::size_t k = 0; k < count; ++k) {
      const auto i = clear[k];
      classes[i] = classOfClear(boxes[i], p[k], nearest[k], hint(i));
    }
  }
}

template <std::floating_point T, typename Index>
bool BoxAnswers<T, Index>::facetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const {
  const auto q = scaled(box);
  if (!q) return false;
  const QueryBox query(*q);
  constexpr double kTouching = std::numeric_limits<double>::min();
  index_.around(*q, kTouching, [&](std::span<const std::uint32_t> ids) {
    for (const auto id : ids) {
      if (id == kNone) break;
      if (query.isApart(query.toBox(surface().corners(id)))) continue;
      if (!visit(facet(id, query))) return 0.0;  // nothing is nearer than that
    }
    return kTouching;
  });
  return true;
}

template <std::floating_point T, typename Index>
SurfaceFacet<T> BoxAnswers<T, Index>::facet(std::uint32_t id, const QueryBox& box) const {
  const auto normalOf = [this](std::uint32_t triangle) {
    const auto [a, b, c] = surface().corners(triangle);
    return Vec3<T>(normalized(cross(b - a, c - a)));
  };
  SurfaceFacet<T> result{index_.triangle(id), normalOf(id), {}, surface().owner(id)};
  const auto corners = surface().corners(id);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto neighbour = surface().neighbours[id][i];
    const auto& first = corners[i];
    const auto& second = corners[(i + 1) % 3];
    if (neighbour == kNone || box.isApart(box.toBox({first, second, second}))) continue;
    result.across[i] = normalOf(neighbour);
  }
  return result;
}

template class BoxAnswers<float, MeshIndex<float>>;
template class BoxAnswers<double, MeshIndex<double>>;
template class BoxAnswers<float, DcelIndex<float>>;
template class BoxAnswers<double, DcelIndex<double>>;

}  // namespace cutwater
