// What moving and scaling a mesh must not change, on real meshes and on nasty ones.

#include <Cutwater/Mesh/MeshSDF.hpp>

#include "Oracle/Nasties.hpp"
#include "Oracle/Probes.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

class MotionsTest : public ::testing::TestWithParam<Nasty> {
 protected:
  const PolygonSoup soup_ = triangulated(GetParam().make());

  template <typename T>
  void expectScaledExactly(int exponent) const {
    const MeshSDF<T> mesh(soup_);
    const T factor = std::ldexp(T(1), exponent);
    const MeshSDF<T> other(withPoints(
        soup_, [&](const Vec3<double>& p) { return Vec3<double>(factor * Vec3<T>(p)); }));
    Probes probes(soup_, 31);
    for (int i = 0; i < scaled(200); ++i) {
      const auto p = Vec3<T>(i % 4 == 0 ? probes.next() : probes.nextHard());
      ASSERT_EQ(other.signedDistance(factor * p), factor * mesh.signedDistance(p)) << p;
    }
  }
};

TEST_P(MotionsTest, PowersOfTwoScaleEveryBit) {
  for (const int exponent : {-300, -40, 40, 300}) expectScaledExactly<double>(exponent);
  for (const int exponent : {-40, 30}) expectScaledExactly<float>(exponent);
}

TEST_P(MotionsTest, RigidMotionsChangeNoSignBeyondRounding) {
  const MeshSDF<double> mesh(soup_);
  const auto home = mesh.guarantee();
  for (const auto& placement : {anyPlacement(), farPlacement(soup_.boundingBox())}) {
    const MeshSDF<double> other(moved(soup_, placement));
    const auto away = other.guarantee();
    Probes probes(soup_, 32);
    for (int i = 0; i < scaled(500); ++i) {
      const auto p = i % 4 == 0 ? probes.next() : probes.nextHard();
      const auto q = placement.toWorld(p);
      const double before = mesh.signedDistance(p);
      const double after = other.signedDistance(q);
      // The error of either value; the roundings of vertices and point are less than a third one.
      const double band = home.error(length(p)) + 2 * away.error(length(q));
      ASSERT_LE(std::abs(std::abs(after) - std::abs(before)), band) << p;
      ASSERT_TRUE(std::abs(before) <= band || (after < 0) == (before < 0)) << p;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, MotionsTest, ::testing::ValuesIn(nastyAndRealSolids()),
                         [](const auto& solid) { return std::string(solid.param.name); });

}  // namespace
}  // namespace cutwater::test
