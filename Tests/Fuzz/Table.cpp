#include <Cutwater/Io/BeamTable.hpp>
#include <Cutwater/Io/ReadBalls.hpp>
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

template <typename Read>
auto readOrRefuseTable(const std::string& path, Read&& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const Error& error) {
    const std::string message = error.what();
    expect(error.kind() == ErrorKind::File || error.kind() == ErrorKind::Limit, "the error's kind");
    expect(message.starts_with(path + ": "), "messages begin with the file");
    expect(message.size() < 400, "messages are short");
    expect(message.find('\n') == std::string::npos, "messages are one line");
  }
  return std::nullopt;
}

bool isSame(const BeamGraph& a, const BeamGraph& b) {
  if (a.nodes != b.nodes || a.beams.size() != b.beams.size() || a.balls.size() != b.balls.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.beams.size(); ++i) {
    const auto& x = a.beams[i];
    const auto& y = b.beams[i];
    if (x.nodes != y.nodes || x.radii != y.radii || x.body != y.body || x.caps != y.caps) {
      return false;
    }
  }
  for (std::size_t i = 0; i < a.balls.size(); ++i) {
    if (a.balls[i].node != b.balls[i].node || a.balls[i].radius != b.balls[i].radius) return false;
  }
  return true;
}

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
      test::readOrRefuseTable(path, [&] { return cutwater::readBalls(path, test::kOptions); });
  if (balls) test::askOrRefuse([&] { return cutwater::PackedBed<double>(*balls); });
  const auto graph =
      test::readOrRefuseTable(path, [&] { return cutwater::readBeams(path, test::kOptions); });
  if (!graph) return 0;
  test::askOrRefuse([&] { return cutwater::BeamLattice<double>(*graph); });
  cutwater::writeBeams(folder / "again", *graph);
  test::expect(test::isSame(cutwater::readBeams(folder / "again", test::kOptions), *graph),
               "written beams read back");
  return 0;
}
