#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Shapes/Detail/PlanarEdge.hpp>

namespace cutwater::detail {

int sideOfLine(const Vec2<double>& a, const Vec2<double>& b, const Vec2<double>& p) {
  const double left = (b.x - a.x) * (p.y - a.y);
  const double right = (b.y - a.y) * (p.x - a.x);
  const double size = std::abs(left) + std::abs(right);
  // Five roundings of half an ulp each (Shewchuk's filter has a smaller allowance).
  if (std::abs(left - right) > 0x1p-50 * size) return left > right ? 1 : -1;
  const auto exactly = DoubleDouble::difference(b.x, a.x) * DoubleDouble::difference(p.y, a.y) -
                       DoubleDouble::difference(b.y, a.y) * DoubleDouble::difference(p.x, a.x);
  if (abs(exactly) <= 0x1p-98 * size) return 0;
  return exactly > 0.0 ? 1 : -1;
}

template <std::floating_point T>
PlanarEdge<T>::PlanarEdge(const Vec2<T>& start, const Vec2<T>& end) : start_(start), end_(end) {
  const double x = double{end.x} - double{start.x};
  const double y = double{end.y} - double{start.y};
  const double length = std::hypot(x, y);
  along_ = {static_cast<T>(x / length), static_cast<T>(y / length)};
  length_ = static_cast<T>(length);
}

template <std::floating_point T>
int PlanarEdge<T>::side(const Vec2<T>& p) const {
  const auto exactly = [](const Vec2<T>& v) { return Vec2<double>{double{v.x}, double{v.y}}; };
  return sideOfLine(exactly(start_), exactly(end_), exactly(p));
}

template <std::floating_point T>
auto PlanarEdge<T>::foot(const Vec2<T>& p) const -> Foot {
  const Vec2<T> fromStart = p - start_;
  const T along = dot(fromStart, along_);
  if (0 < along && along < length_) {
    const T beyond = cross(fromStart, along_);
    return {std::abs(beyond), beyond * outward(), true};
  }
  const Vec2<T> gap = along <= 0 ? fromStart : p - end_;
  return {length(gap), gap, false};
}

template <std::floating_point T>
Box<T> PlanarEdge<T>::boundingBox() const {
  const Vec3<T> a{start_.x, start_.y, 0};
  const Vec3<T> b{end_.x, end_.y, 0};
  return {min(a, b), max(a, b)};
}

template class PlanarEdge<float>;
template class PlanarEdge<double>;

}  // namespace cutwater::detail
