#include <Cutwater/Grid/UnresolvedCell.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cutwater::detail {

namespace {

/// Whether the corners that have a bit are connected along edges of the cube.
bool areConnected(unsigned corners) {
  unsigned reached = corners & -corners;
  for (unsigned before = 0; before != reached;) {
    before = reached;
    // One step along each axis.
    const unsigned x = (reached & 0x55U) << 1U | (reached & 0xaaU) >> 1U;
    const unsigned y = (reached & 0x33U) << 2U | (reached & 0xccU) >> 2U;
    const unsigned z = (reached & 0x0fU) << 4U | (reached & 0xf0U) >> 4U;
    reached |= (x | y | z) & corners;
  }
  return reached == corners;
}

}  // namespace

template <std::floating_point T>
UnresolvedCell<T>::UnresolvedCell(const SignedDistanceFunction<T>& solid, const Box<T>& box,
                                  const std::array<T, 8>& corners)
    : solid_(solid), box_(box) {
  for (std::size_t i = 0; i < 8; ++i) inside_ |= (corners[i] < 0 ? 1U : 0U) << i;
}

template <std::floating_point T>
auto UnresolvedCell<T>::find(bool isCut) -> std::optional<Finding> {
  const bool isHidden = inside_ == 0 || inside_ == 0xffU;
  Finding result{.isSolid = inside_ == 0};
  if (isHidden) {
    result.kind = hiddenKind();
  } else {
    if (!isMultiCut(result.isSolid)) return {};
    result.kind = UnresolvedKind::MultiCut;
  }
  if (result.kind == UnresolvedKind::MultiCut && thickest_ > 0) {
    result.depth = thickest_;
    result.point = thickestAt_;
    return result;
  }
  samplePoints();
  for (std::size_t i = 0; i < count_; ++i) {
    const T depth = depthAt(i, result.isSolid);
    // What is hidden is as deep as its deepest place; between sheets the narrowest matters.
    if (i > 0 && (isHidden ? depth <= result.depth : depth >= result.depth)) continue;
    result.depth = depth;
    result.point = points_[i];
  }
  if (count_ == 0) result.point = box_.center();
  if (isHidden && !isCut && !(result.depth > 0)) return {};
  return result;
}

template <std::floating_point T>
bool UnresolvedCell<T>::mayMeet(const Box<T>& part) const {
  const auto kind = solid_.classify(part);
  return kind == BoxClass::Cut || kind == BoxClass::Unknown;
}

template <std::floating_point T>
std::size_t UnresolvedCell<T>::crossed(int corner, int axis) {
  const int other = corner | 1 << axis;
  const Segment<T> edge{box_.corner(corner), box_.corner(other)};
  if (isInside(corner) == isInside(other) && !mayMeet({edge.start, edge.end})) return 0;
  std::optional<T> last;
  const auto visit = [&](const Crossing<T>& crossing) {
    note(crossing.point, crossing.normal);
    if (last) noteStretch(edge, *last, crossing.parameter);
    last = crossing.parameter;
    return true;
  };
  return solid_.crossings(edge, visit).found;
}

template <std::floating_point T>
void UnresolvedCell<T>::noteStretch(const Segment<T>& edge, T first, T second) {
  const auto middle = edge.at((first + second) / 2);
  const T thickness = 2 * std::abs(solid_.signedDistance(middle));
  if (!(thickness > thickest_)) return;
  thickest_ = thickness;
  thickestAt_ = middle;
}

template <std::floating_point T>
UnresolvedKind UnresolvedCell<T>::hiddenKind() {
  std::size_t crossings = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 8; ++corner) {
      if ((corner >> axis & 1) == 0) crossings += crossed(corner, axis);
    }
  }
  if (crossings > 0) return UnresolvedKind::Thin;
  for (int axis = 0; axis < 3; ++axis) {
    for (const T side : {box_.lower[axis], box_.upper[axis]}) {
      auto face = box_;
      face.lower[axis] = face.upper[axis] = side;
      if (mayMeet(face)) return UnresolvedKind::Grazing;
    }
  }
  return UnresolvedKind::Thin;
}

template <std::floating_point T>
bool UnresolvedCell<T>::isMultiCut(bool& isSolid) {
  // Of a connected solid the fluid is on two sides: it is a wall.
  isSolid = !areConnected(~inside_ & 0xffU);
  bool found = isSolid || !areConnected(inside_);
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 8; ++corner) {
      if ((corner >> axis & 1) != 0 || crossed(corner, axis) < 2) continue;
      if (!found) isSolid = !isInside(corner);
      found = true;
    }
  }
  return found;
}

template <std::floating_point T>
void UnresolvedCell<T>::note(const Vec3<T>& point, const Vec3<T>& normal) {
  if (count_ == kMostPoints) return;
  points_[count_] = point;
  normals_[count_++] = normal;
}

template <std::floating_point T>
void UnresolvedCell<T>::samplePoints() {
  constexpr int kMostSteps = 4;
  const T margin = box_.diagonal() * T(0x1p-16);
  for (int n = 0; n < 27; ++n) {
    const auto part = [](int i) { return static_cast<T>(2 * i + 1) / 6; };
    const auto size = box_.size();
    auto p =
        box_.lower + Vec3<T>{size.x * part(n % 3), size.y * part(n / 3 % 3), size.z * part(n / 9)};
    // From the surface to the cell and back: where it meets the cell, both come together.
    for (int step = 0; step < kMostSteps; ++step) {
      const auto hit = solid_.closestPoint(p);
      if (!isFinite(hit.point)) break;
      if (box_.grown(margin).contains(hit.point)) {
        note(hit.point, hit.normal);
        break;
      }
      p = max(box_.lower, min(box_.upper, hit.point));
    }
  }
}

template <std::floating_point T>
T UnresolvedCell<T>::depthAt(std::size_t point, bool isSolid) const {
  const Vec3<T> direction = isSolid ? -normals_[point] : normals_[point];
  const Vec3<T> from = max(box_.lower, min(box_.upper, points_[point]));
  T reach = box_.diagonal();
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] > 0) {
      reach = std::min(reach, (box_.upper[axis] - from[axis]) / direction[axis]);
    } else if (direction[axis] < 0) {
      reach = std::min(reach, (box_.lower[axis] - from[axis]) / direction[axis]);
    }
  }
  // The point itself is off the surface by rounding.
  const T skipped = box_.diagonal() * T(0x1p-20);
  if (!(reach > skipped)) return 0;
  T depth = reach;
  solid_.crossings({from + skipped * direction, from + reach * direction},
                   [&](const Crossing<T>& crossing) {
                     depth = skipped + crossing.parameter * (reach - skipped);
                     return false;
                   });
  return depth;
}

template class UnresolvedCell<float>;
template class UnresolvedCell<double>;

}  // namespace cutwater::detail
