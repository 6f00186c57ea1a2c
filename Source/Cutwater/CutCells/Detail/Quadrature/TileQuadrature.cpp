#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>
#include <Cutwater/CutCells/Detail/Faces/SheetTree.hpp>
#include <Cutwater/CutCells/Detail/Moments/ArcMoments.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/RegionRule.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/TileQuadrature.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace cutwater {

namespace {

class TileRules {
 public:
  TileRules(const TileCut& cut, const CutCells::Moments& moments, const CutFrame& frame)
      : cut_(cut),
        walls_(cut.polygons.walls),
        wallOf_(cut.polygons.wallOf),
        moments_(moments),
        frame_(frame),
        ofPlanes_(moments.degree),
        ofPolyhedra_(moments.degree) {
    for (auto* rows : {&out_.volume, &out_.wall, &out_.arc}) rows->first = {0};
  }

  CutCells::Quadrature all() {
    const auto sides = sidesOf(cut_.content, cut_.numbers);
    std::size_t side = 0;
    std::size_t wall = 0;
    for (std::uint32_t piece = 0; piece < cut_.content.pieces.size(); ++piece) {
      const auto firstWall = wall;
      while (wall < wallOf_.size() && wallOf_[wall].first == piece) ++wall;
      const auto firstSide = side;
      while (side < sides.size() && sides[side].piece == piece) ++side;
      addVolume(piece, {firstWall, wall}, std::span(sides).subspan(firstSide, side - firstSide));
      addWall(piece, {firstWall, wall});
    }
    addArcs();
    return std::move(out_);
  }

 private:
  using Range = std::pair<std::size_t, std::size_t>;

  void addVolume(std::uint32_t number, const Range& walls, std::span<const PieceSide> sides) {
    closed_.clear();
    for (auto i = walls.first; i < walls.second; ++i) closed_.push_back({walls_.of(i), true});
    for (const auto& side : sides) {
      closed_.push_back({cut_.polygons.arcs.of(side.arc), side.face % 2 == 0});
    }
    const auto& piece = cut_.content.pieces[number];
    // In the units of the frame, as the sides.
    std::array<double, Monomials<3>::kCount> moments{};
    const auto ofPiece = moments_.ofVolume(number);
    for (std::size_t i = 0; i < ofPiece.size(); ++i) {
      moments[i] = ofPiece[i] * unitOf(frame_, 3 + kMonomials<3>[i].degree);
    }
    auto& rows = out_.volume;
    for (const auto& [at, weight] : ofPolyhedra_.of(
             closed_, std::span(moments).first(ofPiece.size()), asStated(frame_, piece.centroid))) {
      addPoint(at, weight, rows);
    }
    adjust(piece.volume, rows.first.back(), rows);
    addIfEmpty(piece.centroid, piece.volume, rows);
    endRow(3, rows);
  }

  void addWall(std::uint32_t number, const Range& walls) {
    auto& rows = out_.wall;
    for (auto i = walls.first; i < walls.second; ++i) {
      if (WallPolygons::isOfArc(wallOf_[i].second)) continue;
      const auto normal = addPolygon(walls_.of(i), rows);
      out_.wallNormals.resize(rows.points.size(), -normal);
    }
    const auto& piece = cut_.content.pieces[number];
    addIfEmpty(piece.wallCentroid, piece.area, rows);
    const double size = length(piece.areaVector);
    out_.wallNormals.resize(rows.points.size(),
                            size > 0 ? piece.areaVector / size : Vec3<double>{});
    endRow(2, rows);
  }

