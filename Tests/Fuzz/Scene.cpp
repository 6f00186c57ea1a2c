#include <Cutwater/Scene/ReadScene.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "Fuzz.hpp"
#include "Support/TemporaryFolder.hpp"

// Scenes: what is read is a solid that can be described and asked, whatever it is made of. A mesh
// and tables of beams and balls are there for scenes to name.

namespace cutwater::test {
namespace {

/// A solid may refuse what it is made of: of kind Argument or Topology, beside those of files.
std::optional<Solid<double>> solidOrRefusal(const std::string& path) {
  try {
    return answerOrRefusal(
        path,
        [&] { return readScene(path, {.solid = {}, .maxBytes = 16U << 20U, .maxBeams = 10000}); },
        {ErrorKind::Argument, ErrorKind::File, ErrorKind::Limit, ErrorKind::Topology});
  } catch (const std::bad_alloc&) {
    expect(false, "no more memory than the file is worth");
  }
  return std::nullopt;
}

void ask(const Solid<double>& solid) {
  expect(!solid.describe().empty(), "there is a description");
  const auto box = solid.boundingBox();
  for (const auto& p : {box.center(), Vec3<double>{0.25, -0.5, 1}}) {
    if (!isFinite(p)) continue;
    expect(!std::isnan(solid.signedDistance(p)), "there is a value");
    static_cast<void>(solid.gradient(p));
    static_cast<void>(solid.classify({p - Vec3<double>{1, 1, 1}, p + Vec3<double>{1, 1, 1}}));
  }
}

/// What scenes may name, in the folder of the scene.
void writeParts(const TemporaryFolder& folder) {
  std::ofstream(folder / "m.off") << "OFF 4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                     "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  std::ofstream(folder / "b.csv") << "node,0,0,0\nnode,1,0,0\nbeam,0,1,0.1,0.2\nball,1,0.3\n";
  std::ofstream(folder / "c.csv") << "0,0,0,1\n1,2,0.5,0.75\n";
}

}  // namespace
}  // namespace cutwater::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace test = cutwater::test;
  static const test::TemporaryFolder folder;
  static const bool isPrepared = (test::writeParts(folder), true);
  static_cast<void>(isPrepared);
  const std::string path = folder / "scene.toml";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  const auto solid = test::solidOrRefusal(path);
  if (solid) test::ask(*solid);
  return 0;
}
