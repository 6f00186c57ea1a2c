#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellRims.hpp>
#include <Cutwater/CutCells/Detail/Pieces/MeetingCells.hpp>
#include <Cutwater/CutCells/Detail/Pieces/OpenArcs.hpp>

#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

/// An open part of one of a cell's faces.
struct OpenPart {
  std::uint32_t arc = 0;
  int axis = 0;
  bool isHigh = false;  ///< the face is above the cell
};

/// The first of a cell's fragments at each edge of the mesh: an open-addressing hash table.
class FirstWithEdge {
 public:
  /// For so many fragments, which have up to three edges each.
  void reset(std::size_t fragments) {
    const auto count = std::bit_ceil(4 * fragments);
    slots_.assign(count, {kNone, kNone});
    shift_ = 32 - std::countr_zero(count);
  }
  /// Returns `fragment` if it is the first one.
  std::uint32_t firstWith(std::uint32_t edge, std::uint32_t fragment) {
    auto slot = (edge * 0x9e3779b1U) >> static_cast<unsigned>(shift_);  // Knuth, 6.4
    while (slots_[slot].first != edge && slots_[slot].first != kNone) {
      slot = (slot + 1) & static_cast<std::uint32_t>(slots_.size() - 1);
    }
    auto& [key, first] = slots_[slot];
    if (key == kNone) key = edge, first = fragment;
    return first;
  }

 private:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> slots_;
  int shift_ = 0;
};

/// Joins and measures the pieces of one cell after another.
class CellBuilder {
 public:
  CellBuilder(const TileSurface& surface, const EdgeStretches& stretches, const FacePieces& faces,
              const GridPlanes& planes, std::span<const std::uint32_t> arcOfFullFace,
              CellPieces& out)
      : surface_(surface),
        stretches_(stretches),
        faces_(faces),
        planes_(planes),
        arcOfFullFace_(arcOfFullFace),
        traces_(surface),
        out_(out) {}

  /// `firstFragment`: the number of the first of the cell's fragments.
  void build(std::span<const TileFragment> fragments, std::uint32_t firstFragment) {
    fragments_ = fragments;
    firstFragment_ = firstFragment;
    place_ = surface_.numbers().placeOfCell(fragments.front().cell);
    for (int axis = 0; axis < 3; ++axis) {
      auto place = place_;
      for (int side = 0; side < 2; ++side, ++place[asIndex(axis)]) {
        face_[asIndex(2 * axis + side)] = surface_.numbers().face(axis, place);
      }
    }
    findOpenParts();
    sets_.reset(fragments_.size() + open_.size());
    joinFragments();
    joinFaces();
    joinEdges();
    joinShells();
    measure();
  }

