#include <Cutwater/CutCells/Detail/Moments/ArcMoments.hpp>

#include <utility>

namespace cutwater {

ArcMoments::ArcMoments(const FacePieces& faces, const CellPieces& content, const CutFrame& frame,
                       int degree)
    : faces_(faces),
      arcs_(content.arcs),
      frame_(frame),
      degree_(degree),
      count_(Monomials<2>::count(degree)),
      moments_(arcs_.size() * count_),
      references_(arcs_.size()),
      hasReference_(arcs_.size()) {
  const auto parts = faces.pieces();
  for (std::uint32_t part = 0; part < parts.size(); part = faces.of(parts[part].face).second) {
    addCutFace(parts[part].face);
  }
  for (auto arc = parts.size(); arc < arcs_.size() && !arcs_[arc].isOpenPatch(); ++arc) {
    addWholeFace(arc);
  }
  addOpenPatches(content);
}

void ArcMoments::addCutFace(std::uint32_t face) {
  const FaceFrame frame(faces_.surface().numbers(), faces_.planes(), face);
  const int across = frame.axes().across;
  if (faces_.meetsOn(face)) {
    addRegions(face, across);
  } else {
    addRims(frame);
  }
  const auto [firstPart, lastPart] = faces_.of(face);
  for (auto part = firstPart; part < lastPart; ++part) finishRim(part, across);
}

void ArcMoments::addRegions(std::uint32_t face, int across) {
  for (const auto& [polygon, point, isFluid, part] : faces_.regionsOn(face)) {
    if (part == kNone) continue;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      addRimPart(part, {polygon[k], polygon[(k + 1) % polygon.size()]}, across);
    }
  }
}

void ArcMoments::addRims(const FaceFrame& frame) {
  const auto& surface = faces_.surface();
  const int across = frame.axes().across;
  const auto face = surface.numbers().face(across, frame.place());
  const auto [firstTrace, lastTrace] = faces_.tracesOf(face);
  for (auto i = firstTrace; i < lastTrace; ++i) {
    const auto& trace = surface.traces()[i];
    addRimPart(faces_.ofTrace(i), {trace.from, trace.to}, across);
  }
  for (int side = 0; side < 4; ++side) {
    const auto edge = edgeOfFace(across, frame.place(), side);
    const auto stretches = faces_.stretches().of(edge.axis, edge.place);
    for (std::size_t s = 0; s < stretches.size(); ++s) {
      addRimPart(faces_.ofStretch(face, side, s), frame.endsOf(side, stretches[s]), across);
    }
  }
}

void ArcMoments::addOpenPatches(const CellPieces& content) {
  const auto& surface = faces_.surface();
  for (std::size_t i = 0; i < content.openArcOf.size(); ++i) {
    const auto arc = content.openArcOf[i];
    if (arc < arcs_.size()) addOpenPolygon(arc, surface.points(surface.fragments()[i]));
  }
  const auto& [of, polygons] = content.meetingWalls;
  for (std::size_t n = 0; n < of.size(); ++n) {
    const auto patch = of[n].second;
    if (WallPolygons::isOfArc(patch)) addOpenPolygon(patch - WallPolygons::kOfArc, polygons.of(n));
  }
  for (std::uint32_t arc = 0; arc < arcs_.size(); ++arc) {
    if (arcs_[arc].isOpenPatch()) finishRim(arc, surface.numbers().axisOfFace(arcs_[arc].face));
  }
}

/// Its edges, the polygon's normal pointing into the fluid: what lies within the arc cancels.
void ArcMoments::addOpenPolygon(std::uint32_t arc, std::span<const Vec3<double>> points) {
  const bool isBelow = arcs_[arc].below != kNone;  // its normal points down then
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::array ends{points[k], points[(k + 1) % points.size()]};
    if (isBelow) std::swap(ends[0], ends[1]);
    addRimPart(arc, ends, faces_.surface().numbers().axisOfFace(arcs_[arc].face));
  }
}

/// Applies the factors of simplices, and moves the moments to the centroid.
void ArcMoments::finishRim(std::uint32_t arc, int across) {
  const auto own = std::span(moments_).subspan(arc * count_, count_);
  for (std::size_t i = 0; i < count_; ++i) {
    const auto& [powers, degree, raised, factorials] = kMonomials<2>[i];
    own[i] *= factorials * factorialRatio(0, degree + 2);
  }
  shift(own, degree_, alongFace(references_[arc] - centroid(arc), across));
}

void ArcMoments::addRimPart(std::uint32_t arc, const std::array<Vec3<double>, 2>& ends,
                            int across) {
  if (hasReference_[arc] == 0) references_[arc] = ends[0];
  hasReference_[arc] = 1;
  const auto p = ends[0] - references_[arc];
  const auto q = ends[1] - references_[arc];
  const double twice = cross(p, q)[across];
  std::array<double, Monomials<2>::kCount> h{1};
  addCorner(h, degree_, alongFace(p, across));
  addCorner(h, degree_, alongFace(q, across));
  for (std::size_t i = 0; i < count_; ++i) moments_[arc * count_ + i] += twice * h[i];
}

void ArcMoments::addWholeFace(std::size_t arc) {
  const FaceFrame frame(faces_.surface().numbers(), faces_.planes(), arcs_[arc].face);
  const int across = frame.axes().across;
  const auto whole = momentsOfBox(alongFace(frame.corner(0) - centroid(arc), across),
                                  alongFace(frame.corner(3) - centroid(arc), across));
  std::copy_n(whole.begin(), count_, moments_.begin() + static_cast<std::ptrdiff_t>(arc * count_));
}

}  // namespace cutwater
