#pragma once

#include "Report.hpp"
#include "Support/SurfaceInBlock.hpp"

namespace cutwater::benchmarks {

/// The library's own search for the nearest triangle, compiled once more with an observer that
/// counts.
class CountedSearch {
 public:
  explicit CountedSearch(const PolygonSoup& soup) : mesh_(soup) {}

  /// Finds the distances of the points, without signs and one by one, and tells what that took.
  /// @throws std::logic_error if the search left out what it could not do without.
  Effort ask(std::span<const Vec3<double>> points, std::span<double> distances) const;

 private:
  /// Of one point; returns its distance in units of the surface.
  double ask(const Vec3<double>& p, Effort& effort) const;

  test::SearchableInBlock<double> mesh_;
};

/// The time that this machine takes to fetch what a leaf holds from anywhere in so much memory, one
/// leaf after the other, where none waits for the one before. No search is faster that reads as
/// much of it as ours has to, unless the cache holds it.
[[nodiscard]] double leafFetchNanoseconds(std::size_t memoryBytes);

}  // namespace cutwater::benchmarks
