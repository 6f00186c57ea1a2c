#pragma once

#include <Cutwater/Core/Vec3.hpp>

namespace cutwater::benchmarks {

/// Corners in a row: a query reads one or two cache lines and follows no index.
struct Corners {
  Vec3<double> a, b, c;
};

/// Where on a triangle its closest point lies; the edges follow the vertices.
enum Part : unsigned { kVertexA, kVertexB, kVertexC, kEdgeAB, kEdgeBC, kEdgeCA, kFace };

struct ClosestPoint {
  Vec3<double> offset;  ///< from the closest point to the query point
  Part part = kFace;
};

/// By the triangle's Voronoi regions (C. Ericson, "Real-Time Collision Detection", 2005, 5.1.5):
/// what a user of these peers would write.
inline ClosestPoint closestPoint(const Vec3<double>& p, const Corners& triangle) {
  const auto& [a, b, c] = triangle;
  const auto ab = b - a;
  const auto ac = c - a;
  const auto ap = p - a;
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {ap, kVertexA};

  const auto bp = p - b;
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {bp, kVertexB};

  const auto cp = p - c;
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {cp, kVertexC};

  const double ofC = d1 * d4 - d3 * d2;
  if (ofC <= 0 && d1 >= 0 && d3 <= 0) return {ap - d1 / (d1 - d3) * ab, kEdgeAB};
  const double ofB = d5 * d2 - d1 * d6;
  if (ofB <= 0 && d2 >= 0 && d6 <= 0) return {ap - d2 / (d2 - d6) * ac, kEdgeCA};
  const double ofA = d3 * d6 - d5 * d4;
  if (ofA <= 0 && d4 >= d3 && d5 >= d6) {
    return {bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), kEdgeBC};
  }
  const double scale = 1 / (ofA + ofB + ofC);
  return {ap - (ofB * scale * ab + ofC * scale * ac), kFace};
}

}  // namespace cutwater::benchmarks
