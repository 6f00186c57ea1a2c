#include <Cutwater/Grid/Detail/CellBatch.hpp>

namespace cutwater::detail {

template <std::floating_point T>
void CellBatch<T>::flush() {
  const auto& gridPatch = task_.gridPatch;
  for (std::size_t i = 0; i < count_; ++i) {
    const auto [a, b, c] = offsets_[i];
    cells_[i] = gridPatch.level.cell(gridPatch.indices.at(a, b, c));
  }
  if (task_.promise.lipschitz) storeTold();
  Scratch<BoxClass, kMost> classes;
  task_.solid.classify(cells_.first(count_), classes.first(count_), hints_.first(count_),
                       {.threads = 1});
  for (std::size_t i = 0; i < count_; ++i) {
    const auto [a, b, c] = offsets_[i];
    task_.targets.boxClass.at(a, b, c) = classes[i];
  }
  count_ = 0;
}

template <std::floating_point T>
void CellBatch<T>::storeTold() {
  Scratch<Vec3<T>, kMost> centers;
  Scratch<T, kMost> values;
  for (std::size_t i = 0; i < count_; ++i) centers[i] = cells_[i].center();
  task_.solid.signedDistances(centers.first(count_), values.first(count_), {.threads = 1});
  std::size_t left = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const auto cell = OrientedBox<T>::of(cells_[i]);
    const CellTest<T> test(task_.promise, length(cell.center) + cell.radius());
    const auto found =
        cell.isWithin(task_.promise.domain) ? test.classOf(cell, values[i]) : BoxClass::Unknown;
    if (found == BoxClass::Unknown) {
      offsets_[left] = offsets_[i];
      hints_[left] = hints_[i];
      cells_[left++] = cells_[i];
    } else {
      const auto [a, b, c] = offsets_[i];
      task_.targets.boxClass.at(a, b, c) = found;
    }
  }
  count_ = left;
}

template class CellBatch<float>;
template class CellBatch<double>;

}  // namespace cutwater::detail
