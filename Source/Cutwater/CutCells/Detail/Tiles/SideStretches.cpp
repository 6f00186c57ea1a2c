#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>
#include <Cutwater/CutCells/Detail/Tiles/SideStretches.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

SideStretches::SideStretches(const TileSurface& surface, const EdgeStretches& stretches,
                             const GridPlanes& planes)
    : stretches_(stretches), numbers_(surface.numbers()) {
  std::map<std::uint32_t, Baffles> baffles;
  for (const auto& crossing : surface.baffleCrossings()) {
    if (numbers_.axisOfEdge(crossing.edge) == 2) continue;
    baffles[crossing.edge].crossings.push_back(crossing.position);
  }
  for (const auto& trace : surface.traces()) {
    if (!surface.isBaffle(trace.triangle) || numbers_.axisOfFace(trace.face) != 2) continue;
    for (int side = 0; side < 4; ++side) {
      const auto [axis, place] = edgeOfFace(2, numbers_.placeOfFace(trace.face), side);
      const double at = planes.at(1 - axis, place[asIndex(1 - axis)]);
      const auto isOn = [&, across = 1 - axis](const Vec3<double>& p) {
        return std::abs(p[across] - at) <= EdgeStretch::kRounding;
      };
      const auto [lower, upper] = std::minmax({trace.from[axis], trace.to[axis]});
      if (!isOn(trace.from) || !isOn(trace.to) || upper - lower <= EdgeStretch::kRounding) continue;
      baffles[numbers_.edge(axis, place)].covers.push_back({lower, upper});
    }
  }
  for (const auto& [edge, onEdge] : baffles) {
    const auto whole = stretches.of(numbers_.axisOfEdge(edge), numbers_.placeOfEdge(edge));
    divided_[edge] = divided(whole, onEdge);
  }
}

std::span<const EdgeStretch> SideStretches::of(int axis, const TilePlace& first) const {
  const auto found = divided_.find(numbers_.edge(axis, first));
  return found == divided_.end() ? stretches_.of(axis, first) : std::span(found->second);
}

std::vector<EdgeStretch> SideStretches::divided(std::span<const EdgeStretch> stretches,
                                                const Baffles& baffles) {
  std::vector<EdgeStretch> result;
  for (const auto& stretch : stretches) {
    std::vector<double> ends{stretch.from, stretch.to};
    const auto add = [&](double end) {
      if (stretch.from < end && end < stretch.to) ends.push_back(end);
    };
    for (const double crossing : baffles.crossings) add(crossing);
    for (const auto& cover : baffles.covers) {
      add(cover.lower);
      add(cover.upper);
    }
    std::ranges::sort(ends);
    for (std::size_t n = 1; n < ends.size(); ++n) {
      const EdgeStretch part{.from = ends[n - 1], .to = ends[n]};
      const auto hides = [&](const Interval<double>& cover) {
        return cover.contains(part.middle());
      };
      if (part.from < part.to && std::ranges::none_of(baffles.covers, hides)) {
        result.push_back(part);
      }
    }
  }
  return result;
}

}  // namespace cutwater
