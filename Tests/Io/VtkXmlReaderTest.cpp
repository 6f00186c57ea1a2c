#include "VtkXmlSample.hpp"

namespace cutwater::test {
namespace {

using VtkXmlReaderTest = PointFile;

const std::vector<double> kCoordinates{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.7};

/// A tetrahedron and a polyhedron of the same shape, with arrays of all types.
VtkXmlSample grid(const XmlEncoding& encoding) {
  VtkXmlSample file("UnstructuredGrid", encoding);
  file << "<FieldData>\n";
  file.array<float>("Float32", "Name=\"TIME\" NumberOfTuples=\"1\"", {0.25F});
  file << "<Array type=\"String\" Name=\"title\" NumberOfTuples=\"1\" format=\"ascii\">65 "
          "0</Array>\n"
          "</FieldData>\n<Piece NumberOfPoints=\"4\" NumberOfCells=\"2\">\n<PointData>\n";
  file.array<std::int8_t>("Int8", "Name=\"i8\"", {-128, 127, 0, 1});
  file.array<std::uint8_t>("UInt8", "Name=\"u8\"", {0, 255, 1, 2});
  file.array<std::int16_t>("Int16", "Name=\"i16\"", {-32768, 1, 2, 3});
  file.array<std::uint16_t>("UInt16", "Name=\"u16\"", {65535, 1, 2, 3});
  file.array<std::int32_t>("Int32", "Name=\"i32\"", {INT32_MIN, 1, 2, 3});
  file.array<std::uint32_t>("UInt32", "Name=\"u32\"", {UINT32_MAX, 1, 2, 3});
  file.array<std::int64_t>("Int64", "Name=\"i64\"", {INT64_MIN, 1, 2, 3});
  file.array<std::uint64_t>("UInt64", "Name=\"u64\"", {UINT64_MAX, 1, 2, 3});
  file.array<float>("Float32", "Name=\"U &amp; V\" NumberOfComponents=\"3\"",
                    {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0.1F});
  file << "</PointData>\n<CellData>\n";
  file.array<double>("Float64", "Name=\"q\"", {-0.0, 1e300});
  file << "</CellData>\n<Points>\n";
  file.array<double>("Float64", "NumberOfComponents=\"3\"", kCoordinates);
  file << "</Points>\n<Cells>\n";
  file.array<std::int64_t>("Int64", "Name=\"connectivity\"", {0, 1, 2, 3, 0, 1, 2, 3});
  file.array<std::int32_t>("Int32", "Name=\"offsets\"", {4, 8});
  file.array<std::uint8_t>("UInt8", "Name=\"types\"", {10, 42});
  file.array<std::int64_t>("Int64", "Name=\"faces\"",
                           {4, 3, 0, 1, 2, 3, 0, 1, 3, 3, 0, 2, 3, 3, 1, 2, 3});
  file.array<std::int64_t>("Int64", "Name=\"faceoffsets\"", {-1, 17});
  file << "</Cells>\n</Piece>\n";
  return file;
}

const PointData kGrid{
    .mesh = DataMesh::Unstructured,
    .points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.7}},
    .pointArrays = {{"i8", std::vector<std::int8_t>{-128, 127, 0, 1}},
                    {"u8", std::vector<std::uint8_t>{0, 255, 1, 2}},
                    {"i16", std::vector<std::int16_t>{-32768, 1, 2, 3}},
                    {"u16", std::vector<std::uint16_t>{65535, 1, 2, 3}},
                    {"i32", std::vector<std::int32_t>{INT32_MIN, 1, 2, 3}},
                    {"u32", std::vector<std::uint32_t>{UINT32_MAX, 1, 2, 3}},
                    {"i64", std::vector<std::int64_t>{INT64_MIN, 1, 2, 3}},
                    {"u64", std::vector<std::uint64_t>{UINT64_MAX, 1, 2, 3}},
                    {"U & V", std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0.1F}, 3}},
    .cells = {.kinds = {10, 42},
              .offsets = {0, 4, 8},
              .corners = {0, 1, 2, 3, 0, 1, 2, 3},
              .faces = {4, 3, 0, 1, 2, 3, 0, 1, 3, 3, 0, 2, 3, 3, 1, 2, 3},
              .faceEnds = {-1, 17}},
    .cellArrays = {{"q", std::vector<double>{-0.0, 1e300}}},
    .fieldArrays = {{"TIME", std::vector<float>{0.25F}}}};

