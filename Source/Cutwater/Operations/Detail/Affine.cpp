#include <Cutwater/Core/Detail/DomainUnder.hpp>
#include <Cutwater/Core/Detail/Epsilon.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Detail/Affine.hpp>

#include <algorithm>

#include <Eigen/LU>
#include <Eigen/SVD>

namespace cutwater {

namespace {

using detail::kEps;

// Computed in this type and rounded to double or float, the inverse of a map that is not close to
// singular is exact to the last place.
using Accurate = long double;
using Matrix = Eigen::Matrix<Accurate, 3, 3>;

template <std::floating_point T>
Matrix toEigen(const AffineMap<T>& map) {
  Matrix result;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) result(i, j) = map.columns[static_cast<std::size_t>(j)][i];
  }
  return result;
}

Accurate greatestStretch(const Matrix& m) {
  return Eigen::JacobiSVD<Matrix>(m).singularValues()(0);
}

}  // namespace

template <std::floating_point T>
Affine<T>::Affine(Solid<T> operand, const AffineMap<T>& map)
    : PointMap<T>(std::move(operand)), map_(map) {
  for (const auto& column : map.columns) {
    require(isFinite(column), "transformed: need a finite map", Named{"column", column});
  }
  require(isFinite(map.offset), "transformed: need a finite map", Named{"offset", map.offset});
  const Matrix forward = toEigen(map);
  const Matrix inverse = forward.inverse();
  const bool isInvertible = inverse.allFinite();
  const Accurate back = isInvertible ? greatestStretch(inverse) : 0;
  const double condition = static_cast<double>(greatestStretch(forward) * back);
  require(isInvertible && condition >= 0.5 && condition < 1 / (64 * static_cast<double>(kEps<T>)),
          "transformed: need a map that is not singular", Named{"condition number", condition});
  condition_ = static_cast<T>(condition);
  leastStretch_ = static_cast<T>(1 / back) * (1 - 4 * kEps<T>);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      inverse_.columns[static_cast<std::size_t>(j)][i] = static_cast<T>(inverse(i, j));
    }
  }
}

template <std::floating_point T>
Vec3<T> Affine<T>::mapped(const Vec3<T>& p) const {
  return inverse_.direction(p - map_.offset);
}

template <std::floating_point T>
OrientedBox<T> Affine<T>::image(const OrientedBox<T>& box) const {
  OrientedBox<T> result;
  result.center = mapped(box.center);
  for (std::size_t i = 0; i < 3; ++i) {
    result.halfAxis[i] = inverse_.direction(box.halfAxis[i]);
  }
  const T size = length(box.center) + box.radius() + length(map_.offset);
  result.slack = (box.slack + 24 * kEps<T> * size) / leastStretch_;
  return result;
}

template <std::floating_point T>
bool Affine<T>::isRectangular(const OrientedBox<T>& box) {
  return dot(box.halfAxis[0], box.halfAxis[1]) == 0 && dot(box.halfAxis[1], box.halfAxis[2]) == 0 &&
         dot(box.halfAxis[2], box.halfAxis[0]) == 0;
}

template <std::floating_point T>
OrientedBox<T> Affine<T>::mapped(const OrientedBox<T>& box) const {
  const auto result = image(box);
  return isRectangular(result) ? result : OrientedBox<T>::of(result.bounds());
}

template <std::floating_point T>
Vec3<T> Affine<T>::pulledBack(const Vec3<T>&, const Vec3<T>& gradient) const {
  return inverse_.transposed(gradient);
}

template <std::floating_point T>
CrossingCount Affine<T>::localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const {
  const Segment<T> image{mapped(segment.start), mapped(segment.end)};
  return this->operand().crossings(image, [&](Crossing<T> crossing) {
    crossing.point = segment.at(crossing.parameter);
    crossing.normal = normalized(inverse_.transposed(crossing.normal));
    return visit(crossing);
  });
}

template <std::floating_point T>
BoxClass Affine<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  const auto imageOfBox = image(box);
  if (!isRectangular(imageOfBox)) return PointMap<T>::localClassify(box, hint);
  const auto byValues = SignedDistanceFunction<T>::localClassify(box, hint);
  return byValues != BoxClass::Unknown ? byValues : this->classOf(this->operand(), imageOfBox);
}

template <std::floating_point T>
Guarantee<T> Affine<T>::localGuarantee() const {
  auto promise = this->operand().guarantee();
  promise.outside = std::min(promise.outside, Quality::LowerBound);
  promise.inside = std::min(promise.inside, Quality::LowerBound);
  // The difference, products and sums move the point by less than 8 eps / leastStretch; the earlier
  // rounding of the inverse counts if the map is close to singular.
  const T ofInverse =
      static_cast<T>(std::numeric_limits<Accurate>::epsilon() / Accurate{kEps<T>}) * condition_;
  promise.ulps += 2 + (8 + 16 * ofInverse) * promise.lipschitz.value_or(T(1));
  promise.size = promise.size * leastStretch_ + length(map_.offset);
  AffineMap<T> back = inverse_;
  back.offset = -inverse_.direction(map_.offset);
  promise.domain = detail::domainUnder(map_, back, promise.domain);
  return promise;
}

template <std::floating_point T>
Box<T> Affine<T>::localBoundingBox() const {
  // An error of the value moves the surface by as much where A stretches least, and by `condition`
  // times as much where it stretches most.
  auto promise = localGuarantee();
  promise.ulps *= condition_;
  return promise.grown(map_(this->operand().boundingBox()));
}

template class Affine<float>;
template class Affine<double>;

}  // namespace cutwater
