#include <Cutwater/CutCells/Detail/Rows/MergeGraph.hpp>

#include <algorithm>
#include <set>
#include <tuple>

namespace cutwater {

namespace {

/// Of a cell's largest face: a wall's vector that is less is rounding.
constexpr double kNoDirection = 1e-13;

}  // namespace

void MergeGraph::add(const Arc& arc) {
  const auto number = static_cast<std::uint32_t>(arcs_.size());
  for (const bool isBelow : {true, false}) {
    const auto side = isBelow ? arc.below : arc.above;
    if (side < nodes_.size()) {
      nodes_[side].arcs.push_back(number);
    } else if (side == CutCells::kWholeCell) {
      ofWhole_[isBelow ? arc.placeBelow() : arc.placeAbove()].push_back(number);
    }
  }
  arcs_.push_back(arc);
}

void MergeGraph::cover(double smallest) {
  const auto pieces = static_cast<std::uint32_t>(nodes_.size());
  for (std::uint32_t first = 0, last = 0; first < pieces; first = last) {
    while (last < pieces && nodes_[last].place == nodes_[first].place) ++last;
    const auto kept = largest(first, last);
    for (auto node = first; node < last; ++node) {
      if (node != kept || isSmall(nodes_[node], smallest)) coverNode(node);
    }
  }
  // Covering closes faces of neighbours, which may leave these without a direction of the wall.
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) changed_.push_back(node);
  while (!changed_.empty()) {
    const auto node = changed_.back();
    changed_.pop_back();
    if (!nodes_[node].isCovered && !hasDirection(nodes_[node])) coverNode(node);
  }
}

/// The first of the largest of some nodes.
std::uint32_t MergeGraph::largest(std::uint32_t first, std::uint32_t last) const {
  auto result = first;
  for (auto node = first; node < last; ++node) {
    if (nodes_[node].volume > nodes_[result].volume) result = node;
  }
  return result;
}

bool MergeGraph::isSmall(const Node& node, double share) const {
  if (share == 0) return false;
  const auto size = mesh_.boxOf(node.place).size();
  return std::clamp(node.volume / (size.x * size.y * size.z), 0.0, 1.0) < share;
}

bool MergeGraph::hasDirection(const Node& node) const {
  if (node.wallArea == 0 && node.closed.size() == 0) return true;
  const auto size = mesh_.boxOf(node.place).size();
  const double face = std::max({size.y * size.z, size.z * size.x, size.x * size.y});
  return length(node.wallVector) > kNoDirection * face;
}

/// Makes a node of a cell that was all fluid, with all of its faces.
std::uint32_t MergeGraph::nodeOfWhole(Place place) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  const auto box = mesh_.boxOf(place);
  const auto size = box.size();
  nodes_.push_back({.place = place,
                    .volume = size.x * size.y * size.z,
                    .centroid = box.center(),
                    .wallVector = {},
                    .closed = Moments(box.center()),
                    .arcs = std::exchange(ofWhole_[place], {})});
  ofWhole_.erase(place);
  std::set<std::tuple<Place, std::uint8_t, bool>> known;  // the cell across, the axis, and the side
  for (const auto arc : nodes_[number].arcs) {
    auto& it = arcs_[arc];
    const bool isAbove = it.placeAbove() == place;
    (isAbove ? it.above : it.below) = number;
    known.emplace(isAbove ? it.placeBelow() : it.placeAbove(), it.axis, isAbove);
  }
  for (auto& face : mesh_.facesOfWhole(place)) {
    const bool isAbove = face.placeAbove() == place;
    if (known.contains({isAbove ? face.placeBelow() : face.placeAbove(), face.axis, isAbove}))
      continue;
    (isAbove ? face.above : face.below) = number;
    add(face);
  }
  return number;
}

void MergeGraph::coverNode(std::uint32_t node) {
  nodes_[node].isCovered = true;
  const auto arcs = nodes_[node].arcs;
  for (const auto arc : arcs) closeArc(arc);
}

/// Makes the arc a wall of what is not covered beside it.
void MergeGraph::closeArc(std::uint32_t arc) {
  if (std::exchange(arcs_[arc].isClosed, true)) return;
  for (const bool isBelow : {true, false}) {
    auto side = isBelow ? arcs_[arc].below : arcs_[arc].above;
    if (side == CutCells::kWholeCell) {
      side = nodeOfWhole(isBelow ? arcs_[arc].placeBelow() : arcs_[arc].placeAbove());
    }
    if (side >= nodes_.size() || nodes_[side].isCovered) continue;
    const auto& it = arcs_[arc];
    auto& node = nodes_[side];
    Vec3<double> vector;
    vector[it.axis] = isBelow ? it.area : -it.area;
    auto centroid = it.centroid;
    if (isBelow) centroid[it.axis] += it.belowBy;
    node.closed.add(it.area, centroid);
    node.closedVector += vector;
    node.wallVector += vector;
    changed_.push_back(side);
  }
}

}  // namespace cutwater
