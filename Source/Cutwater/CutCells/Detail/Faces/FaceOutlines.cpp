#include <Cutwater/CutCells/Detail/Faces/FaceFrame.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceOutlines.hpp>
#include <Cutwater/CutCells/Detail/Faces/JoinedLoops.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

namespace {

using Loop = std::vector<Vec3<double>>;

/// Walks around the open parts of one cut face. Seen against the face's axis, fluid is on the left:
/// up the first and the last side, see edgeOfFace(), and down those between.
class OutlineWalk {
 public:
  OutlineWalk(const TileSurface& surface, const EdgeStretches& stretches, const FacePieces& faces,
              const GridPlanes& planes, std::uint32_t face)
      : faces_(faces), frame_(surface.numbers(), planes, face), face_(face) {
    const auto [first, last] = faces.tracesOf(face);
    firstTrace_ = first;
    traces_ = surface.traces().subspan(first, last - first);
    std::size_t nodes = traces_.size();
    for (int side = 0; side < 4; ++side) {
      const auto edge = edgeOfFace(frame_.axes().across, frame_.place(), side);
      gridEdges_[asIndex(side)] = surface.numbers().edge(edge.axis, edge.place);
      stretches_[asIndex(side)] = stretches.of(edge.axis, edge.place);
      firstNode_[asIndex(side)] = nodes;
      nodes += stretches_[asIndex(side)].size();
    }
    isSeen_.resize(nodes);
    for (std::size_t i = 0; i < traces_.size(); ++i) {
      if (traces_[i].start.gridEdge == kNone) starts_.emplace_back(traces_[i].start.meshEdge, i);
    }
    std::ranges::sort(starts_);
  }

  /// The loops of each of the face's parts, from the first part on.
  [[nodiscard]] std::vector<std::vector<Loop>> loops() {
    const auto [firstPart, lastPart] = faces_.of(face_);
    std::vector<std::vector<Loop>> result(lastPart - firstPart);
    // Stretches first: a loop that has one is its part's rim.
    for (std::size_t n = isSeen_.size(); n-- > 0;) {
      if (isSeen_[n] != 0) continue;
      auto loop = loopFrom(n);
      if (loop.size() >= 3) result[partOf(n) - firstPart].push_back(std::move(loop));
    }
    return result;
  }

 private:
  static bool goesUp(int side) { return FaceFrame::goesUp(side); }

  [[nodiscard]] int sideOf(std::size_t node) const {
    int side = 3;
    while (node < firstNode_[asIndex(side)]) --side;
    return side;
  }
  [[nodiscard]] std::uint32_t partOf(std::size_t node) const {
    if (node < traces_.size())
      return faces_.ofTrace(firstTrace_ + static_cast<std::uint32_t>(node));
    const int side = sideOf(node);
    return faces_.ofStretch(face_, side, node - firstNode_[asIndex(side)]);
  }

  [[nodiscard]] Loop loopFrom(std::size_t node) {
    Loop loop;
    while (node < isSeen_.size() && isSeen_[node] == 0) {
      isSeen_[node] = 1;
      // An end is the next one's start, but for rounding: both, so that all who share it agree.
      for (const auto& point : endsOf(node)) {
        if (loop.empty() || loop.back() != point) loop.push_back(point);
      }
      node = next(node);
    }
    while (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
    return loop;
  }
  /// In the order of the walk.
  [[nodiscard]] std::array<Vec3<double>, 2> endsOf(std::size_t node) const {
    if (node < traces_.size()) return {traces_[node].from, traces_[node].to};
    const int side = sideOf(node);
    return frame_.endsOf(side, stretches_[asIndex(side)][node - firstNode_[asIndex(side)]]);
  }

  /// What follows; a number beyond all nodes if there is nothing, which no closed surface has.
  [[nodiscard]] std::size_t next(std::size_t node) const {
    if (node < traces_.size()) return nextOfTrace(traces_[node]);
    const int side = sideOf(node);
    const auto number = node - firstNode_[asIndex(side)];
    const auto& stretch = stretches_[asIndex(side)][number];
    const auto triangle = goesUp(side) ? stretch.end : stretch.start;
    if (triangle == kNone) return behindCorner(side);
    for (std::size_t i = 0; i < traces_.size(); ++i) {
      const auto& trace = traces_[i];
      if (trace.triangle == triangle && trace.start.gridEdge == gridEdges_[asIndex(side)]) return i;
    }
    return isSeen_.size();
  }
  [[nodiscard]] std::size_t nextOfTrace(const FaceTrace& trace) const {
    if (trace.end.gridEdge == kNone) {
      const auto found = std::ranges::lower_bound(starts_, trace.end.meshEdge, {},
                                                  [](const auto& s) { return s.first; });
      const bool isThere = found != starts_.end() && found->first == trace.end.meshEdge;
      return isThere ? found->second : isSeen_.size();
    }
    const auto side =
        static_cast<int>(std::ranges::find(gridEdges_, trace.end.gridEdge) - gridEdges_.begin());
    const auto stretches = stretches_[asIndex(side)];
    for (std::size_t s = 0; s < stretches.size(); ++s) {
      const auto triangle = goesUp(side) ? stretches[s].start : stretches[s].end;
      if (triangle == trace.triangle) return firstNode_[asIndex(side)] + s;
    }
    return isSeen_.size();
  }
  /// The first stretch of the side that follows, counterclockwise.
  [[nodiscard]] std::size_t behindCorner(int side) const {
    constexpr std::array<int, 4> kNext{3, 2, 0, 1};
    const int following = kNext[asIndex(side)];
    const auto count = stretches_[asIndex(following)].size();
    if (count == 0) return isSeen_.size();
    return firstNode_[asIndex(following)] + (goesUp(following) ? 0 : count - 1);
  }

  const FacePieces& faces_;
  FaceFrame frame_;
  std::uint32_t face_;
  std::uint32_t firstTrace_ = 0;
  std::span<const FaceTrace> traces_;
  std::array<std::span<const EdgeStretch>, 4> stretches_;
  std::array<std::uint32_t, 4> gridEdges_{};
  std::array<std::size_t, 4> firstNode_{};
  std::vector<std::pair<std::uint32_t, std::size_t>> starts_;  // of traces, by edge of the mesh
  std::vector<char> isSeen_;
};

}  // namespace

void addOutlines(const TileSurface& surface, const EdgeStretches& stretches,
                 const FacePieces& faces, const GridPlanes& planes, std::uint32_t face,
                 CutCells::Polygons& out) {
  const FaceAxes axes(surface.numbers().axisOfFace(face));
  for (auto& loops : OutlineWalk(surface, stretches, faces, planes, face).loops()) {
    // None is left of a part whose rim is a point.
    out.add(joinedLoops(axes, std::move(loops)));
  }
}

void addWholeOutline(const TileNumbers& numbers, const GridPlanes& planes, std::uint32_t face,
                     CutCells::Polygons& out) {
  const FaceFrame frame(numbers, planes, face);
  out.add(std::array{frame.corner(0), frame.corner(1), frame.corner(3), frame.corner(2)});
}

}  // namespace cutwater
