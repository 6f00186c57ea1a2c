#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutRows.hpp>

#include <algorithm>

namespace cutwater {

std::uint32_t CutLeaves::rowOf(std::uint32_t leaf) const {
  const auto found = std::ranges::lower_bound(cut.leaf, leaf);
  return found != cut.leaf.end() && *found == leaf
             ? static_cast<std::uint32_t>(found - cut.leaf.begin())
             : kNoRow;
}

bool CutLeaves::isTouchedOnly(std::uint32_t row) const {
  return isOnlyTouched(*this, row);
}

double CutLeaves::leafVolume(std::uint32_t row) const {
  const auto size = cut.box[row].upper - cut.box[row].lower;
  return size.x * size.y * size.z;
}

double CutLeaves::volumeFraction(std::uint32_t piece) const {
  return std::clamp(pieces.volume[piece] / leafVolume(pieces.cell[piece]), 0.0, 1.0);
}

double CutLeaves::aperture(std::uint32_t arc) const {
  return std::clamp(arcs.area[arc] / arcs.faceArea[arc], 0.0, 1.0);
}

}  // namespace cutwater
