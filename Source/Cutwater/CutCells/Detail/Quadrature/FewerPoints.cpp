#include <Cutwater/CutCells/Detail/Quadrature/FewerPoints.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Core>

namespace cutwater {

namespace {

/// What is less, of functions' values of about 1, is rounding: then points depend on others.
constexpr double kDependent = 1e-13;

/// So many points for each function are reduced at a time.
constexpr std::size_t kAtATime = 3;

}  // namespace

void FewerPoints::add(std::span<const double> values, double weight) {
  if (points_.size() >= kAtATime * functions_) reduce();
  points_.push_back({added_++, weight});
  values_.insert(values_.end(), values.begin(), values.end());
}

std::vector<FewerPoints::Kept> FewerPoints::take() {
  if (points_.size() > functions_) reduce();
  added_ = 0;
  values_.clear();
  return std::exchange(points_, {});
}

void FewerPoints::reduce() {
  eliminate();
  for (std::size_t column = 0; column < points_.size(); ++column) {
    if (hasRow_[column] == 0) giveAway(column);
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!(points_[i].weight > 0)) continue;
    const auto values = values_.begin() + static_cast<std::ptrdiff_t>(i * functions_);
    std::copy_n(values, functions_,
                values_.begin() + static_cast<std::ptrdiff_t>(count * functions_));
    points_[count++] = points_[i];
  }
  points_.resize(count);
  values_.resize(count * functions_);
}

/// By Gauss and Jordan. A row without any point is a function that depends on others here.
void FewerPoints::eliminate() {
  table_.resize(functions_ * points_.size());
  for (std::size_t column = 0; column < points_.size(); ++column) {
    for (std::size_t row = 0; row < functions_; ++row) {
      at(row, column) = values_[column * functions_ + row];
    }
  }
  hasRow_.assign(points_.size(), 0);
  ofRow_.clear();
  for (std::size_t function = 0; function < functions_; ++function) {
    const auto row = ofRow_.size();
    if (row != function) {
      std::swap_ranges(&at(row, 0), &at(row, 0) + points_.size(), &at(function, 0));
    }
    std::size_t column = 0;
    double largest = kDependent;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (hasRow_[i] == 0 && std::abs(at(row, i)) > largest) {
        column = i;
        largest = std::abs(at(row, i));
      }
    }
    if (!(largest > kDependent)) continue;
    ofRow_.push_back(column);
    hasRow_[column] = 1;
    exchange(row, column, 0);
  }
}

/// The row stands for this point from now on; what comes before the first column does not count.
void FewerPoints::exchange(std::size_t row, std::size_t column, std::size_t firstColumn) {
  const auto count = static_cast<Eigen::Index>(points_.size());
  const auto from = static_cast<Eigen::Index>(firstColumn);
  const auto valuesOf = [&](std::size_t of) {
    return Eigen::Map<Eigen::RowVectorXd>(&at(of, 0), count).tail(count - from);
  };
  auto own = valuesOf(row);
  const double pivot = at(row, column);
  own /= pivot;
  for (std::size_t other = 0; other < functions_; ++other) {
    const double factor = at(other, column);
    if (other == row || factor == 0) continue;
    valuesOf(other) -= factor * own;
    at(other, column) = 0;
  }
}

/// Moves a point's weight to those that rows stand for, by which it is expressed. If one of them
/// has too little for that, either that one is used up by it, or another as this point gains: by
/// the larger share, so that no small number is divided by. This point takes its place.
void FewerPoints::giveAway(std::size_t column) {
  double& own = points_[column].weight;
  // 0: as this point loses; 1: as it gains.
  std::array<double, 2> least{own, std::numeric_limits<double>::infinity()};
  std::array<std::size_t, 2> usedUp{ofRow_.size(), ofRow_.size()};
  for (std::size_t row = 0; row < ofRow_.size(); ++row) {
    const double share = at(row, column);
    if (share == 0) continue;
    const std::size_t way = share < 0 ? 0 : 1;
    const double step = points_[ofRow_[row]].weight / std::abs(share);
    if (step < least[way]) {
      least[way] = step;
      usedUp[way] = row;
    }
  }
  const auto shareOf = [&](std::size_t row) {
    return row < ofRow_.size() ? std::abs(at(row, column)) : 0.0;
  };
  const bool gains = usedUp[0] < ofRow_.size() && shareOf(usedUp[1]) > shareOf(usedUp[0]);
  const double loss = gains ? -least[1] : least[0];
  for (std::size_t row = 0; row < ofRow_.size(); ++row) {
    double& weight = points_[ofRow_[row]].weight;
    weight = std::max(weight + loss * at(row, column), 0.0);
  }
  own -= loss;
  const auto row = usedUp[gains ? 1 : 0];
  if (row == ofRow_.size()) {
    own = 0;
    return;
  }
  points_[ofRow_[row]].weight = 0;
  ofRow_[row] = column;
  exchange(row, column, column);
}

}  // namespace cutwater
