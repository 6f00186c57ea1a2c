#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Faces/BaffleWays.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceRegions.hpp>
#include <Cutwater/CutCells/Detail/Faces/LocalWinding.hpp>
#include <Cutwater/CutCells/Detail/Moments/Moments.hpp>
#include <Cutwater/CutCells/Detail/Pieces/MeetingCells.hpp>
#include <Cutwater/CutCells/Detail/Pieces/OpenArcs.hpp>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

using Polygon = SheetTree::Polygon;

/// Added to the patches of sheets that are open and lie in a face of the cell.
constexpr std::uint32_t kOpenSheet = 0x80000000;

std::vector<Sheet> sheetsOf(const TileSurface& surface, const GridPlanes& planes,
                            std::span<const TileFragment> fragments) {
  std::vector<Sheet> sheets;
  for (const auto& fragment : fragments) {
    Sheet sheet;
    if (!makeSheet(surface, fragment, sheet)) continue;
    if (openFaceOf(surface, planes, fragment).isFace()) sheet.patch |= kOpenSheet;
    sheets.push_back(std::move(sheet));
  }
  std::stable_partition(sheets.begin(), sheets.end(),
                        [](const Sheet& sheet) { return !sheet.isBaffle; });
  return sheets;
}

/// One cell.
class MeetingCell {
 public:
  MeetingCell(const FacePieces& faces, std::span<const std::uint32_t> arcOfFullFace,
              std::span<const TileFragment> fragments, CellPieces& out)
      : faces_(faces),
        surface_(faces.surface()),
        arcOfFullFace_(arcOfFullFace),
        cell_(fragments.front().cell),
        place_(surface_.numbers().placeOfCell(cell_)),
        tree_(faces.planes().boxOf(place_), sheetsOf(surface_, faces.planes(), fragments)),
        points_(tree_.pointsIn()),
        ways_(surface_, fragments),
        out_(out) {
    const auto size = faces.planes().sizeOf(place_);
    least_ = kSliver * std::min({size.x * size.y, size.y * size.z, size.z * size.x});
    somePatch_ = surface_.patchOf(fragments.front().triangle);
    const WindingInCell windings(surface_, faces.stretches(), cell_);
    for (const auto& point : points_) isFluid_.push_back(windings.at(point) <= 0 ? 1 : 0);
  }

  void run() {
    findOpenParts();
    sets_.reset(tree_.leafCount() + open_.size());
    for (const auto& portal : tree_.portals()) {
      if (isFluid_[portal.below] != 0 && isFluid_[portal.above] != 0) {
        if (ways_.areAny()) {
          joinAroundBaffles(portal);
        } else {
          unite(portal.below, portal.above, portal.polygon);
        }
      } else if (isFluid_[portal.below] != isFluid_[portal.above]) {
        addWall(portal);
      }
    }
    for (std::size_t face = 0; face < 6; ++face) addFace(face);
    measure();
  }

 private:
  struct OpenPart {
    std::uint32_t arc = 0;
    std::size_t face = 0;  ///< two for each axis, low and high
  };
  struct Wall {
    std::uint32_t node = 0;  ///< whose it is: a leaf, or an open part
    std::uint32_t patch = 0;
    Polygon polygon;
    std::size_t openFace = kNoFace;  ///< in which it is a part of an open patch
    std::uint32_t openArc = kNone;   ///< whose arc this is
  };
  using OpenKey = std::tuple<std::uint32_t, std::size_t, std::uint32_t>;
  static OpenKey openKeyOf(const Wall& wall) { return {wall.node, wall.openFace, wall.patch}; }
  static constexpr std::size_t kNoFace = 6;

