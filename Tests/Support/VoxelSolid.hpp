#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace cutwater::test {

/// Triangles that share vertices.
struct IndexedTriangles {
  std::vector<Vec3<double>> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A solid of equal cubes, of which no two touch along an edge or in a vertex only.
class VoxelSolid {
 public:
  using Place = std::array<int, 3>;

  explicit VoxelSolid(double width) : width_(width) {}

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] bool has(const Place& voxel) const { return voxels_.contains(voxel); }
  [[nodiscard]] std::size_t count() const { return voxels_.size(); }
  void add(const Place& voxel) { voxels_.insert(voxel); }

  /// Adds voxels until no two touch along an edge or in a vertex only, and the same holds for what
  /// is not in the solid. Voxels have indices from 1 to n - 1.
  void close(int n) {
    for (bool isChanged = true; isChanged;) {
      isChanged = false;
      for (int x = 0; x < n; ++x) {
        for (int y = 0; y < n; ++y) {
          for (int z = 0; z < n; ++z) isChanged = closeAt({x, y, z}) || isChanged;
        }
      }
    }
  }

  /// The surface, with normals out of the solid.
  [[nodiscard]] IndexedTriangles surface() const {
    IndexedTriangles result;
    std::map<Place, std::uint32_t> numbers;
    const auto vertex = [&](const Place& p) {
      const auto [found, isNew] =
          numbers.emplace(p, static_cast<std::uint32_t>(result.positions.size()));
      if (isNew) result.positions.push_back({p[0] * width_, p[1] * width_, p[2] * width_});
      return found->second;
    };
    for (const auto& voxel : voxels_) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
          auto next = voxel;
          next[axis] += side == 1 ? 1 : -1;
          if (has(next)) continue;
          const auto corner = [&](int c, int d) {
            auto p = voxel;
            p[axis] += side;
            p[(axis + 1) % 3] += c;
            p[(axis + 2) % 3] += d;
            return vertex(p);
          };
          const auto a = corner(0, 0);
          const auto b = side == 1 ? corner(1, 0) : corner(0, 1);
          const auto c = corner(1, 1);
          const auto d = side == 1 ? corner(0, 1) : corner(1, 0);
          result.triangles.push_back({a, b, c});
          result.triangles.push_back({a, c, d});
        }
      }
    }
    return result;
  }

 private:
  [[nodiscard]] static Place moved(Place p, std::size_t c, std::size_t d) {
    ++p[c];
    ++p[d];
    return p;
  }
  bool closeAt(const Place& p) {
    bool isChanged = false;
    const auto put = [&](const Place& voxel) {
      isChanged = voxels_.insert(voxel).second || isChanged;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto c = p;
      auto d = p;
      ++c[(axis + 1) % 3];
      ++d[(axis + 2) % 3];
      const auto far = moved(p, (axis + 1) % 3, (axis + 2) % 3);
      if (has(p) && has(far) && !has(c) && !has(d)) put(c);
      if (has(c) && has(d) && !has(p) && !has(far)) put(p);
    }
    std::array<Place, 8> corner;
    int mask = 0;
    for (int k = 0; k < 8; ++k) {
      corner[static_cast<std::size_t>(k)] = {p[0] + (k & 1), p[1] + (k >> 1 & 1), p[2] + (k >> 2)};
      mask |= (has(corner[static_cast<std::size_t>(k)]) ? 1 : 0) << k;
    }
    for (int k = 0; k < 4; ++k) {
      const int both = 1 << k | 1 << (7 - k);
      const auto at = [&](int n) { return corner[static_cast<std::size_t>(n)]; };
      if (mask == both) {
        put(at((k & 3) | ((7 - k) & 4)));
        put(at((k & 2) | ((7 - k) & 5)));
      }
      if ((~mask & 255) == both) put(at(k));
    }
    return isChanged;
  }

  double width_;
  std::set<Place> voxels_;
};

}  // namespace cutwater::test
