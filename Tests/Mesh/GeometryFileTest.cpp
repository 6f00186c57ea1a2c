// MeshSDF::toBytes(), view(), save() and open().

#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <fstream>
#include <sys/stat.h>
#include <thread>

#include "Mesh/GeometryFiles.hpp"
#include "Support/Precisions.hpp"
#include "Support/SameMeshes.hpp"
#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class GeometryFileTest : public ::testing::Test {};
TYPED_TEST_SUITE(GeometryFileTest, Precisions);

bool sameBytes(const Block& a, const Block& b) {
  return std::ranges::equal(a.bytes(), b.bytes());
}

/// The mesh comes back from its bytes, and so does what is made of it.
template <typename T>
void expectComesBack(const MeshSDF<T>& mesh) {
  const auto bytes = mesh.toBytes(42);
  const auto viewed = MeshSDF<T>::view(bytes);
  expectSame(viewed, mesh);
  EXPECT_EQ(viewed.placement(), mesh.placement());
  EXPECT_EQ(viewed.memoryBytes(), mesh.memoryBytes());
  EXPECT_EQ(viewed.guarantee().continuous, mesh.guarantee().continuous);
  EXPECT_EQ(viewed.guarantee().outside, mesh.guarantee().outside);
  EXPECT_TRUE(sameBytes(viewed.toBytes(42), bytes));
  const auto trusted = MeshSDF<T>::view(bytes.bytes(), {.verifyPayload = false});
  EXPECT_TRUE(sameBytes(trusted.toBytes(42), bytes));

  auto positions = std::vector<Vec3<T>>();
  for (const auto& p : mesh.soup().points) {
    positions.push_back(static_cast<Vec3<T>>(p + 0.05 * Vec3<double>{p.y, p.z, p.x}));
  }
  expectSame(viewed.refitted(positions), mesh.refitted(positions));
}

TYPED_TEST(GeometryFileTest, AMeshComesBackFromItsBytes) {
  using T = TypeParam;
  const auto ball = tessellation::icosphere(1, 2);
  expectComesBack(MeshSDF<T>(ball));
  expectComesBack(MeshSDF<T>(tetrahedron()));
  expectComesBack(MeshSDF<T>(tessellation::torus(2, 0.5, 24, 12)));  // of quads
  expectComesBack(
      MeshSDF<T>(together(ball, moved(ball, {1, 0, 0})), {.findSelfIntersections = true}));
  expectComesBack(MeshSDF<T>(together(ball, insideOut(moved(ball, {3, 0, 0})))));
  expectComesBack(MeshSDF<T>(flipped(ball, 7)));
}

TYPED_TEST(GeometryFileTest, AnOpenMeshComesBackFromItsBytes) {
  using T = TypeParam;
  expectComesBack(MeshSDF<T>(openBoxOfPatches()));
  expectComesBack(MeshSDF<T>(bowl(24)));
  expectComesBack(MeshSDF<T>(bowl(16), {.signs = SignScheme::NearestFeature}));
  expectComesBack(MeshSDF<T>(twistedBand(24, 0.25, 1)));
  expectComesBack(MeshSDF<T>(unwelded(tetrahedron())));
}

TYPED_TEST(GeometryFileTest, AMeshOfSliversComesBackFromItsBytes) {
  using T = TypeParam;
  expectComesBack(MeshSDF<T>(bipyramid(3000)));  // with hulls around the children of nodes
  expectComesBack(MeshSDF<T>(onlyFaces(bipyramid(1000), [](std::size_t i) { return i > 9; })));
}

TYPED_TEST(GeometryFileTest, AMovedMeshComesBackWhereItWas) {
  using T = TypeParam;
  auto mesh = MeshSDF<T>(openBoxOfPatches());
  mesh.translate({1, T(-2.5), T(0.1)});
  expectComesBack(mesh);
  mesh.rotate(T(33.3), {1, 2, 3});
  for (int i = 0; i < 100; ++i) mesh.rotate(1, 2);
  expectComesBack(mesh);
}

TYPED_TEST(GeometryFileTest, AMeshOfAnotherScaleComesBack) {
  using T = TypeParam;
  for (const double factor : {1e-12, 1e12}) {
    expectComesBack(MeshSDF<T>(withPoints(bowl(16), [&](auto p) { return factor * p; })));
  }
}

