#pragma once

#include <Cutwater/Mesh/MeshSDF.hpp>

#include <numbers>
#include <vector>

namespace cutwater::test {

/// Winding numbers by the definition: solid angles by van Oosterom and Strackee's formula, summed
/// triangle by triangle in `long double`.
class WindingOracle {
 public:
  /// Of the triangles as the mesh has oriented them, in its own frame.
  template <typename T>
  explicit WindingOracle(const MeshSDF<T>& mesh) {
    for (std::uint32_t id = 0; id < mesh.triangleCount(); ++id) {
      const auto t = mesh.triangle(id);
      triangles_.push_back({Vec3<Real>(t[0]), Vec3<Real>(t[1]), Vec3<Real>(t[2])});
    }
  }

  template <typename T>
  [[nodiscard]] double at(const Vec3<T>& point) const {
    const Vec3<Real> p(point);
    Real sum = 0;
    for (const auto& t : triangles_) {
      const auto a = t[0] - p;
      const auto b = t[1] - p;
      const auto c = t[2] - p;
      const Real la = std::sqrt(dot(a, a));
      const Real lb = std::sqrt(dot(b, b));
      const Real lc = std::sqrt(dot(c, c));
      sum += std::atan2(dot(a, cross(b, c)),
                        la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return static_cast<double>(sum / (2 * std::numbers::pi_v<Real>));
  }

 private:
  using Real = long double;

  std::vector<std::array<Vec3<Real>, 3>> triangles_;
};

}  // namespace cutwater::test
