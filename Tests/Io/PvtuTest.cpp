#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/VtkFiles.hpp>

#include "Support/Precisions.hpp"
#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class PvtuTest : public ::testing::Test {
 protected:
  const TemporaryFolder folder;
  const std::vector<std::string> pieces{"a_0.vtu", "a&b.vtu"};
  const std::vector<VtkArray> arrays{{"normal", std::span<const Vec3<T>>()},
                                     {"class", std::span<const std::uint8_t>()}};
};
TYPED_TEST_SUITE(PvtuTest, Precisions);

TYPED_TEST(PvtuTest, NamesPiecesAndTypes) {
  using T = TypeParam;
  writePvtu<T>(this->folder / "a.pvtu", this->pieces, this->arrays);
  const std::string type = sizeof(T) == 4 ? "Float32" : "Float64";
  // By hand, from the format's description.
  EXPECT_EQ(contentOf(this->folder / "a.pvtu"),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
            "header_type=\"UInt64\">\n"
            "  <PUnstructuredGrid GhostLevel=\"0\">\n"
            "    <PPointData/>\n"
            "    <PCellData Vectors=\"normal\">\n"
            "      <PDataArray type=\"" +
                type +
                "\" Name=\"normal\" NumberOfComponents=\"3\"/>\n"
                "      <PDataArray type=\"UInt8\" Name=\"class\" NumberOfComponents=\"1\"/>\n"
                "    </PCellData>\n"
                "    <PPoints>\n"
                "      <PDataArray type=\"" +
                type +
                "\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
                "    </PPoints>\n"
                "    <Piece Source=\"a_0.vtu\"/>\n"
                "    <Piece Source=\"a&amp;b.vtu\"/>\n"
                "  </PUnstructuredGrid>\n"
                "</VTKFile>\n");
}

TYPED_TEST(PvtuTest, RefusesWhatCannotBe) {
  using T = TypeParam;
  const auto write = [this](const std::vector<std::string>& names, std::vector<VtkArray> values) {
    writePvtu<T>(this->folder / "a.pvtu", names, values);
  };
  EXPECT_THROW(write({}, this->arrays), Error);
  EXPECT_THROW(write(this->pieces, {}), Error);
  EXPECT_THROW(write(this->pieces, {this->arrays[0], this->arrays[0]}), Error);
  EXPECT_EQ(this->folder.fileCount(), 0U);
  EXPECT_THROW(writePvtu<T>(this->folder / "no" / "a.pvtu", this->pieces, this->arrays), Error);
}

}  // namespace
}  // namespace cutwater::test