  [[nodiscard]] std::uint32_t faceNumber(std::size_t face) const {
    auto place = place_;
    place[face / 2] += static_cast<int>(face % 2);
    return surface_.numbers().face(static_cast<int>(face / 2), place);
  }
  void findOpenParts() {
    for (std::size_t n = 0; n < 6; ++n) {
      const auto face = faceNumber(n);
      firstOpen_[n] = static_cast<std::uint32_t>(open_.size());
      if (faces_.isCut(face)) {
        const auto [from, to] = faces_.of(face);
        for (auto arc = from; arc < to; ++arc) open_.push_back({arc, n});
      } else if (arcOfFullFace_[face] != kNone) {
        open_.push_back({arcOfFullFace_[face], n});
      }
    }
  }
  /// kNone if the face has no such arc.
  [[nodiscard]] std::uint32_t nodeOfArc(std::size_t face, std::uint32_t arc) const {
    for (auto i = firstOpen_[face]; i < open_.size() && open_[i].face == face; ++i) {
      if (open_[i].arc == arc) return tree_.leafCount() + i;
    }
    return kNone;
  }
  void unite(std::uint32_t one, std::uint32_t other, const Polygon& open) {
    if (0.5 * length(twiceArea(open)) > least_) sets_.unite(one, other);
  }

  /// Joins fluid with fluid, but through a baffle, which is a wall on both sides.
  void joinAroundBaffles(const SheetTree::Portal& portal) {
    const auto up = twiceArea(portal.polygon);
    const auto open = withoutBaffles(portal.polygon, tree_.sheetsAt(portal),
                                     [&](std::uint32_t patch, const Polygon& part) {
                                       addWallPart({portal.above, patch, part}, up);
                                       addWallPart({portal.below, patch, part}, -up);
                                     });
    for (const auto& part : open) {
      if (isGap(part) || sets_.find(portal.below) == sets_.find(portal.above)) continue;
      if (ways_.isOpen(points_[portal.below], middleOf(part), points_[portal.above])) {
        unite(portal.below, portal.above, part);
      }
    }
  }

  void addWall(const SheetTree::Portal& portal) {
    const bool facesUp = isFluid_[portal.above] != 0;
    addWall(facesUp ? portal.above : portal.below, portal.polygon,
            (facesUp ? 1.0 : -1.0) * twiceArea(portal.polygon), tree_.sheetsAt(portal));
  }
  /// `normal`: into the fluid. `face`: in which all of it lies, with the fluid in the cell.
  void addWall(std::uint32_t node, const Polygon& polygon, const Vec3<double>& normal,
               std::span<const Sheet> sheets, std::size_t face = kNoFace) {
    if (sheets.empty()) {  // only if rounding has hidden them
      addWallPart({node, somePatch_, polygon}, normal);
      return;
    }
    sharedOut(polygon, normal, sheets, [&](std::uint32_t patch, const Polygon& part) {
      const bool isOpen = (patch & kOpenSheet) != 0;
      addWallPart({node, patch & ~kOpenSheet, part, isOpen ? face : kNoFace}, normal);
    });
  }
  void addWallPart(Wall wall, const Vec3<double>& normal) {
    if (dot(twiceArea(wall.polygon), normal) < 0) std::ranges::reverse(wall.polygon);
    walls_.push_back(std::move(wall));
  }

