// A program of somebody else's that closes a hole: an octahedron without one of its faces.
#include <Cutwater/Repair/FillHoles.hpp>

#include <array>
#include <cstdio>

int main() {
  cutwater::PolygonSoup soup;
  soup.points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  soup.patchNames = {"all"};
  using Corners = std::array<std::uint32_t, 3>;
  for (const auto& corners :
       {Corners{1, 3, 2}, Corners{3, 4, 2}, Corners{4, 0, 2}, Corners{1, 0, 5}, Corners{3, 1, 5},
        Corners{4, 3, 5}, Corners{0, 4, 5}}) {
    soup.addPolygon(corners);
  }
  const auto report = cutwater::fillHoles(soup);
  std::printf("%zu hole, volume %.6f\n", report.filled.count, report.after.volume);
  return report.filled.count == 1 && soup.polygonCount() == 8 ? 0 : 1;
}
