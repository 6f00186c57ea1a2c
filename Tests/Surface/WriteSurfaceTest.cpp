#include <Cutwater/Surface/WriteSurface.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "SampleFiles.hpp"

namespace cutwater::test {
namespace {

/// Coordinates of every size and with all bits in use; -0 and denormals among them.
PolygonSoup wildSoup(bool trianglesOnly) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(-2, 2);
  std::uniform_int_distribution<int> exponent(-300, 300);
  PolygonSoup soup;
  for (int i = 0; i < 300; ++i) {
    const double x = std::ldexp(mantissa(random), exponent(random));
    soup.points.push_back({x, mantissa(random), std::ldexp(1.0, -1074) * i});
  }
  soup.points[5] = {-0.0, 0.1, std::numeric_limits<double>::max()};
  soup.points[6] = {std::numeric_limits<double>::lowest(), 1e22, 1.0 / 3};
  soup.patchNames = {"hull", "two words", "#3"};
  for (std::uint32_t i = 0; i + 5 < 300; ++i) {
    std::vector<std::uint32_t> polygon;
    const std::uint32_t sides = trianglesOnly ? 3 : 3 + i % 3;
    for (std::uint32_t c = 0; c < sides; ++c) polygon.push_back(i + c);
    soup.addPolygon(polygon, i / 10 % 3);
  }
  return soup;
}

/// The polygons sorted by patch, which is how formats with groups hold them.
PolygonSoup patchByPatch(const PolygonSoup& soup) {
  PolygonSoup sorted;
  sorted.points = soup.points;
  sorted.patchNames = soup.patchNames;
  for (std::uint32_t patch = 0; patch < soup.patchNames.size(); ++patch) {
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      if (soup.patches[i] == patch) sorted.addPolygon(soup.polygon(i), patch);
    }
  }
  return sorted;
}

void expectSameBits(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a[i][axis]), std::bit_cast<std::uint64_t>(b[i][axis]));
    }
  }
}

SurfaceFile throughFile(const PolygonSoup& soup, const std::string& name, bool ascii) {
  const TemporaryFolder folder;
  writeSurface(folder / name, soup, {.ascii = ascii});
  EXPECT_EQ(folder.fileCount(), 1U);
  ReadOptions options;
  options.weld = false;
  return readSurface(folder / name, options);
}

TEST(WriteSurfaceTest, IndexedFormatsComeBackToTheBit) {
  const auto original = wildSoup(false);
  for (const auto& [name, ascii] : {std::pair{"a.obj", false},
                                    {"a.off", false},
                                    {"a.PLY", false},
                                    {"a.ply", true},
                                    {"a.vtk", false},
                                    {"a.VTK", true}}) {
    const auto file = throughFile(original, name, ascii);
    const std::string text = name;
    const bool hasGroups = file.report.format == SurfaceFormat::Obj;
    const auto soup = hasGroups ? patchByPatch(original) : original;
    EXPECT_EQ(file.report.binary, text == "a.PLY" || text == "a.vtk");
    expectSameBits(file.soup.points, soup.points);
    EXPECT_EQ(file.soup.corners, soup.corners);
    EXPECT_EQ(file.soup.offsets, soup.offsets);
    if (!hasGroups) continue;
    EXPECT_EQ(file.soup.patches, soup.patches);
    EXPECT_EQ(file.soup.patchNames, soup.patchNames);
  }
}