TEST_F(VtkXmlReaderTest, ReadsTheSameFromEveryEncoding) {
  for (const auto& encoding : xmlEncodings()) {
    SCOPED_TRACE(encoding.format + " " + encoding.appended);
    const auto data = read(grid(encoding).text());
    expectSameData(data, kGrid);
    EXPECT_EQ(data.notes.size(), 1U);
  }
}

TEST_F(VtkXmlReaderTest, WhatIsWrittenReadsBackToTheBit) {
  expectSameData(again(kGrid, "again.vtu"), kGrid);
  auto single = kGrid;
  single.singlePrecision = true;
  single.points[3].z = double{0.7F};
  expectSameData(again(single, "single.vtu"), single);
  expectSameData(again({.mesh = DataMesh::Unstructured}, "empty.vtu"),
                 {.mesh = DataMesh::Unstructured});
  auto named = kGrid;
  for (const char* name : {"\x01", "\x7f", "\xff\xfe", "\xc3", "\x80", "\xc0\xaf", "\xed\xa0\x80",
                           "\xef\xbf\xbe", "\xf4\x90\x80\x80", "\xc3("}) {
    named.pointArrays[0].name = name;
    EXPECT_NE(writeRefusal(named, "a.vtu").find("printable"), std::string::npos) << name;
  }
  named.pointArrays[0].name = "\xc3\xa4<>\"'\xf0\x9f\x98\x80";
  expectSameData(again(named, "names.vtu"), named);
}

