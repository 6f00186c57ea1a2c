#include <Cutwater/CutCells/Detail/Leaves/CoarseFace.hpp>

#include <algorithm>
#include <limits>
#include <tuple>

namespace cutwater {

namespace {

/// By how much a point lies outside of a convex polygon that is counterclockwise about an axis, at
/// most, across one of its edges; negative within.
double distanceOutside(std::span<const Vec3<double>> polygon, int axis, const Vec3<double>& p) {
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto way = polygon[(k + 1) % polygon.size()] - polygon[k];
    const double size = length(way);
    if (size > 0) most = std::max(most, -cross(way, p - polygon[k])[axis] / size);
  }
  return most;
}

}  // namespace

CoarseFace::CoarseFace(const LeafGrid& grid, const LeafSources& sources,
                       std::span<const FluidClass> classes, std::uint32_t coarse, int axis,
                       bool isHigh)
    : grid_(grid),
      sources_(sources),
      coarse_(coarse),
      axis_(axis),
      isHigh_(isHigh),
      finer_(grid.finerAcross(sources.source(coarse).leaf, axis, isHigh)) {
  findParts(classes);
  if (!sources_.tileOf(coarse_).rims.behind.empty()) {
    lookUpBehind();
    return;
  }
  for (auto& part : parts_) findBehind(part);
  for (auto& part : points_) findBehind(part);
  sets_.reset(parts_.size());
  joinThroughEdges();
  settle();
}

void CoarseFace::findParts(std::span<const FluidClass> classes) {
  for (const auto leaf : finer_) {
    firstPart_.push_back(static_cast<std::uint32_t>(parts_.size()));
    const auto source = sources_.of(leaf);
    if (source == kNone) {
      if (classes[leaf] == FluidClass::Fluid) parts_.push_back({.leaf = leaf});
      continue;
    }
    for (const auto& [face, arc] : sources_.tileOf(source).arcsOf(finerFace(source))) {
      parts_.push_back({.leaf = leaf, .arc = arc});
    }
    for (const auto& [face, arc] : sources_.tileOf(source).pointsOf(finerFace(source))) {
      points_.push_back({.leaf = leaf, .arc = arc});
    }
  }
  firstPart_.push_back(static_cast<std::uint32_t>(parts_.size()));
}

void CoarseFace::lookUpBehind() {
  const auto& behind = sources_.tileOf(coarse_).rims.behind;
  const auto face = sources_.faceOf(coarse_, axis_, isHigh_);
  for (std::size_t n = 0; n < finer_.size(); ++n) {
    for (auto part = firstPart_[n]; part < firstPart_[n + 1]; ++part) {
      const std::tuple wanted(face, finer_[n], part - firstPart_[n]);
      const auto found = std::ranges::lower_bound(behind, wanted, {}, &LeafRims::PieceBehind::key);
      if (found != behind.end() && found->key() == wanted) parts_[part].behind = found->piece;
    }
  }
}

void CoarseFace::findBehind(Part& part) const {
  if (sources_.tileOf(coarse_).cut.meets[sources_.source(coarse_).row] != 0) {
    part.behind = behindPoint(pointIn(part));
    return;
  }
  part.behind = kUnknown;
  if (part.arc == kNone) return;
  const auto& fine = sources_.tileOf(sources_.of(part.leaf)).rims.triangles;
  const auto& walls = sources_.tileOf(coarse_).rims.walls;
  const auto row = sources_.source(coarse_).row;
  const auto key = [](const LeafRims::WallTriangle& wall) {
    return std::pair(wall.row, wall.triangle);
  };
  for (auto rim = std::ranges::lower_bound(fine, part.arc, {}, &LeafRims::RimTriangle::arc);
       rim != fine.end() && rim->arc == part.arc; ++rim) {
    const std::pair wanted(row, rim->triangle);
    const auto wall = std::ranges::lower_bound(walls, wanted, {}, key);
    if (wall == walls.end() || key(*wall) != wanted) continue;
    part.behind = wall->piece;
    if (part.behind != kNone) return;
  }
  // Behind what has an area there is a piece, even if all of its rim belongs to films.
  const auto& arc = sources_.tileOf(sources_.of(part.leaf)).cut.content.arcs[part.arc];
  const auto size = grid_.boxInFrame(sources_.source(coarse_).leaf).size();
  if (arc.area > PieceSums::nothing(size)) part.behind = kUnknown;
}

Vec3<double> CoarseFace::pointIn(const Part& part) const {
  if (part.arc == kNone) {
    const auto box = grid_.boxInFrame(part.leaf);
    auto middle = box.center();
    middle[axis_] = isHigh_ ? box.lower[axis_] : box.upper[axis_];
    return middle;
  }
  const auto& tile = sources_.tileOf(sources_.of(part.leaf));
  const auto& points = tile.rims.innerPoints;
  const auto found = std::ranges::lower_bound(points, part.arc, {}, &LeafRims::InnerPoint::arc);
  if (found != points.end() && found->arc == part.arc) return found->point;
  return tile.cut.content.arcs[part.arc].centroid;  // of all of a face
}

