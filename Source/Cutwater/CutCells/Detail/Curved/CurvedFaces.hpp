#pragma once

#include <Cutwater/CutCells/Detail/Curved/FluidParts.hpp>
#include <Cutwater/CutCells/Detail/Curved/FluidRule.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>

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
  /// What tells parts apart if there are several, and the number of each among these; kNone if it
  /// is none of them.
  std::optional<FluidParts> connected = {};
  std::vector<std::uint32_t> partOf = {};

  /// The part of a point in the fluid; the first one, if it is in none.
  [[nodiscard]] std::size_t partAt(const Vec3<double>& point) const {
    const auto part = connected ? partOf[connected->at(point)] : 0;
    return part == kNone ? 0 : part;
  }
  [[nodiscard]] bool isCut() const { return !parts.empty() && !isWhole; }
  /// Moves it to another plane across its axis, where this field has the same values.
  void moveTo(int axis, double plane, const FluidField& field);
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