  void addArcs() {
    // Of arcs of open patches, the polygons.
    std::vector<std::pair<std::uint32_t, std::size_t>> openPolygons;
    for (std::size_t i = 0; i < wallOf_.size(); ++i) {
      const auto patch = wallOf_[i].second;
      if (WallPolygons::isOfArc(patch)) openPolygons.emplace_back(patch - WallPolygons::kOfArc, i);
    }
    std::ranges::stable_sort(openPolygons, {}, &std::pair<std::uint32_t, std::size_t>::first);
    auto open = openPolygons.begin();
    auto& rows = out_.arc;
    const auto& arcs = cut_.content.arcs;
    for (std::uint32_t arc = 0; arc < arcs.size(); ++arc) {
      addPolygon(cut_.polygons.arcs.of(arc), rows);
      for (; open != openPolygons.end() && open->first == arc; ++open) {
        addPolygon(walls_.of(open->second), rows);
      }
      addIfEmpty(arcs[arc].centroid, arcs[arc].area, rows);
      endRow(2, rows);
    }
  }

  /// The points of a plane polygon; returns its normal.
  Vec3<double> addPolygon(std::span<const Vec3<double>> polygon, CutCells::PointRows& rows) {
    const auto area = 0.5 * twiceArea(polygon);
    const double size = length(area);
    if (!(size > 0)) return {};
    const FaceAxes axes(nearestAxis(area));
    const auto inPlane = [&](const Vec3<double>& corner) {
      const auto way = corner - polygon[0];
      return PlaneRule::Point{way[axes.first], way[axes.second]};
    };
    rim_.clear();
    auto from = inPlane(polygon.back());
    for (const auto& corner : polygon) {
      const auto to = inPlane(corner);
      rim_.push_back(area[axes.across] > 0 ? PlaneRule::Edge{from, to} : PlaneRule::Edge{to, from});
      from = to;
    }
    const auto first = rows.points.size();
    for (const auto& [at, weight] : ofPlanes_.of(rim_)) {
      auto point = polygon[0];
      point[axes.first] += at[0];
      point[axes.second] += at[1];
      point[axes.across] -=
          (area[axes.first] * at[0] + area[axes.second] * at[1]) / area[axes.across];
      addPoint(point, weight * size / std::abs(area[axes.across]), rows);
    }
    adjust(size, first, rows);
    return area / size;
  }

  static void addPoint(const Vec3<double>& at, double weight, CutCells::PointRows& rows) {
    rows.points.push_back(at);
    rows.weights.push_back(weight);
  }

  /// Makes the weights from the first one on add up to `total`. If they differ by far, all is
  /// rounding of corners, and they are dropped.
  static void adjust(double total, std::size_t first, CutCells::PointRows& rows) {
    const auto weights = std::span(rows.weights).subspan(first);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    if (sum > 0.5 * total && sum < 2 * total) {
      for (double& weight : weights) weight *= total / sum;
    } else {
      rows.points.resize(first);
      rows.weights.resize(first);
    }
  }
  /// A row that is rounding has its centroid.
  static void addIfEmpty(const Vec3<double>& centroid, double total, CutCells::PointRows& rows) {
    if (total > 0 && rows.points.size() == rows.first.back()) addPoint(centroid, total, rows);
  }
  /// In the coordinates of the world; weights are lengths to this power.
  void endRow(int power, CutCells::PointRows& rows) {
    const double unit = unitOf(frame_, power);
    for (auto i = rows.first.back(); i < rows.points.size(); ++i) {
      rows.points[i] = frame_.toWorld(rows.points[i]);
      rows.weights[i] /= unit;
    }
    rows.first.push_back(rows.points.size());
  }

  const TileCut& cut_;
  const CutCells::Polygons& walls_;
  std::span<const std::pair<std::uint32_t, std::uint32_t>> wallOf_;
  const CutCells::Moments& moments_;
  const CutFrame& frame_;
  PlaneRule ofPlanes_;
  PolyhedronRule ofPolyhedra_;
  std::vector<PolyhedronRule::Side> closed_;
  std::vector<PlaneRule::Edge> rim_;
  CutCells::Quadrature out_;
};

}  // namespace

CutCells::Quadrature findQuadrature(const TileCut& cut, const CutCells::Moments& moments,
                                    const CutFrame& frame) {
  return TileRules(cut, moments, frame).all();
}

}  // namespace cutwater
