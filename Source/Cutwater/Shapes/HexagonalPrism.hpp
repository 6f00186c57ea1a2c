#pragma once

#include <Cutwater/Shapes/Detail/Prismatic.hpp>

namespace cutwater {

/// A regular hexagonal prism between z = -height/2 and height/2, about the local z axis. All sides
/// are `inradius` away from the axis; two of them are normal to the y axis.
///
/// Exact: the plane is folded by the hexagon's symmetries so that the side at y = inradius is the
/// nearest.
/// @throws Error unless 0 < inradius < infinity and 0 < height < infinity.
template <std::floating_point T>
class HexagonalPrism final : public Prismatic<T> {
 public:
  HexagonalPrism(T inradius, T height);

 private:
  std::string localName() const override { return "Hexagonal prism"; }
  T sectionDistance(const Vec2<T>& p) const override;
  Vec2<T> sectionGradient(const Vec2<T>& p) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  T inradius_;
  T halfSide_;
};

extern template class HexagonalPrism<float>;
extern template class HexagonalPrism<double>;

}  // namespace cutwater
