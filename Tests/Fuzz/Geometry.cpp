#include <Cutwater/Core/Checksum.hpp>

#include <cstring>

#include "Queries.hpp"

// A geometry file as it comes, and once more with its checksums made good: what a forger would do.
// Then numbers may be any, but no query may read beyond arrays or go on for ever.

namespace cutwater::test {
namespace {

constexpr std::size_t kHeaderBytes = 24;  // where these stand
constexpr std::size_t kBlockChecksum = 48;

void makeGood(std::span<std::byte> bytes) {
  std::uint64_t headerBytes = 0;
  if (bytes.size() < kBlockChecksum + 8) return;
  std::memcpy(&headerBytes, bytes.data() + kHeaderBytes, sizeof(headerBytes));
  if (headerBytes < kBlockChecksum + 16 || headerBytes > bytes.size()) return;
  const std::uint64_t block = checksum(bytes.subspan(headerBytes), 1);
  std::memcpy(bytes.data() + kBlockChecksum, &block, sizeof(block));
  const std::uint64_t header = xxHash64(bytes.first(headerBytes - 8));
  std::memcpy(bytes.data() + headerBytes - 8, &header, sizeof(header));
}

template <typename T>
void askForged(const MeshSDF<T>& mesh) {
  const auto probes = probesOf(mesh);
  const auto brick = brickBetween(probes.front(), probes.back());
  std::vector<SurfacePoint<T>> nearest(brick.size());
  mesh.closestPoints(brick, nearest, {.threads = 1});
  for (const auto& p : probes) {
    static_cast<void>(mesh.closestPoint(p));
    const Box<T> box{p, p + Vec3<T>{1, 1, 1}};
    BoxHint hint;
    static_cast<void>(mesh.bounds(box, &hint));
    static_cast<void>(mesh.classify(box, &hint));
    mesh.crossings({p, box.upper}, [](const Crossing<T>&) { return true; });
    mesh.facetsIn(box, [](const SurfaceFacet<T>&) { return true; });
  }
  static_cast<void>(mesh.soup());
  static_cast<void>(mesh.signReport().summary());
}

template <typename T>
void viewOrRefuse(std::span<const std::byte> bytes, bool forged) {
  try {
    const auto mesh = MeshSDF<T>::view(bytes, {.threads = 1});
    if (forged) {
      askForged(mesh);
    } else {
      expectPromises(mesh);
    }
  } catch (const Error& error) {
    expect(error.kind() == ErrorKind::File, "the error's kind");
  }
}

}  // namespace
}  // namespace cutwater::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace test = cutwater::test;
  const auto block = cutwater::alignedCopy(std::as_bytes(std::span(data, size)));
  static_cast<void>(cutwater::geometryFileInfo(block.bytes()));
  test::viewOrRefuse<float>(block.bytes(), false);
  test::viewOrRefuse<double>(block.bytes(), false);
  // The copy is ours, and nobody looks at it meanwhile.
  test::makeGood({const_cast<std::byte*>(block.bytes().data()), size});
  test::viewOrRefuse<float>(block.bytes(), true);
  test::viewOrRefuse<double>(block.bytes(), true);
  return 0;
}
