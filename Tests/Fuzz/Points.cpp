#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Io/VtpSurface.hpp>

#include <fstream>

#include "Fuzz.hpp"
#include "Support/TemporaryFolder.hpp"

// Points with data, in every format. What is read is whole: it can be written, and reads back with
// the same points and cells.

namespace cutwater::test {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{16} << 20U;

/// Written as a file of this name; nothing where the format has no place for the data.
std::optional<PointData> again(const Folder& folder, const PointData& data, const char* name) {
  try {
    writePointData(folder / name, data);
  } catch (const Error& error) {
    expect(error.kind() == ErrorKind::Argument, "the error's kind");
    return std::nullopt;
  }
  return readPointData(folder / name);
}

void expectReadsBack(const Folder& folder, const PointData& data, const char* name) {
  const auto back = again(folder, data, name);
  if (!back) return;
  expect(back->points == data.points, "points read back");
  expect(back->cells == data.cells, "cells read back");
  expect(back->pointArrays.size() == data.pointArrays.size(), "so do arrays of points");
  expect(back->cellArrays.size() == data.cellArrays.size(), "and those of cells");
}

void ask(const Folder& folder, const PointData& data) {
  expect(cellCenters(data).size() == data.cells.count(), "every cell has a centre");
  expectReadsBack(folder, data, "again.vtk");
  expectReadsBack(folder, data, data.mesh == DataMesh::Unstructured ? "again.vtu" : "again.vtp");
  if (data.mesh != DataMesh::Points || data.points.empty()) return;
  if (const auto back = again(folder, data, "again.csv")) {
    expect(back->points == data.points, "tables read back");
  }
  static_cast<void>(answerOrRefusal((folder / "again.npy").string(),
                                    [&] { return again(folder, data, "again.npy"); }));
}

}  // namespace
}  // namespace cutwater::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace test = cutwater::test;
  static const test::TemporaryFolder folder;
  const std::string path = folder / "fuzz";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  const auto points = test::answerOrRefusal(test::kFuzzName, [&] {
    return cutwater::readPointData(std::as_bytes(std::span(data, size)), test::kFuzzName,
                                   {.maxBytes = test::kMostBytes});
  });
  if (points) test::ask(folder, *points);
  const auto surface = test::answerOrRefusal(
      path, [&] { return cutwater::readAnySurface(path, {.maxBytes = test::kMostBytes}); });
  if (surface) test::expectWhole(*surface);
  return 0;
}
