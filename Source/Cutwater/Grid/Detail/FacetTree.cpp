#include <Cutwater/Grid/Detail/FacetTree.hpp>

#include <algorithm>

namespace cutwater::detail {

namespace {

/// An upper bound on the computed dot product of any two vectors in the boxes. Terms are added in
/// the same order, as rounding preserves the order of sums and products.
template <std::floating_point T>
T mostDot(const Box<T>& a, const Box<T>& b) {
  const auto along = [&](int i) {
    return std::max({a.lower[i] * b.lower[i], a.lower[i] * b.upper[i], a.upper[i] * b.lower[i],
                     a.upper[i] * b.upper[i]});
  };
  return along(0) + along(1) + along(2);
}

template <std::floating_point T>
Box<T> negated(const Box<T>& box) {
  return {-box.upper, -box.lower};
}

}  // namespace

template <std::floating_point T>
void FacetTree<T>::build() {
  nodes_.clear();
  if (!facets_.empty()) divide(0, facets_.size());
}

template <std::floating_point T>
std::size_t FacetTree<T>::divide(std::size_t begin, std::size_t end) {
  const auto number = nodes_.size();
  auto& node = nodes_.emplace_back();
  node.begin = begin;
  node.end = end;
  for (auto i = begin; i < end; ++i) {
    for (const auto& corner : facets_[i].corners) node.corners.extend(corner);
    node.normals.extend(facets_[i].normal);
  }
  if (end - begin <= kLeaf) return number;
  // Halves it along its longest side, or that of the box of normals, which have length 1.
  const auto size = node.corners.size();
  int axis = 0;
  for (int i = 1; i < 3; ++i) axis = size[i] > size[axis] ? i : axis;
  const auto middle = begin + (end - begin) / 2;
  const auto first = facets_.begin();
  const auto at = [&](std::size_t place) { return first + static_cast<std::ptrdiff_t>(place); };
  std::nth_element(at(begin), at(middle), at(end), [axis](const Facet& a, const Facet& b) {
    return a.corners[0][axis] + a.corners[1][axis] + a.corners[2][axis] <
           b.corners[0][axis] + b.corners[1][axis] + b.corners[2][axis];
  });
  divide(begin, middle);
  const auto upper = divide(middle, end);
  nodes_[number].upper = upper;
  return number;
}

template <std::floating_point T>
bool FacetTree<T>::mayFace(const Node& a, const Node& b, T side, T least) {
  if (!(-mostDot(a.normals, negated(b.normals)) < kFacing)) return false;
  const auto mayBeBefore = [&](const Node& from, const Node& of) {
    const Box<T> offsets{from.corners.lower - of.corners.upper,
                         from.corners.upper - of.corners.lower};
    return mostDot(side > 0 ? of.normals : negated(of.normals), offsets) > least;
  };
  return mayBeBefore(a, b) && mayBeBefore(b, a);
}

/// Whether two facets face each other, with their fronts if side is 1 or their backs if it is -1,
/// and are at least `least` apart somewhere.
template <std::floating_point T>
bool FacetTree<T>::face(const Facet& a, const Facet& b, T side, T least) {
  if (!(dot(a.normal, b.normal) < kFacing)) return false;
  const auto isBefore = [&](const Facet& from, const Facet& of) {
    return std::ranges::any_of(from.corners, [&](const Vec3<T>& corner) {
      return side * dot(of.normal, corner - of.corners[0]) > least;
    });
  };
  return isBefore(a, b) && isBefore(b, a);
}

template class FacetTree<float>;
template class FacetTree<double>;

}  // namespace cutwater::detail
