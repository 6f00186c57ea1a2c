#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceSum.hpp>
#include <Cutwater/CutCells/Detail/Faces/SheetTree.hpp>
#include <Cutwater/CutCells/Detail/Pieces/OpenArcs.hpp>

#include <algorithm>
#include <tuple>

namespace cutwater {

OpenFace openFaceOf(const TileSurface& surface, const GridPlanes& planes,
                    const TileFragment& fragment) {
  const auto kind = surface.openKindOf(fragment.triangle);
  if (kind == OpenKind::Wall) return {};
  if (!hasAxis(kind)) return {.isOpen = true};
  const int axis = axisOf(kind);
  const double place = surface.placeOf(fragment.triangle, axis);
  const int plane = surface.numbers().placeOfCell(fragment.cell)[asIndex(axis)];
  for (const bool isHigh : {false, true}) {
    if (planes.at(axis, plane + (isHigh ? 1 : 0)) == place) return {true, axis, isHigh};
  }
  return {.isOpen = true};
}

namespace {

/// Whether nothing is left of a fragment but a line or a point: where the moved surface reaches
/// into a cell that the surface touches.
bool isFilm(std::span<const Vec3<double>> points) {
  return twiceArea(points) == Vec3<double>{};
}

class OpenArcs {
 public:
  OpenArcs(const TileSurface& surface, const GridPlanes& planes, CellPieces& out)
      : surface_(surface), planes_(planes), out_(out) {
    out_.openArcOf.assign(surface.fragments().size(), kNone);
  }

  void run(const CellMask* wanted) {
    const auto fragments = surface_.fragments();
    for (std::uint32_t first = 0; first < fragments.size();) {
      auto end = first + 1;
      while (end < fragments.size() && fragments[end].cell == fragments[first].cell) ++end;
      if (isWanted(wanted, fragments[first].cell)) {
        const bool meets = surface_.meetAny(fragments.subspan(first, end - first));
        for (auto i = first; i < end; ++i) take(i, meets);
      }
      first = end;
    }
    join();
    addArcs();
  }

 private:
  /// A fragment in a face.
  struct Part {
    std::uint32_t fragment = 0;
    std::uint32_t piece = 0;
    std::uint32_t patch = 0;
    OpenFace face;
  };

  void take(std::uint32_t number, bool meets) {
    const auto& fragment = surface_.fragments()[number];
    const auto face = openFaceOf(surface_, planes_, fragment);
    const auto piece = out_.ofFragments[number];
    if (!face.isOpen || (piece == kNone && !meets)) return;
    if (!face.isFace()) {
      const auto points = surface_.points(fragment);
      if (!isFilm(points)) {
        out_.misfits.push_back({fragment.triangle, fragment.cell, points.front()});
      }
    }
    if (!face.isFace() || meets) return;  // see MeetingCells
    parts_.push_back({number, piece, surface_.patchOf(fragment.triangle), face});
    out_.openArcOf[number] = CellPieces::kNoArea;
  }

  /// Parts that share an edge of the mesh.
  void join() {
    sets_.reset(parts_.size());
    std::vector<std::tuple<std::uint32_t, int, std::uint32_t, std::uint32_t, std::uint32_t>> edges;
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
      const auto& [fragment, piece, patch, face] = parts_[i];
      for (const auto edge : surface_.meshEdges(surface_.fragments()[fragment])) {
        if (edge != kNone) {
          edges.emplace_back(piece, 2 * face.axis + (face.isHigh ? 1 : 0), patch, edge, i);
        }
      }
    }
    std::ranges::sort(edges);
    const auto key = [](const auto& edge) {
      const auto& [piece, face, patch, number, part] = edge;
      return std::tuple(piece, face, patch, number);
    };
    for (std::size_t n = 1; n < edges.size(); ++n) {
      if (key(edges[n]) != key(edges[n - 1])) continue;
      sets_.unite(std::get<4>(edges[n]), std::get<4>(edges[n - 1]));
    }
  }

  /// In the order of the first fragment of each.
  void addArcs() {
    std::vector<FaceSum> sums;
    std::vector<std::uint32_t> sumOf(parts_.size());
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
      const auto root = sets_.find(i);
      if (root == i) {
        const FaceAxes axes(parts_[i].face.axis);
        sumOf[i] = static_cast<std::uint32_t>(sums.size());
        sums.emplace_back(axes.first, axes.second, pointsOf(parts_[i]).front());
      }
      sumOf[i] = sumOf[root];
      addRim(parts_[i], sums[sumOf[i]]);
    }
    std::vector<std::uint32_t> arcOf(sums.size(), CellPieces::kNoArea);
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
      const auto sum = sumOf[i];
      if (sets_.find(i) == i && sums[sum].area() > 0) {
        arcOf[sum] = static_cast<std::uint32_t>(out_.arcs.size());
        addArc(parts_[i], sums[sum]);
      }
      out_.openArcOf[parts_[i].fragment] = arcOf[sum];
    }
  }
  [[nodiscard]] std::span<const Vec3<double>> pointsOf(const Part& part) const {
    return surface_.points(surface_.fragments()[part.fragment]);
  }
  /// Seen against the axis, its normal points away where the fluid is below it.
  void addRim(const Part& part, FaceSum& sum) const {
    const auto points = pointsOf(part);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto& from = points[k];
      const auto& to = points[(k + 1) % points.size()];
      part.face.isHigh ? sum.addTrace(to, from) : sum.addTrace(from, to);
    }
  }
  void addArc(const Part& part, const FaceSum& sum) {
    const auto& [isOpen, axis, isHigh] = part.face;
    auto place = surface_.numbers().placeOfCell(surface_.fragments()[part.fragment].cell);
    place[asIndex(axis)] += isHigh ? 1 : 0;
    PieceArc arc{.face = surface_.numbers().face(axis, place),
                 .area = sum.area(),
                 .centroid = sum.centroid(),
                 .patch = part.patch};
    (isHigh ? arc.below : arc.above) = part.piece;
    out_.arcs.push_back(arc);
  }

  const TileSurface& surface_;
  const GridPlanes& planes_;
  CellPieces& out_;
  std::vector<Part> parts_;
  detail::DisjointSets sets_;
};

}  // namespace

void addOpenArcs(const TileSurface& surface, const GridPlanes& planes, const CellMask* wanted,
                 CellPieces& out) {
  if (surface.hasOpenPatches()) OpenArcs(surface, planes, out).run(wanted);
}

}  // namespace cutwater