 private:
  [[nodiscard]] std::uint32_t faceOf(int axis, int side) const {
    return face_[asIndex(2 * axis + side)];
  }
  void findOpenParts() {
    open_.clear();
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) {
        const auto face = faceOf(axis, side);
        auto& first = firstOpen_[asIndex(2 * axis + side)];
        first = static_cast<std::uint32_t>(open_.size());
        if (faces_.isCut(face)) {
          const auto [from, to] = faces_.of(face);
          for (auto arc = from; arc < to; ++arc) open_.push_back({arc, axis, side == 1});
        } else if (arcOfFullFace_[face] != kNone) {
          open_.push_back({arcOfFullFace_[face], axis, side == 1});
        }
      }
    }
  }
  [[nodiscard]] std::uint32_t nodeOfArc(int axis, int side, std::uint32_t arc) const {
    const auto first = firstOpen_[asIndex(2 * axis + side)];
    const auto i = first + (arc - open_[first].arc);  // they have numbers one after the other
    return static_cast<std::uint32_t>(fragments_.size()) + i;
  }

  void joinFragments() {
    if (fragments_.size() == 1) return;
    edges_.reset(fragments_.size());
    for (std::uint32_t i = 0; i < fragments_.size(); ++i) {
      for (const auto edge : surface_.meshEdges(fragments_[i])) {
        if (edge != kNone) sets_.unite(i, edges_.firstWith(edge, i));
      }
    }
  }
  void joinFaces() {
    for (std::uint32_t i = 0; i < fragments_.size(); ++i) {
      for (const auto trace : traces_.of(firstFragment_ + i)) {
        const auto& t = surface_.traces()[trace];
        const int axis = surface_.numbers().axisOfFace(t.face);
        const int side = t.below == firstFragment_ + i ? 1 : 0;
        sets_.unite(i, nodeOfArc(axis, side, faces_.ofTrace(trace)));
      }
    }
  }
  /// Open parts of two faces that meet in a stretch of an edge.
  void joinEdges() {
    for (int axis = 0; axis < 3; ++axis) {
      const int c = (axis + 1) % 3;
      const int d = (axis + 2) % 3;
      for (int corner = 0; corner < 4; ++corner) {
        if (sets_.count() == 1) return;
        const int sideC = corner % 2;
        const int sideD = corner / 2;
        auto place = place_;
        place[asIndex(c)] += sideC;
        place[asIndex(d)] += sideD;
        const auto stretches = stretches_.of(axis, place);
        for (std::size_t s = 0; s < stretches.size(); ++s) {
          // Of the face across c, the edge runs along the second axis; across d, along the first.
          const auto onC = arcAt(c, sideC, s, sideD, true);
          const auto onD = arcAt(d, sideD, s, sideC, false);
          sets_.unite(nodeOfArc(c, sideC, onC), nodeOfArc(d, sideD, onD));
        }
      }
    }
  }
  [[nodiscard]] std::uint32_t arcAt(int axis, int side, std::size_t stretch, int other,
                                    bool alongSecond) const {
    const auto face = faceOf(axis, side);
    if (!faces_.isCut(face)) return arcOfFullFace_[face];
    return faces_.ofStretch(face, (alongSecond ? 2 : 0) + other, stretch);
  }

  /// Shells around body that touch no face, but for points: their fluid is that around them.
  void joinShells() {
    if (sets_.count() == 1 && std::ranges::any_of(open_, [this](const OpenPart& part) {
          return !out_.arcs[part.arc].isNothing;
        })) {
      return;
    }
    touchesFace_.assign(fragments_.size(), 0);
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
      const auto root = sets_.find(static_cast<std::uint32_t>(fragments_.size()) + i);
      const bool isPoint = out_.arcs[open_[i].arc].isNothing;
      if (root < fragments_.size() && !isPoint) touchesFace_[root] = 1;
    }
    const auto isShell = [&](std::uint32_t i) { return touchesFace_[sets_.find(i)] == 0; };
    std::uint32_t any = 0;
    while (any < fragments_.size() && !isShell(any)) ++any;
    if (any == fragments_.size()) return;
    std::vector<double> volumes(fragments_.size());
    std::vector<Vec3<double>> lowest(fragments_.size());
    std::vector<double> areas(fragments_.size());
    std::vector<char> seen(fragments_.size());
    for (std::uint32_t i = 0; i < fragments_.size(); ++i) {
      const auto root = sets_.find(i);
      if (touchesFace_[root] != 0) continue;
      for (const auto& p : surface_.points(fragments_[i])) {
        if (seen[root] == 0 || p.z < lowest[root].z) lowest[root] = p;
        seen[root] = 1;
      }
      const auto origin = surface_.points(fragments_[root]).front();
      forTriangles(i, [&](const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
        const auto area = cross(b - a, c - a);
        volumes[root] -= dot(a - origin, area);
        areas[root] += length(area);
      });
    }
    std::vector<std::uint32_t> shells;
    for (std::uint32_t i = 0; i < fragments_.size(); ++i) {
      if (seen[i] != 0 && volumes[i] < 0 && areas[i] > PieceSums::nothing(planes_.sizeOf(place_))) {
        shells.push_back(i);
      }
    }
    std::ranges::sort(shells, {}, [&](std::uint32_t i) { return lowest[i].z; });
    for (const auto shell : shells) sets_.unite(shell, below(lowest[shell], shell));
  }
  /// What a ray down the z axis meets first.
  [[nodiscard]] std::uint32_t below(const Vec3<double>& p, std::uint32_t except) {
    std::uint32_t found = kNone;
    double best = -std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < fragments_.size(); ++i) {
      if (sets_.find(i) == sets_.find(except)) continue;
      const auto points = surface_.points(fragments_[i]);
      bool isInside = false;
      Vec3<double> normal;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const auto& a = points[k];
        const auto& b = points[(k + 1) % points.size()];
        normal += cross(a - points[0], b - points[0]);
        if ((a.y <= p.y) == (b.y <= p.y)) continue;
        if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) isInside = !isInside;
      }
      if (!isInside || !(normal.z > 0)) continue;  // the fluid is above what it meets
      const double z = points[0].z -
                       (normal.x * (p.x - points[0].x) + normal.y * (p.y - points[0].y)) / normal.z;
      if (z <= p.z && z > best) found = i, best = z;
    }
    if (found != kNone) return found;
    const auto face = faceOf(2, 0);
    const auto arc = faces_.isCut(face) ? faces_.at(face, p) : arcOfFullFace_[face];
    return arc == kNone ? except : nodeOfArc(2, 0, arc);
  }

  template <typename Visit>
  void forTriangles(std::uint32_t fragment, Visit&& visit) const {
    const auto points = surface_.points(fragments_[fragment]);
    for (std::size_t k = 2; k < points.size(); ++k) visit(points[0], points[k - 1], points[k]);
  }

  void measure() {
    const auto count = static_cast<std::uint32_t>(fragments_.size() + open_.size());
    sumOf_.assign(count, kNone);  // by root
    sums_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      auto& sum = sumOf_[sets_.find(i)];
      if (sum == kNone) {
        sum = static_cast<std::uint32_t>(sums_.size());
        sums_.emplace_back(referenceOf(i));
      }
      if (i < fragments_.size()) {
        addFragment(sums_[sum], fragments_[i]);
      } else {
        addOpenPart(sums_[sum], open_[i - fragments_.size()]);
      }
    }
    const auto size = planes_.sizeOf(place_);
    numberOfSum_.clear();
    for (auto& sum : sums_) {
      numberOfSum_.push_back(kNone);
      if (sum.isNothing(size)) continue;
      numberOfSum_.back() = static_cast<std::uint32_t>(out_.pieces.size());
      sum.appendWalls(numberOfSum_.back(), out_.walls);
      out_.pieces.push_back(withinCell(sum.piece(fragments_.front().cell), planes_.boxOf(place_)));
    }
    for (std::uint32_t i = 0; i < fragments_.size(); ++i) {
      out_.ofFragments.push_back(numberOfSum_[sumOf_[sets_.find(i)]]);
    }
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
      const auto node = static_cast<std::uint32_t>(fragments_.size()) + i;
      auto& arc = out_.arcs[open_[i].arc];
      const auto piece = numberOfSum_[sumOf_[sets_.find(node)]];
      (open_[i].isHigh ? arc.below : arc.above) = piece;
      arc.isDropped = arc.isDropped || piece == kNone;
    }
  }
  [[nodiscard]] Vec3<double> referenceOf(std::uint32_t node) const {
    return node < fragments_.size() ? surface_.points(fragments_[node]).front()
                                    : out_.arcs[open_[node - fragments_.size()].arc].centroid;
  }
  void addFragment(PieceSums& sum, const TileFragment& fragment) const {
    if (surface_.hasOpenPatches() && openFaceOf(surface_, planes_, fragment).isFace()) {
      sum.addOpenPatch(surface_.points(fragment));
    } else {
      sum.addWall(surface_.points(fragment), surface_.patchOf(fragment.triangle));
    }
  }
  void addOpenPart(PieceSums& sum, const OpenPart& part) const {
    const auto& arc = out_.arcs[part.arc];
    const double plane = planes_.at(part.axis, place_[asIndex(part.axis)] + (part.isHigh ? 1 : 0));
    const double way = plane - sum.reference()[part.axis];
    sum.addOpenPart(part.isHigh ? way : -way, arc.area, arc.centroid);
  }

  const TileSurface& surface_;
  const EdgeStretches& stretches_;
  const FacePieces& faces_;
  const GridPlanes& planes_;
  std::span<const std::uint32_t> arcOfFullFace_;
  TracesOfFragments traces_;
  CellPieces& out_;
  // Of the cell:
  std::span<const TileFragment> fragments_;
  std::uint32_t firstFragment_ = 0;
  TilePlace place_{};
  std::array<std::uint32_t, 6> face_{};  // 2 axis + side
  std::vector<OpenPart> open_;
  std::array<std::uint32_t, 6> firstOpen_{};
  detail::DisjointSets sets_;  // of fragments, then open parts
  FirstWithEdge edges_;
  std::vector<char> touchesFace_;
  std::vector<std::uint32_t> sumOf_;
  std::vector<PieceSums> sums_;
  std::vector<std::uint32_t> numberOfSum_;
};

}  // namespace

