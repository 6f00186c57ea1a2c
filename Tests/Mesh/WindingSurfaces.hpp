#pragma once

#include <Cutwater/Mesh/Detail/MeshIndex.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <vector>

#include "Support/DamagedSoups.hpp"

namespace cutwater::test {

inline PolygonSoup ballOf(const Vec3<double>& center = {}, double radius = 1, int level = 3) {
  return moved(tessellation::icosphere(radius, level), center);
}
inline PolygonSoup blockOf(const Vec3<double>& lower, const Vec3<double>& upper, int n = 4) {
  return tessellation::box(lower, upper, n);
}
struct NamedSurface {
  const char* name;
  PolygonSoup soup;
};

/// What is behind a MeshSDF of this soup.
template <typename T>
MeshIndex<T> indexOf(const PolygonSoup& soup) {
  const TriangleSurfaceArrays<T> arrays{DcelMesh<T>(soup)};
  const auto tree = buildTriangleTree<T>(arrays.positions(), arrays.triangles());
  return MeshIndex<T>(arrays, tree, std::vector<char>{'a', '\0'}, {});
}

}  // namespace cutwater::test
