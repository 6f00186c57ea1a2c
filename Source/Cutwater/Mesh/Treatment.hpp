#pragma once

#include <Cutwater/Surface/Cleaning/Clean.hpp>
#include <Cutwater/Surface/Cleaning/Rims.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cutwater {

/// How openings in a plane across an axis are closed.
enum class ClosingKind : std::uint8_t {
  Cap,     ///< by faces in the plane, see capOnPlane()
  Mirror,  ///< by the mirror image, see mirrorAt()
  Extend,  ///< by walls from the rims to the plane, and an end there, see extendTo()
};

/// One step of a treatment: openings are closed at a plane.
struct PlaneClosing {
  ClosingKind kind = ClosingKind::Cap;
  AxisPlane plane;
};

/// Something that a treatment does, and how often: "faces turned", 3.
struct TreatmentEffect {
  std::string what;
  std::size_t count = 0;
};

/// A repair of a surface, in the order of its members. diagnose() suggests some, treat() carries
/// them out.
struct Treatment {
  CleanOptions clean;
  std::vector<PlaneClosing> closings = {};
  double tolerance = 0;  ///< of caps and mirror images, a length: see CapOptions, mirrorAt()
  std::optional<double> widestHole = {};  ///< then holes up to this width are filled

  std::string effect = {};  ///< as tried by diagnose(): what it does and what remains, in words
  bool isClosed = false;    ///< likewise: afterwards no edge is open or has faces in excess
};

/// Fills the holes of a surface that are no wider than `widest`, and returns how many. For programs
/// that link Cutwater::Repair:
///
///     [](PolygonSoup& soup, double widest) {
///       return fillHoles(soup, {.widest = widest}).filled.count;
///     }
using HoleFilling = std::function<std::size_t(PolygonSoup& soup, double widest)>;

/// Carries out a treatment, and returns what it did, each kind of effect once.
/// @throws Error as clean(), capOnPlane(), mirrorAt(), extendTo() and `fillHoles` do, the steps
/// before being done then; Error(Argument) if holes are to be filled and `fillHoles` is empty.
std::vector<TreatmentEffect> treat(PolygonSoup& soup, const Treatment& treatment,
                                   const HoleFilling& fillHoles = {});

}  // namespace cutwater
