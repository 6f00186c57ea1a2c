#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Faces/FacePieces.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceSum.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

/// Copies of a vertex leave loops that are a point, but for rounding: shorter than this, in
/// perimeters of the face.
constexpr double kNothing = 1e-14;

/// The number of the trace that a ray from the point, down the second axis, meets first; kNone if
/// none of those that `counts` accepts.
template <typename Counts>
std::uint32_t traceBelow(std::span<const FaceTrace> traces, const FaceAxes& axes,
                         const Vec3<double>& p, Counts&& counts) {
  const int c = axes.first;
  const int d = axes.second;
  std::uint32_t found = kNone;
  double best = -std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < traces.size(); ++i) {
    const auto& from = traces[i].from;
    const auto& to = traces[i].to;
    if ((from[c] <= p[c]) == (to[c] <= p[c]) || !counts(i)) continue;
    const double height = from[d] + (p[c] - from[c]) / (to[c] - from[c]) * (to[d] - from[d]);
    if (height <= p[d] && height > best) found = i, best = height;
  }
  return found;
}

/// Whether the fluid is above a trace, along the second axis: on its left.
bool facesUp(const FaceTrace& trace, const FaceAxes& axes) {
  return trace.to[axes.first] > trace.from[axes.first];
}

/// The stretch in which a ray ends that meets no trace before the edge; like traces, without its
/// upper end.
std::size_t stretchAt(std::span<const EdgeStretch> stretches, double position) {
  std::size_t s = 0;
  while (s + 1 < stretches.size() && position >= stretches[s].to) ++s;
  return s;
}

}  // namespace

/// Joins the rims of parts, and measures these, of one face after another.
class FacePieces::Builder {
 public:
  explicit Builder(FacePieces& owner) : owner_(owner) {}

  void build(CutFace& face) {
    face_ = &face;
    axes_ = FaceAxes(owner_.surface_.numbers().axisOfFace(face.face));
    place_ = owner_.surface_.numbers().placeOfFace(face.face);
    traces_ = owner_.surface_.traces().subspan(face.firstTrace, face.lastTrace - face.firstTrace);
    findStretches();
    sets_.reset(nodes());
    joinTraces();
    joinStretches();
    joinCorners();
    joinHoles();
    measure();
  }

 private:
  void findStretches() {
    auto count = static_cast<std::uint32_t>(owner_.ofStretch_.size());
    for (int side = 0; side < 4; ++side) {
      const auto edge = edgeOfFace(axes_.across, place_, side);
      stretches_[asIndex(side)] = owner_.stretches_.of(edge.axis, edge.place);
      gridEdges_[asIndex(side)] = owner_.surface_.numbers().edge(edge.axis, edge.place);
      face_->firstStretch[asIndex(side)] = count;
      count += static_cast<std::uint32_t>(stretches_[asIndex(side)].size());
    }
    face_->firstStretch[4] = count;
    owner_.ofStretch_.resize(count);
  }
  [[nodiscard]] std::uint32_t node(int side, std::size_t stretch) const {
    return static_cast<std::uint32_t>(traces_.size() + stretch) +
           face_->firstStretch[asIndex(side)] - face_->firstStretch[0];
  }

