#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace cutwater {

/// How a mesh tells inside from outside.
enum class SignScheme : std::uint8_t {
  /// NearestFeature where a check finds the surface sound, else WindingNumber.
  Automatic,
  /// By the side of the nearest triangles, and by exact parity where those disagree: the fastest,
  /// and never wrong on a closed surface that does not meet itself. On others it is what the
  /// pseudonormal says, which may suit a sheet.
  NearestFeature,
  /// Inside where the winding number exceeds 1/2: for any surface. Overlapping shells are a union,
  /// holes are closed by the sheet on which the winding number is 1/2.
  WindingNumber,
};

/// Options of a MeshSDF: how signs are decided, and how closely the surface is checked.
struct MeshSDFOptions {
  SignScheme signs = SignScheme::Automatic;
  /// Refuse surfaces that do not bound a solid, as far as the check can tell.
  bool requireWatertight = false;
  /// Let the check look for self-intersections everywhere, which takes about as long as building
  /// the tree, and not at probes only.
  bool findSelfIntersections = false;
  /// Places of the surface (of its box, if it is open) that the check looks at, besides one per
  /// shell; fewer where thousands of triangles lie on one another.
  std::size_t probes = 1024;
};

/// What a mesh's signs rest on.
struct SignReport {
  SignScheme scheme = SignScheme::NearestFeature;
  std::size_t unbalancedEdges = 0;  ///< the triangles along them do not run both ways alike
  std::size_t shells = 0;
  std::size_t turnedFaces = 0;   ///< turned to agree with those around: see orientShells()
  std::size_t turnedShells = 0;  ///< stood inside out
  std::size_t unorientable = 0;  ///< parts like a Moebius strip

  /// Places that were looked at: see MeshSDFOptions::probes.
  std::size_t probes = 0;
  /// Closed surfaces: probes without the solid just behind them or without free space just before,
  /// because shells overlap, touch or are nested.
  std::size_t unsound = 0;
  /// Open surfaces: probes in the bounding box where the winding number is more than 0.1 from an
  /// integer, so that the sign is a matter of opinion.
  std::size_t ambiguous = 0;
  std::optional<std::size_t> selfIntersections =
      {};  ///< pairs of triangles, if they were looked for

  /// As many triangles run one way along every edge as the other way.
  [[nodiscard]] bool isClosed() const { return unbalancedEdges == 0; }
  /// Closed, and the check found nothing: signs are exact and distances those to the solid.
  [[nodiscard]] bool isSound() const {
    return isClosed() && unsound == 0 && unorientable == 0 && selfIntersections.value_or(0) == 0;
  }
  /// The share of the surface (or, of an open one, of its box) that may be unsound (ambiguous) with
  /// 95 % confidence: for none of n probes 3/n, else the share seen plus two standard deviations.
  [[nodiscard]] double doubt() const;

  /// One line: "nearest feature: closed; 1024 probes, all sound (at most 0.3 % of the surface
  /// unsound, 95 % confidence)".
  [[nodiscard]] std::string summary() const;
};

}  // namespace cutwater
