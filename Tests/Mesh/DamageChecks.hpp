#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <functional>
#include <optional>

#include "Support/DamagedSoups.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"
#include "Support/WindingOracle.hpp"

namespace cutwater::test {

/// What is to be said and promised of a mesh.
struct Expected {
  std::size_t unbalancedEdges = 0;
  std::size_t shells = 1;
  std::size_t turnedFaces = 0;
  std::size_t turnedShells = 0;
  std::size_t unorientable = 0;
  /// Shares of the probes that are unsound or ambiguous.
  double leastDoubtful = 0;
  double mostDoubtful = 0;
  /// Whether points are inside the solid that was meant; nothing where the damage leaves it open.
  std::function<std::optional<bool>(const Vec3<double>&)> meant = {};
};

template <typename T>
void expectReport(const MeshSDF<T>& mesh, const Expected& expected) {
  const auto& report = mesh.signReport();
  EXPECT_EQ(report.unbalancedEdges, expected.unbalancedEdges);
  EXPECT_EQ(report.shells, expected.shells);
  EXPECT_EQ(report.turnedFaces, expected.turnedFaces);
  EXPECT_EQ(report.turnedShells, expected.turnedShells);
  EXPECT_EQ(report.unorientable, expected.unorientable);
  const auto doubtful = report.isClosed() ? report.unsound : report.ambiguous;
  const double share = static_cast<double>(doubtful) / static_cast<double>(report.probes);
  EXPECT_GE(share, expected.leastDoubtful);
  EXPECT_LE(share, expected.mostDoubtful);
  const bool sound = expected.unbalancedEdges == 0 && doubtful == 0 && expected.unorientable == 0;
  EXPECT_EQ(report.isSound(), sound);
  EXPECT_EQ(report.scheme, sound ? SignScheme::NearestFeature : SignScheme::WindingNumber);

  const auto promise = mesh.guarantee();
  const auto quality = sound               ? Quality::Exact
                       : report.isClosed() ? Quality::LowerBound
                                           : Quality::SignOnly;
  EXPECT_EQ(promise.inside, quality);
  EXPECT_EQ(promise.outside, quality);
  EXPECT_EQ(promise.continuous, report.isClosed());
  EXPECT_EQ(promise.lipschitz.has_value(), report.isClosed());
  EXPECT_EQ(mesh.closestPoint({9, 9, 9}).exact, sound);
}

/// Signs against the winding number by the definition, and against the solid that was meant.
template <typename T>
void expectSigns(const MeshSDF<T>& mesh, const Expected& expected) {
  const WindingOracle oracle(mesh);
  const auto box = mesh.boundingBox();
  const Vec3<T> middle = box.center();
  RandomPoints<T> random(T(0.6) * maxComponent(box.size()));
  const int count = scaled(2'000);
  int leftOut = 0;
  int unlike = 0;
  int asMeant = 0;
  for (int i = 0; i < count; ++i) {
    // Half of them close to the surface.
    Vec3<T> p = middle + random.next();
    if (i % 2 == 0) {
      const auto there = mesh.closestPoint(p);
      const T near = T(0.05) / static_cast<T>(1 + i % 7);
      p = there.point + near * there.distance * normalized(p - there.point);
    }
    const T value = mesh.signedDistance(p);
    const bool inside = value < 0;
    const double winding = oracle.at(p);
    if (value == 0 || std::abs(winding - 0.5) < 1e-3) {  // on the surface, or as good as on a sheet
      ++leftOut;
    } else if (inside != (winding > 0.5) && unlike++ == 0) {
      ADD_FAILURE() << "winding number " << winding << ", inside: " << inside << " at " << p;
    }
    if (!expected.meant) continue;
    const auto truth = expected.meant(Vec3<double>(p));
    if (!truth) continue;
    ++asMeant;
    ASSERT_EQ(inside, *truth) << p << " winding number " << winding;
  }
  EXPECT_EQ(unlike, 0);
  EXPECT_LE(leftOut, count / 50);
  EXPECT_EQ(mesh.signedDistance(middle + Vec3<T>{1000, 0, 0}) > 0, true);
  EXPECT_GE(asMeant, expected.meant ? count / 4 : 0);
}

template <typename T>
MeshSDF<T> expectMesh(const PolygonSoup& soup, const Expected& expected) {
  const MeshSDF<T> mesh(soup);
  expectReport(mesh, expected);
  expectSigns(mesh, expected);
  if (mesh.signReport().isSound()) {
    EXPECT_NO_THROW(MeshSDF<T>(soup, {.requireWatertight = true}));
  } else {
    EXPECT_THROW(MeshSDF<T>(soup, {.requireWatertight = true}), Error);
  }
  return mesh;
}

/// The ball of radius 1 about `center` but for the sag of its facets and a margin.
inline auto ball(const Vec3<double>& center = {}, double margin = 0) {
  return [=](const Vec3<double>& p) -> std::optional<bool> {
    const double radius = length(p - center);
    if (radius < 0.96 - margin || radius > 1 + margin) return radius < 1;
    return std::nullopt;
  };
}

inline auto boxes(std::vector<Box<double>> parts) {
  return [=](const Vec3<double>& p) -> std::optional<bool> {
    bool inside = false;
    for (const auto& box : parts) {
      if (box.contains(p) && !box.grown(-1e-4).contains(p)) return std::nullopt;
      if (!box.contains(p) && box.grown(1e-4).contains(p)) return std::nullopt;
      inside = inside || box.contains(p);
    }
    return inside;
  };
}

inline PolygonSoup sphere(int subdivisions = 2) {
  return tessellation::icosphere(1, subdivisions);
}

inline PolygonSoup plainBox(const Vec3<double>& lower, const Vec3<double>& upper) {
  return triangulated(tessellation::box(lower, upper));
}

}  // namespace cutwater::test
