#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Moments/Moments.hpp>
#include <Cutwater/CutCells/Detail/Tiles/OpenSides.hpp>

#include <map>
#include <tuple>

namespace cutwater {

void OpenSides::addTrace(const FaceTrace& trace, const PieceArc& arc) {
  for (const auto& end : {trace.start, trace.end}) {
    if (end.gridEdge != kNone) continue;
    ends_.emplace_back(end.meshEdge, static_cast<std::uint32_t>(parts_.size()));
  }
  parts_.push_back(arc);
}

std::vector<PieceArc> OpenSides::arcs() const {
  const auto sideOf = [](const PieceArc& arc) {
    return std::tuple(arc.below, arc.above, arc.face, arc.patch);
  };
  detail::DisjointSets sets(parts_.size());
  std::map<std::pair<decltype(sideOf({})), std::uint32_t>, std::uint32_t> ofEnd;
  for (const auto& [edge, part] : ends_) {
    const auto [other, isNew] = ofEnd.try_emplace({sideOf(parts_[part]), edge}, part);
    if (!isNew) sets.unite(part, other->second);
  }
  std::map<std::uint32_t, Moments> sums;  // by the first part
  for (std::uint32_t n = 0; n < parts_.size(); ++n) {
    const auto& arc = parts_[n];
    sums.try_emplace(sets.find(n), arc.centroid).first->second.add(arc.area, arc.centroid);
  }
  std::vector<PieceArc> result;
  for (const auto& [first, sum] : sums) {
    if (!(sum.size() > 0)) continue;
    auto& arc = result.emplace_back(parts_[first]);
    arc.area = sum.size();
    arc.centroid = sum.centroid();
  }
  return result;
}

}  // namespace cutwater
