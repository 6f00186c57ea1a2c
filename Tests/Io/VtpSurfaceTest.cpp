#include <Cutwater/Io/VtpSurface.hpp>
#include <Cutwater/Surface/WriteSurface.hpp>

#include "PointFile.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

constexpr const char* kPoints =
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 "
    "0 0 0 1</DataArray></Points>\n";

/// Cells of one element of PolyData.
std::string part(const std::string& name, const std::string& corners, const std::string& ends) {
  return "<" + name + "><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
         corners + "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" +
         ends + "</DataArray></" + name + ">\n";
}

std::string polyData(const std::string& counts, const std::string& parts) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\"><PolyData>\n<Piece "
         "NumberOfPoints=\"4\" " +
         counts + ">\n" + kPoints + parts + "</Piece></PolyData></VTKFile>\n";
}

class VtpSurfaceTest : public PointFile {
 protected:
  [[nodiscard]] SurfaceFile surface(const std::string& text,
                                    const ReadOptions& options = {}) const {
    std::ofstream(folder / "part.vtp", std::ios::binary) << text;
    return readAnySurface(folder / "part.vtp", options);
  }
  [[nodiscard]] std::string refused(const std::string& text) const {
    try {
      static_cast<void>(surface(text));
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing";
  }
};

TEST_F(VtpSurfaceTest, TakesPolygonsAndStrips) {
  const auto file =
      surface(polyData("NumberOfPolys=\"2\" NumberOfStrips=\"1\" NumberOfVerts=\"1\"",
                       part("Verts", "2", "1") + part("Polys", "0 2 1 0 1 3 2", "3 7") +
                           part("Strips", "0 1 2 3", "4")),
              {.scale = 2});
  EXPECT_EQ(file.soup.points,
            (std::vector<Vec3<double>>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}));
  EXPECT_EQ(file.soup.offsets, (std::vector<std::uint64_t>{0, 3, 7, 10, 13}));
  EXPECT_EQ(file.soup.corners, (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 2, 0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(file.soup.patchNames, (std::vector<std::string>{"part"}));
  EXPECT_EQ(file.report.format, SurfaceFormat::Vtp);
  EXPECT_FALSE(file.report.binary);
  EXPECT_EQ(file.report.notes.size(), 1U);
}

TEST_F(VtpSurfaceTest, ReadsWhatWritePointDataWrote) {
  const auto soup = cube();
  PointData data{.mesh = DataMesh::PolyData, .points = soup.points};
  data.cells.offsets.assign(soup.offsets.begin(), soup.offsets.end());
  data.cells.corners.assign(soup.corners.begin(), soup.corners.end());
  data.cells.kinds.assign(soup.polygonCount(), 7);
  writePointData(folder / "cube.vtp", data);
  const auto file = readAnySurface(folder / "cube.vtp");
  EXPECT_EQ(file.soup.points, soup.points);
  EXPECT_EQ(file.soup.corners, soup.corners);
  EXPECT_TRUE(file.report.binary);
}

TEST_F(VtpSurfaceTest, OtherFormatsAreReadAsBefore) {
  writeSurface(folder / "cube.ply", cube());
  const auto file = readAnySurface(folder / "cube.ply");
  EXPECT_EQ(file.report.format, SurfaceFormat::Ply);
  EXPECT_EQ(file.soup.corners, readSurface(folder / "cube.ply").soup.corners);
  EXPECT_THROW((void)readAnySurface(folder / "cube.ply", {.scale = 0}), Error);
  EXPECT_THROW((void)readAnySurface(folder / "none.stl"), Error);
  EXPECT_NE(refused("").find("the file is empty"), std::string::npos);
}

TEST_F(VtpSurfaceTest, RefusesWhatIsNoSurface) {
  EXPECT_NE(refused(polyData("", "")).find("no faces"), std::string::npos);
  EXPECT_NE(refused(polyData("NumberOfPolys=\"1\"", part("Polys", "0 1", "2"))).find("2 corners"),
            std::string::npos);
  EXPECT_NE(refused(polyData("NumberOfStrips=\"1\"", part("Strips", "0 1", "2"))).find("2 points"),
            std::string::npos);
  EXPECT_NE(refused("<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece "
                    "NumberOfPoints=\"0\" NumberOfCells=\"0\"/></UnstructuredGrid></VTKFile>")
                .find("not an unstructured grid"),
            std::string::npos);
}

}  // namespace
}  // namespace cutwater::test
