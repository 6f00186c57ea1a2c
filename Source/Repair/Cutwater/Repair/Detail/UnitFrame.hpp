#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <cmath>

namespace cutwater::detail {

/// The map to coordinates of magnitude about 1 and back; its scaling is exact.
class UnitFrame {
 public:
  /// For a box that is not a point.
  explicit UnitFrame(const Box<double>& box)
      : center_(box.center()), size_(std::exp2(std::ceil(std::log2(box.diagonal())))) {}

  [[nodiscard]] double size() const { return size_; }
  void moveInside(PolygonSoup& soup) const {
    for (auto& p : soup.points) p = (1 / size_) * (p - center_);
  }
  void moveOutside(PolygonSoup& soup) const {
    for (auto& p : soup.points) p = center_ + size_ * p;
  }

 private:
  Vec3<double> center_;
  double size_;
};

}  // namespace cutwater::detail
