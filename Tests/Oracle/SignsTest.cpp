// Signs, without a band of rounding in which they may be wrong: against CGAL's exact predicates.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <filesystem>

#include "Oracle/CgalOracle.hpp"
#include "Oracle/Nasties.hpp"
#include "Oracle/Probes.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

/// Whether a value says what is true; the surface itself counts as outside.
template <typename T>
bool isRight(T value, Side side) {
  return side == Side::Inside ? value < 0 : value >= 0 && !std::signbit(value);
}

/// The number of wrong signs at hard probes; tells the first few.
template <typename T, typename Oracle>
int wrongSigns(const MeshSDF<T>& mesh, const PolygonSoup& soup, const Oracle& oracle, int count) {
  Probes probes(soup, 21);
  int wrong = 0;
  for (int i = 0; i < count; ++i) {
    const auto p = Vec3<T>(probes.nextHard());
    const T value = mesh.signedDistance(p);
    const auto side = oracle.side(Vec3<double>(p));
    if (isRight(value, side)) continue;
    if (++wrong > 3) continue;
    ADD_FAILURE() << std::hexfloat << p << std::defaultfloat << " has the value " << value
                  << ", but is " << (side == Side::Inside ? "inside" : "on or outside");
  }
  return wrong;
}

// Quick, or 10^7 probes: see the long test in CMakeLists.txt.
TEST(SignsTest, AreNeverWrongOnRealMeshes) {
  int meshes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CUTWATER_CGAL_MESHES)) {
    SCOPED_TRACE(entry.path().filename());
    PolygonSoup soup;
    try {
      soup = triangulated(readSurface(entry.path().string()).soup);
    } catch (const Error&) {
      continue;  // a few files are broken on purpose
    }
    if (soup.polygonCount() == 0) continue;
    const CgalOracle oracle(soup);
    if (!oracle.boundsSolid()) continue;
    const MeshSDF<double> mesh(soup);
    EXPECT_TRUE(mesh.signReport().isSound()) << mesh.signReport().summary();
    EXPECT_EQ(wrongSigns(mesh, soup, oracle, scaled(5'000)), 0);
    ++meshes;
  }
  RecordProperty("meshes", meshes);
  EXPECT_GE(meshes, 60);
}

class NastySignsTest : public ::testing::TestWithParam<Nasty> {
 protected:
  template <typename T>
  static void expectExactSigns(const PolygonSoup& soup, int count) {
    const MeshSDF<T> mesh(soup);
    ASSERT_TRUE(mesh.signReport().isClosed());
    const CgalOracle oracle(soup);
    if (oracle.boundsSolid()) {
      EXPECT_EQ(wrongSigns(mesh, soup, oracle, count), 0);
      // Where sheets are so close that the check takes them for one, winding numbers decide.
      const MeshSDF<T> nearest(soup, {.signs = SignScheme::NearestFeature});
      EXPECT_EQ(wrongSigns(nearest, soup, oracle, count), 0);
    }
    EXPECT_EQ(wrongSigns(mesh, soup, WindingOracle(soup), count / 10), 0);
  }
};

TEST_P(NastySignsTest, AreNeverWrong) {
  const auto soup = triangulated(GetParam().make());
  expectExactSigns<double>(soup, scaled(2'000));
  expectExactSigns<double>(moved(soup, anyPlacement()), scaled(2'000));
  expectExactSigns<double>(moved(soup, farPlacement(soup.boundingBox())), scaled(1'000));
}

TEST_P(NastySignsTest, AreNeverWrongInFloat) {
  const auto soup = triangulated(GetParam().make());
  for (auto rounded : {snapped(soup), snapped(moved(soup, anyPlacement()))}) {
    weldExactly(rounded);
    expectExactSigns<float>(rounded, scaled(1'000));
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, NastySignsTest, ::testing::ValuesIn(nastyAndRealSolids()),
                         [](const auto& nasty) { return std::string(nasty.param.name); });

}  // namespace
}  // namespace cutwater::test
