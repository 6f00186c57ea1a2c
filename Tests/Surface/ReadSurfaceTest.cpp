#include <Cutwater/Surface/Formats/SoupBuilder.hpp>
#include <Cutwater/Text/TextCursor.hpp>

#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include "SampleFiles.hpp"

namespace cutwater::test {
namespace {

const std::string kObj = "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n";

std::string whatOf(const std::filesystem::path& path, ErrorKind kind = ErrorKind::File) {
  try {
    static_cast<void>(readSurface(path));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    return error.what();
  }
  ADD_FAILURE() << "read " << path;
  return {};
}

TEST(ReadSurfaceTest, TheContentDecidesNotTheName) {
  const TemporaryFolder folder;
  for (const auto& sample : sampleFiles()) {
    for (const auto* name :
         {"wrong.stl", "wrong.obj", "UPPER.PLY", "noextension", "wrong.png.gz"}) {
      store(folder / name, sample.bytes);
      const auto fromFile = readSurface(folder / name);
      const auto fromMemory = readText(sample.bytes, {}, name);
      EXPECT_EQ(fromFile.soup.points, fromMemory.soup.points) << sample.name;
      EXPECT_EQ(fromFile.soup.corners, fromMemory.soup.corners) << sample.name;
      EXPECT_EQ(fromFile.soup.patchNames, fromMemory.soup.patchNames) << sample.name;

      EXPECT_EQ(fromFile.report.compressed, sample.name.ends_with(".gz"));
      EXPECT_EQ(fromFile.report.binary, sample.name.find("bi") == 0) << sample.name;
    }
  }
}

TEST(ReadSurfaceTest, RefusesWhatIsNoSurfaceFile) {
  const TemporaryFolder folder;
  const std::string directory = (folder / "").string();
  EXPECT_EQ(whatOf(directory), directory + ": cannot read: Is a directory");
  const std::string missing = (folder / "missing.stl").string();
  EXPECT_EQ(whatOf(missing), missing + ": cannot open: No such file or directory");
  store(folder / "empty.stl", "");
  EXPECT_EQ(whatOf(folder / "empty.stl"), (folder / "empty.stl").string() + ": the file is empty");
  store(folder / "secret.stl", kObj);
  std::filesystem::permissions(folder / "secret.stl", std::filesystem::perms::none);
  if (geteuid() != 0) {  // root reads everything
    EXPECT_NE(whatOf(folder / "secret.stl").find("Permission denied"), std::string::npos);
  }
  expectFailure("hello, world\n", "byte 0", "none of");
  expectFailure(" \n\n", "byte 0", "none of");
  expectFailure("# only a comment", "byte 0", "none of");
  for (const char* cut : {"#", "# vtk Data", "pl", "SOL", "of"}) {
    expectFailure(cut, "byte 0", "too short: it ends within its first word");
  }
  expectFailure("PK\x03\x04 and so on", "byte 0", "zip");
  expectFailure("<?xml version='1.0'?>", "byte 0", "XML");
  expectFailure("\x89PNG\r\n\x1a\n" + std::string(100, '\0'), "byte 0", "PNG");
  std::string png = "\x89PNG\r\n\x1a\n" + std::string(72, '\0') + "\1" + std::string(152, '\0');
  expectFailure(png, "byte 0", "PNG");  // by its count a binary STL with some bytes behind it
  expectFailure(std::string(100, '\0'), "byte 80", "0 triangles");
  expectFailure("nonsolid\n" + std::string(200, 'a'), "byte 0", "none of");
}

TEST(ReadSurfaceTest, ReadsPipes) {
  const TemporaryFolder folder;
  const auto pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string text = "v 1 0 0\nv 0 1 0\n" + std::string(300000, '\n') + "v 0 0 1\nf 1 2 3\n";
  std::thread writer([&] { store(pipe, text); });
  const auto file = readSurface(pipe);
  writer.join();
  EXPECT_EQ(file.soup.polygonCount(), 1U);
  EXPECT_EQ(file.report.bytes, text.size());
}

TEST(ReadSurfaceTest, ScalesThenPlaces) {
  ReadOptions options;
  options.scale = 0.5;
  options.placement.translate({10, 0, 0});
  options.placement.rotate(90, 2);
  const std::string stl =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\n"
      "endloop\nendfacet\nendsolid\n";
  for (const auto& text : {kObj, stl}) {
    const auto points = readText(text, options).soup.points;
    EXPECT_EQ(points, (std::vector<Vec3<double>>{{0, 10.5, 0}, {-0.5, 10, 0}, {0, 10, 0.5}}));
  }
}

TEST(ReadSurfaceTest, RefusesCoordinatesThatOverflowWhenScaled) {
  ReadOptions options;
  options.scale = 1e10;
  expectFailure(replaced(kObj, "v 0 1", "v 0 1e300"), "line 2", "scale", options);
}

TEST(ReadSurfaceTest, RefusesImpossibleOptions) {
  for (const double scale : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    ReadOptions options;
    options.scale = scale;
    failure(kObj, options, ErrorKind::Argument);
  }
}

TEST(ReadSurfaceTest, WeldsOnlyIfAsked) {
  ReadOptions options;
  options.weld = false;
  const std::string text = kObj + "v -0 0 1\nv 1 0 0\nf 4 5 2\n";
  EXPECT_EQ(readText(text, options).soup.points.size(), 5U);
  EXPECT_EQ(readText(text, options).report.pointsMerged, 0U);
  const auto welded = readText(text);
  EXPECT_EQ(welded.report.pointsMerged, 2U);
  EXPECT_EQ(corners(welded.soup, 1), (Corners{2, 0, 1}));
  const auto loose = readText(binaryStl(4), options);
  EXPECT_EQ(loose.soup.points.size(), 12U);
  EXPECT_EQ(corners(loose.soup, 3), (Corners{9, 10, 11}));
}

TEST(ReadSurfaceTest, PatchesAreNamedAfterTheFile) {
  for (const auto& [name, patch] : {std::pair<std::string, std::string>{"a/b/hull.obj", "hull"},
                                    {"hull.v2.obj.gz", "hull.v2"},
                                    {"hull", "hull"},
                                    {".gz", ".gz"},
                                    {"", "surface"},
                                    {"dir/", "surface"}}) {
    EXPECT_EQ(readText(kObj, {}, name).soup.patchNames, std::vector<std::string>{patch}) << name;
  }
}

TEST(ReadSurfaceTest, KeepsTheLimitOfBytes) {
  ReadOptions options;
  options.maxBytes = kObj.size();
  EXPECT_NO_THROW(readText(kObj, options));
  options.maxBytes = kObj.size() - 1;
  failure(kObj, options, ErrorKind::Limit);
  const TemporaryFolder folder;
  store(folder / "a.obj", kObj);
  EXPECT_THROW(static_cast<void>(readSurface(folder / "a.obj", options)), Error);
}

#ifdef CUTWATER_HAS_ZLIB

TEST(ReadSurfaceTest, ReadsGzipMembersOneBehindTheOther) {
  const std::string two = gzip(kObj.substr(0, 13)) + gzip("") + gzip(kObj.substr(13));
  const auto file = readText(two + std::string(512, '\0'));
  EXPECT_TRUE(file.report.compressed);
  EXPECT_EQ(file.report.bytes, kObj.size());
  EXPECT_EQ(file.soup.polygonCount(), 1U);
}

TEST(ReadSurfaceTest, RefusesBadGzip) {
  const std::string good = gzip(kObj);
  for (std::size_t size = 2; size < good.size(); ++size) {
    const std::string message = failure(good.substr(0, size));
    EXPECT_NE(message.find("test: byte "), std::string::npos) << message;
    EXPECT_NE(message.find("truncated"), std::string::npos) << message;
  }
  std::string bad = good;
  bad[bad.size() - 6] ^= 1;  // the checksum
  EXPECT_NE(failure(bad).find("corrupt"), std::string::npos);
  EXPECT_NE(failure(good + "tail").find("behind the gzip stream"), std::string::npos);
  EXPECT_NE(failure(gzip(good)).find("gzip file in a gzip file"), std::string::npos);
  EXPECT_NE(failure(gzip("")).find("empty"), std::string::npos);
}

TEST(ReadSurfaceTest, GzipBombsStopAtTheLimit) {
  ReadOptions options;
  options.maxBytes = 100000;
  const std::string bomb = gzip(kObj + std::string(20000000, '\n'));
  ASSERT_LT(bomb.size(), options.maxBytes);
  EXPECT_NE(failure(bomb, options, ErrorKind::Limit).find("100000"), std::string::npos);
  EXPECT_EQ(readText(bomb).soup.polygonCount(), 1U);
}

#else

TEST(ReadSurfaceTest, SaysThatZlibIsMissing) {
  EXPECT_NE(failure("\x1f\x8b\x08").find("zlib"), std::string::npos);
}

#endif

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

// The C++ locale always; the C locale where the machine has one with a comma.
TEST(ReadSurfaceTest, LocalesHaveNoEffect) {
  const TemporaryFolder folder;
  const auto soup = readText(replaced(kObj, "1 0 0", "1234567.125 0 1e-7")).soup;
  const auto written = [&](const char* name) {
    writeSurface(folder / name, soup, {.ascii = true});
    return contentOf(folder / name);
  };
  const std::string before = written("before.off");
  const std::locale old = std::locale::global(std::locale(std::locale(), new DecimalComma));
  for (const auto* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE", "fr_FR"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  }
  const std::string after = written("after.off");
  const auto again = readText(after).soup;
  const std::string refused = failure(replaced(kObj, "v 1 0 0", "v 1,5 0 0"));
  std::setlocale(LC_ALL, "C");
  std::locale::global(old);
  EXPECT_EQ(after, before);
  EXPECT_EQ(again.points, soup.points);
  EXPECT_NE(after.find("1234567.125"), std::string::npos);
  EXPECT_NE(refused.find("line 1"), std::string::npos);
}

TEST(ReadSurfaceTest, RefusesMoreThanIndicesCanName) {
  const std::string text = "here";
  const formats::Content content{"test", text};
  const formats::TextCursor at(content);
  formats::SoupBuilder builder({}, "patch", 3);
  for (int i = 0; i < 3; ++i) builder.addPoint({1.0 * i, 0, 0}, at);
  const auto limit = [](auto action) {
    try {
      action();
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::Limit);
    }
  };
  limit([&] { builder.addPoint({4, 0, 0}, at); });
  limit([&] { builder.addCorner(Vec3<double>{4, 0, 0}, at); });
  const auto addFace = [&] {
    for (int i = 0; i < 3; ++i) builder.addCorner(std::int64_t{i}, at);
    builder.endPolygon(at);
  };
  for (int i = 0; i < 3; ++i) addFace();
  limit(addFace);
}

TEST(ReadSurfaceTest, ListsOfFormats) {
  EXPECT_EQ(surfaceFormats("or"), "STL, OBJ, PLY, OFF or legacy VTK");
  EXPECT_EQ(anySurfaceFormats("or"), "STL, OBJ, PLY, OFF, legacy VTK or VTP");
  EXPECT_EQ(surfaceExtensions("and"), ".stl, .obj, .ply, .off and .vtk");
}

/// A row of the table that no writer or reader backs, or another one's, would show here.
TEST(ReadSurfaceTest, WhatIsWrittenUnderAnExtensionIsReadAsItsFormat) {
  PolygonSoup triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.addPolygon(std::array<std::uint32_t, 3>{0, 1, 2});
  const TemporaryFolder folder;
  for (const auto& [format, name, extension] : kReadSurfaceFormats) {
    SCOPED_TRACE(name);
    EXPECT_EQ(namesOf(format).name, name);
    const auto file = folder / ("triangle" + std::string(extension));
    writeSurface(file, triangle);
    EXPECT_EQ(readSurface(file).report.format, format);
  }
}

}  // namespace
}  // namespace cutwater::test
