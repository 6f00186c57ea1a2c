#include <tbb/global_control.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include "Peers/PseudonormalSign.hpp"

namespace cutwater::benchmarks {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

class Cgal final : public Peer {
 public:
  explicit Cgal(const PolygonSoup& soup) : sign_(soup) {
    triangles_.reserve(soup.polygonCount());
    for (const auto& [a, b, c] : cornersOf(soup)) {
      triangles_.emplace_back(toPoint(a), toPoint(b), toPoint(c));
    }
    tree_ = std::make_unique<Tree>(triangles_.begin(), triangles_.end());
    tree_->build();
    tree_->accelerate_distance_queries();
  }

  void signedDistances(std::span<const Vec3<double>> points,
                       std::span<double> distances) const override {
    for (std::size_t i = 0; i < points.size(); ++i) distances[i] = signedDistance(points[i]);
  }

 private:
  static Kernel::Point_3 toPoint(const Vec3<double>& p) { return {p.x, p.y, p.z}; }
  static Vec3<double> fromPoint(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

  [[nodiscard]] double signedDistance(const Vec3<double>& p) const {
    const auto found = tree_->closest_point_and_primitive(toPoint(p)).second;
    // Which vertex or edge the closest point lies on takes a second look at the triangle.
    const Corners corners{fromPoint((*found)[0]), fromPoint((*found)[1]), fromPoint((*found)[2])};
    return sign_.signedDistance(static_cast<std::size_t>(found - triangles_.begin()),
                                closestPoint(p, corners));
  }

  PseudonormalSign sign_;
  Triangles triangles_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace

std::unique_ptr<Peer> buildCgal(const PolygonSoup& triangles, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  return std::make_unique<Cgal>(triangles);
}

}  // namespace cutwater::benchmarks
