#include "Options/CuttingCost.hpp"

#include <algorithm>
#include <cmath>

namespace cutwater::tool {

double bytesToCut(double cells, std::size_t triangles, bool polygons) {
  // As measured for hulls, statues and machine parts.
  constexpr double kCell = 1200;
  constexpr double kCellWithPolygons = 5000;
  constexpr double kTriangle = 500;
  return (polygons ? kCellWithPolygons : kCell) * cells +
         kTriangle * static_cast<double>(triangles);
}

double secondsToCut(double cells, const std::function<CutCount(int)>& cutLarger) {
  constexpr double kFew = 1e5;
  constexpr double kPass = 4e4;
  if (cells < kFew) return -1;
  const int halvings = static_cast<int>(std::ceil(0.5 * std::log2(cells / kPass)));
  const auto few = cutLarger(halvings + 1);
  const auto more = cutLarger(halvings);
  if (!(more.cells > few.cells)) return -1;
  const double each = std::max(0.0, (more.seconds - few.seconds) / (more.cells - few.cells));
  return more.seconds + each * (cells - more.cells);
}

}  // namespace cutwater::tool
