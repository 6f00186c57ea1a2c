#pragma once

#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "Support/Guarantee.hpp"
#include "Support/SurfaceSamples.hpp"

namespace cutwater::test {

/// Counts what went wrong, keeps the first case's description, and tells the test at the end.
class Tally {
 public:
  explicit Tally(const char* what) : what_(what) {}
  Tally(const Tally&) = delete;
  Tally& operator=(const Tally&) = delete;
  ~Tally() {
    EXPECT_EQ(wrong_, 0) << what_ << ": " << wrong_ << " of " << all_
                         << " wrong, first: " << first_;
  }

  template <typename... Facts>
  void expect(bool ok, const Facts&... facts) {
    ++all_;
    if (ok || wrong_++ > 0) return;
    std::ostringstream text;
    text.precision(17);
    ((text << facts << ' '), ...);
    first_ = text.str();
  }
  [[nodiscard]] int all() const { return all_; }

 private:
  const char* what_;
  int all_ = 0;
  int wrong_ = 0;
  std::string first_;
};

/// One run of expectGuarantee(); the parts are spread over several files.
template <std::floating_point T>
class GuaranteeCheck {
 public:
  GuaranteeCheck(const Solid<T>& solid, double extent, const GuaranteeOptions& options);

  void run();
  [[nodiscard]] const GuaranteeCounts& counts() const { return counts_; }

 private:
  // Values: GuaranteeValues.cpp
  void checkSign();
  void checkLipschitz();
  void checkDistances();
  /// The sign changes at the closest point that the solid tells, which is no farther than this.
  [[nodiscard]] bool hasSurfaceAt(const Vec3<T>& p, double distance) const;
  void checkWithin();
  void checkBatches();
  void checkNonFinite();
  void checkMotions();
  // Boxes: GuaranteeBoxes.cpp
  void checkBoxes();
  void checkOneBox(const Box<T>& box, Tally& bounds, Tally& classes);
  void checkDistanceBounds(const Box<T>& box, Tally& bounds) const;
  /// Proves by values and the Lipschitz constant alone that the box holds no surface, if it can.
  [[nodiscard]] bool isCertainlyFree(const Box<T>& box, int depth) const;
  void checkBoundingBox();
  void checkClearance(const Solid<T>& solid);
  // Surface: GuaranteeSurface.cpp
  void checkGradient();
  void checkClosestPoints();
  void checkCrossings();
  void checkSurfaces();
  void checkSidesOf(std::span<const Solid<T>> surfaces, const Box<T>& box, Tally& tally);
  void checkOneSegment(const Segment<T>& segment, Tally& tally);

  [[nodiscard]] double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine_);
  }
  [[nodiscard]] Vec3<T> randomPoint(double extent) {
    const double x = uniform(-extent, extent);
    const double y = uniform(-extent, extent);
    return Vec3<T>(Vec3<double>{x, y, uniform(-extent, extent)});
  }
  [[nodiscard]] Vec3<T> randomDirection() {
    return Vec3<T>(normalized(Vec3<double>(randomPoint(1))));
  }
  /// Half of the points are near the surface, at distances from 1e-9 extents up.
  [[nodiscard]] Vec3<T> probe();
  [[nodiscard]] T error(const Vec3<T>& p) const { return promise_.error(length(p)); }

  Solid<T> solid_;
  double extent_;
  GuaranteeOptions options_;
  GuaranteeCounts counts_;
  Guarantee<T> promise_;
  std::mt19937 engine_;
  SurfaceSamples<T> samples_;
};

}  // namespace cutwater::test
