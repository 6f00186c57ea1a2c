#include <Cutwater/CutCells/Detail/Moments/Monomials.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/RegionRule.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>

namespace cutwater {

namespace {

/// Corners that are nearer to each other than this share of all are one: the difference is
/// rounding.
constexpr double kSame = 1e-14;

/// In shares of a volume, moments that are off by less are right but for rounding.
constexpr double kRounding = 1e-14;

/// Sorts coordinates, and leaves one of those that are the same.
void makeDistinct(std::vector<double>& corners) {
  if (corners.empty()) return;
  std::ranges::sort(corners);
  const double last = corners.back();
  const double same = kSame * (last - corners.front());
  const auto isNear = [same](double a, double b) { return b - a <= same; };
  corners.erase(std::unique(corners.begin(), corners.end(), isNear), corners.end());
  corners.back() = last;
}

/// The ends of parts between two coordinates.
void divide(double low, double high, int parts, std::vector<double>& ends) {
  ends.assign(1, low);
  for (int n = 1; n < parts; ++n) ends.push_back(low + n * (high - low) / parts);
  ends.push_back(high);
}

/// Points for the rough weights of a rule for this degree.
std::span<const GaussPoint> roughPoints(int degree) {
  return gaussPoints(degree + 1);
}

/// Calls visit(at, weight) for Gauss points in each of the parts between these ends.
template <typename Visit>
void forParts(std::span<const GaussPoint> rule, std::span<const double> ends, const Visit& visit) {
  if (ends.empty()) return;
  forStretches(rule, ends[0], ends.subspan(1),
               [&](double at, double weight, std::uint32_t) { visit(at, weight); });
}

/// The distance to a coordinate that is farthest from another one; 1 in place of none.
double farthest(double from, double low, double high) {
  const double distance = std::max(from - low, high - from);
  return distance > 0 ? distance : 1;
}

/// Of all points, those that are left.
template <typename Point>
void keepFew(FewerPoints& few, std::vector<WeightedPoint<Point>>& points) {
  std::size_t count = 0;
  for (const auto& [point, weight] : few.take()) points[count++] = {points[point].at, weight};
  points.resize(count);
}

}  // namespace

PlaneRule::PlaneRule(int degree) : degree_(degree), few_(Monomials<2>::count(degree)) {}

PlaneRule::Points PlaneRule::of(std::span<const Edge> rim) {
  corners_.clear();
  for (const auto& edge : rim) {
    corners_.push_back(edge.from[0]);
    corners_.push_back(edge.to[0]);
  }
  makeDistinct(corners_);
  addLines(rim, gaussOfDegree(degree_ + 1));
  const auto count = Monomials<2>::count(degree_);
  if (points_.size() <= count) return points_;
  const auto [low, high] =
      std::ranges::minmax(points_, {}, [](const auto& point) { return point.at[1]; });
  const Point middle{std::midpoint(corners_.front(), corners_.back()),
                     std::midpoint(low.at[1], high.at[1])};
  const Point size{farthest(middle[0], corners_.front(), corners_.back()),
                   farthest(middle[1], low.at[1], high.at[1])};
  std::array<double, Monomials<2>::kCount> values{};
  for (const auto& [at, weight] : points_) {
    evaluate<2>({(at[0] - middle[0]) / size[0], (at[1] - middle[1]) / size[1]},
                std::span(values).first(count));
    few_.add(std::span(values).first(count), weight);
  }
  keepFew(few_, points_);
  return points_;
}

PlaneRule::Points PlaneRule::roughlyOf(std::span<const Edge> rim, int parts) {
  double low = rim.empty() ? 0 : rim.front().from[0];
  double high = low;
  for (const auto& edge : rim) {
    low = std::min({low, edge.from[0], edge.to[0]});
    high = std::max({high, edge.from[0], edge.to[0]});
  }
  divide(low, high, parts, corners_);
  addLines(rim, roughPoints(degree_));
  return points_;
}

void PlaneRule::addLines(std::span<const Edge> rim, std::span<const GaussPoint> across) {
  points_.clear();
  forParts(across, corners_, [&](double at, double weight) { addLine(at, weight, rim); });
}

/// The part of a line along the second axis that lies in the region.
void PlaneRule::addLine(double at, double weight, std::span<const Edge> rim) {
  crossings_.clear();
  for (const auto& [from, to] : rim) {
    const bool enters = from[0] < at;
    if (enters == (to[0] < at)) continue;
    const double share = (at - from[0]) / (to[0] - from[0]);
    crossings_.emplace_back(from[1] + share * (to[1] - from[1]), enters ? 1 : -1);
  }
  std::ranges::sort(crossings_);
  int winding = 0;
  for (std::size_t i = 0; i + 1 < crossings_.size(); ++i) {
    winding += crossings_[i].second;
    if (winding < 1) continue;
    forParts(gaussOfDegree(degree_), std::array{crossings_[i].first, crossings_[i + 1].first},
             [&](double along, double share) {
               points_.push_back({{at, along}, weight * share});
             });
  }
}

PolyhedronRule::PolyhedronRule(int degree)
    : degree_(degree), ofSections_(degree), few_(Monomials<3>::count(degree)) {}

PolyhedronRule::Points PolyhedronRule::of(std::span<const Side> sides,
                                          std::span<const double> moments,
                                          const Vec3<double>& about) {
  measure(sides);
  for (const int parts : {1, 2, 4, kBetweenCorners}) {
    addSections(sides, parts);
    if (fit(moments, about)) break;
  }
  const auto count = Monomials<3>::count(degree_);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    few_.add(std::span(values_).subspan(i * count, count), points_[i].weight);
  }
  keepFew(few_, points_);
  return points_;
}

