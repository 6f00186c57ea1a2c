#pragma once

#include <Cutwater/CutCells/Detail/Surface/CutPeriod.hpp>
#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// The period of a solid, which starts where the fewest images matter.
/// @throws Error(Argument) as that of a box; and unless the solid repeats itself along axes without
/// bounds, as a sample of its values tells.
template <std::floating_point T>
[[nodiscard]] CutPeriod periodOf(const Solid<T>& solid, const Vec3<double>& length);

/// The union of a solid with those of its images that matter where cells are cut.
template <std::floating_point T>
[[nodiscard]] Solid<T> withImages(const Solid<T>& solid, const CutPeriod& period);

extern template CutPeriod periodOf(const Solid<float>&, const Vec3<double>&);
extern template CutPeriod periodOf(const Solid<double>&, const Vec3<double>&);
extern template Solid<float> withImages(const Solid<float>&, const CutPeriod&);
extern template Solid<double> withImages(const Solid<double>&, const CutPeriod&);

}  // namespace cutwater
