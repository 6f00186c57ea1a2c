#pragma once

#include <Cutwater/Surface/Detail/PairTest.hpp>

#include <array>
#include <optional>
#include <vector>

namespace cutwater {

/// Triangles that lie so close together that their boxes say little, such as those around one
/// vertex, with the pairs among them that are to be decided: each member with each guest, and with
/// each other member if `within` is set. Ascending.
struct Crowd {
  std::vector<std::uint32_t> members;
  std::vector<std::uint32_t> guests = {};
  bool within = true;

  [[nodiscard]] std::size_t size() const { return members.size() + guests.size(); }
  /// Whether there is no pair to decide.
  [[nodiscard]] bool isDecided() const {
    return members.empty() || (guests.empty() && (!within || members.size() == 1));
  }
};

/// Splits a crowd by a plane. Each of its pairs is in exactly one part, or has a triangle on either
/// side, and then does not meet. None if no plane was found that leaves less work.
///
/// The planes are tried on a sample. Some are perpendicular to the directions in which triangles
/// extend most or least. Others lead exactly through the one or two vertices that most of the
/// triangles share: triangles that touch the plane there alone, from either side, have only these
/// vertices in common. Exact predicates tell the sides, so a fan of n triangles takes n log n.
[[nodiscard]] std::optional<std::array<Crowd, 3>> split(const PairTest& pairs, const Crowd& crowd);

}  // namespace cutwater
