#include <Cutwater/CutCells/Detail/Curved/CurvedFaces.hpp>
#include <Cutwater/CutCells/Detail/Curved/CurvedMoments.hpp>
#include <Cutwater/CutCells/Detail/Curved/CurvedPieces.hpp>
#include <Cutwater/CutCells/Detail/Curved/CurvedTile.hpp>
#include <Cutwater/CutCells/Detail/Curved/GridSamples.hpp>
#include <Cutwater/CutCells/Detail/Curved/WallLattice.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace cutwater {

namespace {

/// A cell that is cut, and how to find the pieces in it.
struct CurvedCell {
  std::uint32_t cell = 0;
  std::uint32_t firstPiece = 0;
  std::optional<FluidParts> parts;         // if there are several
  std::vector<std::uint32_t> pieceOfPart;  // of each of these

  [[nodiscard]] std::uint32_t pieceAt(const Vec3<double>& point) const {
    return parts ? pieceOfPart[parts->at(point)] : firstPiece;
  }
};

/// What is open of the sides of a cell.
struct CellSides {
  OpenShares areas;
  bool isCut = false;
  bool isOpen = false;
  double gap = 0;

  void add(int axis, int side, const CurvedFace& face) {
    areas.add(axis, side, face.area);
    isCut = isCut || face.isCut();
    isOpen = isOpen || !face.parts.empty();
    gap = std::max(gap, face.gap);
  }
};

/// A face of a finer cell across a side of a cell.
struct FinerFace {
  int axis = 0;
  int side = 0;
  std::uint32_t number = 0;  // among those across this side
  CurvedFace face;
};

class CurvedTile {
 public:
  CurvedTile(const FluidField& field, const GridPlanes& planes, const SolidCutterOptions& how,
             const CutOptions& options)
      : solid_(field),
        fields_(field, planes),
        field_(fields_.here()),
        planes_(planes),
        how_(how),
        degree_(options.moments),
        withPolygons_(options.polygons),
        withPoints_(options.quadrature),
        rule_(field_, how.points),
        samples_(fields_, planes) {
    out_.numbers = TileNumbers(planes.sizes());
    out_.moments.degree = options.moments;
    faces_.resize(out_.numbers.faceCount());
    isFound_.resize(out_.numbers.faceCount());
  }

  void restrictTo(const TileLeaves& leaves) { leaves_ = &leaves; }

  TileCut run() {
    rowOf_.assign(out_.numbers.cellCount(), kNone);
    forTilePlaces(out_.numbers.cells(), [&](const TilePlace& cell) {
      if (leaves_ != nullptr && !leaves_->wanted[out_.numbers.cell(cell)]) return;
      out_.isBody[out_.numbers.cell(cell)] = !isFluidNode(cell);
      if (samples_.leavesRoom(cell)) cutCell(cell);
    });
    out_.firstPiece.push_back(pieceCount());
    addArcs();
    finishWalls();
    if (withPolygons_) addPolygons();
    return std::move(out_);
  }
  [[nodiscard]] const std::vector<BehindFiner>& behindFiner() const { return behind_; }

 private:
  [[nodiscard]] std::uint32_t pieceCount() const {
    return static_cast<std::uint32_t>(out_.content.pieces.size());
  }
  [[nodiscard]] bool isFluidNode(const TilePlace& node) const { return samples_.valueAt(node) > 0; }

  const CurvedFace& faceAt(int axis, const TilePlace& place) {
    const auto number = out_.numbers.face(axis, place);
    if (isFound_[number] == 0) {
      isFound_[number] = 1;
      if (planes_.shiftAt(axis, place[asIndex(axis)]) > 0) {
        return faces_[number] = faceBeyondSeam(axis, place);
      }
      const auto box = samples_.boxOf(place, axis);
      if (samples_.leavesRoom(place, axis)) {
        const BoxView view(field_, box, samples_.of(place, axis));
        faces_[number] = openPartsOf(field_, view, rule_, how_.tolerance);
      } else if (isFluidNode(place)) {
        faces_[number] = wholeFace(box, rule_);
      }
    }
    return faces_[number];
  }

