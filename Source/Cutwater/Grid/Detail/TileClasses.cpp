#include <Cutwater/Grid/Detail/TargetBox.hpp>
#include <Cutwater/Grid/Detail/TileClasses.hpp>

namespace cutwater::detail {

template <std::floating_point T>
void TileClasses<T>::fill(const OffsetBox& tile) {
  divideTile<Part>(
      task_.order, tile, [this](std::span<Part> parts, int /*bits*/) { settle(parts); },
      [&](const Part& part, int bits) {
        auto hint = part.hint;
        if (task_.promise.lipschitz) {
          static_cast<void>(task_.solid.classify(boxOf(part.indices), &hint));
        }
        forIndices(task_.order, tile, part, bits, [&](const Offset& inTile) {
          batch_.add(
              {tile.first[0] + inTile[0], tile.first[1] + inTile[1], tile.first[2] + inTile[2]},
              hint);
        });
      });
}

template <std::floating_point T>
Box<T> TileClasses<T>::boxOf(const OffsetBox& indices) const {
  const auto& [first, size] = indices;
  const auto& gridPatch = task_.gridPatch;
  const auto cell = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return gridPatch.level.cell(gridPatch.indices.at(i, j, k));
  };
  // Coordinates grow with the index, even when rounded, so no cell is outside.
  return {cell(first[0], first[1], first[2]).lower,
          cell(first[0] + size[0] - 1, first[1] + size[1] - 1, first[2] + size[2] - 1).upper};
}

template <std::floating_point T>
void TileClasses<T>::settle(std::span<Part> parts) const {
  Scratch<Vec3<T>, TilePart::kMost> centers;
  Scratch<Box<T>, TilePart::kMost> boxes;
  Scratch<T, TilePart::kMost> values;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    boxes[i] = boxOf(parts[i].indices);
    centers[i] = boxes[i].center();
  }
  if (!task_.promise.lipschitz) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      static_cast<void>(task_.solid.classify(boxes[i], &parts[i].hint));
    }
    return;
  }
  task_.solid.signedDistances(centers.first(parts.size()), values.first(parts.size()),
                              {.threads = 1});
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!isClear(boxes[i], values[i])) continue;
    parts[i].isSettled = true;
    fillBox(task_.targets.boxClass, parts[i].indices,
            values[i] < 0 ? BoxClass::Inside : BoxClass::Outside);
  }
}

template <std::floating_point T>
bool TileClasses<T>::isClear(const Box<T>& box, T atCenter) const {
  const auto whole = OrientedBox<T>::of(box);
  if (!whole.isWithin(task_.promise.domain)) return false;
  // The centres of the cells are no farther away than this, and the value changes accordingly.
  const auto half = T(0.5) * task_.gridPatch.level.spacing();
  const Vec3<T> extent{whole.halfAxis[0].x, whole.halfAxis[1].y, whole.halfAxis[2].z};
  const T way = length(max(extent - half, Vec3<T>{})) + whole.slack;
  const CellTest<T> test(task_.promise, length(whole.center) + whole.radius());
  return std::abs(atCenter) - *task_.promise.lipschitz * (1 + CellTest<T>::kRoom) * way >
         (1 + CellTest<T>::kRoom) * test.clearance(length(half)) + whole.slack;
}

template class TileClasses<float>;
template class TileClasses<double>;

}  // namespace cutwater::detail