TYPED_TEST(GeometryFileTest, OptionsComeBack) {
  using T = TypeParam;
  const auto ball = tessellation::icosphere(1, 1);
  const MeshSDF<T> mesh(ball, {.requireWatertight = true});
  const auto viewed = MeshSDF<T>::view(mesh.toBytes());
  std::vector<Vec3<T>> flat;
  for (const auto& p : ball.points) flat.push_back({static_cast<T>(p.x), static_cast<T>(p.y), 0});
  EXPECT_THROW((void)viewed.refitted(flat), Error);
}

TYPED_TEST(GeometryFileTest, TheTrianglesCanBeTakenOut) {
  using T = TypeParam;
  const auto soup = openBoxOfPatches();
  const MeshSDF<T> mesh(soup);
  const auto taken = mesh.soup();
  EXPECT_EQ(taken.points, soup.points);
  EXPECT_EQ(taken.patchNames, soup.patchNames);
  ASSERT_EQ(taken.polygonCount(), mesh.triangleCount());
  EXPECT_EQ(taken.polygonCount(), 2 * soup.polygonCount());
  for (std::uint32_t id = 0; id < taken.polygonCount(); ++id) {
    EXPECT_EQ(taken.patches[id], soup.patches[id / 2]);
    const auto corners = mesh.triangle(id);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(static_cast<Vec3<T>>(taken.points[taken.polygon(id)[i]]), corners[i]);
    }
  }
}

TYPED_TEST(GeometryFileTest, AFileHoldsTheBytes) {
  using T = TypeParam;
  const TemporaryFolder folder;
  const MeshSDF<T> mesh(openBoxOfPatches());
  mesh.save(folder / "box.cutwater", 42);
  EXPECT_EQ(folder.fileCount(), 1U);
  const auto content = contentOf(folder / "box.cutwater");
  EXPECT_TRUE(std::ranges::equal(std::as_bytes(std::span(content)), mesh.toBytes(42).bytes()));
  expectSame(MeshSDF<T>::open(folder / "box.cutwater"), mesh);
  expectSame(MeshSDF<T>::open(folder / "box.cutwater", {.verifyPayload = false}), mesh);
}

TYPED_TEST(GeometryFileTest, AFileThatIsReplacedStaysForThoseThatHaveIt) {
  using T = TypeParam;
  const TemporaryFolder folder;
  const MeshSDF<T> one(tessellation::icosphere(1, 2));
  const MeshSDF<T> other(bowl(24));
  one.save(folder / "a");
  const auto before = MeshSDF<T>::open(folder / "a");
  other.save(folder / "a");
  expectSame(before, one);
  expectSame(MeshSDF<T>::open(folder / "a"), other);
  std::filesystem::remove(folder / "a");
  expectSame(before, one);
}

TYPED_TEST(GeometryFileTest, WhatCannotBeMappedIsRead) {
  using T = TypeParam;
  const TemporaryFolder folder;
  const auto pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const MeshSDF<T> mesh(bowl(24));
  const std::jthread writer([&] { mesh.save(pipe); });
  expectSame(MeshSDF<T>::open(pipe), mesh);
}

TYPED_TEST(GeometryFileTest, AMeshKeepsABlockAliveAndNeedsSpansNoLongerOnceRefitted) {
  using T = TypeParam;
  const auto soup = bowl(24);
  const MeshSDF<T> mesh(soup);
  const auto kept = MeshSDF<T>::view(mesh.toBytes());  // nobody else holds the block
  expectSame(kept, mesh);
  std::vector<Vec3<T>> positions;
  for (const auto& p : soup.points) positions.push_back(static_cast<Vec3<T>>(p));
  const auto refitted = [&] {
    const EditableBytes bytes(mesh.toBytes().bytes());
    return MeshSDF<T>::view(bytes.bytes()).refitted(positions);
  }();
  expectSame(refitted, mesh);
}