  /// One in the last plane across an axis: found a period below.
  CurvedFace faceBeyondSeam(int axis, TilePlace place);

  /// Finds the finer faces across a side of a cell.
  [[nodiscard]] bool findFiner(const TilePlace& cell, int axis, int side, CellSides& sides) {
    if (leaves_ == nullptr) return false;
    const auto boxes = leaves_->finerFaces(out_.numbers.cell(cell), axis, side);
    for (std::uint32_t n = 0; n < boxes.size(); ++n) {
      finer_.push_back({axis, side, n, openPartsOf(field_, boxes[n], rule_, how_.tolerance)});
      sides.add(axis, side, finer_.back().face);
    }
    return !boxes.empty();
  }

  CellSides sidesOf(const TilePlace& cell) {
    finer_.clear();
    CellSides sides;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        if (findFiner(cell, axis, side, sides)) continue;
        sides.add(axis, side, faceAt(axis, faceOf(cell, axis, side)));
      }
    }
    return sides;
  }
  [[nodiscard]] static TilePlace faceOf(TilePlace cell, int axis, int side) {
    cell[asIndex(axis)] += side;
    return cell;
  }

  void cutCell(const TilePlace& cell) {
    const auto sides = sidesOf(cell);
    const auto box = samples_.boxOf(cell);
    const BoxView view(field_, box, samples_.of(cell));
    rule_.findIn(view, sides.areas, how_.tolerance);
    double volume = 0;
    double area = 0;
    for (const auto& span : rule_.points().spans) volume += span.size();
    for (const auto& wall : rule_.points().walls) area += wall.weight;
    const auto size = box.size();
    const double whole = size.x * size.y * size.z;
    const double side = whole / maxComponent(size);
    const bool isCut = sides.isCut || area > kNothingOfCell * side;
    const auto number = out_.numbers.cell(cell);
    if (!isCut || volume <= kNothingOfCell * whole) {
      out_.isBody[number] = volume < 0.5 * whole;
      if (!isCut || !sides.isOpen) return;
    }
    addCell(cell, view, std::max(sides.gap, rule_.gap()));
    addFinerFaces(out_.numbers.cell(cell));
  }

  /// What is behind them in the last cell.
  void addFinerFaces(std::uint32_t cell) {
    for (const auto& [axis, side, number, face] : finer_) {
      for (std::uint32_t part = 0; part < face.parts.size(); ++part) {
        const auto piece = cells_.back().pieceAt(face.parts[part].inside);
        auto& vector = out_.content.pieces[piece].areaVector;
        vector[axis] += side == 0 ? face.parts[part].area : -face.parts[part].area;
        behind_.push_back({cell, axis, side, number, part, piece});
      }
    }
  }

  void addCell(const TilePlace& cell, const BoxView& view, double gap) {
    const auto number = out_.numbers.cell(cell);
    rowOf_[number] = static_cast<std::uint32_t>(cells_.size());
    out_.cells.push_back(number);
    out_.firstPiece.push_back(pieceCount());
    unsigned corners = 0;
    for (int corner = 0; corner < 8; ++corner) {
      if (view.isFluid(corner)) corners |= 1U << static_cast<unsigned>(corner);
    }
    out_.fluidCorners.push_back(static_cast<std::uint8_t>(corners));
    out_.isTouched.push_back(0);
    out_.meets.push_back(0);
    out_.error.push_back(gap);
    cells_.push_back({.cell = number, .firstPiece = pieceCount(), .parts = {}, .pieceOfPart = {}});
    auto& here = cells_.back();
    FluidParts parts(field_, view.box(), rule_.points());
    std::vector<PieceRule> rules(std::max<std::size_t>(1, parts.count()));
    for (const auto& span : rule_.points().spans)
      rules[parts.of(span.block, span.middle())].add(span);
    for (const auto& wall : rule_.points().walls) {
      rules[parts.of(wall.block, wall.inside)].points.walls.push_back(wall);
    }
    if (rules.size() > 1) {
      forOpenParts(cell, [&](const OpenPart& part) { rules[parts.at(part.inside)].isOpen = true; });
    }
    addPieces(view.box(), rules, here);
    if (rules.size() > 1) here.parts.emplace(std::move(parts));
  }

  /// Those of all sides.
  template <typename Visit>
  void forOpenParts(const TilePlace& cell, const Visit& visit) {
    for (const auto& finer : finer_) std::ranges::for_each(finer.face.parts, visit);
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        const auto face = out_.numbers.face(axis, faceOf(cell, axis, side));
        std::ranges::for_each(faces_[face].parts, visit);
      }
    }
  }

  /// A piece for each part with a volume, and a wall or an open face; others belong to the largest.
  /// One at least.
  void addPieces(const Box<double>& box, std::vector<PieceRule>& rules, CurvedCell& here) {
    const auto size = box.size();
    const auto largest = static_cast<std::size_t>(
        std::ranges::max_element(rules, {}, &PieceRule::volume) - rules.begin());
    here.pieceOfPart.assign(rules.size(), kNone);
    const auto isPiece = [&](std::size_t part) {
      const auto& rule = rules[part];
      const bool isBounded = rule.isOpen || !rule.points.walls.empty();
      return part == largest ||
             (isBounded && rule.volume > kNothingOfCell * size.x * size.y * size.z);
    };
    for (std::size_t part = 0; part < rules.size(); ++part) {
      if (isPiece(part)) continue;
      for (const auto& span : rules[part].points.spans) rules[largest].add(span);
      auto& walls = rules[largest].points.walls;
      walls.insert(walls.end(), rules[part].points.walls.begin(), rules[part].points.walls.end());
    }
    for (std::size_t part = 0; part < rules.size(); ++part) {
      if (!isPiece(part)) continue;
      here.pieceOfPart[part] = pieceCount();
      addPiece(field_, box, here.cell, rules[part], out_.content);
      rules_.push_back(std::move(rules[part].points));
    }
    for (auto& piece : here.pieceOfPart) {
      if (piece == kNone) piece = here.pieceOfPart[largest];
    }
  }

  /// The row in cells_ of the cell at a place; kNone if it is not cut, or not in the tile.
  [[nodiscard]] std::uint32_t rowAt(const TilePlace& cell) const {
    for (std::size_t a = 0; a < 3; ++a) {
      if (cell[a] < 0 || cell[a] >= out_.numbers.cells()[a]) return kNone;
    }
    return rowOf_[out_.numbers.cell(cell)];
  }

  void addArcs() {
    for (std::uint32_t number = 0; number < faces_.size(); ++number) {
      const int axis = out_.numbers.axisOfFace(number);
      const auto place = out_.numbers.placeOfFace(number);
      auto placeBelow = place;
      --placeBelow[asIndex(axis)];
      const auto below = rowAt(placeBelow);
      const auto above = rowAt(place);
      if (below == kNone && above == kNone) continue;
      for (const auto& part : faces_[number].parts) {
        PieceArc arc{.face = number, .area = part.area, .centroid = part.centroid};
        if (below != kNone) arc.below = cells_[below].pieceAt(part.inside);
        if (above != kNone) arc.above = cells_[above].pieceAt(part.inside);
        if (arc.below != kNone) out_.content.pieces[arc.below].areaVector[axis] -= part.area;
        if (arc.above != kNone) out_.content.pieces[arc.above].areaVector[axis] += part.area;
        out_.content.arcs.push_back(arc);
        if (degree_ >= 0) addArcMoments(part, axis, out_.moments);
        if (withPoints_) addArcPoints(part, how_.points, out_.quadrature);
      }
    }
  }

  /// Parts of a wall add up to what closes the piece.
  void finishWalls() {
    auto gaps = std::vector<Vec3<double>>(pieceCount());
    for (std::size_t p = 0; p < gaps.size(); ++p) gaps[p] = out_.content.pieces[p].areaVector;
    for (const auto& wall : out_.content.walls) gaps[wall.piece] -= wall.areaVector;
    for (auto& wall : out_.content.walls) {
      wall.areaVector += (wall.area / out_.content.pieces[wall.piece].area) * gaps[wall.piece];
    }
    for (std::size_t p = 0; p < gaps.size(); ++p) {
      if (degree_ >= 0) addPieceMoments(out_.content.pieces[p], rules_[p], out_.moments);
      if (withPoints_) addPiecePoints(rules_[p], how_.points, out_.quadrature);
    }
  }

  void addPolygons() {
    const CellLattice lattice(planes_, leaves_ != nullptr ? &leaves_->around : nullptr);
    WallLattice wall(field_, planes_, lattice);
    std::uint32_t face = kNone;
    for (const auto& arc : out_.content.arcs) {
      if (arc.face == face) continue;
      face = arc.face;
      wall.addOutlines(out_.numbers.axisOfFace(face), out_.numbers.placeOfFace(face), faces_[face],
                       out_.polygons.arcs);
    }
    for (const auto& cell : cells_) {
      const auto pieceAt = [&](const Vec3<double>& point) { return cell.pieceAt(point); };
      wall.addWalls(out_.numbers.placeOfCell(cell.cell), pieceAt, out_.content, out_.polygons);
    }
  }

  struct BelowSeam;

  const FluidField& solid_;
  NearFields fields_;
  const FluidField& field_;
  const GridPlanes& planes_;
  const SolidCutterOptions& how_;
  int degree_;
  bool withPolygons_;
  bool withPoints_;
  FluidRule rule_;
  GridSamples samples_;
  std::vector<CurvedFace> faces_;
  std::vector<char> isFound_;
  std::vector<std::uint32_t> rowOf_;  // of cells
  std::vector<CurvedCell> cells_;
  std::vector<RulePoints> rules_;  // of pieces
  const TileLeaves* leaves_ = nullptr;
  std::vector<FinerFace> finer_;  // of the cell at hand
  std::vector<BehindFiner> behind_;
  std::array<std::shared_ptr<BelowSeam>, 3> belowSeam_;  // across each axis, once it is needed
  TileCut out_;
};