  /// Traces of triangles that share an edge of the mesh.
  void joinTraces() {
    if (traces_.size() == 1) return;
    ends_.clear();
    for (std::uint32_t i = 0; i < traces_.size(); ++i) {
      for (const auto& end : {traces_[i].start, traces_[i].end}) {
        if (end.gridEdge == kNone) ends_.emplace_back(end.meshEdge, i);
      }
    }
    std::ranges::sort(ends_);
    for (std::size_t i = 1; i < ends_.size(); ++i) {
      if (ends_[i].first == ends_[i - 1].first) sets_.unite(ends_[i].second, ends_[i - 1].second);
    }
  }
  /// Stretches with the traces at their ends.
  void joinStretches() {
    for (std::uint32_t i = 0; i < traces_.size(); ++i) {
      for (const auto& end : {traces_[i].start, traces_[i].end}) {
        if (end.gridEdge == kNone) continue;
        const int side =
            static_cast<int>(std::ranges::find(gridEdges_, end.gridEdge) - gridEdges_.begin());
        const auto stretches = stretches_[asIndex(side)];
        for (std::size_t s = 0; s < stretches.size(); ++s) {
          const bool isAtStart = stretches[s].start == traces_[i].triangle;
          if (isAtStart || stretches[s].end == traces_[i].triangle) sets_.unite(i, node(side, s));
        }
      }
    }
  }
  /// Stretches of two edges that meet in a corner in the fluid.
  void joinCorners() {
    for (int corner = 0; corner < 4 && sets_.count() > 1; ++corner) {
      auto place = place_;
      place[asIndex(axes_.first)] += corner % 2;
      place[asIndex(axes_.second)] += corner / 2;
      if (!owner_.stretches_.isFluid(place)) continue;
      const int along = corner / 2;       // the edge along the first axis, low or high
      const int across = 2 + corner % 2;  // the one along the second
      const auto last = [&](int side, bool isHigh) {
        return node(side, isHigh ? stretches_[asIndex(side)].size() - 1 : 0);
      };
      sets_.unite(last(along, corner % 2 == 1), last(across, corner / 2 == 1));
    }
  }

  /// Loops around body: their fluid is that around them.
  void joinHoles() {
    isNothing_.assign(traces_.size(), 0);
    if (sets_.count() == 1 && nodes() > traces_.size()) return;
    touchesRim_.assign(traces_.size(), 0);
    for (std::uint32_t i = static_cast<std::uint32_t>(traces_.size()); i < nodes(); ++i) {
      const auto root = sets_.find(i);
      if (root < traces_.size()) touchesRim_[root] = 1;
    }
    const auto isLoop = [&](std::uint32_t i) { return touchesRim_[sets_.find(i)] == 0; };
    std::uint32_t any = 0;
    while (any < traces_.size() && !isLoop(any)) ++any;
    if (any == traces_.size()) return;
    std::vector<double> areas(traces_.size());
    std::vector<double> lengths(traces_.size());
    std::vector<std::uint32_t> lowest(traces_.size(), kNone);
    for (std::uint32_t i = 0; i < traces_.size(); ++i) {
      const auto root = sets_.find(i);
      if (touchesRim_[root] != 0) continue;
      areas[root] += areaBetween(traces_[root].from, traces_[i]);
      lengths[root] += length(traces_[i].to - traces_[i].from);
      if (lowest[root] == kNone || height(i) < height(lowest[root])) lowest[root] = i;
    }
    std::vector<std::uint32_t> holes;
    for (std::uint32_t i = 0; i < traces_.size(); ++i) {
      isNothing_[i] = lowest[i] != kNone && lengths[i] <= kNothing * perimeter() ? 1 : 0;
    }
    for (std::uint32_t i = 0; i < traces_.size(); ++i) {
      if (lowest[i] == kNone || isNothing_[i] != 0) continue;
      // Of a film, rounding decides on the sign of its area.
      const bool isFilm = std::abs(areas[i]) <= kNothing * perimeter() * lengths[i];
      const bool isHole = isFilm ? isFluidBelow(traces_[lowest[i]].from, i) : areas[i] < 0;
      if (isHole) holes.push_back(i);
    }
    std::ranges::sort(holes, {}, [&](std::uint32_t i) { return height(lowest[i]); });
    for (const auto hole : holes) sets_.unite(hole, below(traces_[lowest[hole]].from, hole));
  }
  [[nodiscard]] double perimeter() const {
    double sum = 0;
    for (const int axis : {axes_.first, axes_.second}) {
      const int plane = place_[asIndex(axis)];
      sum += 2 * (owner_.planes_.at(axis, plane + 1) - owner_.planes_.at(axis, plane));
    }
    return sum;
  }
  [[nodiscard]] std::uint32_t nodes() const {
    return static_cast<std::uint32_t>(traces_.size()) + face_->firstStretch[4] -
           face_->firstStretch[0];
  }
  [[nodiscard]] double height(std::uint32_t trace) const {
    return traces_[trace].from[axes_.second];
  }
  /// Twice the area between a trace and a point.
  [[nodiscard]] double areaBetween(const Vec3<double>& p, const FaceTrace& t) const {
    const auto q = t.from - p;
    const auto way = t.to - t.from;
    return q[axes_.first] * way[axes_.second] - q[axes_.second] * way[axes_.first];
  }

