#include <Cutwater/Surface/Cleaning/CleanReport.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

TEST(CleanReport, ALinePerStep) {
  CleanReport report;
  CleanStep step{CleanKind::DuplicateFaces, {}, {2, 0.5}, {2, 0.5}};
  report.steps.push_back(step);
  for (int i = 0; i < 10; ++i) step.correction.add({i + 0.5, 0, -1}, i == 3 ? 0.25 : 0.125);
  step.after = {1, 0.5};
  report.steps.push_back(step);
  step.kind = CleanKind::TurnedShells;
  step.correction = {};
  step.correction.add({1, 2, 3});
  step.before = {1, -1};
  step.after = {1, 1};
  report.steps.push_back(step);
  EXPECT_EQ(report.text(),
            "duplicate faces removed                 0\n"
            "duplicate faces removed                 10, largest 0.25, area 2 -> 1; at (0.5, 0, -1)"
            " (1.5, 0, -1) (2.5, 0, -1) (3.5, 0, -1) (4.5, 0, -1) (5.5, 0, -1) (6.5, 0, -1)"
            " (7.5, 0, -1) ...\n"
            "shells turned                           1, volume -1 -> 1; at (1, 2, 3)\n");
  EXPECT_EQ(report.count(CleanKind::DuplicateFaces), 10U);
  EXPECT_EQ(report.count(CleanKind::EqualPoints), 0U);
  EXPECT_FALSE(report.changedNothing());
}

TEST(CleanReport, WhatCannotBeOrientedIsNoChange) {
  CleanReport report;
  EXPECT_TRUE(report.changedNothing());
  CleanStep step{CleanKind::UnorientableShells, {}, {}, {}};
  step.correction.places.count = 2;
  report.steps.push_back(step);
  EXPECT_TRUE(report.changedNothing());
  EXPECT_EQ(report.text(), "shells that cannot be oriented          2\n");
}

}  // namespace
}  // namespace cutwater::test
