// CellLattice: tetrahedra that fill cells and fit together, whatever the levels of leaves.

#include <Cutwater/CutCells/Detail/Curved/CellLattice.hpp>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

/// A cube of 2^3 roots that are divided at random, up to twice.
class RandomRoots {
 public:
  static constexpr int kRoots = 2;
  static constexpr int kLevels = 2;

  explicit RandomRoots(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> width(0.5, 1.5);
    for (auto& planes : finest_) {
      planes.assign(1, -0.3);
      for (int i = 0; i < kRoots << kLevels; ++i) planes.push_back(planes.back() + width(random));
    }
    for (int level = 0; level < kLevels; ++level) {
      forTilePlaces(sizesOf(level), [&](const TilePlace& cell) {
        if (isThere(cell, level) && random() % 2 == 0) divided_.emplace(level, cell);
      });
    }
  }

  static TilePlace sizesOf(int level) {
    return {kRoots << level, kRoots << level, kRoots << level};
  }
  [[nodiscard]] bool isDivided(const TilePlace& cell, int level) const {
    return divided_.contains({level, cell});
  }
  [[nodiscard]] bool isLeaf(const TilePlace& cell, int level) const {
    return isThere(cell, level) && !isDivided(cell, level);
  }
  [[nodiscard]] double plane(int level, int axis, int number) const {
    return finest_[asIndex(axis)][static_cast<std::size_t>(number) << (kLevels - level)];
  }
  [[nodiscard]] double volume() const {
    double product = 1;
    for (const auto& planes : finest_) product *= planes.back() - planes.front();
    return product;
  }

 private:
  [[nodiscard]] bool isThere(const TilePlace& cell, int level) const {
    return level == 0 || isDivided({cell[0] / 2, cell[1] / 2, cell[2] / 2}, level - 1);
  }

  std::array<std::vector<double>, 3> finest_;
  std::set<std::pair<int, TilePlace>> divided_;
};

/// Tetrahedra by their points, and how often a triangle is one of their faces.
class Tetrahedra {
 public:
  void add(const std::array<Vec3<double>, 4>& points) {
    const auto& [a, b, c, d] = points;
    volume_ += std::abs(dot(b - a, cross(c - a, d - a))) / 6;
    for (std::size_t without = 0; without < 4; ++without) {
      Face face;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& p = points[i < without ? i : i + 1];
        face[i] = {p.x, p.y, p.z};
      }
      std::ranges::sort(face);
      ++faces_[face];
    }
  }
  [[nodiscard]] double volume() const { return volume_; }
  /// Those that are not in the planes of the cube's ends, and belong to one tetrahedron, or to
  /// many.
  [[nodiscard]] int loose(const RandomRoots& roots) const {
    int count = 0;
    for (const auto& [face, times] : faces_) {
      bool isOuter = false;
      for (int axis = 0; axis < 3; ++axis) {
        for (const int end : {0, RandomRoots::kRoots}) {
          const double plane = roots.plane(0, axis, end);
          const auto isIn = [&](const auto& p) { return p[asIndex(axis)] == plane; };
          isOuter = isOuter || std::ranges::all_of(face, isIn);
        }
      }
      if (times != (isOuter ? 1 : 2)) ++count;
    }
    return count;
  }

 private:
  using Face = std::array<std::array<double, 3>, 3>;
  double volume_ = 0;
  std::map<Face, int> faces_;
};

TEST(CellLatticeTest, TetrahedraOfLeavesOfAnyLevelFitTogether) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const RandomRoots roots(seed);
    Tetrahedra tetrahedra;
    for (int level = 0; level <= RandomRoots::kLevels; ++level) {
      const auto sizes = RandomRoots::sizesOf(level);
      std::array<std::vector<double>, 3> positions;
      GridPlanes planes;
      for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i <= sizes[asIndex(axis)]; ++i) {
          positions[asIndex(axis)].push_back(roots.plane(level, axis, i));
        }
        planes.positions[asIndex(axis)] = positions[asIndex(axis)];
      }
      const auto plane = [&](int axis, int number) {
        return roots.plane(RandomRoots::kLevels, axis, number);
      };
      const auto isDivided = [&](const TilePlace& cell, int below) {
        return roots.isDivided(cell, level + below);
      };
      const LeavesAround leaves{RandomRoots::kLevels - level, plane, isDivided};
      const CellLattice lattice(planes, &leaves);
      forTilePlaces(sizes, [&](const TilePlace& cell) {
        if (!roots.isLeaf(cell, level)) return;
        lattice.forTetrahedra(cell, [&](const CellLattice::Tetrahedron& nodes) {
          std::array<Vec3<double>, 4> points;
          for (std::size_t i = 0; i < 4; ++i) points[i] = lattice.pointOf(nodes[i]);
          tetrahedra.add(points);
        });
      });
    }
    EXPECT_NEAR(tetrahedra.volume(), roots.volume(), 1e-12 * roots.volume()) << seed;
    EXPECT_EQ(tetrahedra.loose(roots), 0) << seed;
  }
}

/// The triangles of a face, around the axis, are those of the tetrahedra on both sides.
TEST(CellLatticeTest, TrianglesOfFacesAreThoseOfTetrahedra) {
  const std::array<double, 3> positions{0, 1, 3};
  GridPlanes planes;
  planes.positions.fill(positions);
  const CellLattice lattice(planes, nullptr);
  for (int axis = 0; axis < 3; ++axis) {
    TilePlace above{};
    above[asIndex(axis)] = 1;
    std::set<std::set<TilePlace>> triangles;
    lattice.forTriangles(axis, above, [&](const CellLattice::Triangle& nodes) {
      triangles.insert({nodes.begin(), nodes.end()});
      const auto a = lattice.pointOf(nodes[0]);
      const auto normal = cross(lattice.pointOf(nodes[1]) - a, lattice.pointOf(nodes[2]) - a);
      EXPECT_EQ(normal[axis], 0.25);
    });
    EXPECT_EQ(triangles.size(), 8U);
    for (const auto& cell : {TilePlace{}, above}) {
      std::size_t seen = 0;
      lattice.forTetrahedra(cell, [&](const CellLattice::Tetrahedron& nodes) {
        std::set<TilePlace> inPlane;
        for (const auto& node : nodes) {
          if (lattice.pointOf(node)[axis] == 1) inPlane.insert(node);
        }
        if (inPlane.size() == 3) seen += triangles.count(inPlane);
      });
      EXPECT_EQ(seen, 8U);
    }
  }
}

}  // namespace
}  // namespace cutwater::test