  /// The trace that a ray from the point meets first, down the second axis; not those of the set
  /// `except`.
  [[nodiscard]] std::uint32_t otherBelow(const Vec3<double>& p, std::uint32_t except,
                                         bool isInFluid = false) {
    return traceBelow(traces_, axes_, p, [&](std::uint32_t i) {
      const auto root = sets_.find(i);
      if (isInFluid && !facesUp(traces_[i], axes_)) return false;
      return root != sets_.find(except) && isNothing_[root] == 0;
    });
  }
  [[nodiscard]] bool isFluidBelow(const Vec3<double>& p, std::uint32_t except) {
    const auto found = otherBelow(p, except);
    if (found != kNone) return facesUp(traces_[found], axes_);
    return std::ranges::any_of(stretches_[0], [&](const EdgeStretch& stretch) {
      return stretch.from <= p[axes_.first] && p[axes_.first] < stretch.to;
    });
  }
  /// What the ray meets first, from a point around which the fluid is: of a film, the upper side.
  [[nodiscard]] std::uint32_t below(const Vec3<double>& p, std::uint32_t except) {
    const auto found = otherBelow(p, except, true);
    if (found != kNone) return found;
    // Nothing there only if rounding hides it.
    if (stretches_[0].empty()) return except;
    return node(0, stretchAt(stretches_[0], p[axes_.first]));
  }

  void measure() {
    pieceOf_.assign(nodes(), kNone);
    sums_.clear();
    face_->firstPiece = static_cast<std::uint32_t>(owner_.pieces_.size());
    for (std::uint32_t i = 0; i < nodes(); ++i) {
      const auto root = sets_.find(i);
      if (pieceOf_[root] == kNone) {
        pieceOf_[root] = static_cast<std::uint32_t>(owner_.pieces_.size());
        owner_.pieces_.push_back({.face = face_->face,
                                  .centroid = {},
                                  .isNothing = root < traces_.size() && isNothing_[root] != 0});
        sums_.emplace_back(axes_.first, axes_.second, referenceOf(i));
      }
      pieceOf_[i] = pieceOf_[root];
    }
    for (std::uint32_t i = 0; i < traces_.size(); ++i) {
      owner_.ofTrace_[face_->firstTrace + i] = pieceOf_[i];
      sums_[pieceOf_[i] - face_->firstPiece].addTrace(traces_[i].from, traces_[i].to);
    }
    for (int side = 0; side < 4; ++side) {
      for (std::size_t s = 0; s < stretches_[asIndex(side)].size(); ++s) {
        const auto piece = pieceOf_[node(side, s)];
        owner_.ofStretch_[face_->firstStretch[asIndex(side)] + s] = piece;
        addStretch(sums_[piece - face_->firstPiece], side, stretches_[asIndex(side)][s]);
      }
    }
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      auto& piece = owner_.pieces_[face_->firstPiece + i];
      piece.area = sums_[i].area();
      if (piece.area < 0 && piece.area > -kNothing * perimeter() * perimeter()) piece.area = 0;
      piece.centroid = sums_[i].centroid();
    }
  }
  /// A point near the part, for which sums do not cancel.
  [[nodiscard]] Vec3<double> referenceOf(std::uint32_t first) const {
    if (first < traces_.size()) return traces_[first].from;
    Vec3<double> corner;
    for (int axis = 0; axis < 3; ++axis)
      corner[axis] = owner_.planes_.at(axis, place_[asIndex(axis)]);
    return corner;
  }
  void addStretch(FaceSum& sum, int side, const EdgeStretch& stretch) const {
    const bool isAlongFirst = side < 2;
    const int across = isAlongFirst ? axes_.second : axes_.first;
    sum.addEdge(isAlongFirst, side % 2 == 1,
                owner_.planes_.at(across, place_[asIndex(across)] + side % 2), stretch.middle(),
                stretch.length());
  }

  FacePieces& owner_;
  // Of the face:
  CutFace* face_ = nullptr;
  FaceAxes axes_{0};
  TilePlace place_{};
  std::span<const FaceTrace> traces_;
  std::array<std::span<const EdgeStretch>, 4> stretches_;
  std::array<std::uint32_t, 4> gridEdges_{};
  detail::DisjointSets sets_;  // of traces, then stretches
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;
  std::vector<char> touchesRim_;
  std::vector<char> isNothing_;  // by root of a loop
  std::vector<std::uint32_t> pieceOf_;
  std::vector<FaceSum> sums_;
};

