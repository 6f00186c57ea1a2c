#include <Cutwater/Io/Tables.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>

#include <cmath>
#include <fstream>

#include "Fuzz.hpp"
#include "Support/TemporaryFolder.hpp"

// Tables of beams and of balls. What is read is a solid that can be made and asked, and beams
// written again read back the same.

namespace cutwater::test {
namespace {

constexpr ReadTableOptions kOptions{.maxBytes = std::uint64_t{16} << 20U};

/// A solid, or refused by one clear sentence: of kind Argument.
template <typename Make>
void askOrRefuse(Make&& make) {
  try {
    const auto solid = make();
    const auto middle = solid.boundingBox().center();
    if (isFinite(middle)) expect(!std::isnan(solid.signedDistance(middle)), "there is a value");
  } catch (const Error& error) {
    expect(error.kind() == ErrorKind::Argument, "the error's kind");
  }
}

}  // namespace
}  // namespace cutwater::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace test = cutwater::test;
  static const test::TemporaryFolder folder;
  const std::string path = folder / "fuzz";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  const auto balls =
      test::answerOrRefusal(path, [&] { return cutwater::readBalls(path, test::kOptions); });
  if (balls) test::askOrRefuse([&] { return cutwater::PackedBed<double>(*balls); });
  const auto graph =
      test::answerOrRefusal(path, [&] { return cutwater::readBeams(path, test::kOptions); });
  if (!graph) return 0;
  test::askOrRefuse([&] { return cutwater::BeamLattice<double>(*graph); });
  cutwater::writeBeams(folder / "again", *graph);
  test::expect(cutwater::readBeams(folder / "again", test::kOptions) == *graph,
               "written beams read back");
  return 0;
}
