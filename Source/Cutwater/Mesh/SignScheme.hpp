#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace cutwater {

/// How a mesh distinguishes inside from outside.
enum class SignScheme : std::uint8_t {
  /// NearestFeature if a check finds the surface sound, else WindingNumber.
  Automatic,
  /// By the side of the nearest triangles, and by exact parity where those disagree: the fastest
  /// scheme, and never wrong on a closed surface without self-intersections. On open surfaces the
  /// sign is that of the pseudonormal, which may suit a sheet. Where a surface is not sound, it
  /// jumps, and the solid behind it may have no end: the guarantee is SignOnly, boundingBox() is
  /// infinite, and few boxes are decided.
  NearestFeature,
  /// Inside where the winding number exceeds 1/2, for any surface. Overlapping shells form a union;
  /// holes are closed by the sheet on which the winding number is 1/2.
  WindingNumber,
};

/// Options of a MeshSDF: how signs are decided, and how closely the surface is checked.
struct MeshSDFOptions {
  SignScheme signs = SignScheme::Automatic;
  /// Refuse surfaces that do not bound a solid, as far as the check can detect.
  bool requireWatertight = false;
  /// Look for self-intersections of a closed surface everywhere, by exact predicates, so that none
  /// is missed. If false, only probes may notice them. Of an open surface, and of one that meets
  /// itself, triangles that others come close to are looked for: signs are the same if not, but
  /// those near the others take three to six times as long.
  bool findSelfIntersections = true;
  /// Places in the box of an open surface that the check examines; on a closed one, besides one per
  /// shell, where it has not been searched, or meets itself or is nested: then they tell how much
  /// of it that concerns. Fewer where thousands of triangles lie on top of one another.
  std::size_t probes = 1024;
};

/// What the signs of a mesh are based on.
struct SignReport {
  SignScheme scheme = SignScheme::NearestFeature;
  std::size_t unbalancedEdges = 0;  ///< triangles run more often one way than the other
  std::size_t shells = 0;
  std::size_t turnedFaces = 0;   ///< turned to agree with their neighbours: see orientFaces()
  std::size_t turnedShells = 0;  ///< turned because they were inside out
  std::size_t unorientable = 0;  ///< parts like a Moebius strip

  /// Places that were examined: see MeshSDFOptions::probes.
  std::size_t probes = 0;
  /// Closed surfaces: probes without the solid just behind them or without free space just in
  /// front, because shells overlap, touch or are nested.
  std::size_t unsound = 0;
  /// Open surfaces: probes in the bounding box where the winding number is more than 0.1 from an
  /// integer, so the sign is ambiguous.
  std::size_t ambiguous = 0;
  /// Pairs of triangles that pass through or lie on one another, at most 1 000 000; empty if they
  /// were not looked for. Those that touch along edges or at corners, as at T-junctions, do not
  /// count, unlike in findSelfIntersections(): signs and distances are exact there.
  std::optional<std::size_t> selfIntersections = {};
  /// Closed surfaces that were searched and do not meet themselves: the sides of triangles that
  /// lie, in part or all, on edges of other triangles without being one with them. T-junctions that
  /// triangles without area close do not count.
  std::size_t touchingEdges = 0;
  /// Closed surfaces that were searched: no triangles pass through or lie on one another, and each
  /// part of the surface between edges where more than two triangles meet has the solid just behind
  /// it and free space just in front.
  /// The check examined one place on each, since what is true there is true all over the part.
  bool isProven = false;

  /// Along every edge, as many triangles run one way as the other.
  [[nodiscard]] bool isClosed() const { return unbalancedEdges == 0; }
  /// Closed, and the check found nothing: signs are exact, and distances are those to the solid.
  /// Certain if isProven.
  [[nodiscard]] bool isSound() const {
    return isClosed() && unsound == 0 && unorientable == 0 && selfIntersections.value_or(0) == 0;
  }
  /// The share of the surface (for an open one, of its box) that may be unsound (ambiguous), with
  /// 95 % confidence: 3/n if none of n probes is, else the observed share plus two standard
  /// deviations.
  [[nodiscard]] double doubt() const;

  /// One line: "nearest feature: closed; 1024 probes, all sound (at most 0.3 % of the surface
  /// unsound, 95 % confidence)".
  [[nodiscard]] std::string summary() const;
};

}  // namespace cutwater
