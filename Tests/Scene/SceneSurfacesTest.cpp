#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Cleaning/Clean.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Surface/WriteSurface.hpp>

#include "Scenes.hpp"

namespace cutwater::test {
namespace {

using Mesh = MeshSDF<double>;

class SceneSurfacesTest : public SceneTest {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(folder / "parts");
    auto open = triangulated(tessellation::box({-1, -0.5, 0}, {1, 2, 1.5}));
    writeSurface(folder / "parts/box.ply", open);
    open.corners.resize(open.corners.size() - 3);
    open.offsets.pop_back();
    open.patches.pop_back();
    writeSurface(folder / "open.off", open);
  }
  [[nodiscard]] PolygonSoup box(double scale = 1) const { return soupIn("parts/box.ply", scale); }
  /// With the patch called after the table.
  [[nodiscard]] PolygonSoup soupIn(const std::string& name, double scale = 1) const {
    auto soup = readSurface(folder / name, {.scale = scale}).soup;
    soup.patchNames = {"it"};
    return soup;
  }
};

TEST_F(SceneSurfacesTest, AreThoseOfTheLibrary) {
  const std::string mesh = "[it]\nmesh = \"parts/box.ply\"\n";
  expectSame(read(mesh), Mesh(box()));
  expectSame(read(mesh + "scale = 0.5"), Mesh(box(0.5)));
  const auto open = soupIn("open.off");
  const std::string openMesh = "[it]\nmesh = \"open.off\"\n";
  expectSame(read(openMesh), Mesh(open));
  expectSame(read(openMesh + "signs = \"nearest\""),
             Mesh(open, {.signs = SignScheme::NearestFeature}));
  EXPECT_NE(read(openMesh).describe(), read(openMesh + "signs = \"nearest\"").describe());
  EXPECT_TRUE(refusal("\n" + openMesh + "require_watertight = true", ErrorKind::Topology)
                  .starts_with("line 2: [it]: "));
  EXPECT_EQ(namesOf(scene::surfaceForms()), (std::vector<std::string>{"mesh", "prepared"}));
}

TEST_F(SceneSurfacesTest, HandOnHowSignsAreFound) {
  const auto solid = read(
      "[it]\nmesh = \"parts/box.ply\"\nsigns = \"winding\"\nfind_self_intersections = true\n"
      "probes = 7");
  const auto* const mesh = solid.as<Mesh>();
  ASSERT_NE(mesh, nullptr);
  EXPECT_EQ(mesh->signReport().scheme, SignScheme::WindingNumber);
  EXPECT_EQ(mesh->signReport().selfIntersections, 0U);
  EXPECT_EQ(mesh->signReport().probes,
            Mesh(box(), {.signs = SignScheme::WindingNumber, .probes = 7}).signReport().probes);
}

TEST_F(SceneSurfacesTest, MayBeCleaned) {
  auto soup = box();
  for (auto corner : {0U, 0U, 1U}) soup.corners.push_back(corner);  // a face without area
  soup.offsets.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  soup.patches.push_back(0);
  soup.points.push_back(soup.points[0] + Vec3<double>{1e-4, 0, 0});  // and one of two places
  for (auto& corner : soup.corners) {
    if (corner == 0) {
      corner = static_cast<std::uint32_t>(soup.points.size() - 1);
      break;
    }
  }
  writeSurface(folder / "dirty.off", soup);
  const std::string mesh = "[it]\nmesh = \"dirty.off\"\n";
  auto cleaned = soupIn("dirty.off");
  clean(cleaned, {.weldWithin = 1e-3});
  EXPECT_LT(cleaned.polygonCount(), soup.polygonCount());
  expectSame(read(mesh + "clean = true\nweld_within = 1e-3"), Mesh(cleaned));
  EXPECT_EQ(refusal(mesh + "weld_within = 1e-3"),
            "line 3: mesh: \"weld_within\" needs \"clean = true\"");
  EXPECT_EQ(refusal(mesh + "orient = false"), "line 3: mesh: \"orient\" needs \"clean = true\"");
}

/// What each key of cleaning does, by the options that it stands for.
TEST_F(SceneSurfacesTest, HandOnHowToClean) {
  auto twice = box();
  const auto count = twice.corners.size();
  for (std::size_t i = 0; i < count; i += 3) {  // each face, and its reverse
    for (const auto corner : {twice.corners[i], twice.corners[i + 2], twice.corners[i + 1]}) {
      twice.corners.push_back(corner);
    }
    twice.offsets.push_back(static_cast<std::uint32_t>(twice.corners.size()));
    twice.patches.push_back(0);
  }
  const auto inner = triangulated(tessellation::box({-0.5, 0, 0.5}, {0.5, 1, 1}));
  auto nested = box();
  for (const auto corner : inner.corners) {
    nested.corners.push_back(corner + static_cast<std::uint32_t>(nested.points.size()));
  }
  nested.points.insert(nested.points.end(), inner.points.begin(), inner.points.end());
  for (std::size_t i = 0; i < inner.polygonCount(); ++i) {
    nested.offsets.push_back(nested.offsets.back() + 3);
    nested.patches.push_back(0);
  }
  writeSurface(folder / "nested.off", nested);
  writeSurface(folder / "twice.off", twice);
  const auto expectCleaned = [&](const char* name, const std::string& keys,
                                 const CleanOptions& options) {
    SCOPED_TRACE(keys);
    auto soup = soupIn(name);
    clean(soup, options);
    const std::string text = "[it]\nmesh = \"" + std::string(name) + "\"\nclean = true\n";
    expectSame(read(text + keys), Mesh(soup));
  };
  expectCleaned("nested.off", "", {});
  expectCleaned("nested.off", "nested = \"cavities\"", {.nested = NestedShells::Cavities});
  expectCleaned("nested.off", "nested = \"solids\"", {.nested = NestedShells::Solids});
  expectCleaned("nested.off", "nested = \"cavities\"\norient = false",
                {.orient = false, .nested = NestedShells::Cavities});
  expectCleaned("twice.off", "opposite = \"keep\"", {.opposite = OppositeFaces::Keep});
  EXPECT_TRUE(refusal("[it]\nmesh = \"twice.off\"\nclean = true\nopposite = \"cancel\"",
                      ErrorKind::Topology)
                  .starts_with("line 1: [it]: "));  // nothing is left
}

TEST_F(SceneSurfacesTest, SeveralPatchesKeepTheNamesInTheFile) {
  auto two = box();
  two.patchNames = {"deck", "hull"};
  two.patches[3] = 1;
  writeSurface(folder / "two.obj", two);
  using Names = std::vector<std::string>;
  const std::string mesh = "[it]\nmesh = \"two.obj\"\n";
  EXPECT_EQ(read(mesh).patchNames(), (Names{"deck", "hull"}));
  EXPECT_EQ(read(mesh + "patch = \"ship\"").patchNames(), (Names{"ship/deck", "ship/hull"}));
}

TEST_F(SceneSurfacesTest, MayBePrepared) {
  const Mesh mesh(box());
  mesh.save(folder / "box.cutwater");
  expectSame(read("[it]\nprepared = \"box.cutwater\""), mesh);
  EXPECT_EQ(refusal("[it]\nprepared = \"box.cutwater\"\nscale = 2"),
            "line 3: prepared has no key \"scale\"");
  EXPECT_TRUE(refusal("[it]\nprepared = \"parts/box.ply\"").starts_with("line 1: [it]: "));
}

TEST_F(SceneSurfacesTest, TellTheLineOfFilesThatAreNotThere) {
  const auto message = refusal("\n\n[it]\nmesh = \"none.stl\"");
  EXPECT_TRUE(message.starts_with("line 3: [it]: " + (folder / "none.stl").string())) << message;
  EXPECT_EQ(refusal("[it]\nmesh = \"two\\nlines.stl\""),
            "line 2: \"mesh\" of mesh: need the name of a file, found \"two?lines.stl\"");
}

}  // namespace
}  // namespace cutwater::test