std::vector<PieceSide> sidesOf(const CellPieces& content, const TileNumbers& numbers) {
  std::vector<PieceSide> sides;
  for (std::uint32_t arc = 0; arc < content.arcs.size(); ++arc) {
    const auto& of = content.arcs[arc];
    if (of.isOpenPatch()) continue;
    const int axis = numbers.axisOfFace(of.face);
    if (of.below != kNone) sides.push_back({of.below, 2 * axis + 1, arc});
    if (of.above != kNone) sides.push_back({of.above, 2 * axis, arc});
  }
  std::ranges::sort(
      sides, {}, [](const PieceSide& side) { return std::tuple(side.piece, side.face, side.arc); });
  return sides;
}

CellPieces findCellPieces(const TileSurface& surface, const EdgeStretches& stretches,
                          const FacePieces& faces, const GridPlanes& planes,
                          const CellMask* wanted) {
  CellPieces result;
  for (const auto& piece : faces.pieces()) {
    result.arcs.push_back({.face = piece.face,
                           .area = piece.area,
                           .centroid = piece.centroid,
                           .isNothing = piece.isNothing});
  }
  const auto fragments = surface.fragments();
  const auto arcOfFullFace = addFullFaces(surface, stretches, faces, planes, wanted, result.arcs);
  CellBuilder builder(surface, stretches, faces, planes, arcOfFullFace, result);
  MeetingCells meeting(faces, arcOfFullFace, result);
  for (std::uint32_t first = 0; first < fragments.size();) {
    auto end = first + 1;
    while (end < fragments.size() && fragments[end].cell == fragments[first].cell) ++end;
    const auto here = fragments.subspan(first, end - first);
    if (!isWanted(wanted, here.front().cell)) {
      result.ofFragments.resize(end, kNone);
    } else if (surface.meetAny(here)) {
      meeting.build(here);
    } else {
      builder.build(here, first);
    }
    first = end;
  }
  addOpenArcs(surface, planes, wanted, result);
  return result;
}

}  // namespace cutwater
