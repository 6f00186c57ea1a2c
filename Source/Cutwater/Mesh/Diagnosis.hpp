#pragma once

#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Sdf/Guarantee.hpp>
#include <Cutwater/Surface/Cleaning/Clean.hpp>
#include <Cutwater/Surface/Cleaning/Rims.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>

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

/// How much a defect matters for signs and distances.
enum class Severity : std::uint8_t {
  Error,    ///< the sign is ambiguous somewhere, or the surface bounds nothing
  Warning,  ///< handled, but in a way worth knowing
  Note,     ///< harmless
};

/// "error", "warning" or "note".
[[nodiscard]] const char* nameOf(Severity severity);

/// The place of a defect.
struct DefectPlace {
  Vec3<double> point;                ///< the middle of the edge or face, the vertex
  std::vector<std::uint32_t> faces;  ///< polygons counted from 0, where they are of use
};

/// Defects of one kind that a surface has. Docs/diagnosis.md lists the kinds.
struct Defect {
  Severity severity{};
  std::string key;      ///< for programs: "openEdges"
  std::string name;     ///< for people: "open edges"
  std::string meaning;  ///< consequence for signs and distances, a sentence
  std::size_t count = 0;
  bool isComplete = true;                ///< false: counting was stopped, there are more
  std::vector<DefectPlace> places = {};  ///< the first few
};

/// A loop of open edges, as it is after cleaning and the welding that is worth it.
struct Opening {
  std::size_t edges = 0;
  Box<double> box;
  std::optional<AxisPlane> plane;  ///< across an axis, if it lies in one: 1e-4 of the diagonal
};

/// Wall time of the steps of diagnose(), in seconds.
struct DiagnosisSeconds {
  double check = 0;              ///< connecting the faces, and check()
  double selfIntersections = 0;  ///< findSelfIntersections()
  double build = 0;              ///< of the MeshSDF
  double treatments = 0;         ///< trying repairs
};

/// What a surface is good for: what is wrong with it, what that means for signs and distances, and
/// which repairs help.
struct Diagnosis {
  MeshReport report;
  SelfIntersections selfIntersections;
  /// How a MeshSDF<double> of the surface decides signs, what its distances are, and its size in
  /// bytes; none if there are no triangles.
  std::optional<SignReport> signs;
  std::optional<Guarantee<double>> guarantee;
  std::size_t memoryBytes = 0;
  /// The volume of the solid that the signs describe: that of the shells, turned outward. None
  /// where they may overlap, or are open.
  std::optional<double> solidVolume;
  std::vector<Defect> defects;  ///< the worst first
  /// Repairs that help. The first is recommended, others are alternatives.
  std::vector<Treatment> treatments;
  std::vector<Opening> openings;  ///< the largest first
  /// Where signs stay a matter of opinion whatever treatment: a gap for wrap() to close all of it.
  std::optional<double> wrapGap;
  DiagnosisSeconds seconds;

  /// Whether the surface bounds a solid without doubt.
  [[nodiscard]] bool isSound() const;
  /// A sentence on what the surface is fit for.
  [[nodiscard]] std::string verdict() const;
};

/// Options of diagnose().
struct DiagnosisOptions {
  /// Whether to look for treatments and openings, too, if there are defects.
  bool tryTreatments = true;
  /// Fills holes where nothing else closes the surface; if empty, that is not tried. The library
  /// has no such function of its own: see HoleFilling.
  HoleFilling fillHoles = {};
  /// Called before each step with what it does: "checking", "building", ...
  std::function<void(const char* step)> onStep = {};
};

/// Examines a surface as `cutwater info` does: its defects and their meaning, and repairs, which
/// are tried on a copy, so that only effects that occur are promised.
///
/// Treatments are cleaning; if the surface is open, tolerances for welding and T-junctions that
/// close gaps; then caps, a mirror image or an extension for openings in planes across an axis;
/// then fillHoles. Defects that are not there are not listed; a surface without any has no
/// treatments. Takes about as long as building two MeshSDFs and, where there are defects, cleaning
/// the surface up to some ten times.
/// @throws Error as DcelMesh does for an invalid soup.
[[nodiscard]] Diagnosis diagnose(const PolygonSoup& soup, const DiagnosisOptions& options = {});

}  // namespace cutwater
