#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cutwater {

/// Of a rule with positive weights, a rule that has no more points than there are functions, some
/// of the same, with positive weights and the same integrals of these functions (Caratheodory's
/// theorem; Tchakaloff 1957 for integrals).
///
/// Points that depend linearly on others, as vectors of the functions' values, are expressed by
/// these, and give their weight to them until it, or one of theirs, is 0. That takes some
/// functions^2 operations for each point.
class FewerPoints {
 public:
  /// The first of the functions is 1; the others are about as large.
  explicit FewerPoints(std::size_t functions) : functions_(functions) {}

  /// A point of the rule: the functions' values there, and its weight. Counted from 0 on.
  void add(std::span<const double> values, double weight);

  /// A point that is left.
  struct Kept {
    std::size_t point = 0;
    double weight = 0;
  };
  /// Those that are left of all, in the order in which they were added; then there are none again.
  [[nodiscard]] std::vector<Kept> take();

 private:
  void reduce();
  void eliminate();
  void exchange(std::size_t row, std::size_t column, std::size_t firstColumn);
  void giveAway(std::size_t column);
  [[nodiscard]] double& at(std::size_t row, std::size_t column) {
    return table_[row * points_.size() + column];
  }

  std::size_t functions_;
  std::size_t added_ = 0;
  std::vector<Kept> points_;    // that are left
  std::vector<double> values_;  // of the functions at each of them, one after the other
  // While they are reduced: each column has the point as a sum of those that the rows stand for.
  std::vector<double> table_;
  std::vector<std::size_t> ofRow_;  // the point that a row stands for
  std::vector<char> hasRow_;        // of each point
};

}  // namespace cutwater