  /// Leaves and regions of a face end at baffles in the same lines, but for rounding, which is
  /// large where a baffle is nearly parallel to the face: what is so little of both is no opening.
  static constexpr double kLittle = 1e-6;
  /// Twice those of leaves, if there are baffles.
  [[nodiscard]] std::vector<double> areasOnFace(std::size_t n) const {
    if (!ways_.areAny()) return {};
    std::vector<double> areas(tree_.leafCount());
    tree_.divide(
        tree_.face(n), SheetTree::inwards(n),
        [&](std::uint32_t leaf, const Polygon& part) { areas[leaf] += length(twiceArea(part)); });
    return areas;
  }
  /// Joins what is open on a face with what is behind it, and adds walls in the face's plane.
  void addFace(std::size_t n) {
    const auto face = faceNumber(n);
    const auto inwards = SheetTree::inwards(n);
    const auto areas = areasOnFace(n);
    const auto onFace = ways_.areAny() ? BaffleWays(surface_, face) : BaffleWays();
    const auto isWayOpen = [&](std::uint32_t leaf, const Polygon& part, const Vec3<double>& point) {
      if (areas.empty()) return true;
      const auto middle = middleOf(part);
      return ways_.isOpen(points_[leaf], middle) && onFace.isOpen(middle, point);
    };
    for (const auto& region : faces_.regionsOn(face)) {
      // Rounding may find fluid on a face that has none.
      const auto arc = region.isFluid ? nodeOfRegion(n, face, region) : kNone;
      const bool isOpen = arc != kNone;
      const double whole = length(twiceArea(region.polygon));
      tree_.divide(region.polygon, inwards, [&](std::uint32_t leaf, const Polygon& part) {
        if (isOpen && isFluid_[leaf] != 0) {
          const double least = areas.empty() ? 0 : kLittle * std::min(areas[leaf], whole);
          const bool isOpening = length(twiceArea(part)) >= least;
          if (isOpening && isWayOpen(leaf, part, region.point)) unite(arc, leaf, part);
        } else if (isOpen) {
          addWall(arc, part, -inwards, tree_.sheetsIn(n));
        } else if (isFluid_[leaf] != 0) {
          addWall(leaf, part, inwards, tree_.sheetsIn(n), n);
        }
      });
    }
  }
  [[nodiscard]] std::uint32_t nodeOfRegion(std::size_t n, std::uint32_t face,
                                           const FaceRegions::Region& region) const {
    return nodeOfArc(n, faces_.isCut(face) ? region.part : arcOfFullFace_[face]);
  }