/// Cells stand in VTK's order, whatever that of their elements.
TEST_F(VtkXmlReaderTest, ReadsPolyDataInVtksOrder) {
  for (const auto& encoding : xmlEncodings()) {
    VtkXmlSample sample("PolyData", encoding);
    sample << "<Piece NumberOfPoints=\"4\" NumberOfVerts=\"1\" NumberOfLines=\"1\" "
              "NumberOfStrips=\"1\" NumberOfPolys=\"2\">\n<Points>\n";
    sample.array<float>("Float32", "Name=\"Points\" NumberOfComponents=\"3\"",
                        {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    sample << "</Points>\n<CellData>";
    sample.array<std::int32_t>("Int32", "Name=\"id\"", {0, 1, 2, 3, 4});
    const auto part = [&](const std::string& name, const std::vector<std::int64_t>& corners,
                          const std::vector<std::int64_t>& ends) {
      sample << "<" + name + ">\n";
      sample.array("Int64", "Name=\"connectivity\"", corners);
      sample.array("Int64", "Name=\"offsets\"", ends);
      sample << "</" + name + ">\n";
    };
    sample << "</CellData>\n";
    part("Strips", {0, 1, 2, 3}, {4});
    part("Polys", {0, 1, 2, 1, 2, 3}, {3, 6});
    part("Verts", {3}, {1});
    part("Lines", {2, 3}, {2});
    sample << "</Piece>\n";
    const auto data = read(sample.text());
    EXPECT_EQ(data.mesh, DataMesh::PolyData);
    EXPECT_TRUE(data.singlePrecision);
    EXPECT_EQ(data.cells, (DataCells{.kinds = {2, 4, 7, 7, 6},
                                     .offsets = {0, 1, 3, 6, 9, 13},
                                     .corners = {3, 2, 3, 0, 1, 2, 1, 2, 3, 0, 1, 2, 3},
                                     .faces = {},
                                     .faceEnds = {}}));
    expectSameData(again(data, "again.vtp"), data);
    expectSameData(again(data, "again.vtk"), data);
  }
  EXPECT_NE(writeRefusal(kGrid, "a.vtp").find("written as .vtu"), std::string::npos);
}

/// The document, with one part of it replaced.
class Changed {
 public:
  explicit Changed(std::string text) : text_(std::move(text)) {}
  std::string operator()(const std::string& from, const std::string& to) const {
    const auto at = text_.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return std::string(text_).replace(at, from.size(), to);
  }

 private:
  std::string text_;
};

TEST_F(VtkXmlReaderTest, RefusesWhatDoesNotFitTogether) {
  const Changed with(grid({}).text());
  const auto refused = [&](const std::string& from, const std::string& to,
                           const std::string& part) {
    const auto message = refusal(with(from, to));
    EXPECT_TRUE(message.starts_with("line ")) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  refused("type=\"UnstructuredGrid\"", "type=\"ImageData\"", "found \"ImageData\"");
  refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"", "needs 15 numbers, and has 12");
  refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"3\"", "more than 9 numbers");
  refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"-4\"", "NumberOfPoints is \"-4\"");
  refused("NumberOfPoints=\"4\"", "", "the attribute NumberOfPoints is missing");
  refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"99999999999\"", "the file promises");
  refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"999999999999999\"", "NumberOfPoints is");
  refused("NumberOfCells=\"2\"", "NumberOfCells=\"1\"", "more than 1 numbers");
  refused("Float64\" NumberOfComponents=\"3\"", "Float64\"", "points need 3 components");
  refused("Float64\" NumberOfComponents=\"3\"", "Int64\" NumberOfComponents=\"3\"",
          "floating-point");
  refused("Float64\" NumberOfComponents=\"3\"", "Bit\" NumberOfComponents=\"3\"", "type \"Bit\"");
  refused("<Points>", "<Points></Points><Points>", "need one element Points");
  refused("Name=\"u8\"", "Name=\"i8\"", "a second array named \"i8\"");
  refused("Name=\"u8\"", "", "an array without a name");
  refused("Name=\"types\"", "Name=\"kinds\"", "no array named \"types\"");
  refused("Name=\"faces\"", "Name=\"facets\"", "no array named \"faces\"");
  refused(" 127\n", " 128\n", "\"128\" is out of range");
  refused(" 127\n", " 1.5\n", "found \"1.5\"");
  refused(" 0.7\n", " nan\n", "a coordinate of point 3 is not finite");
  refused(" 4\n 8\n", " 4\n 3\n", "must ascend");
  refused(" 4\n 8\n", " 4\n 7\n", "more than 7 numbers");
  refused(" 17\n", " 16\n", "more than 16 numbers");
  refused("-1\n 17\n", "-2\n 17\n", "-2 is out of range");
  refused("-1\n 17\n", "17\n 17\n", "the faces of cell 0");
  refused(" 42\n", " 12\n", "more than 0 numbers");
  refused("format=\"ascii\">", "format=\"text\">", "found \"text\"");
  refused("Name=\"TIME\" NumberOfTuples=\"1\"", "Name=\"TIME\"", "NumberOfTuples is missing");
  refused("</VTKFile>", "", "the file ends too early: it should end with </VTKFile>");
}

TEST_F(VtkXmlReaderTest, RefusesCellsWhoseCornersAreNoPoints) {
  const Changed with(grid({}).text());
  const std::string corners = " 0\n 1\n 2\n 3\n 0\n 1\n 2\n 3\n";
  EXPECT_NE(refusal(with(corners, " 0\n 1\n 2\n 4\n 0\n 1\n 2\n 3\n"))
                .find("index 4 is out of range: the file has 4 points"),
            std::string::npos);
  EXPECT_NE(refusal(with(corners, " 0\n 1\n 2\n -1\n 0\n 1\n 2\n 3\n")).find("-1 is out of range"),
            std::string::npos);
  const std::string faces = " 4\n 3\n 0\n 1\n 2\n 3\n";
  EXPECT_NE(refusal(with(faces, " 5\n 3\n 0\n 1\n 2\n 3\n")).find("faces of cell 1"),
            std::string::npos);
  EXPECT_NE(refusal(with(faces, " 4\n 3\n 0\n 1\n 9\n 3\n")).find("faces of cell 1"),
            std::string::npos);
}

