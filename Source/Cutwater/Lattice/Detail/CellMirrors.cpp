#include <Cutwater/Lattice/Detail/CellMirrors.hpp>

#include <algorithm>
#include <array>
#include <optional>

namespace cutwater::detail {

namespace {

constexpr std::array<ChamberWall, 6> kOctant{{{{1, 0, 0}, 0},
                                              {{0, 1, 0}, 0},
                                              {{0, 0, 1}, 0},
                                              {{-1, 0, 0}, -0.5},
                                              {{0, -1, 0}, -0.5},
                                              {{0, 0, -1}, -0.5}}};
constexpr std::array<ChamberWall, 5> kSortXY{
    {{{-1, 0, 0}, -0.5}, {{1, -1, 0}, 0}, {{0, 1, 0}, 0}, {{0, 0, 1}, 0}, {{0, 0, -1}, -0.5}}};
constexpr std::array<ChamberWall, 4> kSort{
    {{{-1, 0, 0}, -0.5}, {{1, -1, 0}, 0}, {{0, 1, -1}, 0}, {{0, 0, 1}, 0}}};
constexpr std::array<ChamberWall, 4> kFcc{
    {{{1, -1, 0}, 0}, {{0, 1, -1}, 0}, {{0, 1, 1}, 0}, {{-1, -1, 0}, -0.5}}};

// Struts reach up to 1.5 from their midpoints, which are in [0, 1); chambers are in [-1/2, 1/2].
// Copies farther away do not meet them.
constexpr int kFirst = -3;
constexpr int kAcross = 6;

/// Struts whose ends differ less in height above a wall count as parallel to it.
constexpr double kShallow = 1e-3;

/// The part in the chamber. It may be more, because all of the strut belongs to the lattice.
std::optional<CellStrut> clipped(const CellStrut& strut, CellFold fold) {
  const auto along = strut.b - strut.a;
  double first = 0;
  double last = 1;
  const auto at = [&](double t) { return t == 1 ? strut.b : strut.a + t * along; };
  for (const auto& wall : wallsOf(fold)) {
    const double from = wall.height(strut.a);
    const double change = wall.height(strut.b) - from;
    // Kept whole if parallel to a wall: rounding would decide where to cut it.
    if (std::abs(change) < kShallow) {
      if (from < -kShallow) return {};
    } else if (change > 0) {
      first = std::max(first, -from / change);
    } else {
      last = std::min(last, -from / change);
    }
  }
  // What ends at a wall, coming from outside, has an image inside that ends there, too.
  for (const auto& wall : wallsOf(fold)) {
    const double change = wall.height(strut.b) - wall.height(strut.a);
    if (std::abs(change) < kShallow) continue;
    if (wall.height(at(change > 0 ? last : first)) < kRounding) return {};
  }
  return CellStrut{at(first), at(last)};
}

}  // namespace

std::span<const ChamberWall> wallsOf(CellFold fold) {
  switch (fold) {
    case CellFold::Octant:
      return kOctant;
    case CellFold::SortXY:
      return kSortXY;
    case CellFold::Sort:
      return kSort;
    case CellFold::Fcc:
      return kFcc;
    default:
      return {};
  }
}

std::vector<ChamberStrut> strutsInChamber(std::span<const CellStrut> struts, CellFold fold) {
  std::vector<ChamberStrut> found;
  for (std::uint32_t i = 0; i < struts.size(); ++i) {
    for (int copy = 0; copy < kAcross * kAcross * kAcross; ++copy) {
      const int layer = copy / (kAcross * kAcross);
      const Vec3<double> place{1.0 * (copy % kAcross + kFirst),
                               1.0 * (copy / kAcross % kAcross + kFirst), 1.0 * (layer + kFirst)};
      const CellStrut moved{struts[i].a + place, struts[i].b + place};
      if (const auto part = clipped(moved, fold)) found.push_back({*part, i, moved.middle()});
    }
  }
  return found;
}

}  // namespace cutwater::detail
