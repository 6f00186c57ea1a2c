#include <Cutwater/P4est/DistributedVtu.hpp>

#include <algorithm>
#include <array>

#include "Ranks.hpp"
#include "Support/OctreeMeshes.hpp"
#include "Support/ParsedVtk.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class DistributedVtuTest : public ::testing::Test {
 protected:
  DistributedVtuTest() {
    fill(solid, mesh.local(), {.distance = distance});
    for (const auto& cell : mesh.local().cells()) levels.push_back(cell.level);
  }

  [[nodiscard]] std::vector<VtkArray> arrays() const {
    return {{"distance", std::span<const T>(distance)},
            {"level", std::span<const std::uint8_t>(levels)}};
  }
  static DistributedOctree<T> made(const Solid<T>& solid, const OctreeDomain<T>& domain) {
    return DistributedOctree<T>(solid, domain, {.cut = 3}, MPI_COMM_WORLD);
  }
  /// Names of the pieces in the order of the file.
  static std::vector<std::string> piecesOf(const std::string& content) {
    std::vector<std::string> names;
    const std::string mark = "<Piece Source=\"";
    for (auto at = content.find(mark); at != std::string::npos; at = content.find(mark, at + 1)) {
      const auto begin = at + mark.size();
      names.push_back(content.substr(begin, content.find('"', begin) - begin));
    }
    return names;
  }

  const std::string type = sizeof(T) == 4 ? "Float32" : "Float64";
  const SharedFolder folder;
  const Solid<T> solid = ballAndPlate<T>();
  const OctreeDomain<T> domain{{T(-1.3), T(-1.2), T(-1.25)}, T(0.6), {4, 4, 5}};
  const DistributedOctree<T> mesh = made(solid, domain);
  std::vector<T> distance = std::vector<T>(mesh.local().cells().size());
  std::vector<std::uint8_t> levels;
};
TYPED_TEST_SUITE(DistributedVtuTest, Precisions);

TYPED_TEST(DistributedVtuTest, PiecesTogetherAreTheMesh) {
  using T = TypeParam;
  const std::vector<std::string> patches{"ball"};
  writePvtu(this->folder / "m.pvtu", this->mesh, this->arrays(), {.patchNames = patches});
  EXPECT_EQ(this->folder.fileCount(), 1U + static_cast<std::size_t>(rankCount()));
  const auto content = contentOf(this->folder / "m.pvtu");
  EXPECT_NE(content.find("<VTKFile type=\"PUnstructuredGrid\""), std::string::npos);
  EXPECT_NE(content.find("<PDataArray type=\"" + this->type + "\" Name=\"Points\""),
            std::string::npos);
  const Octree<T> expected(this->solid, this->domain, {.cut = 3}, {.threads = 1});
  std::size_t n = 0;
  for (const auto& name : this->piecesOf(content)) {
    const ParsedVtk piece(contentOf(this->folder / name));
    EXPECT_EQ(piece.texts("patch names"), patches);
    const auto points = piece.template array<Vec3<T>>("Points", this->type);
    const auto corners = piece.template array<std::int32_t>("connectivity", "Int32");
    const auto values = piece.template array<T>("distance", this->type);
    EXPECT_EQ(8 * values.size(), corners.size());
    for (std::size_t i = 0; i < values.size(); ++i, ++n) {
      ASSERT_LT(n, expected.cells().size());
      const auto box = expected.box(expected.cells()[n]);
      for (std::size_t c = 0; c < 8; ++c) {
        EXPECT_EQ(points.at(static_cast<std::size_t>(corners[8 * i + c])),
                  box.corner(static_cast<int>(c)));
      }
      EXPECT_EQ(values[i], this->solid.signedDistance(expected.center(expected.cells()[n])));
    }
  }
  EXPECT_EQ(n, expected.cells().size());
  MPI_Barrier(MPI_COMM_WORLD);
}

TYPED_TEST(DistributedVtuTest, ReplacesWhatWasThere) {
  const auto write = [&] { writePvtu(this->folder / "m.pvtu", this->mesh, this->arrays()); };
  write();
  const auto first = contentOf(this->folder / "m.pvtu");
  write();
  EXPECT_EQ(contentOf(this->folder / "m.pvtu"), first);
  EXPECT_EQ(this->folder.fileCount(), 1U + static_cast<std::size_t>(rankCount()));
  MPI_Barrier(MPI_COMM_WORLD);
}

TYPED_TEST(DistributedVtuTest, RankWithoutCellsWritesAnEmptyPiece) {
  using T = TypeParam;
  const OctreeDomain<T> one({0, 0, 0}, 1, {1, 1, 1});
  const DistributedOctree<T> small(Sphere<T>({9, 9, 9}, 1), one, {.cut = 1}, MPI_COMM_WORLD);
  const std::vector<T> values(small.local().cells().size(), T(3));
  const VtkArray array{"three", std::span<const T>(values)};
  writePvtu(this->folder / "one.pvtu", small, std::span(&array, 1));
  std::size_t cells = 0;
  for (const auto& name : this->piecesOf(contentOf(this->folder / "one.pvtu"))) {
    const ParsedVtk piece(contentOf(this->folder / name));
    cells += piece.template array<T>("three", this->type).size();
    EXPECT_EQ(piece.template array<Vec3<T>>("Points", this->type).size() % 8, 0U);
  }
  EXPECT_EQ(cells, 1U);
  MPI_Barrier(MPI_COMM_WORLD);
}

TYPED_TEST(DistributedVtuTest, OneRanksFailureReachesAllAndLeavesNothing) {
  const auto last = "m_" + std::to_string(rankCount() - 1) + ".vtu";
  if (ownRank() == 0) std::filesystem::create_directories(this->folder / last / "in the way");
  MPI_Barrier(MPI_COMM_WORLD);
  const auto text = expectAgreedError(
      ErrorKind::File, [&] { writePvtu(this->folder / "m.pvtu", this->mesh, this->arrays()); });
  EXPECT_NE(text.find(last), std::string::npos) << text;
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(this->folder.fileCount(), 1U);
  expectAgreedError(ErrorKind::File, [&] {
    writePvtu(this->folder / "none" / "m.pvtu", this->mesh, this->arrays());
  });
  expectAgreedError(ErrorKind::Argument, [&] {
    auto arrays = this->arrays();
    if (ownRank() == 0) arrays[1].values = std::span<const std::uint8_t>();
    writePvtu(this->folder / "n.pvtu", this->mesh, arrays);
  });
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(this->folder.fileCount(), 1U);
  MPI_Barrier(MPI_COMM_WORLD);
}

}  // namespace
}  // namespace cutwater::test
