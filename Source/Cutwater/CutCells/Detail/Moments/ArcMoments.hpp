#pragma once

#include <Cutwater/CutCells/Detail/Faces/FaceFrame.hpp>
#include <Cutwater/CutCells/Detail/Moments/Monomials.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutSurface.hpp>

namespace cutwater {

/// A point in a tile's coordinates, rounded as it is in the world.
[[nodiscard]] inline Vec3<double> asStated(const CutFrame& frame, const Vec3<double>& point) {
  const auto p = frame.toWorld(point);
  return {frame.toFrame(0, p.x), frame.toFrame(1, p.y), frame.toFrame(2, p.z)};
}

/// A unit of the world to a power, in those of the frame: a power of two.
[[nodiscard]] inline double unitOf(const CutFrame& frame, int power) {
  double unit = 1;
  for (int n = 0; n < power; ++n) unit *= frame.scale;
  return unit;
}

/// The moments of the open parts of a tile's faces, in the coordinates of the tile, about centroids
/// as they are stated in the world.
///
/// Each straight part of a rim adds those of the triangle that it makes with a point of the part;
/// where triangles meet, those of its convex regions do.
class ArcMoments {
 public:
  /// Of the open parts of cut faces, of whole faces, which follow these, and of open patches. Views
  /// its arguments.
  ArcMoments(const FacePieces& faces, const CellPieces& content, const CutFrame& frame, int degree);

  [[nodiscard]] std::span<const double> of(std::size_t arc) const {
    return std::span(moments_).subspan(arc * count_, count_);
  }
  /// The point that they refer to.
  [[nodiscard]] Vec3<double> centroid(std::size_t arc) const {
    return asStated(frame_, arcs_[arc].centroid);
  }

 private:
  void addCutFace(std::uint32_t face);
  void addRegions(std::uint32_t face, int across);
  void addRims(const FaceFrame& frame);
  void addRimPart(std::uint32_t arc, const std::array<Vec3<double>, 2>& ends, int across);
  void addWholeFace(std::size_t arc);
  void addOpenPatches(const CellPieces& content);
  void addOpenPolygon(std::uint32_t arc, std::span<const Vec3<double>> points);
  void finishRim(std::uint32_t arc, int across);

  const FacePieces& faces_;
  std::span<const PieceArc> arcs_;
  const CutFrame& frame_;
  int degree_;
  std::size_t count_;
  std::vector<double> moments_;
  std::vector<Vec3<double>> references_;  // of arcs with a rim
  std::vector<char> hasReference_;
};

}  // namespace cutwater
