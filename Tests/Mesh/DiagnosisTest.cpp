#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/Diagnosis.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "DiagnosisCases.hpp"

namespace cutwater::test {
namespace {

TEST(DiagnosisTest, ACleanSurfaceHasNoDefects) {
  const auto found = diagnose(makeSoup(kCorners, kSides));
  EXPECT_TRUE(found.defects.empty());
  EXPECT_TRUE(found.treatments.empty());
  EXPECT_TRUE(found.openings.empty());
  EXPECT_FALSE(found.wrapGap);
  EXPECT_TRUE(found.isSound());
  EXPECT_EQ(found.verdict(), "bounds a solid: signs are exact, distances are those to the solid");
  EXPECT_EQ(found.solidVolume, 1);
  ASSERT_TRUE(found.signs && found.guarantee);
  EXPECT_EQ(found.signs->scheme, SignScheme::NearestFeature);
  EXPECT_EQ(found.guarantee->inside, Quality::Exact);
  EXPECT_EQ(found.memoryBytes, MeshSDF<double>(makeSoup(kCorners, kSides)).memoryBytes());
}

TEST(DiagnosisTest, OpenEdgesAreListedWithTheirPlaces) {
  const auto found = diagnose(openBox());
  EXPECT_EQ(keysOf(found), (std::set<std::string>{"openEdges"}));
  const auto defect = expectDefect(found, "openEdges", Severity::Error, 4);
  std::set<std::array<double, 4>> places;  // of the edge's middle, and its face
  for (const auto& [p, faces] : defect.places) {
    ASSERT_EQ(faces.size(), 1U);
    EXPECT_EQ(p.z, 1);
    places.insert({p.x, p.y, p.z, double(faces.front())});
  }
  EXPECT_EQ(places, (std::set<std::array<double, 4>>{
                        {0.5, 0, 1, 1}, {1, 0.5, 1, 2}, {0.5, 1, 1, 3}, {0, 0.5, 1, 4}}));
  EXPECT_NE(defect.meaning.find("a matter of opinion at "), std::string::npos) << defect.meaning;
  EXPECT_FALSE(found.isSound());
  EXPECT_TRUE(found.verdict().starts_with("does not bound a solid")) << found.verdict();
  EXPECT_FALSE(found.solidVolume);
}

TEST(DiagnosisTest, ASmallHoleIsAWarning) {
  auto soup = tessellation::icosphere(1.0, 5);
  soup.corners.resize(soup.corners.size() - 3);
  soup.offsets.pop_back();
  soup.patches.pop_back();
  const auto found = diagnose(soup, {.tryTreatments = false});
  expectDefect(found, "openEdges", Severity::Warning, 3);
  EXPECT_TRUE(found.treatments.empty() && found.openings.empty());
  EXPECT_EQ(found.verdict(), "is not closed: signs are found nevertheless, see the warnings below");
}

TEST(DiagnosisTest, NonManifoldEdges) {
  auto faces = kSides;
  faces.push_back({1, 8, 5});  // a fin at an edge of the cube
  const auto fin = diagnose(makeSoup(joined(kCorners, Points{{2, 0, 0.5}}), faces), {false});
  expectDefect(fin, "nonManifoldEdges", Severity::Warning, 1);
  EXPECT_TRUE(keysOf(fin).contains("openEdges"));
}

TEST(DiagnosisTest, TurnedShellsAndFaces) {
  const auto soup = makeSoup(kCorners, turned(kSides));
  const auto found = diagnose(soup);
  EXPECT_EQ(keysOf(found), (std::set<std::string>{"insideOutShells"}));
  expectDefect(found, "insideOutShells", Severity::Warning, 1);
  EXPECT_EQ(found.report.volume, -1);
  EXPECT_EQ(found.solidVolume, 1);
  EXPECT_TRUE(found.verdict().ends_with("; see the warnings")) << found.verdict();
  ASSERT_EQ(found.treatments.size(), 1U);
  expectCure(soup, found.treatments.front(), 6, 1);

  auto faces = kSides;
  faces[5] = turned(faces[5]);
  const auto one = diagnose(makeSoup(kCorners, faces));
  const auto defect = expectDefect(one, "turnedFaces", Severity::Warning, 1);
  ASSERT_EQ(defect.places.size(), 1U);
  EXPECT_EQ(defect.places[0].point, (Vec3<double>{0.5, 0.5, 1}));
  EXPECT_EQ(defect.places[0].faces, std::vector<std::uint32_t>{5});
  ASSERT_EQ(one.treatments.size(), 1U);
  EXPECT_EQ(one.treatments[0].effect, "faces turned: 1; closed then");
}

TEST(DiagnosisTest, AMoebiusStripHasNoInside) {
  constexpr int kParts = 12;
  Points points;
  Faces faces;
  for (std::uint32_t i = 0; i < kParts; ++i) {
    const double turn = 2 * std::numbers::pi * i / kParts;
    for (const double side : {-0.3, 0.3}) {
      const double radius = 1 + side * std::cos(turn / 2);
      points.push_back(
          {radius * std::cos(turn), radius * std::sin(turn), side * std::sin(turn / 2)});
    }
    const std::uint32_t a = 2 * i;
    const std::uint32_t c = i + 1 < kParts ? a + 2 : 1;
    const std::uint32_t d = i + 1 < kParts ? a + 3 : 0;
    faces.push_back({a, c, a + 1});
    faces.push_back({a + 1, c, d});
  }
  expectDefect(diagnose(makeSoup(points, faces), {false}), "unorientableShells", Severity::Error,
               1);
}

TEST(DiagnosisTest, ShellsThatOverlapOrNest) {
  const auto overlapping = diagnose(
      makeSoup(joined(kCorners, scaledBy(1, {0.5, 0.4, 0.3})), joined(kSides, kSides)), {false});
  const auto meeting = expectDefect(overlapping, "selfIntersections", Severity::Warning, 6);
  for (const auto& [p, pair] : meeting.places) {
    ASSERT_EQ(pair.size(), 2U);
    EXPECT_TRUE(pair[0] < 6 && 6 <= pair[1]);  // a face of either cube
  }
  expectDefect(overlapping, "components", Severity::Note, 2);
  EXPECT_EQ(overlapping.signs->scheme, SignScheme::WindingNumber);

  // Along an edge: of four faces of either cube, all pairs but one top and one bottom.
  const auto touching =
      diagnose(makeSoup(joined(kCorners, scaledBy(1, {1, 1, 0})), joined(kSides, kSides)), {false});
  expectDefect(touching, "selfIntersections", Severity::Note, 14);
  EXPECT_TRUE(touching.signs->isProven);

  const auto points = joined(kCorners, scaledBy(0.5, {0.25, 0.25, 0.25}));
  const auto nested = diagnose(makeSoup(points, joined(kSides, kSides)), {false});
  EXPECT_TRUE(keysOf(nested).contains("unsoundSurface"));
  const auto cavity = diagnose(makeSoup(points, joined(kSides, turned(kSides))), {false});
  EXPECT_EQ(keysOf(cavity), (std::set<std::string>{"components"}));
  EXPECT_EQ(cavity.solidVolume, 1 - 0.125);
}

TEST(DiagnosisTest, DegenerateAndDuplicateFaces) {
  // A needle on an edge of its own, a face twice, a face with a corner twice, a point for nothing.
  const auto points = joined(kCorners, Points{{0.5, 0, 0}, {9, 9, 9}});
  auto faces = kSides;
  faces[0] = {0, 3, 2, 1, 8};
  faces.insert(faces.begin() + 1, {0, 8, 1});
  faces.push_back(kSides[3]);
  faces.push_back({0, 0, 1});
  const auto soup = makeSoup(points, faces);
  const auto found = diagnose(soup);
  expectDefect(found, "zeroAreaFaces", Severity::Note, 2);
  expectDefect(found, "duplicateFaces", Severity::Note, 1);
  expectDefect(found, "repeatedCorners", Severity::Note, 1);
  const auto unused = expectDefect(found, "unusedPoints", Severity::Note, 1);
  ASSERT_EQ(unused.places.size(), 1U);
  EXPECT_EQ(unused.places[0].point, (Vec3<double>{9, 9, 9}));
  ASSERT_EQ(found.treatments.size(), 1U);
  EXPECT_TRUE(std::ranges::is_sorted(found.defects, {}, &Defect::severity));
  expectCure(soup, found.treatments.front(), 6, 1);
}

TEST(DiagnosisTest, PanelsOfNoThickness) {
  const auto found = diagnose(makeSoup(joined(kCorners, Points{{2, 0, 0}, {3, 0, 0}, {2, 1, 0}}),
                                       joined(kSides, Faces{{0, 1, 2}, {0, 2, 1}})),
                              {false});
  expectDefect(found, "oppositeFaces", Severity::Warning, 1);
  expectDefect(found, "selfIntersections", Severity::Note, 1);  // only those
}

TEST(DiagnosisTest, NonManifoldVerticesAndWarpedPolygons) {
  auto more = scaledBy(1, {1, 1, 1});  // touches the first at a corner
  auto faces = joined(kSides, kSides);
  for (auto& face : faces) std::ranges::replace(face, 8U, 6U);
  const auto touching = diagnose(makeSoup(joined(kCorners, more), faces), {false});
  expectDefect(touching, "nonManifoldVertices", Severity::Note, 1);

  auto points = kCorners;
  points[6].z = 1.5;
  const auto warped = diagnose(makeSoup(points, kSides), {false});
  const auto defect = expectDefect(warped, "nonPlanarPolygons", Severity::Note, 1);
  ASSERT_EQ(defect.places.size(), 1U);
  EXPECT_EQ(defect.places[0].faces, std::vector<std::uint32_t>{5});
}

TEST(DiagnosisTest, NoFacesAndFlatOnes) {
  const auto none = diagnose(makeSoup(kCorners, {{0, 0, 1}, {1, 2, 2}}));
  expectDefect(none, "noFaces", Severity::Error, 2);
  EXPECT_FALSE(none.signs || none.guarantee || none.wrapGap);
  EXPECT_TRUE(none.treatments.empty());
  EXPECT_FALSE(none.isSound());

  const auto inlet = diagnose(makeSoup(kCorners, {kSides[5]}));
  const auto flat = expectDefect(inlet, "flat", Severity::Error, 1);
  EXPECT_NE(flat.meaning.find("z = 1"), std::string::npos) << flat.meaning;
  EXPECT_FALSE(inlet.wrapGap);
  ASSERT_EQ(inlet.treatments.size(), 1U);  // of its unused points only
  EXPECT_TRUE(inlet.treatments[0].closings.empty());
}

TEST(DiagnosisTest, InvalidSoupsAreRefused) {
  PolygonSoup soup = openBox();
  soup.corners[0] = 99;
  EXPECT_THROW(static_cast<void>(diagnose(soup)), Error);
}

TEST(DiagnosisTest, Example) {
  PolygonSoup soup = openBox();
  // [DOCS
  const Diagnosis diagnosis = diagnose(soup);
  std::printf("%s\n", diagnosis.verdict().c_str());
  for (const Defect& defect : diagnosis.defects) {
    std::printf("%s: %zu %s: %s\n", nameOf(defect.severity), defect.count, defect.name.c_str(),
                defect.meaning.c_str());
  }
  if (!diagnosis.treatments.empty()) {
    const Treatment& best = diagnosis.treatments.front();
    std::printf("try: %s\n", best.effect.c_str());  // openings closed: 1; closed then
    treat(soup, best);
  }
  // DOCS]
  EXPECT_TRUE(diagnose(soup).isSound());
}

}  // namespace
}  // namespace cutwater::test
