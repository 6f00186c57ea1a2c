#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>
#include <Cutwater/Surface/Detail/ConnectedShells.hpp>
#include <Cutwater/Surface/Detail/RimLoops.hpp>

#include <algorithm>
#include <set>

namespace cutwater::detail {

Vec3<double> middleOf(const PolygonSoup& soup, std::size_t polygon) {
  const auto corners = soup.polygon(polygon);
  const double share = 1 / static_cast<double>(corners.size());  // applied first: no overflow
  Vec3<double> sum;
  for (const auto corner : corners) sum += share * soup.points[corner];
  return sum;
}

double extentOf(const PolygonSoup& soup, std::size_t polygon) {
  Box<double> box;
  for (const auto corner : soup.polygon(polygon)) box.extend(soup.points[corner]);
  return box.diagonal();
}

void keepPolygons(PolygonSoup& soup, const std::vector<bool>& keep) {
  std::size_t kept = 0;
  std::uint64_t end = 0;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    // The write position never overtakes the read position.
    const std::uint64_t from = soup.offsets[i];
    const std::uint64_t size = soup.offsets[i + 1] - from;
    std::copy_n(soup.corners.begin() + static_cast<std::ptrdiff_t>(from), size,
                soup.corners.begin() + static_cast<std::ptrdiff_t>(end));
    soup.patches[kept] = soup.patches[i];
    soup.offsets[kept] = end;
    end += size;
    ++kept;
  }
  soup.offsets[kept] = end;
  soup.offsets.resize(kept + 1);
  soup.corners.resize(end);
  soup.patches.resize(kept);
}

void turnPolygon(PolygonSoup& soup, std::size_t polygon) {
  const auto at = [&](std::uint64_t i) {
    return soup.corners.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::reverse(at(soup.offsets[polygon] + 1), at(soup.offsets[polygon + 1]));
}

std::vector<std::array<std::uint32_t, 3>> indicesOf(std::span<const TriangleCorners> triangles) {
  std::vector<std::array<std::uint32_t, 3>> result;
  result.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) result.push_back({index(a), index(b), index(c)});
  return result;
}

std::vector<OpenEdge> openEdgesOf(const PolygonSoup& soup) {
  const auto triangulation = triangulate(soup);
  auto edges = findOpenEdges(indicesOf(triangulation.triangles), soup.points.size());
  for (auto& edge : edges) edge.triangle = triangulation.polygons[edge.triangle];
  return edges;
}

std::vector<std::uint32_t> partsOf(const PolygonSoup& soup) {
  const auto triangulation = triangulate(soup);
  const auto shells = connectShells(indicesOf(triangulation.triangles), soup.points.size());
  std::vector<std::uint32_t> parts(soup.polygonCount());
  for (std::size_t i = 0; i < triangulation.polygons.size(); ++i) {
    parts[triangulation.polygons[i]] = shells.shellOf[i];
  }
  return parts;
}

std::vector<std::vector<std::uint32_t>> loopsAround(std::span<const OpenEdge> edges) {
  std::vector<std::vector<std::uint32_t>> loops;
  RimLoops rims(edges);
  rims.run([&](std::span<const std::uint32_t> loop) {
    auto& points = loops.emplace_back();
    for (const auto place : loop) points.push_back(rims.vertices()[place]);
  });
  return loops;
}

std::uint32_t patchNamed(PolygonSoup& soup, const std::string& name) {
  auto& names = soup.patchNames;
  const auto at = [&] {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  };
  if (at() == names.size()) {
    const std::set<std::size_t> used(soup.patches.begin(), soup.patches.end());
    while (used.contains(names.size())) names.emplace_back("surface");
  }
  if (at() == names.size()) names.push_back(name);
  return static_cast<std::uint32_t>(at());
}

}  // namespace cutwater::detail
