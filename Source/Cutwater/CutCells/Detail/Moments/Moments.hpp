#pragma once

#include <Cutwater/Core/Vec3.hpp>

namespace cutwater {

/// A sum of areas or volumes and their moments about a point nearby.
class Moments {
 public:
  explicit Moments(const Vec3<double>& about) : about_(about) {}

  void add(double size, const Vec3<double>& centroid) {
    if (size_ == 0) only_ = centroid;
    size_ += size;
    moment_ += size * (centroid - about_);
  }
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] Vec3<double> centroid() const {
    return size_ > 0 ? about_ + moment_ / size_ : only_;
  }

 private:
  Vec3<double> about_;
  Vec3<double> only_;
  double size_ = 0;
  Vec3<double> moment_;
};

}  // namespace cutwater
