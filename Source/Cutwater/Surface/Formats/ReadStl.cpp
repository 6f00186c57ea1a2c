#include <Cutwater/Surface/Formats/Readers.hpp>

namespace cutwater::formats {

namespace {

void expect(TextCursor& text, std::string_view keyword) {
  const auto found = text.wordOfFile();
  if (!equalIgnoringCase(found, keyword)) {
    text.fail("expected " + inQuotes(keyword) + ", found " + inQuotes(found));
  }
}

// Normals are discarded, as they follow from the corners; but they must look like numbers. Some
// programs write NaN for degenerate facets, in Microsoft's old spelling too.
void skipNormal(TextCursor& text) {
  expect(text, "normal");
  for (int axis = 0; axis < 3; ++axis) {
    const auto component = text.word();
    if (component.find(".#") == std::string_view::npos) {
      static_cast<void>(text.toNumber(component));
    }
  }
}

// Reads what follows the word "facet".
void readFacet(TextCursor& text, SoupBuilder& builder) {
  skipNormal(text);
  expect(text, "outer");
  expect(text, "loop");
  std::uint64_t corners = 0;
  auto keyword = text.wordOfFile();
  for (; equalIgnoringCase(keyword, "vertex"); keyword = text.wordOfFile()) {
    const double x = text.number();
    const double y = text.number();
    const double z = text.number();
    builder.addCorner({x, y, z}, text);
    ++corners;
  }
  if (!equalIgnoringCase(keyword, "endloop")) {
    text.fail("expected \"vertex\" or \"endloop\", found " + inQuotes(keyword));
  }
  if (corners != 3) text.fail("a facet has " + std::to_string(corners) + " vertices");
  expect(text, "endfacet");
  builder.endPolygon(text);
}

}  // namespace

SurfaceFile readAsciiStl(const Content& content, SoupBuilder& builder) {
  TextCursor text(content);
  bool inSolid = false;
  for (;;) {
    const auto keyword = text.wordOfFileOrNone();
    if (keyword.empty()) break;
    if (equalIgnoringCase(keyword, "solid")) {
      builder.setPatch(text.rest());
      inSolid = true;
    } else if (inSolid && equalIgnoringCase(keyword, "facet")) {
      readFacet(text, builder);
    } else if (inSolid && equalIgnoringCase(keyword, "endsolid")) {
      text.rest();
      inSolid = false;
    } else {
      text.fail("expected a facet or a solid, found " + inQuotes(keyword));
    }
  }
  if (inSolid) builder.note("The last solid has no endsolid.");
  return std::move(builder).finish(text);
}

std::uint32_t binaryStlCount(std::string_view bytes) {
  const Content content{"", bytes};
  ByteCursor cursor(content, std::endian::little);
  cursor.seek(80);
  return cursor.read<std::uint32_t>();
}

SurfaceFile readBinaryStl(const Content& content, SoupBuilder& builder) {
  ByteCursor cursor(content, std::endian::little);
  builder.report().binary = true;
  cursor.seek(80);
  const auto count = cursor.read<std::uint32_t>();
  if (count == 0) cursor.fail("a binary STL of 0 triangles");
  cursor.requireRecords(count, kBinaryStlTriangle, "triangles (if this is a binary STL)");
  if (count * kBinaryStlTriangle > cursor.bytesLeft()) cursor.fail("the last triangle is cut off");
  const std::uint64_t behind = cursor.bytesLeft() - count * kBinaryStlTriangle;
  if (behind > 0 && behind % kBinaryStlTriangle == 0) {
    cursor.fail("the file promises " + std::to_string(count) + " triangles, but holds " +
                std::to_string(cursor.bytesLeft() / kBinaryStlTriangle));
  }
  builder.reservePolygons(count, 3 * std::uint64_t{count});
  for (std::uint32_t i = 0; i < count; ++i) {
    cursor.beginRecord();
    cursor.skip(3 * sizeof(float));  // the normal follows from the corners
    for (int corner = 0; corner < 3; ++corner) {
      const double x = cursor.read<float>();
      const double y = cursor.read<float>();
      const double z = cursor.read<float>();
      builder.addCorner({x, y, z}, cursor);
    }
    cursor.skip(sizeof(std::uint16_t));  // attributes, e.g. colours
    builder.endPolygon(cursor);
  }
  if (behind > 0) {
    builder.note(std::to_string(behind) + " bytes behind the last triangle are not read.");
  }
  return std::move(builder).finish(cursor);
}

}  // namespace cutwater::formats
