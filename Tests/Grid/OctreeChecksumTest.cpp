#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeFill.hpp>

#include <cstring>
#include <functional>

#include "Support/OctreeMeshes.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class OctreeChecksumTest : public ::testing::Test {
 protected:
  OctreeChecksumTest() { fill(solid, mesh, targets()); }
  OctreeTargets<T> targets() { return {distance, normal, patch}; }

  const Solid<T> solid = ballAndPlate<T>();
  const Octree<T> mesh = ballAndPlateMesh<T>(3);
  std::vector<T> distance = std::vector<T>(mesh.cells().size());
  std::vector<Vec3<T>> normal = std::vector<Vec3<T>>(mesh.cells().size());
  std::vector<std::uint32_t> patch = std::vector<std::uint32_t>(mesh.cells().size());
};
TYPED_TEST_SUITE(OctreeChecksumTest, Precisions);

TYPED_TEST(OctreeChecksumTest, IsTheSumOfHashesOfTheBytes) {
  using T = TypeParam;
  const OctreeDomain<T> domain({0, 0, 0}, 1, {2, 1, 1});
  const OctreeCells<T> two(domain, 1,
                           {{{0, 0, 0}, 0, BoxClass::Outside}, {{3, 1, 1}, 1, BoxClass::Cut}});
  std::vector<T> values{T(-0.0), T(2.5)};
  std::uint64_t expected = 0;
  for (std::size_t n = 0; n < 2; ++n) {
    std::array<std::byte, 2 + 12 + sizeof(T)> bytes{};
    const auto& cell = two.cells()[n];
    bytes[0] = static_cast<std::byte>(cell.level);
    bytes[1] = static_cast<std::byte>(cell.kind);
    std::memcpy(&bytes[2], &cell.index, 12);
    std::memcpy(&bytes[14], &values[n], sizeof(T));
    expected += xxHash64(bytes);
  }
  EXPECT_EQ(checksum(two, {.distance = values}), expected);
}

TYPED_TEST(OctreeChecksumTest, OfStretchesAddUpToThatOfTheWhole) {
  using T = TypeParam;
  const auto all = this->mesh.cells();
  for (const std::size_t length : {std::size_t{1000}, std::size_t{4321}}) {
    std::uint64_t sum = 0;
    for (std::size_t first = 0; first < all.size(); first += length) {
      const auto count = std::min(length, all.size() - first);
      const auto some = all.subspan(first, count);
      const OctreeCells<T> part(this->mesh.domain(), 3, {some.begin(), some.end()});
      sum += checksum(part, {.distance = std::span(this->distance).subspan(first, count),
                             .normal = std::span(this->normal).subspan(first, count),
                             .patch = std::span(this->patch).subspan(first, count)});
    }
    EXPECT_EQ(sum, checksum(this->mesh, this->targets()));
  }
  EXPECT_EQ(checksum(this->mesh, this->targets(), 1), checksum(this->mesh, this->targets(), 3));
}

TYPED_TEST(OctreeChecksumTest, ChangesWithEveryBit) {
  using T = TypeParam;
  const auto expected = checksum(this->mesh, this->targets());
  const auto middle = this->distance.size() / 2;
  const auto expectChange = [&](auto& value, auto other) {
    const auto before = std::exchange(value, other);
    EXPECT_NE(checksum(this->mesh, this->targets()), expected);
    value = before;
  };
  expectChange(this->distance[middle], std::nextafter(this->distance[middle], T(9)));
  expectChange(this->normal[middle].z, std::nextafter(this->normal[middle].z, T(9)));
  expectChange(this->patch[middle], this->patch[middle] + 1);
  std::swap(this->distance.front(), this->distance.back());
  EXPECT_NE(checksum(this->mesh, this->targets()), expected);
  std::swap(this->distance.front(), this->distance.back());
  EXPECT_EQ(checksum(this->mesh, this->targets()), expected);
  EXPECT_NE(checksum(this->mesh, {.distance = this->distance}), expected);
  std::vector<OctreeCell> cells(this->mesh.cells().begin(), this->mesh.cells().end());
  cells[middle].kind = BoxClass::Unknown;
  EXPECT_NE(checksum(OctreeCells<T>(this->mesh.domain(), 3, cells), this->targets()), expected);
}

TYPED_TEST(OctreeChecksumTest, RefusesValuesOfOtherCells) {
  EXPECT_THROW(
      static_cast<void>(checksum(this->mesh, {.distance = std::span(this->distance).first(3)})),
      Error);
  EXPECT_THROW(static_cast<void>(checksum(this->mesh, this->targets(), -1)), Error);
}

}  // namespace
}  // namespace cutwater::test