FacePieces::FacePieces(const TileSurface& surface, const EdgeStretches& stretches,
                       const GridPlanes& planes, const CellMask* wanted)
    : surface_(surface),
      stretches_(stretches),
      planes_(planes),
      numberOf_(surface.numbers().faceCount(), kNone),
      ofTrace_(surface.traces().size(), kNone) {
  Builder builder(*this);
  const auto traces = surface.traces();
  for (std::uint32_t first = 0; first < traces.size();) {
    auto last = first + 1;
    while (last < traces.size() && traces[last].face == traces[first].face) ++last;
    if (!surface.numbers().isBeside(traces[first].face, wanted)) {
      first = last;
      continue;
    }
    cutFaces_.push_back({.face = traces[first].face, .firstTrace = first, .lastTrace = last});
    numberOf_[traces[first].face] = static_cast<std::uint32_t>(cutFaces_.size() - 1);
    if (surface.meetAny(traces.subspan(first, last - first))) {
      cutFaces_.back().firstPiece = static_cast<std::uint32_t>(pieces_.size());
      cutFaces_.back().regions = static_cast<std::uint32_t>(regions_.size());
      regions_.emplace_back(surface, stretches, planes, traces[first].face);
      const auto parts = regions_.back().parts();
      pieces_.insert(pieces_.end(), parts.begin(), parts.end());
    } else {
      builder.build(cutFaces_.back());
    }
    first = last;
  }
}

std::uint32_t FacePieces::ofStretch(std::uint32_t face, int side, std::size_t stretch) const {
  const auto& cut = cutFaces_[cutFace(face)];
  return ofStretch_[cut.firstStretch[static_cast<std::size_t>(side)] + stretch];
}

std::pair<std::uint32_t, std::uint32_t> FacePieces::of(std::uint32_t face) const {
  const auto cut = cutFace(face);
  const auto last = cut + 1 < cutFaces_.size() ? cutFaces_[cut + 1].firstPiece
                                               : static_cast<std::uint32_t>(pieces_.size());
  return {cutFaces_[cut].firstPiece, last};
}

std::vector<FaceRegions::Region> FacePieces::regionsOn(std::uint32_t face) const {
  const auto copied = [](const FaceRegions& from) {
    return std::vector<FaceRegions::Region>(from.regions().begin(), from.regions().end());
  };
  if (isCut(face) && meetsOn(face)) {
    auto regions = copied(meetingRegions(face));
    for (auto& region : regions) {
      if (region.part != kNone) region.part += of(face).first;
    }
    return regions;
  }
  auto regions = copied(FaceRegions(surface_, stretches_, planes_, face));
  for (auto& region : regions) {
    if (region.part == kNone) continue;
    region.part = isCut(face) ? at(face, region.point) : kNone;
  }
  return regions;
}

std::uint32_t FacePieces::at(std::uint32_t face, const Vec3<double>& point) const {
  const auto& cut = cutFaces_[cutFace(face)];
  const FaceAxes axes(surface_.numbers().axisOfFace(face));
  const auto traces = surface_.traces().subspan(cut.firstTrace, cut.lastTrace - cut.firstTrace);
  const auto found = traceBelow(traces, axes, point, [&](std::uint32_t i) {
    return facesUp(traces[i], axes) && !pieces_[ofTrace_[cut.firstTrace + i]].isNothing;
  });
  if (found != kNone) return ofTrace_[cut.firstTrace + found];
  const auto edge = edgeOfFace(axes.across, surface_.numbers().placeOfFace(face), 0);
  const auto stretches = stretches_.of(edge.axis, edge.place);
  if (stretches.empty()) return cut.firstPiece;  // only if rounding hides it
  return ofStretch(face, 0, stretchAt(stretches, point[axes.first]));
}

}  // namespace cutwater