/// A layer of cells above the plane that is a period below the last one across an axis.
struct CurvedTile::BelowSeam {
  BelowSeam(const CurvedTile& of, int axis)
      : planes(of.planes_), tile(of.solid_, withLayer(axis), of.how_, {}) {}

  const GridPlanes& withLayer(int axis) {
    auto& across = planes.positions[asIndex(axis)];
    const double plane = across.back() - planes.period[axis];
    positions = {plane, plane + (across.back() - across[across.size() - 2])};
    across = positions;
    return planes;
  }

  std::array<double, 2> positions{};
  GridPlanes planes;
  CurvedTile tile;
};

CurvedFace CurvedTile::faceBeyondSeam(int axis, TilePlace place) {
  auto& below = belowSeam_[asIndex(axis)];
  if (!below) below = std::make_shared<BelowSeam>(*this, axis);
  const double plane = planes_.at(axis, place[asIndex(axis)]);
  place[asIndex(axis)] = 0;
  auto face = below->tile.faceAt(axis, place);
  face.moveTo(axis, plane, field_);
  return face;
}

}  // namespace

WholeBox wholeBox(const FluidField& field, const Box<double>& box) {
  const double value = field.value(box.center());
  const double reach = field.changeToCorners(box);
  return {reach > 0 && std::abs(value) > reach, value > 0};
}

TileCut cutTile(const FluidField& field, const GridPlanes& planes, const SolidCutterOptions& how,
                const CutOptions& options) {
  return CurvedTile(field, planes, how, options).run();
}

TileCut cutTile(const FluidField& field, const GridPlanes& planes, const SolidCutterOptions& how,
                const CutOptions& options, const TileLeaves& leaves,
                std::vector<BehindFiner>& behind) {
  CurvedTile tile(field, planes, how, options);
  tile.restrictTo(leaves);
  auto cut = tile.run();
  behind = tile.behindFiner();
  return cut;
}

}  // namespace cutwater
