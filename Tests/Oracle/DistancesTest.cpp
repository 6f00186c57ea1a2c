// Distances to nasty surfaces: against quadruple precision and all triangles.

#include <Cutwater/Mesh/MeshSDF.hpp>

#include "Oracle/Nasties.hpp"
#include "Oracle/Probes.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"
#include "Support/TriangleOracle.hpp"

namespace cutwater::test {
namespace {

/// The distance to all triangles; those whose sphere is too far are passed over.
class BruteForce {
 public:
  explicit BruteForce(const PolygonSoup& soup) {
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      const auto v = soup.polygon(i);
      Corners t{soup.points[v[0]], soup.points[v[1]], soup.points[v[2]]};
      const auto middle = (t[0] + t[1] + t[2]) / 3.0;
      const double radius =
          std::max({length(t[0] - middle), length(t[1] - middle), length(t[2] - middle)});
      all_.push_back({t, middle, radius});
    }
  }
  double distance(const Vec3<double>& p) const {
    Float128 best = std::numeric_limits<double>::max();
    double limit = std::numeric_limits<double>::max();
    for (const auto& [t, middle, radius] : all_) {
      if (length(p - middle) - radius > limit) continue;
      best = std::min(best, triangleDistanceExactly(p, t[0], t[1], t[2]));
      limit = static_cast<double>(best) + 1e-12 * (length(p) + length(middle) + radius);
    }
    return static_cast<double>(best);
  }

 private:
  using Corners = std::array<Vec3<double>, 3>;
  struct Bounded {
    Corners corners;
    Vec3<double> middle;
    double radius;
  };
  std::vector<Bounded> all_;
};

class DistancesTest : public ::testing::TestWithParam<Nasty> {
 protected:
  /// The largest error, in eps (|p| + |V|max).
  template <typename T>
  static double worstError(const PolygonSoup& soup, int count) {
    const MeshSDF<T> mesh(soup);
    const BruteForce oracle(soup);
    const double size{mesh.guarantee().size};
    Probes probes(soup, 41);
    double worst = 0;
    for (int i = 0; i < count; ++i) {
      auto q = i % 2 == 0 ? probes.next() : probes.nextHard();
      if (i % 8 == 0) q = 1e3 * q;
      const auto p = Vec3<T>(q);
      const Vec3<double> exact(p);
      const double error =
          std::abs(std::abs(double{mesh.signedDistance(p)}) - oracle.distance(exact));
      worst = std::max(worst, error / (length(exact) + size));
    }
    return worst / double{std::numeric_limits<T>::epsilon()};
  }
};

TEST_P(DistancesTest, AreWithinEightEps) {
  const auto soup = triangulated(GetParam().make());
  for (const auto& placed : {soup, moved(soup, anyPlacement())}) {
    EXPECT_LE(worstError<double>(placed, scaled(250)), 8);
  }
}

TEST_P(DistancesTest, AreWithinEightEpsInFloat) {
  const auto soup = triangulated(GetParam().make());
  for (const auto& placed : {snapped(soup), snapped(moved(soup, anyPlacement()))}) {
    EXPECT_LE(worstError<float>(placed, scaled(250)), 8);
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, DistancesTest, ::testing::ValuesIn(nasties()),
                         [](const auto& nasty) { return std::string(nasty.param.name); });

}  // namespace
}  // namespace cutwater::test
