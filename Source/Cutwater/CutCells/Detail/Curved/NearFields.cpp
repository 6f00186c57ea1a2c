#include <Cutwater/CutCells/Detail/Curved/NearFields.hpp>

namespace cutwater {

Box<double> boxOf(const GridPlanes& planes) {
  Box<double> box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = planes.positions[asIndex(axis)].front();
    box.upper[axis] = planes.positions[asIndex(axis)].back();
  }
  return box;
}

const FluidField& NearFields::below(const Vec3<double>& shift) {
  auto box = boxOf(planes_);
  std::size_t axes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (shift[axis] == 0) continue;
    axes |= std::size_t{1} << asIndex(axis);
    box.lower[axis] = box.upper[axis] -= shift[axis];
  }
  auto& near = near_[axes];
  if (!near) near = Near{fieldIn(field_, box)};
  return near->field ? *near->field : field_;
}

}  // namespace cutwater
