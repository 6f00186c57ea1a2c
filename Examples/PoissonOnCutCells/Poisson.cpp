#include "Poisson.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Dense>
#include <Eigen/Sparse>

using cutwater::Vec3;

namespace {

constexpr auto kNone = ControlVolumes::kNone;

Vec3<double> unit(int axis, double sign) {
  Vec3<double> result;
  result[axis] = sign;
  return result;
}

/// At the box's side that an open part lies in.
BoundaryPoint sideOf(const OpenPart& part) {
  return {.at = part.centroid, .normal = unit(part.axis, part.above == kNone ? 1 : -1)};
}

BoundaryPoint pointOf(const WallPart& wall) {
  return {.at = wall.centroid, .normal = wall.normal, .patch = wall.patch};
}

}  // namespace

/// The polynomial of degree two about a point that fits values and conditions best. Offsets are in
/// cells, so that its coefficients are of one size.
class Poisson::Fit {
 public:
  Fit(const Vec3<double>& about, double width) : about_(about), width_(width) {}

  void addValue(std::uint32_t volume, const Vec3<double>& at) {
    add(monomials(offset(at)), weightAt(at), volume, 0);
  }
  void addCondition(const BoundaryPoint& point, const Condition& condition) {
    if (condition.kind == Condition::Kind::Value) {
      add(monomials(offset(point.at)), weightAt(point.at), kNone, condition.value);
    } else {
      add(derivatives(offset(point.at), point.normal), weightAt(point.at), kNone,
          condition.value * width_);
    }
  }

  /// The coefficients of the derivative along a direction at the point: of all solutions of the
  /// equations that the fit's polynomials must fulfil, the shortest.
  [[nodiscard]] Combination derivative(const Vec3<double>& direction) const {
    const auto count = static_cast<Eigen::Index>(rows_.size());
    Eigen::MatrixXd system(kMonomials, count);
    for (Eigen::Index n = 0; n < count; ++n) {
      const auto& row = rows_[static_cast<std::size_t>(n)];
      for (Eigen::Index m = 0; m < kMonomials; ++m) {
        system(m, n) = row.factors[static_cast<std::size_t>(m)] * row.weight;
      }
    }
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(kMonomials);
    for (int axis = 0; axis < 3; ++axis) wanted(1 + axis) = direction[axis] / width_;
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    constexpr double kDependent = 1e-8;
    decomposition.setThreshold(kDependent);
    decomposition.compute(system);
    const Eigen::VectorXd shares = decomposition.solve(wanted);
    Combination result;
    for (Eigen::Index n = 0; n < count; ++n) {
      const auto& row = rows_[static_cast<std::size_t>(n)];
      const double factor = shares(n) * row.weight;
      if (row.volume == kNone) {
        result.constant += factor * row.known;
      } else {
        result.terms.push_back({row.volume, factor});
      }
    }
    return result;
  }

 private:
  static constexpr Eigen::Index kMonomials = 10;
  using Factors = std::array<double, kMonomials>;
  struct Row {
    Factors factors;
    double weight;
    std::uint32_t volume;  ///< kNone: what is known
    double known;
  };

  [[nodiscard]] Vec3<double> offset(const Vec3<double>& at) const { return (at - about_) / width_; }
  /// It falls with the third power of the distance: neighbours of a neighbour only help out.
  [[nodiscard]] double weightAt(const Vec3<double>& at) const {
    constexpr double kLargest = 20;
    const double distance = length(offset(at));
    return 1 / (1 / kLargest + distance * distance * distance);
  }
  static Factors monomials(const Vec3<double>& d) {
    return {1, d.x, d.y, d.z, d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.y * d.z, d.z * d.x};
  }
  /// Of the monomials, along a normal.
  static Factors derivatives(const Vec3<double>& d, const Vec3<double>& n) {
    return {0,
            n.x,
            n.y,
            n.z,
            2 * d.x * n.x,
            2 * d.y * n.y,
            2 * d.z * n.z,
            d.x * n.y + d.y * n.x,
            d.y * n.z + d.z * n.y,
            d.z * n.x + d.x * n.z};
  }
  void add(const Factors& factors, double weight, std::uint32_t volume, double known) {
    rows_.push_back({.factors = factors, .weight = weight, .volume = volume, .known = known});
  }

  Vec3<double> about_;
  double width_;
  std::vector<Row> rows_;
};

Poisson::Poisson(const ControlVolumes& volumes, Problem problem)
    : volumes_(volumes), problem_(std::move(problem)) {
  solve();
}

/// The seeds, what is beside them, and what is beside that.
std::vector<std::uint32_t> Poisson::around(std::vector<std::uint32_t> seeds) const {
  constexpr int kRings = 2;
  auto found = std::move(seeds);
  std::size_t first = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const auto last = found.size();
    for (; first < last; ++first) {
      for (const auto number : volumes_.openPartsOf(found[first])) {
        const auto& part = volumes_.openParts()[number];
        for (const auto side : {part.below, part.above}) {
          if (side != kNone && std::ranges::find(found, side) == found.end()) found.push_back(side);
        }
      }
    }
  }
  return found;
}