/// Sections are across the axis along which the fewest corners lie, lines across the next.
void PolyhedronRule::measure(std::span<const Side> sides) {
  for (int axis = 0; axis < 3; ++axis) {
    auto& along = corners_[asIndex(axis)];
    along.clear();
    for (const auto& side : sides) {
      for (const auto& corner : side.corners) along.push_back(corner[axis]);
    }
    makeDistinct(along);
  }
  axes_ = {0, 1, 2};
  const auto cornersAlong = [&](int axis) { return corners_[asIndex(axis)].size(); };
  std::stable_sort(axes_.begin(), axes_.end(),
                   [&](int a, int b) { return cornersAlong(a) < cornersAlong(b); });
}

void PolyhedronRule::addSections(std::span<const Side> sides, int parts) {
  points_.clear();
  const auto& corners = corners_[asIndex(axes_[0])];
  if (corners.empty()) return;
  if (parts == kBetweenCorners) {
    ends_ = corners;
  } else {
    divide(corners.front(), corners.back(), parts, ends_);
  }
  const auto across = parts == kBetweenCorners ? gaussOfDegree(degree_ + 2) : roughPoints(degree_);
  forParts(across, ends_, [&](double at, double weight) { addSection(at, weight, sides, parts); });
}

void PolyhedronRule::addSection(double at, double weight, std::span<const Side> sides, int parts) {
  section_.clear();
  for (const auto& side : sides) addSectionOf(side, at);
  const auto inPlane =
      parts == kBetweenCorners ? ofSections_.of(section_) : ofSections_.roughlyOf(section_, parts);
  for (const auto& [point, share] : inPlane) {
    auto& added = points_.emplace_back();
    added.weight = weight * share;
    added.at[axes_[0]] = at;
    added.at[axes_[1]] = point[0];
    added.at[axes_[2]] = point[1];
  }
}

/// Where the edges of a side meet the section's plane, straight parts of it begin and end. They are
/// given from and to the first of these points, so that none needs to be paired. The points of an
/// edge are the same bits for both of its sides, so that sections are closed.
void PolyhedronRule::addSectionOf(const Side& side, double at) {
  const bool isEven = (axes_[1] + 3 - axes_[0]) % 3 == 1;
  const auto& corners = side.corners;
  PlaneRule::Point first{};
  bool hasFirst = false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& from = corners[k];
    const auto& to = corners[k + 1 < corners.size() ? k + 1 : 0];
    const bool rises = from[axes_[0]] < at;
    if (rises == (to[axes_[0]] < at)) continue;
    const auto& low = rises ? from : to;
    const auto& high = rises ? to : from;
    const auto point = low + (at - low[axes_[0]]) / (high[axes_[0]] - low[axes_[0]]) * (high - low);
    const PlaneRule::Point inPlane{point[axes_[1]], point[axes_[2]]};
    if (!hasFirst) {
      first = inPlane;
      hasFirst = true;
    } else if ((rises != side.isReversed) == isEven) {
      section_.push_back({first, inPlane});
    } else {
      section_.push_back({inPlane, first});
    }
  }
}

/// Multiplies the weights by a polynomial, so that they have these moments: of w p with the
/// polynomials q, the sum is that of p times the Gram matrix of the weights. False, and nothing is
/// changed, if it is not positive at all points, or does not exist.
bool PolyhedronRule::fit(std::span<const double> moments, const Vec3<double>& about) {
  if (points_.empty()) return false;
  const auto count = Monomials<3>::count(degree_);
  Vec3<double> size;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& along = corners_[asIndex(axis)];
    size[axis] = farthest(about[axis], along.front(), along.back());
  }
  const auto rows = static_cast<Eigen::Index>(count);
  const auto columns = static_cast<Eigen::Index>(points_.size());
  values_.resize(count * points_.size());
  Eigen::VectorXd weights(columns);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto way = points_[i].at - about;
    evaluate<3>({way.x / size.x, way.y / size.y, way.z / size.z},
                std::span(values_).subspan(i * count, count));
    weights[static_cast<Eigen::Index>(i)] = points_[i].weight;
  }
  Eigen::VectorXd wanted(rows);
  for (std::size_t i = 0; i < count; ++i) {
    double unit = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int n = 0; n < kMonomials<3>[i].powers[axis]; ++n) {
        unit *= size[static_cast<int>(axis)];
      }
    }
    wanted[static_cast<Eigen::Index>(i)] = moments[i] / unit;
  }
  const Eigen::Map<const Eigen::MatrixXd> values(values_.data(), rows, columns);
  // Point by point, as Eigen may use threads for products of matrices.
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(rows, rows);
  for (Eigen::Index i = 0; i < columns; ++i) {
    gram.selfadjointView<Eigen::Lower>().rankUpdate(values.col(i), weights[i]);
  }
  const Eigen::LDLT<Eigen::MatrixXd> solver(gram);
  Eigen::VectorXd fitted = weights;
  Eigen::VectorXd off = wanted - values * fitted;
  for (int pass = 0; pass < 2; ++pass) {  // the second one for rounding
    fitted += weights.cwiseProduct(values.transpose() * solver.solve(off));
    off = wanted - values * fitted;
  }
  const bool isRight = off.lpNorm<Eigen::Infinity>() <= kRounding * moments[0];
  if (!isRight || !(fitted.minCoeff() > 0)) return false;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    points_[i].weight = fitted[static_cast<Eigen::Index>(i)];
  }
  return true;
}

}  // namespace cutwater
