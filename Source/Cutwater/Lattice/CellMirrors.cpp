#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Lattice/CellMirrors.hpp>

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

/// No chamber is outside of it.
constexpr Box<double> kAllChambers{{0, 0, -0.5}, {0.5, 0.5, 0.5}};

/// Shorter pieces are the ends of struts that meet a wall.
constexpr double kShortest = 1e-9;

std::optional<CellStrut> clipped(const CellStrut& strut, CellFold fold) {
  const auto along = strut.b - strut.a;
  double first = 0;
  double last = 1;
  for (const auto& wall : wallsOf(fold)) {
    const double from = wall.height(strut.a);
    const double change = wall.height(strut.b) - from;
    // Along a wall: on it within rounding, or beyond.
    if (std::abs(change) < kShortest) {
      if (from < -kShortest) return {};
    } else if (change > 0) {
      first = std::max(first, -from / change);
    } else {
      last = std::min(last, -from / change);
    }
  }
  if ((last - first) * length(along) < kShortest) return {};
  const auto at = [&](double t) { return t == 1 ? strut.b : strut.a + t * along; };
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
    const auto& [a, b] = struts[i];
    // Copies whose box meets that of the chambers.
    Vec3<double> first;
    Vec3<double> last;
    for (int axis = 0; axis < 3; ++axis) {
      first[axis] = std::ceil(kAllChambers.lower[axis] - std::max(a[axis], b[axis]) - kShortest);
      last[axis] = std::floor(kAllChambers.upper[axis] - std::min(a[axis], b[axis]) + kShortest);
    }
    for (double x = first.x; x <= last.x; ++x) {
      for (double y = first.y; y <= last.y; ++y) {
        for (double z = first.z; z <= last.z; ++z) {
          const Vec3<double> place{x, y, z};
          const CellStrut copy{a + place, b + place};
          if (const auto part = clipped(copy, fold)) found.push_back({*part, i, copy.middle()});
        }
      }
    }
  }
  return found;
}

}  // namespace cutwater::detail