TEST_F(VtkXmlReaderTest, RefusesDamagedBinaryData) {
  const auto binary = grid({.format = "binary"}).text();
  const Changed with(binary);
  const std::string time = base64(bytesOf<std::uint32_t>({4}) + bytesOf<float>({0.25F}));
  const auto refused = [&](const std::string& to, const std::string& part) {
    const auto message = refusal(with(time, to));
    EXPECT_TRUE(message.starts_with("line 5: ")) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  refused(base64(bytesOf<std::uint32_t>({8}) + bytesOf<float>({0.25F})), "has 8 bytes");
  refused(base64(bytesOf<std::uint32_t>({3}) + bytesOf<float>({0.25F})), "has 3 bytes");
  refused(time.substr(0, 8), "end too early");
  refused(time.substr(0, 7), "end too early");
  refused("*" + time.substr(1), "no base64");
  refused(time + time, "data behind the last number");
  EXPECT_NE(refusal(with(" byte_order=\"LittleEndian\"", "")).find("no byte_order"),
            std::string::npos);
  EXPECT_NE(refusal(with("LittleEndian", "Middle")).find("byte order \"Middle\""),
            std::string::npos);
  EXPECT_NE(
      refusal(with("byte_order", "header_type=\"Int8\" byte_order")).find("header type \"Int8\""),
      std::string::npos);
  EXPECT_NE(refusal(with("byte_order", "compressor=\"vtkLZ4DataCompressor\" byte_order"))
                .find("vtkLZ4DataCompressor"),
            std::string::npos);
}

TEST_F(VtkXmlReaderTest, RefusesDamagedAppendedData) {
  for (const char* encoding : {"raw", "base64"}) {
    const auto whole = grid({.format = "appended", .appended = encoding}).text();
    const Changed with(whole);
    EXPECT_NE(refusal(with("offset=\"0\"", "offset=\"999999\"")).find("offset \"999999\""),
              std::string::npos);
    EXPECT_NE(refusal(with("offset=\"0\"", "offset=\"-1\"")).find("offset \"-1\""),
              std::string::npos);
    EXPECT_NE(refusal(with(" offset=\"0\"", "")).find("without an offset"), std::string::npos);
    EXPECT_NE(refusal(with("encoding=\"", "encoding=\"x")).find("raw or base64"),
              std::string::npos);
    EXPECT_NE(refusal(with(" _", " ")).find("underscore"), std::string::npos);
    for (std::size_t size = 0; size < whole.size() - 1; ++size) {
      EXPECT_NE(refusal(whole.substr(0, size)), "nothing") << size;
    }
  }
}

#ifdef CUTWATER_HAS_ZLIB
TEST_F(VtkXmlReaderTest, RefusesDamagedCompressedData) {
  const auto whole = grid({.format = "appended", .compressed = true}).text();
  const auto begin = whole.find(" _") + 2;
  // Every bit belongs to a size or to zlib's checksum, or has no meaning: the size of a block where
  // there is only a smaller one.
  std::size_t refusedCount = 0;
  for (std::size_t i = begin; i < whole.size() - 40; ++i) {
    auto damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 16);
    if (refusal(damaged) == "nothing") {
      expectSameData(read(damaged), kGrid);
    } else {
      ++refusedCount;
    }
  }
  EXPECT_GT(refusedCount, 9 * (whole.size() - 40 - begin) / 10);
  // One block that says that it is a hundred million bytes.
  const Changed with(whole);
  EXPECT_NE(refusal(with("NumberOfPoints=\"4\"", "NumberOfPoints=\"100000000\"")).find("room for"),
            std::string::npos);
}

TEST_F(VtkXmlReaderTest, RefusesArraysThatInflateBeyondTheLimit) {
  VtkXmlSample sample("PolyData", {.format = "binary", .compressed = true});
  sample << "<Piece NumberOfPoints=\"0\">\n</Piece>\n<FieldData>\n";
  sample.array<double>("Float64", "Name=\"a\" NumberOfTuples=\"1000\"", std::vector<double>(1000));
  sample << "</FieldData>\n";
  const auto text = sample.text();
  EXPECT_EQ(read(text).fieldArrays.size(), 1U);
  const auto readWithin = [](const std::string& content, std::uint64_t limit) {
    return readPointData(std::as_bytes(std::span(content)), "points", {.maxBytes = limit});
  };
  EXPECT_NO_THROW((void)readWithin(text, std::max<std::size_t>(text.size(), 8000)));
  const auto more = Changed(text)("NumberOfTuples=\"1000\"", "NumberOfTuples=\"99999\"");
  try {
    static_cast<void>(readWithin(more, more.size() + 100));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Limit);
  }
}
#endif

}  // namespace
}  // namespace cutwater::test
