#pragma once

#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Render/Detail/SliceFrame.hpp>

#include <vector>

/// Internals of renderSlice(), for its own parts only.
namespace cutwater::detail {

/// The intersections of the faces of a mesh's cells with the plane, as lines on the plot, each
/// once.
template <std::floating_point T>
[[nodiscard]] std::vector<Stroke> meshLines(const Octree<T>& mesh, const SlicePlane<T>& plane,
                                            const SliceWindow<T>& window, const PlotArea& area);

extern template std::vector<Stroke> meshLines(const Octree<float>&, const SlicePlane<float>&,
                                              const SliceWindow<float>&, const PlotArea&);
extern template std::vector<Stroke> meshLines(const Octree<double>&, const SlicePlane<double>&,
                                              const SliceWindow<double>&, const PlotArea&);

}  // namespace cutwater::detail