std::size_t countOf(const std::string& word, const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(WriteSurfaceTest, EachPatchIsWrittenOnce) {
  const TemporaryFolder folder;
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  soup.patchNames = {"a", "unused", "b", "a"};
  soup.addPolygon(std::array{0U, 1U, 2U}, 2);
  soup.addPolygon(std::array{0U, 1U, 3U}, 7);  // without a name
  soup.addPolygon(std::array{0U, 2U, 1U}, 3);
  soup.addPolygon(std::array{0U, 2U, 3U}, 2);
  soup.addPolygon(std::array{1U, 2U, 3U}, 0);
  writeSurface(folder / "c.obj", soup);
  EXPECT_EQ(contentOf(folder / "c.obj"),
            "# Cutwater\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
            "g a\nf 1 3 2\nf 2 3 4\ng b\nf 1 2 3\nf 1 3 4\ng \nf 1 2 4\n");
  writeSurface(folder / "c.stl", soup, {.ascii = true});
  const auto text = contentOf(folder / "c.stl");
  EXPECT_EQ(countOf("\nendsolid ", text), 3U) << text;
  EXPECT_TRUE(text.starts_with("solid a\nfacet normal 0 0 -1\n")) << text;
  for (const auto* name : {"c.obj", "c.stl"}) {
    const auto read = readSurface(folder / name).soup;
    EXPECT_EQ(read.patchNames, (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_EQ(read.patches, (std::vector<std::uint32_t>{0, 0, 1, 1, 2}));
    writeSurface(folder / "d.obj", read);
    EXPECT_EQ(readSurface(folder / "d.obj").soup.patches, read.patches);
  }
}

TEST(WriteSurfaceTest, VtkTellsPatchesAsCellData) {
  const TemporaryFolder folder;
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.patchNames = {"a", "b"};
  soup.addPolygon(std::array{0U, 1U, 2U}, 1);
  soup.addPolygon(std::array{0U, 2U, 1U}, 0);
  writeSurface(folder / "a.vtk", soup, {.ascii = true});
  EXPECT_EQ(contentOf(folder / "a.vtk"),
            "# vtk DataFile Version 3.0\nCutwater\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n"
            "0 0 0\n1 0 0\n0 1 0\nPOLYGONS 2 8\n3 0 1 2\n3 0 2 1\n"
            "CELL_DATA 2\nSCALARS patch int 1\nLOOKUP_TABLE default\n1\n0\n");
  writeSurface(folder / "b.vtk", soup);
  const auto binary = contentOf(folder / "b.vtk");
  EXPECT_TRUE(binary.ends_with(std::string("default\n\0\0\0\1\0\0\0\0\n", 17))) << binary;
}

std::vector<Vec3<double>> unshared(const PolygonSoup& soup) {
  std::vector<Vec3<double>> points;
  for (const auto corner : soup.corners) points.push_back(soup.points[corner]);
  return points;
}

TEST(WriteSurfaceTest, AsciiStlComesBackToTheBit) {
  const auto soup = patchByPatch(wildSoup(true));
  const auto file = throughFile(wildSoup(true), "a.stl", true);
  expectSameBits(file.soup.points, unshared(soup));
  EXPECT_EQ(file.soup.patches, soup.patches);
  EXPECT_EQ(file.soup.patchNames, soup.patchNames);
}

TEST(WriteSurfaceTest, BinaryStlComesBackInSinglePrecision) {
  auto soup = wildSoup(true);
  for (auto& p : soup.points) {
    p.x = std::fmod(p.x, 1e6);
    if (std::abs(p.z) > 1) p.z = 1.0 / 3;
  }
  const auto file = throughFile(soup, "a.stl", false);
  auto expected = unshared(soup);
  for (auto& p : expected) {
    for (int axis = 0; axis < 3; ++axis) {
      // Volatile: g++ 12 at -O2 drops double -> float -> double on neighbouring doubles.
      volatile float single = static_cast<float>(p[axis]);
      p[axis] = single;
    }
  }
  EXPECT_TRUE(file.report.binary);
  expectSameBits(file.soup.points, expected);
}

TEST(WriteSurfaceTest, StlNormalsAreUnitVectors) {
  const TemporaryFolder folder;
  PolygonSoup soup;
  const double huge = std::numeric_limits<double>::max();
  soup.points = {{-huge, 0, 0}, {huge, 0, 0}, {0, huge, 0}, {0, 1e-300, 0}, {1e-300, 0, 0}, {}};
  soup.addPolygon(std::array{0U, 1U, 2U});
  soup.addPolygon(std::array{3U, 4U, 5U});
  soup.addPolygon(std::array{5U, 5U, 0U});
  writeSurface(folder / "a.stl", soup, {.ascii = true});
  const std::string text = contentOf(folder / "a.stl");
  const auto first = text.find("facet normal 0 0 1\n");
  EXPECT_NE(first, std::string::npos) << text;
  EXPECT_NE(text.find("facet normal 0 0 -1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("facet normal 0 0 0\n"), std::string::npos) << text;
}

TEST(WriteSurfaceTest, LargePolygons) {
  PolygonSoup soup;
  std::vector<std::uint32_t> polygon;
  for (std::uint32_t i = 0; i < 100000; ++i) {
    soup.points.push_back({std::cos(i * 1e-4), std::sin(i * 1e-4), 0});
    polygon.push_back(i);
  }
  soup.addPolygon(polygon);
  EXPECT_EQ(throughFile(soup, "a.obj", false).soup.corners, soup.corners);
  EXPECT_EQ(throughFile(soup, "a.ply", false).soup.corners, soup.corners);
  const TemporaryFolder folder;
  EXPECT_THROW(writeSurface(folder / "a.off", soup), Error);
  EXPECT_THROW(writeSurface(folder / "a.ply", soup, {.ascii = true}), Error);
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(WriteSurfaceTest, RefusesWhatTheFormatCannotHold) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& name, const PolygonSoup& soup, ErrorKind kind,
                           bool ascii = false) {
    try {
      writeSurface(folder / name, soup, {.ascii = ascii});
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), kind) << error.what();
    }
    EXPECT_EQ(folder.fileCount(), 0U);
  };
  refused("a.stl", wildSoup(false), ErrorKind::Topology);
  refused("a.stl", wildSoup(true), ErrorKind::Argument);  // 1e300 in single precision
  refused("a.step", wildSoup(true), ErrorKind::Argument);
  refused("stl", wildSoup(true), ErrorKind::Argument);
  refused("a.obj", PolygonSoup{}, ErrorKind::Argument);
  refused("no/such/folder/a.obj", wildSoup(true), ErrorKind::File);
  auto soup = wildSoup(true);
  soup.points[0].x = std::numeric_limits<double>::quiet_NaN();
  refused("a.obj", soup, ErrorKind::Argument);
  for (const auto* name : {"two\nlines", " blank", "blank ", "back\\"}) {
    soup = wildSoup(true);
    soup.patchNames[1] = name;
    refused("a.obj", soup, ErrorKind::Argument);
    refused("a.stl", soup, ErrorKind::Argument, true);
  }
}

TEST(WriteSurfaceTest, FailuresLeaveTheOldFileAlone) {
  const TemporaryFolder folder;
  store(folder / "a.stl", "precious");
  EXPECT_THROW(writeSurface(folder / "a.stl", wildSoup(true)), Error);
  EXPECT_EQ(contentOf(folder / "a.stl"), "precious");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(WriteSurfaceTest, ReplacesFilesAndFollowsLinks) {
  const TemporaryFolder folder;
  store(folder / "a.obj", "old");
  std::filesystem::permissions(folder / "a.obj", std::filesystem::perms::owner_all);
  std::filesystem::create_symlink(folder / "a.obj", folder / "link.obj");
  writeSurface(folder / "link.obj", wildSoup(true));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.obj"));
  EXPECT_EQ(std::filesystem::status(folder / "a.obj").permissions(),
            std::filesystem::perms::owner_all);
  EXPECT_EQ(readSurface(folder / "a.obj").soup.polygonCount(), wildSoup(true).polygonCount());
  EXPECT_EQ(folder.fileCount(), 2U);
}

TEST(WriteSurfaceTest, ReportsAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/full", folder / "a.obj");
  try {
    writeSurface(folder / "a.obj", wildSoup(true));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::File);
    EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(std::filesystem::exists("/dev/full"));
}

}  // namespace
}  // namespace cutwater::test
