#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Grid/Tag.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>

#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class TagTest : public ::testing::Test {
 protected:
  TagTest() {
    solid = MeshSDF<T>(tessellation::icosphere(0.8, 3)) |
            Cuboid<T>({-1, -1, T(0.0401)}, {T(0.5), 1, T(0.0402)});
    solid.rotate(20, {1, 2, 3});
  }
  [[nodiscard]] std::vector<std::uint8_t> tags(int level, const IndexBox& box,
                                               int threads = 0) const {
    std::vector<std::uint8_t> marks(box.count(), 99);
    tag(rules, solid, {domain.level(level), box}, level,
        GridView<std::uint8_t>::contiguous(marks.data(), box), {.threads = threads});
    return marks;
  }

  Solid<T> solid = Cuboid<T>({0, 0, 0}, {1, 1, 1});
  const OctreeDomain<T> domain{{T(-1.3), T(-1.2), T(-1.25)}, T(0.6), {4, 4, 5}};
  const Refinement<T> rules{.cut = 4, .bands = {{T(0.15), 3}}};
};
TYPED_TEST_SUITE(TagTest, Precisions);

TYPED_TEST(TagTest, MarksWhatTheOctreeDivides) {
  using T = TypeParam;
  const Octree<T> mesh(this->solid, this->domain, this->rules, {.balance = Balance::None});
  for (int level = 0; level <= 4; ++level) {
    const auto box = this->domain.indices(level);
    const auto marks = this->tags(level, box);
    std::size_t n = 0;
    std::size_t divided = 0;
    forEachIndex(box, [&](const Index3& index) {
      const auto mark = marks[n++];
      // Of cells that exist: the mesh's there is finer exactly if it was divided.
      const auto& found = mesh.cells()[*mesh.find(index, level)];
      if (found.level < level) return;
      ASSERT_EQ(mark, found.level > level ? 1 : 0);
      divided += mark;
    });
    EXPECT_EQ(divided > 0, level < 4);
  }
}

TYPED_TEST(TagTest, MarksACellTheSameInAnyPatch) {
  const int level = 2;
  const IndexBox whole{{-3, -2, -1}, {18, 17, 21}};  // beyond the domain: ghost cells
  const auto all = this->tags(level, whole);
  EXPECT_EQ(all, this->tags(level, whole, 1));
  EXPECT_GT(std::ranges::count(all, 1), 100);
  std::size_t checked = 0;
  for (std::int32_t k = whole.lo.k; k <= whole.hi.k; k += 9) {
    for (std::int32_t j = whole.lo.j; j <= whole.hi.j; j += 7) {
      const IndexBox box{
          {whole.lo.i + 1, j, k},
          {whole.hi.i - 2, std::min(j + 6, whole.hi.j), std::min(k + 8, whole.hi.k)}};
      const auto marks = this->tags(level, box);
      std::size_t n = 0;
      forEachIndex(box, [&](const Index3& i) {
        const auto at =
            static_cast<std::size_t>(i.i - whole.lo.i) +
            whole.length(0) * (static_cast<std::size_t>(i.j - whole.lo.j) +
                               whole.length(1) * static_cast<std::size_t>(i.k - whole.lo.k));
        ASSERT_EQ(marks[n++], all[at]);
        ++checked;
      });
    }
  }
  EXPECT_EQ(checked, all.size() / whole.length(0) * (whole.length(0) - 3));
}

TYPED_TEST(TagTest, WritesOnlyWhereTheViewPoints) {
  const IndexBox box{{0, 0, 0}, {8, 4, 5}};
  std::vector<std::uint8_t> marks(3 * box.count(), 99);
  tag(this->rules, this->solid, {this->domain.level(1), box}, 1,
      GridView<std::uint8_t>{marks.data() + 1, {3, 27, 135}});
  const auto expected = this->tags(1, box);
  for (std::size_t i = 0; i < box.count(); ++i) {
    EXPECT_EQ(marks[3 * i], 99);
    EXPECT_EQ(marks[3 * i + 1], expected[i]);
    EXPECT_EQ(marks[3 * i + 2], 99);
  }
}

TYPED_TEST(TagTest, RefusesWhatCannotBe) {
  EXPECT_THROW((void)this->tags(-1, IndexBox::ofSize(1, 1, 1)), Error);
  EXPECT_THROW((void)this->tags(1, IndexBox::ofSize(1, 1, 1), -1), Error);
}

}  // namespace
}  // namespace cutwater::test
