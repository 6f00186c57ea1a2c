#pragma once

#include <Cutwater/CutCells/Detail/Curved/FluidParts.hpp>
#include <Cutwater/CutCells/Detail/Curved/FluidRule.hpp>

namespace cutwater {

/// Shares of a cell or of a face that are rounding.
inline constexpr double kNothingOfCell = 1e-14;

/// A connected open part of a face.
struct OpenPart {
  double area = 0;
  Vec3<double> centroid;
  Vec3<double> inside;           ///< a point of it
  std::vector<FluidSpan> spans;  ///< that make it up
};

/// What is open of a face, found of the face alone: so the cells on both sides find the same.
struct CurvedFace {
  std::vector<OpenPart> parts;
  double area = 0;
  double gap = 0;        ///< see FluidRule::gap()
  bool isWhole = false;  ///< all of it is open

  [[nodiscard]] bool isCut() const { return !parts.empty() && !isWhole; }
};

/// A face, given by its flat box, that is open.
[[nodiscard]] CurvedFace wholeFace(const Box<double>& face, FluidRule& rule);
/// Finds what is open of a face; see FluidRule::findIn().
[[nodiscard]] CurvedFace openPartsOf(const FluidField& field, const BoxView& face, FluidRule& rule,
                                     double tolerance);
/// Of one of which nothing is known yet.
[[nodiscard]] CurvedFace openPartsOf(const FluidField& field, const Box<double>& face,
                                     FluidRule& rule, double tolerance);

}  // namespace cutwater
