#include <Cutwater/Mesh/SignScheme.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

TEST(SignReport, SaysWhatSignsRestOn) {
  SignReport sound{.probes = 1000};
  EXPECT_TRUE(sound.isSound());
  EXPECT_EQ(sound.doubt(), 0.003);
  EXPECT_EQ(
      sound.summary(),
      "nearest feature: closed; 1000 probes, all sound (at most 0.3 % of the surface unsound, "
      "95 % confidence)");

  SignReport overlapping{.scheme = SignScheme::WindingNumber, .probes = 100, .unsound = 50};
  EXPECT_FALSE(overlapping.isSound());
  EXPECT_DOUBLE_EQ(overlapping.doubt(), 0.6);  // 0.5 +- 2 * 0.05
  EXPECT_EQ(
      overlapping.summary(),
      "winding number: closed; 100 probes, 50 unsound (at most 60 % of the surface unsound, 95 "
      "% confidence)");

  SignReport open{.scheme = SignScheme::WindingNumber,
                  .unbalancedEdges = 1,
                  .turnedFaces = 3,
                  .turnedShells = 1,
                  .unorientable = 2,
                  .probes = 1,
                  .ambiguous = 1};
  EXPECT_FALSE(open.isClosed());
  EXPECT_EQ(
      open.summary(),
      "winding number: 1 unbalanced edge, 2 parts not orientable; 1 probe, 1 ambiguous (at "
      "most 100 % of the box ambiguous, 95 % confidence); 3 faces turned; 1 shell stood inside "
      "out");
}

TEST(SignReport, WhatIsProvenIsWithoutDoubt) {
  SignReport proven{.probes = 3, .selfIntersections = 0, .isProven = true};
  EXPECT_TRUE(proven.isSound());
  EXPECT_EQ(proven.doubt(), 0);
  EXPECT_EQ(proven.summary(), "nearest feature: closed, 0 self-intersections; sound everywhere");
}

TEST(SignReport, SelfIntersectionsAreUnsound) {
  SignReport report{.probes = 10};
  report.selfIntersections = 0;
  EXPECT_TRUE(report.isSound());
  report.selfIntersections = 7;
  EXPECT_FALSE(report.isSound());
  EXPECT_NE(report.summary().find("7 self-intersections"), std::string::npos);
  EXPECT_EQ(SignReport{}.doubt(), 1);  // nothing was probed
}

}  // namespace
}  // namespace cutwater::test
