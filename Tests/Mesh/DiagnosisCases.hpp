#pragma once

#include <Cutwater/Mesh/Diagnosis.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "Support/Soups.hpp"

// Cubes with defects, and what a diagnosis of them must say.
namespace cutwater::test {

using Points = std::vector<Vec3<double>>;
using Faces = Polygons;

// A unit cube. Its last face is at z = 1.
inline const Points kCorners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                             {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
inline const Faces kSides{{0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5},
                          {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
inline const Faces kOpenSides(kSides.begin(), kSides.end() - 1);

inline PolygonSoup openBox() {
  return makeSoup(kCorners, kOpenSides);
}

inline Points scaledBy(double factor, const Vec3<double>& origin) {
  Points points = kCorners;
  for (auto& p : points) p = origin + factor * p;
  return points;
}

inline Points joined(Points points, const Points& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

/// The first faces, and others whose corners come behind the first eight points.
inline Faces joined(Faces faces, const Faces& more) {
  for (auto face : more) {
    for (auto& corner : face) corner += 8;
    faces.push_back(face);
  }
  return faces;
}

inline std::vector<std::uint32_t> turned(std::vector<std::uint32_t> face) {
  std::ranges::reverse(face);
  return face;
}

inline Faces turned(Faces faces) {
  for (auto& face : faces) face = turned(face);
  return faces;
}

inline std::set<std::string> keysOf(const Diagnosis& found) {
  std::set<std::string> keys;
  for (const auto& defect : found.defects) keys.insert(defect.key);
  return keys;
}

/// The defect of this key, which must be there once, with these properties.
inline Defect expectDefect(const Diagnosis& found, const std::string& key, Severity severity,
                           std::size_t count) {
  const auto defect = std::ranges::find(found.defects, key, &Defect::key);
  if (defect == found.defects.end()) {
    ADD_FAILURE() << "no " << key;
    return {};
  }
  EXPECT_EQ(std::ranges::count(found.defects, key, &Defect::key), 1);
  EXPECT_STREQ(nameOf(defect->severity), nameOf(severity)) << key;
  EXPECT_EQ(defect->count, count) << key;
  EXPECT_TRUE(defect->isComplete);
  EXPECT_FALSE(defect->name.empty());
  EXPECT_FALSE(defect->meaning.empty());
  return *defect;
}

/// Carries the treatment out, and expects a sound surface of this area and volume.
inline void expectCure(PolygonSoup soup, const Treatment& treatment, double area, double volume,
                       const HoleFilling& fillHoles = {}) {
  EXPECT_TRUE(treatment.isClosed);
  EXPECT_TRUE(treatment.effect.ends_with("; closed then")) << treatment.effect;
  treat(soup, treatment, fillHoles);
  const auto after = diagnose(soup);
  EXPECT_TRUE(after.isSound()) << after.verdict();
  EXPECT_TRUE(after.report.isClosedOriented());
  EXPECT_NEAR(after.report.area, area, 1e-5);
  EXPECT_NEAR(after.report.volume, volume, 1e-5);
}

}  // namespace cutwater::test