Poisson::Combination Poisson::derivative(const Vec3<double>& at, const Vec3<double>& direction,
                                         const std::vector<std::uint32_t>& seeds) const {
  Fit fit(at, volumes_.width());
  for (const auto volume : around(seeds)) {
    fit.addValue(volume, volumes_.centroid(volume));
    for (const auto& wall : volumes_.walls(volume)) {
      fit.addCondition(pointOf(wall), problem_.condition(pointOf(wall)));
    }
    for (const auto number : volumes_.openPartsOf(volume)) {
      const auto& part = volumes_.openParts()[number];
      if (part.below != kNone && part.above != kNone) continue;
      fit.addCondition(sideOf(part), problem_.condition(sideOf(part)));
    }
  }
  return fit.derivative(direction);
}

Poisson::Combination Poisson::fluxThrough(const OpenPart& part) const {
  Combination flux;
  if (part.below == kNone || part.above == kNone) {
    const auto side = sideOf(part);
    const auto condition = problem_.condition(side);
    if (condition.kind == Condition::Kind::Derivative) {
      return {.constant = condition.value * side.normal[part.axis] * part.area};
    }
    flux = derivative(part.centroid, unit(part.axis, 1),
                      {part.above == kNone ? part.below : part.above});
  } else if (volumes_.isCell(part.below) && volumes_.isCell(part.above)) {
    flux.terms = {{part.above, 1 / volumes_.width()}, {part.below, -1 / volumes_.width()}};
  } else {
    flux = derivative(part.centroid, unit(part.axis, 1), {part.below, part.above});
  }
  for (auto& term : flux.terms) term.factor *= part.area;
  flux.constant *= part.area;
  return flux;
}

Poisson::Combination Poisson::fluxInto(const WallPart& wall, std::uint32_t volume) const {
  const auto condition = problem_.condition(pointOf(wall));
  if (condition.kind == Condition::Kind::Derivative) {
    return {.constant = condition.value * wall.area};
  }
  auto flux = derivative(wall.centroid, wall.normal, {volume});
  for (auto& term : flux.terms) term.factor *= wall.area;
  flux.constant *= wall.area;
  return flux;
}

/// The equations: what flows into a volume is its source.
struct Poisson::System {
  explicit System(std::uint32_t count) : right(count), sizes(count), matrix(count, count) {}

  void add(std::uint32_t row, const Combination& flux, double sign) {
    for (const auto& [volume, factor] : flux.terms) {
      entries.emplace_back(static_cast<int>(row), static_cast<int>(volume), sign * factor);
    }
    right(static_cast<Eigen::Index>(row)) -= sign * flux.constant;
  }
  /// Makes the entries of each row of one size. With derivatives alone, u has no mean: then the
  /// right side is shifted to what can be met, and the first row says that u is 0 there.
  void finish() {
    if (!isAnyValue) right -= sizes * (right.sum() / sizes.sum());
    matrix.setFromTriplets(entries.begin(), entries.end());
    using Entries = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator;
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      const bool isFixed = !isAnyValue && row == 0;
      if (isFixed) right(row) = 0;
      double largest = 0;
      for (Entries entry(matrix, row); entry; ++entry) {
        if (isFixed) entry.valueRef() = entry.col() == row ? 1 : 0;
        largest = std::max(largest, std::abs(entry.value()));
      }
      for (Entries entry(matrix, row); entry; ++entry) entry.valueRef() /= largest;
      right(row) /= largest;
    }
  }

  Eigen::VectorXd right;
  Eigen::VectorXd sizes;  ///< of the volumes
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix;
  bool isAnyValue = false;  ///< whether one is known at the boundary
};

Poisson::System Poisson::assemble() const {
  System system(volumes_.count());
  for (std::uint32_t volume = 0; volume < volumes_.count(); ++volume) {
    const double size = volumes_.volume(volume);
    system.sizes(volume) = size;
    system.right(volume) = problem_.source(volumes_.centroid(volume)) * size;
  }
  for (const auto& part : volumes_.openParts()) {
    const auto flux = fluxThrough(part);
    if (part.below != kNone) system.add(part.below, flux, 1);
    if (part.above != kNone) system.add(part.above, flux, -1);
    const bool isSide = part.below == kNone || part.above == kNone;
    if (isSide && !flux.terms.empty()) system.isAnyValue = true;
  }
  for (std::uint32_t volume = 0; volume < volumes_.count(); ++volume) {
    for (const auto& wall : volumes_.walls(volume)) {
      const auto flux = fluxInto(wall, volume);
      system.add(volume, flux, 1);
      if (!flux.terms.empty()) system.isAnyValue = true;
    }
  }
  system.finish();
  return system;
}

void Poisson::solve() {
  const auto system = assemble();
  Eigen::BiCGSTAB<Eigen::SparseMatrix<double, Eigen::RowMajor>, Eigen::IncompleteLUT<double>>
      solver;
  constexpr double kDropped = 1e-3;
  constexpr int kFill = 8;
  constexpr double kTolerance = 1e-12;
  solver.preconditioner().setDroptol(kDropped);
  solver.preconditioner().setFillfactor(kFill);
  solver.setTolerance(kTolerance);
  solver.compute(system.matrix);
  Eigen::VectorXd values = solver.solve(system.right);
  if (!system.isAnyValue) values.array() -= system.sizes.dot(values) / system.sizes.sum();
  values_.assign(values.begin(), values.end());
  residual_ = solver.error();
  iterations_ = static_cast<int>(solver.iterations());
}

Vec3<double> Poisson::gradient(const Vec3<double>& at) const {
  const auto volume = volumes_.at(at);
  Vec3<double> result;
  if (volume == kNone) return result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = derivative(at, unit(axis, 1), {volume});
    result[axis] = along.constant;
    for (const auto& term : along.terms) result[axis] += term.factor * values_[term.volume];
  }
  return result;
}
