#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <functional>

#include "Report.hpp"

namespace cutwater::benchmarks {

struct Comparison {
  std::span<const Vec3<double>> points;
  std::span<const double> answers;
  std::span<const double> truth;
  double diagonal = 1;
  /// Values beyond this are known by their sign alone; see FillOptions::band.
  double limit = std::numeric_limits<double>::infinity();
  bool withSigns = true;
  /// What a value may be off by.
  std::function<double(const Vec3<double>&)> tolerance = {};
};

/// Counts into the check.
void compare(const Comparison& comparison, Check& check);

}  // namespace cutwater::benchmarks
