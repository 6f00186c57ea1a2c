#include <Cutwater/Grid/Detail/UnresolvedCell.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cutwater::detail {

namespace {

/// Whether the corners whose bits are set are connected along edges of the cell.
bool areConnected(unsigned corners) {
  unsigned reached = corners & -corners;
  for (unsigned before = 0; before != reached;) {
    before = reached;
    // Takes one step along each axis.
    const unsigned x = (reached & 0x55U) << 1U | (reached & 0xaaU) >> 1U;
    const unsigned y = (reached & 0x33U) << 2U | (reached & 0xccU) >> 2U;
    const unsigned z = (reached & 0x0fU) << 4U | (reached & 0xf0U) >> 4U;
    reached |= (x | y | z) & corners;
  }
  return reached == corners;
}

}  // namespace

template <std::floating_point T>
auto UnresolvedCell<T>::find(bool isCut) -> std::optional<Finding> {
  const bool isHidden = signs_.inside == 0 || signs_.inside == 0xffU;
  if (isHidden && !isCut && isOnlyTouched()) return {};
  Finding result{.isSolid = signs_.inside == 0};
  if (isHidden) {
    result.kind = hiddenKind();
  } else {
    if (!isMultiCut(result.isSolid)) return {};
    result.kind = UnresolvedKind::MultiCut;
  }
  const auto& thickest = signs_.thickest;
  if (result.kind == UnresolvedKind::MultiCut && thickest.distance != 0) {
    result.depth = 2 * std::abs(thickest.distance);  // the middle is half as far away
    result.point = thickest.middle;
    // An edge may pass through walls and slits alternately, whatever the signs at its ends.
    result.isSolid = thickest.distance < 0;
    return result;
  }
  // Once nothing can be narrower, the rest is not looked at.
  const auto isSettled = [&] { return !isHidden && measured_ > 0 && result.depth == 0; };
  for (std::size_t e = 0; e < kCellEdges.size() && !isSettled(); ++e) {
    walkEdge(e);
    measure(isHidden, result);
  }
  if (!isSettled()) samplePoints();
  measure(isHidden, result);
  if (count_ == 0) result.point = box_.center();
  if (isHidden && !isCut && !(result.depth > 0)) return {};
  return result;
}

template <std::floating_point T>
bool UnresolvedCell<T>::isOnlyTouched() const {
  return solid_.classify(box_.grown(-skin())) ==
         (signs_.inside == 0 ? BoxClass::Outside : BoxClass::Inside);
}

template <std::floating_point T>
void UnresolvedCell<T>::walkEdge(std::size_t number) {
  if (signs_.crossings[number] == 0) return;
  const auto& edge = kCellEdges[number];
  solid_.crossings({box_.corner(edge.from), box_.corner(edge.to())},
                   [&](const Crossing<T>& crossing) {
                     note(crossing.point, crossing.normal);
                     return count_ < kMostPoints;
                   });
}

template <std::floating_point T>
void UnresolvedCell<T>::measure(bool isHidden, Finding& result) {
  // A hidden part is as deep as its deepest place; between sheets the narrowest place counts.
  for (; measured_ < count_; ++measured_) {
    const bool isFirst = measured_ == 0;
    const T reach = reachFrom(measured_, result.isSolid);
    if (!isFirst && isHidden && reach <= result.depth) continue;
    const T most = isFirst || isHidden ? reach : std::min(reach, result.depth);
    const T depth = depthAt(measured_, result.isSolid, most);
    if (!isFirst && (isHidden ? depth <= result.depth : depth >= result.depth)) continue;
    result.depth = depth;
    result.point = points_[measured_];
  }
}

template <std::floating_point T>
UnresolvedKind UnresolvedCell<T>::hiddenKind() const {
  if (std::ranges::any_of(signs_.crossings, [](auto n) { return n > 0; })) {
    return UnresolvedKind::Thin;
  }
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
bool UnresolvedCell<T>::isMultiCut(bool& isSolid) const {
  // If the fluid's corners are not connected, there is fluid on two sides of the solid: a wall.
  isSolid = !areConnected(~signs_.inside & 0xffU);
  if (isSolid || !areConnected(signs_.inside)) return true;
  const auto twice = std::ranges::find_if(signs_.crossings, [](auto n) { return n > 1; });
  if (twice == signs_.crossings.end()) return false;
  const auto place = static_cast<std::size_t>(twice - signs_.crossings.begin());
  isSolid = !signs_.isInside(kCellEdges[place].from);
  return true;
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
    // Alternates between the surface and the cell: where they meet, the two points converge.
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
T UnresolvedCell<T>::reachFrom(std::size_t point, bool isSolid) const {
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
  return reach;
}

template <std::floating_point T>
T UnresolvedCell<T>::depthAt(std::size_t point, bool isSolid, T most) const {
  if (!(most > skin())) return 0;
  const Vec3<T> direction = isSolid ? -normals_[point] : normals_[point];
  const Vec3<T> from = max(box_.lower, min(box_.upper, points_[point]));
  T depth = most;
  solid_.crossings({from + skin() * direction, from + most * direction},
                   [&](const Crossing<T>& crossing) {
                     depth = skin() + crossing.parameter * (most - skin());
                     return false;
                   });
  // Where the surface only touches the cell's faces, there is nothing behind the point.
  const T within = solid_.signedDistance(from + depth / 2 * direction);
  return within != 0 && (within < 0) == isSolid ? depth : 0;
}

template class UnresolvedCell<float>;
template class UnresolvedCell<double>;

}  // namespace cutwater::detail
