#pragma once

#include <Cutwater/CutCells/Detail/Faces/EdgeStretches.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceRegions.hpp>

namespace cutwater {

/// The open parts of all faces that the surface meets, in the order of faces.
///
/// Moments are sums over the boundary, by the divergence theorem in the plane: each trace and each
/// stretch adds its distance from a point of the part times the integral of the monomial along it.
class FacePieces {
 public:
  /// Of the faces of the cells that are wanted: see isWanted().
  FacePieces(const TileSurface& surface, const EdgeStretches& stretches, const GridPlanes& planes,
             const CellMask* wanted = nullptr);

  [[nodiscard]] std::span<const FacePiece> pieces() const { return pieces_; }
  /// What they were made of.
  [[nodiscard]] const TileSurface& surface() const { return surface_; }
  [[nodiscard]] const EdgeStretches& stretches() const { return stretches_; }
  [[nodiscard]] const GridPlanes& planes() const { return planes_; }

  /// The open part on whose rim a trace lies; kNone for traces with body on both sides.
  [[nodiscard]] std::uint32_t ofTrace(std::uint32_t trace) const { return ofTrace_[trace]; }
  /// The open part of a face that has a stretch of one of its edges on its rim: edges 0 and 1 along
  /// the first of the other axes, low and high, 2 and 3 along the second. Only for cut faces.
  [[nodiscard]] std::uint32_t ofStretch(std::uint32_t face, int side, std::size_t stretch) const;
  /// Whether the surface has a trace on the face.
  [[nodiscard]] bool isCut(std::uint32_t face) const { return cutFace(face) != kNone; }
  /// Whether traces on a cut face are those of triangles that meet others: the parts are those of
  /// FaceRegions, and are known by their number alone.
  [[nodiscard]] bool meetsOn(std::uint32_t face) const {
    return cutFaces_[cutFace(face)].regions != kNone;
  }
  /// Of a face on which triangles meet.
  [[nodiscard]] const FaceRegions& meetingRegions(std::uint32_t face) const {
    return regions_[cutFaces_[cutFace(face)].regions];
  }
  /// The convex regions of any face, each with the number of its open part: kNone where there is
  /// none, and on faces that are not cut.
  [[nodiscard]] std::vector<FaceRegions::Region> regionsOn(std::uint32_t face) const;
  /// The parts of a cut face.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> of(std::uint32_t face) const;
  /// The traces on a cut face: the first, and the one behind the last.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> tracesOf(std::uint32_t face) const {
    const auto& cut = cutFaces_[cutFace(face)];
    return {cut.firstTrace, cut.lastTrace};
  }
  /// The part in which a point of a cut face lies that is in the fluid, as far as rounding tells.
  [[nodiscard]] std::uint32_t at(std::uint32_t face, const Vec3<double>& point) const;

 private:
  struct CutFace {
    std::uint32_t face = 0;
    std::uint32_t firstTrace = 0;
    std::uint32_t lastTrace = 0;
    std::uint32_t firstPiece = 0;
    std::uint32_t regions = kNone;                ///< in regions_, if triangles meet
    std::array<std::uint32_t, 5> firstStretch{};  ///< in ofStretch_, per side; then the end
  };
  class Builder;

  [[nodiscard]] std::uint32_t cutFace(std::uint32_t face) const { return numberOf_[face]; }

  const TileSurface& surface_;
  const EdgeStretches& stretches_;
  const GridPlanes& planes_;
  std::vector<CutFace> cutFaces_;
  std::vector<std::uint32_t> numberOf_;  // by face: the cut face
  std::vector<FacePiece> pieces_;
  std::vector<FaceRegions> regions_;
  std::vector<std::uint32_t> ofTrace_;
  std::vector<std::uint32_t> ofStretch_;
};

}  // namespace cutwater