TYPED_TEST(GeometryFileTest, BytesMustBeAligned) {
  using T = TypeParam;
  const auto bytes = MeshSDF<T>(tetrahedron()).toBytes();
  EditableBytes room(bytes.bytes(), 64);
  for (std::size_t shift = 1; shift <= 64; ++shift) {
    std::memmove(room.data() + shift, room.data() + shift - 1, bytes.bytes().size());
    const std::span<const std::byte> moved(room.data() + shift, bytes.bytes().size());
    EXPECT_EQ(MeshSDF<T>::view(alignedCopy(moved)).signedDistance({0, 0, -2}), 2);
    if (shift == 64) break;
    try {
      (void)MeshSDF<T>::view(moved);
      ADD_FAILURE() << shift;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::Argument);
      const auto wanted = "multiple of 64 (beyond one by = " + std::to_string(shift) + ")";
      EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << error.what();
    }
  }
}

TYPED_TEST(GeometryFileTest, AHeaderTellsWhatItIs) {
  using T = TypeParam;
  const TemporaryFolder folder;
  const MeshSDF<T> mesh(tetrahedron());
  mesh.save(folder / "a", 0x1234567890abcdef);
  const auto info = geometryFileInfo(folder / "a");
  ASSERT_TRUE(info);
  EXPECT_EQ(info->version, kGeometryFileVersion);
  EXPECT_EQ(info->bytesPerNumber, sizeof(T));
  EXPECT_EQ(info->source, 0x1234567890abcdefU);
  EXPECT_EQ(geometryFileInfo(mesh.toBytes(5).bytes())->source, 5U);
  EXPECT_FALSE(geometryFileInfo(folder / "b"));
  EXPECT_FALSE(geometryFileInfo(folder / ""));
  std::ofstream(folder / "b") << "solid\nendsolid\n";
  EXPECT_FALSE(geometryFileInfo(folder / "b"));
  EXPECT_FALSE(geometryFileInfo(std::span<const std::byte>()));
}

/// What open() says of a file with this content.
template <typename T>
std::string refusalOf(std::string_view content) {
  return fileRefusal(content, [](const auto& path) { return MeshSDF<T>::open(path); });
}

TYPED_TEST(GeometryFileTest, RefusesOtherFiles) {
  using T = TypeParam;
  EXPECT_EQ(refusalOf<T>(""), "there is nothing in it");
  for (const auto* content : {"solid hull\n", "x", "\x89PNG\r\n\x1a\n",
                              "\x89"
                              "Cutting"}) {
    EXPECT_EQ(refusalOf<T>(content), "this is no geometry file") << content;
  }
  EXPECT_EQ(refusalOf<T>("\x89"
                         "Cut"),
            "the geometry file is damaged: it ends within its header");
  const TemporaryFolder folder;
  for (const auto& path : {folder / "", folder / "missing"}) {
    try {
      (void)MeshSDF<T>::open(path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::File);
      EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    }
  }
}

TEST(GeometryFile, IsNotReadAsASurface) {
  const auto bytes = MeshSDF<double>(tetrahedron()).toBytes();
  try {
    (void)readSurface(bytes.bytes(), "hull.cutwater");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("a prepared geometry file"), std::string::npos);
  }
}

TYPED_TEST(GeometryFileTest, DependsOnNothingButTheMesh) {
  using T = TypeParam;
  const auto soup = together(bowl(24), moved(tessellation::icosphere(1, 3), {3, 0, 0}));
  const auto bytes = MeshSDF<T>(soup).toBytes();
  for (int i = 0; i < 3; ++i) {
    const std::vector<std::byte> noise(std::size_t{1} << (16 + i), std::byte{0xa5});  // on the heap
    EXPECT_TRUE(sameBytes(MeshSDF<T>(soup).toBytes(), bytes)) << noise.size();
  }
}

TEST(GeometryFile, HasTheBytesOfItsVersion) {
  // If the layout has changed, raise kGeometryFileVersion; if only the builder makes another tree,
  // do not. Then write down the new values here.
  EXPECT_EQ(kGeometryFileVersion, 6U);
  const auto hashOf = [](const Block& bytes) { return xxHash64(bytes.bytes()); };
  EXPECT_EQ(hashOf(MeshSDF<float>(openBoxOfPatches()).toBytes()), 0xa088d251bba277fbU);
  EXPECT_EQ(hashOf(MeshSDF<double>(openBoxOfPatches()).toBytes()), 0x845714599076b33eU);
}

}  // namespace
}  // namespace cutwater::test