/// The piece behind the region in which the point lies, or which is nearest to it.
std::uint32_t CoarseFace::behindPoint(const Vec3<double>& point) const {
  const auto& regions = sources_.tileOf(coarse_).rims.openRegions;
  const auto face = sources_.faceOf(coarse_, axis_, isHigh_);
  std::uint32_t piece = kNone;
  double least = std::numeric_limits<double>::infinity();
  auto region = std::ranges::lower_bound(regions, face, {}, &LeafRims::OpenRegion::face);
  for (; region != regions.end() && region->face == face; ++region) {
    const double outside = distanceOutside(region->polygon, axis_, point);
    if (outside < least) least = outside, piece = region->piece;
  }
  return piece;
}

void CoarseFace::joinThroughEdges() {
  for (std::uint32_t n = 0; n < finer_.size(); ++n) {
    for (int side = 0; side < 4; ++side) joinThroughEdge(n, side);
  }
}

/// Where nothing crosses an edge of a finer face, the parts on both sides of it are one. Of two
/// faces, the finer one does this.
void CoarseFace::joinThroughEdge(std::uint32_t finer, int side) {
  const auto& [index, level, kind] = grid_.leaves()[finer_[finer]];
  const FaceAxes axes(axis_);
  const int run = side < 2 ? axes.first : axes.second;
  auto next = index;
  along(next, side < 2 ? axes.second : axes.first) += side % 2 == 0 ? -1 : 1;
  const auto there = grid_.at(next, level, finer_[finer]);
  const auto other = std::ranges::lower_bound(finer_, there);
  const bool isThere = other != finer_.end() && *other == there;
  if (!isThere || grid_.leaves()[*other].level > level) return;
  const double middle = grid_.boxInFrame(finer_[finer]).center()[run];
  const auto part = partAt(finer, side, middle, true);
  if (part == kNone) return;
  const auto beside =
      partAt(static_cast<std::uint32_t>(other - finer_.begin()), side ^ 1, middle, false);
  if (beside != kNone) sets_.unite(part, beside);
}

std::uint32_t CoarseFace::partAt(std::uint32_t finer, int side, double place, bool ifWhole) const {
  const auto source = sources_.of(finer_[finer]);
  const bool isCut =
      source != kNone &&
      std::ranges::binary_search(sources_.tileOf(source).rims.cutFaces, finerFace(source));
  if (!isCut) return firstPart_[finer] < firstPart_[finer + 1] ? firstPart_[finer] : kNone;
  const auto key = [](const LeafRims::RimStretch& s) { return std::pair(s.face, s.side); };
  const auto& stretches = sources_.tileOf(source).rims.stretches;
  const std::pair edge(finerFace(source), side);
  const auto first = std::ranges::lower_bound(stretches, edge, {}, key);
  const auto last = std::ranges::upper_bound(stretches, edge, {}, key);
  const auto found = std::find_if(first, last, [&](const LeafRims::RimStretch& s) {
    return ifWhole ? s.isWhole : s.ends.contains(place);
  });
  return found == last ? kNone : partOf(finer, found->arc);
}

std::uint32_t CoarseFace::partOf(std::uint32_t finer, std::uint32_t arc) const {
  for (auto part = firstPart_[finer]; part < firstPart_[finer + 1]; ++part) {
    if (parts_[part].arc == arc) return part;
  }
  return kNone;
}

void CoarseFace::settle() {
  const auto count = static_cast<std::uint32_t>(parts_.size());
  for (std::uint32_t part = 0; part < count; ++part) {
    auto& root = parts_[sets_.find(part)].behind;
    if (root == kUnknown) root = parts_[part].behind;
  }
  for (std::uint32_t part = 0; part < count; ++part) {
    auto& behind = parts_[part].behind;
    if (behind == kUnknown) behind = parts_[sets_.find(part)].behind;
    if (behind == kUnknown) behind = wholeFacePiece();
  }
  for (auto& part : points_) {
    if (part.behind == kUnknown) part.behind = kNone;
  }
}

std::uint32_t CoarseFace::wholeFacePiece() const {
  const auto& tile = sources_.tileOf(coarse_);
  const auto arcs = tile.arcsOf(sources_.faceOf(coarse_, axis_, isHigh_));
  if (arcs.empty()) return kNone;
  const auto areaOf = [&](const auto& of) { return tile.cut.content.arcs[of.second].area; };
  const auto largest = std::ranges::max_element(arcs, {}, areaOf);  // others are those of films
  const auto& arc = tile.cut.content.arcs[largest->second];
  return isHigh_ ? arc.below : arc.above;
}

}  // namespace cutwater
