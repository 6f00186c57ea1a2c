#pragma once

#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// What is wrong with a surface, and what that means for computing with it: the facts and judgement
// that pages and files show.
namespace cutwater::tool {

/// How much a defect matters for signs and distances.
enum class Severity : std::uint8_t {
  Error,    ///< the sign is ambiguous somewhere, or the surface bounds nothing
  Warning,  ///< handled, but in a way worth knowing
  Note,     ///< harmless
};

/// The place of a defect.
struct DefectPlace {
  Vec3<double> point;                ///< the middle of the edge or face, the vertex
  std::vector<std::uint32_t> faces;  ///< polygons counted from 0, where they are of use
};

struct Defect {
  Severity severity{};
  std::string key;      ///< for programs: "openEdges"
  std::string name;     ///< for people: "open edges"
  std::string meaning;  ///< consequence for signs and distances, a sentence
  std::size_t count = 0;
  bool isComplete = true;                ///< false: counting was stopped, there are more
  std::vector<DefectPlace> places = {};  ///< the first few
};

/// What the checks of a surface found, and how many seconds they took.
struct Examination {
  DcelMesh<double> mesh;
  MeshReport report;
  SelfIntersections selfIntersections;
  double secondsToCheck = 0;
  double secondsToSearch = 0;
};

[[nodiscard]] Examination examine(const PolygonSoup& soup);

/// Returns all defects, worst first. `signs`: as reported by the surface's MeshSDF; none if it has
/// no triangles.
[[nodiscard]] std::vector<Defect> findDefects(const PolygonSoup& soup, const Examination& found,
                                              const std::optional<SignReport>& signs);

/// Whether the surface bounds a solid without doubt, given its defects.
[[nodiscard]] bool isSound(const std::vector<Defect>& defects,
                           const std::optional<SignReport>& signs);

/// A sentence on what the surface is fit for.
[[nodiscard]] std::string verdict(const std::vector<Defect>& defects,
                                  const std::optional<SignReport>& signs);

/// The axis along which the surface has no extent, up to rounding, if there is one.
[[nodiscard]] std::optional<int> flatAxis(const PolygonSoup& soup);

/// "error", "warning" or "note".
[[nodiscard]] const char* nameOf(Severity severity);

}  // namespace cutwater::tool
