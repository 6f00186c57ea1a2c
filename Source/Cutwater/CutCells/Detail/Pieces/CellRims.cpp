#include <Cutwater/CutCells/Detail/Pieces/CellRims.hpp>

#include <utility>

namespace cutwater {

namespace {

PieceArc wholeFace(const TileNumbers& numbers, std::uint32_t face, const GridPlanes& planes) {
  const int axis = numbers.axisOfFace(face);
  const auto place = numbers.placeOfFace(face);
  PieceArc arc{.face = face, .area = 1, .centroid = {}};
  for (int other = 0; other < 3; ++other) {
    const double low = planes.at(other, place[asIndex(other)]);
    arc.centroid[other] = low;
    if (other == axis) continue;
    const double high = planes.at(other, place[asIndex(other)] + 1);
    arc.area *= high - low;
    arc.centroid[other] = 0.5 * (low + high);
  }
  return arc;
}

}  // namespace

std::vector<std::uint32_t> addFullFaces(const TileSurface& surface, const EdgeStretches& stretches,
                                        const FacePieces& faces, const GridPlanes& planes,
                                        const CellMask* wanted, std::vector<PieceArc>& arcs) {
  const auto& numbers = surface.numbers();
  std::vector<std::uint32_t> arcOf(numbers.faceCount(), kNone);
  std::uint32_t last = kNone;
  for (const auto& fragment : surface.fragments()) {
    if (fragment.cell == std::exchange(last, fragment.cell)) continue;
    if (!isWanted(wanted, fragment.cell)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) {
        auto place = numbers.placeOfCell(fragment.cell);
        place[asIndex(axis)] += side;
        const auto face = numbers.face(axis, place);
        if (faces.isCut(face) || arcOf[face] != kNone || !stretches.isFluid(place)) continue;
        arcOf[face] = static_cast<std::uint32_t>(arcs.size());
        arcs.push_back(wholeFace(numbers, face, planes));
      }
    }
  }
  return arcOf;
}

}  // namespace cutwater
