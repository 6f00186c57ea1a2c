#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/BeamGraph.hpp>
#include <Cutwater/Lattice/Detail/Skeleton.hpp>
#include <Cutwater/Lattice/Detail/StrutCopies.hpp>

namespace cutwater {

BeamGraph beamsOf(const UnitCell& cell, const Repeats<double>& cells, double radius) {
  detail::requireFewStruts("beamsOf", cell, {cells.count}, 1);
  for (int axis = 0; axis < 3; ++axis) {
    const double size = cells.period[axis];
    require(size > 0 && std::isfinite(size), "beamsOf: need sizes that are positive and finite",
            Named{"axis", axis}, Named{"size", size});
  }
  BeamGraph graph;
  const auto addNode = [&](const Vec3<double>& inCells) {
    graph.nodes.push_back(detail::times(inCells, cells.period));
    return static_cast<std::uint32_t>(graph.nodes.size() - 1);
  };
  detail::forEachStrut(cell, {cells.count}, addNode, [&](const detail::StrutCopy& strut) {
    graph.beams.push_back({strut.nodes, {radius, radius}});
  });
  return graph;
}

}  // namespace cutwater
