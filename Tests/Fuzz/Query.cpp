#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/DcelSDF.hpp>

#include <algorithm>
#include <array>

#include "Queries.hpp"

// From the bytes of a file to the answers about its surface.

namespace cutwater::test {
namespace {

/// The definition of what a tree's answers must be, to the bit.
template <typename T>
void expectSameWithoutTree(const MeshSDF<T>& mesh, const DcelMesh<T>& dcel) {
  const DcelSDF<T> plain(dcel);
  if (!mesh.signReport().isSound() || !plain.signReport().isSound()) return;
  for (const auto& p : probesOf(mesh)) {
    if (!isFinite(p)) continue;
    expect(mesh.signedDistance(p) == plain.signedDistance(p), "the tree changes no bit");
  }
}

/// What holds for the cut cells of any closed surface, between planes through its vertices and
/// others.
template <typename T>
void expectCutCells(const MeshSDF<T>& mesh) {
  if (!mesh.signReport().isSound() || !isOfOrdinarySize(mesh)) return;
  const Box<double> box{Vec3<double>(mesh.surfaceBox().lower),
                        Vec3<double>(mesh.surfaceBox().upper)};
  const auto inner = Vec3<double>(mesh.triangle(0)[0]);
  std::array<std::vector<double>, 3> planes;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = maxComponent(box.upper - box.lower);
    auto& across = planes[static_cast<std::size_t>(axis)];
    across = {box.lower[axis] - size, box.lower[axis], inner[axis],
              box.lower[axis] + 0.3 * (box.upper[axis] - box.lower[axis]), box.upper[axis]};
    std::ranges::sort(across);
    across.erase(std::unique(across.begin(), across.end()), across.end());
    if (across.size() < 2) return;
  }
  const auto cells =
      CellCutter(Solid<T>(mesh)).cut(cellsBetween(planes), {.polygons = true, .threads = 1});
  const auto report = check(cells);
  expect(report.lostPieces == 0 && report.outOfRange == 0, "cut cells are in their ranges");
  expect(report.worstClosure < 1e-9, "pieces of cut cells close");
  expect(check(merged(cells).cells).multiPieceCells == 0, "merged cells have one piece");
}

template <typename T>
void expectAnswers(const PolygonSoup& soup) {
  try {
    const DcelMesh<T> dcel(soup);
    const MeshSDF<T> mesh(dcel, {.findSelfIntersections = true, .probes = 16});
    expectPromises(mesh);
    expectCutCells(mesh);
    const auto bytes = mesh.toBytes();
    const auto viewed = MeshSDF<T>::view(bytes, {.threads = 1});
    const auto probe = mesh.triangle(0)[0];
    expect(viewed.signedDistance(probe) == mesh.signedDistance(probe), "bytes give the same bits");
    if (mesh.signReport().isClosed()) expectSameWithoutTree(mesh, dcel);
  } catch (const Error& error) {
    const bool isSurface =
        error.kind() == ErrorKind::Topology || error.kind() == ErrorKind::Argument;
    expect(isSurface, "a soup is refused for what it is");
  }
}

}  // namespace
}  // namespace cutwater::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMostCorners = 200;  // more would only take longer
  const auto file = cutwater::test::readAny({data, size});
  if (!file || file->soup.corners.size() > kMostCorners) return 0;
  cutwater::test::expectAnswers<float>(file->soup);
  cutwater::test::expectAnswers<double>(file->soup);
  return 0;
}