  /// Between baffles, and no thicker than rounding, which has cut it off.
  [[nodiscard]] bool isFilm(const PieceSums& sum) const {
    const auto size = faces_.planes().sizeOf(place_);
    return ways_.areAny() && sum.piece(cell_).volume < kSliver * sum.area() * maxComponent(size);
  }
  void measure() {
    std::vector<std::uint32_t> sumOf(tree_.leafCount() + open_.size(), kNone);  // by root
    std::vector<PieceSums> sums;
    const auto sumAt = [&](std::uint32_t node) -> PieceSums& {
      auto& sum = sumOf[sets_.find(node)];
      if (sum == kNone) {
        sum = static_cast<std::uint32_t>(sums.size());
        sums.emplace_back(node < tree_.leafCount()
                              ? points_[node]
                              : out_.arcs[open_[node - tree_.leafCount()].arc].centroid);
      }
      return sums[sum];
    };
    for (const auto& wall : walls_) {
      if (wall.openFace == kNoFace) {
        sumAt(wall.node).addWall(wall.polygon, wall.patch);
      } else {
        sumAt(wall.node).addOpenPatch(wall.polygon);
      }
    }
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
      addOpenPart(sumAt(tree_.leafCount() + i), open_[i]);
    }
    const auto size = faces_.planes().sizeOf(place_);
    std::vector<std::uint32_t> numbers;
    for (auto& sum : sums) {
      numbers.push_back(kNone);
      if (sum.isNothing(size, kSliver) || isFilm(sum)) continue;
      numbers.back() = static_cast<std::uint32_t>(out_.pieces.size());
      sum.appendWalls(numbers.back(), out_.walls);
      out_.pieces.push_back(withinCell(sum.piece(cell_), faces_.planes().boxOf(place_)));
      // What closes the open parts: slivers that were lost do not matter to it.
      out_.pieces.back().areaVector = {};
    }
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
      auto& arc = out_.arcs[open_[i].arc];
      const bool isHigh = open_[i].face % 2 == 1;
      const auto piece = numbers[sumOf[sets_.find(tree_.leafCount() + i)]];
      (isHigh ? arc.below : arc.above) = piece;
      arc.isDropped = arc.isDropped || piece == kNone;
      if (piece == kNone) continue;
      out_.pieces[piece].areaVector[static_cast<int>(open_[i].face / 2)] +=
          isHigh ? -arc.area : arc.area;
    }
    const auto pieceOf = [&](const Wall& wall) { return numbers[sumOf[sets_.find(wall.node)]]; };
    std::erase_if(walls_, [&](const Wall& wall) { return pieceOf(wall) == kNone; });
    for (auto& wall : walls_) wall.node = pieceOf(wall);
    addOpenPatches();
    for (const auto& wall : walls_) {
      if (wall.openFace != kNoFace && wall.openArc == kNone) continue;  // too small to count
      const bool isOpen = wall.openFace != kNoFace;
      out_.meetingWalls.of.emplace_back(wall.node,
                                        isOpen ? WallPolygons::kOfArc + wall.openArc : wall.patch);
      out_.meetingWalls.polygons.add(wall.polygon);
    }
  }
  /// One arc for all that a patch has of a piece in a face. Nodes of walls are pieces now.
  void addOpenPatches() {
    std::map<OpenKey, Moments> sums;
    for (const auto& wall : walls_) {
      if (wall.openFace == kNoFace) continue;
      const auto& polygon = wall.polygon;
      auto& sum = sums.try_emplace(openKeyOf(wall), polygon[0]).first->second;
      for (std::size_t k = 2; k < polygon.size(); ++k) {
        const auto twice = cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
        sum.add(0.5 * length(twice), (polygon[0] + polygon[k - 1] + polygon[k]) / 3.0);
      }
    }
    std::map<OpenKey, std::uint32_t> arcs;
    for (const auto& [key, sum] : sums) {
      const auto& [piece, face, patch] = key;
      if (!(sum.size() > least_)) continue;
      const bool isHigh = face % 2 == 1;
      const auto axis = static_cast<int>(face / 2);
      PieceArc arc{
          .face = faceNumber(face), .area = sum.size(), .centroid = sum.centroid(), .patch = patch};
      arc.centroid[axis] = faces_.planes().at(axis, place_[face / 2] + static_cast<int>(face % 2));
      (isHigh ? arc.below : arc.above) = piece;
      out_.pieces[piece].areaVector[axis] += isHigh ? -arc.area : arc.area;
      arcs[key] = static_cast<std::uint32_t>(out_.arcs.size());
      out_.arcs.push_back(arc);
    }
    for (auto& wall : walls_) {
      const auto found = arcs.find(openKeyOf(wall));
      if (wall.openFace != kNoFace && found != arcs.end()) wall.openArc = found->second;
    }
  }
  void addOpenPart(PieceSums& sum, const OpenPart& part) const {
    const auto& arc = out_.arcs[part.arc];
    const int axis = static_cast<int>(part.face / 2);
    const bool isHigh = part.face % 2 == 1;
    const double plane =
        faces_.planes().at(axis, place_[part.face / 2] + static_cast<int>(part.face % 2));
    const double way = plane - sum.reference()[axis];
    sum.addOpenPart(isHigh ? way : -way, arc.area, arc.centroid);
  }

  const FacePieces& faces_;
  const TileSurface& surface_;
  std::span<const std::uint32_t> arcOfFullFace_;
  std::uint32_t cell_;
  TilePlace place_;
  SheetTree tree_;
  std::vector<Vec3<double>> points_;  // in leaves
  BaffleWays ways_;
  CellPieces& out_;
  double least_ = 0;
  std::uint32_t somePatch_ = 0;
  std::vector<char> isFluid_;  // leaves
  std::vector<OpenPart> open_;
  std::array<std::uint32_t, 6> firstOpen_{};
  detail::DisjointSets sets_;  // of leaves, then open parts
  std::vector<Wall> walls_;
};

}  // namespace

void MeetingCells::build(std::span<const TileFragment> fragments) {
  MeetingCell(faces_, arcOfFullFace_, fragments, out_).run();
  out_.ofFragments.resize(out_.ofFragments.size() + fragments.size(), kNone);
}

}  // namespace cutwater
