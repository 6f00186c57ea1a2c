#include <Cutwater/P4est/SharedGeometry.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/WriteSurface.hpp>

#include <fstream>

#include "Ranks.hpp"
#include "Support/Precisions.hpp"
#include "Support/SameMeshes.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class SharedGeometryTest : public ::testing::Test {
 protected:
  SharedGeometryTest() {
    if (ownRank() != 0) return;
    writeSurface(folder / "ball.stl", tessellation::icosphere(0.8, 3));
    MeshSDF<T>(tessellation::icosphere(0.8, 3)).save(folder / "ball.cutwater");
  }

  /// What the same throws on rank 0 by itself.
  static std::string errorAlone(const std::filesystem::path& path) {
    try {
      if (ownRank() == 0) {
        static_cast<void>(geometryFileInfo(path) ? MeshSDF<T>::open(path)
                                                 : MeshSDF<T>(readSurface(path).soup));
      }
    } catch (const Error& error) {
      return fromRank0(error.what());
    }
    return fromRank0("");
  }
  void expectRefused(const std::string& name) const {
    const auto text = expectAgreedError(
        ErrorKind::File, [&] { const SharedGeometry<T> shared(folder / name, MPI_COMM_WORLD); });
    EXPECT_EQ(text, errorAlone(folder / name));
    EXPECT_NE(text.find(name), std::string::npos) << text;
  }
  void writeFile(const std::string& name, const std::string& content) const {
    if (ownRank() == 0) std::ofstream(folder / name, std::ios::binary) << content;
  }

  const SharedFolder folder;
};
TYPED_TEST_SUITE(SharedGeometryTest, Precisions);

TYPED_TEST(SharedGeometryTest, AnswersAsOneOfTheRanksOwn) {
  using T = TypeParam;
  ReadOptions twice;
  twice.scale = 2;
  for (const int ranksPerCopy : {0, 2}) {
    const SharedGeometry<T> shared(this->folder / "ball.stl", MPI_COMM_WORLD,
                                   {.read = twice, .ranksPerCopy = ranksPerCopy});
    const MeshSDF<T> own(readSurface(this->folder / "ball.stl", twice).soup);
    expectSame(shared.mesh(), own);
  }
}

TYPED_TEST(SharedGeometryTest, TakesGeometryFiles) {
  using T = TypeParam;
  const SharedGeometry<T> shared(this->folder / "ball.cutwater", MPI_COMM_WORLD);
  expectSame(shared.mesh(), MeshSDF<T>::open(this->folder / "ball.cutwater"));
}

TYPED_TEST(SharedGeometryTest, OnlyRank0Makes) {
  using T = TypeParam;
  int made = 0;
  const SharedGeometry<T> shared(MPI_COMM_WORLD, [&] {
    ++made;
    return MeshSDF<T>(tessellation::icosphere(0.5, 2));
  });
  EXPECT_EQ(made, ownRank() == 0 ? 1 : 0);
  EXPECT_EQ(shared.mesh().triangleCount(), 320U);
}

TYPED_TEST(SharedGeometryTest, CopiesOutliveIt) {
  using T = TypeParam;
  std::optional<MeshSDF<T>> copy;
  {
    const SharedGeometry<T> shared(this->folder / "ball.stl", MPI_COMM_WORLD);
    copy.emplace(shared.mesh());
  }
  expectSame(*copy, MeshSDF<T>(readSurface(this->folder / "ball.stl").soup));
}

TYPED_TEST(SharedGeometryTest, ReadErrorsReachAllRanks) {
  using T = TypeParam;
  this->expectRefused("missing.stl");
  this->writeFile("noise.stl", "solid\nfacet normal 0 0 one\n");
  this->expectRefused("noise.stl");
  auto content = ownRank() == 0 ? contentOf(this->folder / "ball.cutwater") : "";
  this->writeFile("short.cutwater", content.substr(0, content.size() / 2));
  this->expectRefused("short.cutwater");
  if (ownRank() == 0) content[content.size() / 2] ^= 1;
  this->writeFile("bent.cutwater", content);
  this->expectRefused("bent.cutwater");
  const SharedGeometry<T> good(this->folder / "ball.stl",
                               MPI_COMM_WORLD);  // goes on after all that
  EXPECT_TRUE(good.mesh().signReport().isSound());
}

}  // namespace
}  // namespace cutwater::test
