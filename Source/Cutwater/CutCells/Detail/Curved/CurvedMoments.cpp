#include <Cutwater/CutCells/Detail/Curved/CurvedMoments.hpp>
#include <Cutwater/CutCells/Detail/Moments/Monomials.hpp>

#include <algorithm>
#include <array>

namespace cutwater {

namespace {

/// Points along a span: exact for the highest degree of moments.
constexpr int kAlongSpan = CutCells::Moments::kHighest / 2 + 1;

template <typename Visit>
void forPoints(std::span<const FluidSpan> spans, int along, const Visit& visit) {
  for (const auto& span : spans) {
    const double from = span.line.start[span.line.axis];
    for (const auto& g : gaussPoints(along)) {
      visit(span.line.at(from + g.at * span.line.length()), g.weight * span.size());
    }
  }
}

template <typename Value>
std::span<Value> appended(std::size_t count, std::vector<Value>& rows) {
  rows.resize(rows.size() + count);
  return std::span(rows).last(count);
}

void endRow(CutCells::PointRows& rows) {
  if (rows.first.empty()) rows.first.push_back(0);
  rows.first.push_back(rows.points.size());
}

void addSpans(std::span<const FluidSpan> spans, int along, CutCells::PointRows& to) {
  forPoints(spans, along, [&](const Vec3<double>& at, double weight) {
    to.points.push_back(at);
    to.weights.push_back(weight);
  });
  endRow(to);
}

}  // namespace

void addArcPoints(const OpenPart& part, int points, CutCells::Quadrature& to) {
  addSpans(part.spans, points, to.arc);
}

void addPiecePoints(const RulePoints& rule, int points, CutCells::Quadrature& to) {
  addSpans(rule.spans, points, to.volume);
  for (const auto& wall : rule.walls) {
    to.wall.points.push_back(wall.at);
    to.wall.weights.push_back(wall.weight);
    to.wallNormals.push_back(wall.normal);
  }
  endRow(to.wall);
}

void addArcMoments(const OpenPart& part, int axis, CutCells::Moments& to) {
  const auto sums = appended(to.perArc(), to.arc);
  std::array<double, Monomials<2>::kCount> monomials{};
  forPoints(part.spans, kAlongSpan, [&](const Vec3<double>& at, double weight) {
    evaluate(alongFace(at - part.centroid, axis), std::span(monomials).first(sums.size()));
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += weight * monomials[i];
  });
}

void addPieceMoments(const CellPiece& piece, const RulePoints& rule, CutCells::Moments& to) {
  const auto count = to.perPiece();
  const auto volume = appended(count, to.volume);
  const auto wall = appended(count, to.wall);
  const auto vector = appended(count, to.wallVector);
  std::array<double, Monomials<3>::kCount> monomials{};
  const auto at = std::span(monomials).first(count);
  forPoints(rule.spans, kAlongSpan, [&](const Vec3<double>& point, double weight) {
    evaluate(asArray(point - piece.centroid), at);
    for (std::size_t i = 0; i < count; ++i) volume[i] += weight * at[i];
  });
  for (const auto& point : rule.walls) {
    evaluate(asArray(point.at - piece.wallCentroid), at);
    for (std::size_t i = 0; i < count; ++i) {
      wall[i] += point.weight * at[i];
      vector[i] += point.weight * at[i] * point.normal;
    }
  }
  vector[0] = piece.areaVector;
}

}  // namespace cutwater
