#include <Cutwater/Mesh/DcelSDF.hpp>

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

template <typename T>
void expectAnswers(const PolygonSoup& soup) {
  try {
    const DcelMesh<T> dcel(soup);
    const MeshSDF<T> mesh(dcel, {.findSelfIntersections = true, .probes = 16});
    expectPromises(mesh);
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
