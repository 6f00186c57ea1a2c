#include <Cutwater/Surface/Formats/Readers.hpp>

namespace cutwater::formats {

namespace {

void requireLine(TextCursor& text, const char* what) {
  if (!text.nextFilledLine()) text.fail("the file ends where " + std::string(what) + " should be");
}

}  // namespace

// Geomview's format: the keyword, three counts, a line per point, a line per face. Texture
// coordinates, colours and normals (ST, C, N before OFF) follow the coordinates.
SurfaceFile readOff(const Content& content, SoupBuilder& builder) {
  TextCursor text(content, {.comments = TextCursor::Comments::Anywhere});
  requireLine(text, "OFF");
  static_cast<void>(text.word());
  auto word = text.word();
  if (equalIgnoringCase(word, "BINARY")) text.fail("binary OFF is not read");
  if (word.empty()) {
    requireLine(text, "the number of points");
    word = text.word();
  }
  const std::int64_t pointsPromised = text.toInteger(word);
  const std::int64_t facesPromised = text.integer();
  text.skipNumbers();                          // the number of edges, which is unreliable
  constexpr std::uint64_t kSmallestPoint = 6;  // "0 0 0\n"
  constexpr std::uint64_t kSmallestFace = 8;   // "3 0 0 0\n"
  const auto points = text.requireRecords(pointsPromised, kSmallestPoint, "points");
  const auto faces = text.requireRecords(facesPromised, kSmallestFace, "faces");
  builder.reservePoints(points);
  builder.reservePolygons(faces, 3 * faces);
  for (std::uint64_t i = 0; i < points; ++i) {
    requireLine(text, "a point");
    const double x = text.number();
    const double y = text.number();
    const double z = text.number();
    builder.addPoint({x, y, z}, text);
    text.skipNumbers();
  }
  for (std::uint64_t i = 0; i < faces; ++i) {
    requireLine(text, "a face");
    const auto corners = text.requireRecords(text.integer(), 2, "corners");
    for (std::uint64_t corner = 0; corner < corners; ++corner) {
      builder.addCorner(text.integer(), text);
    }
    builder.endPolygon(text);
    text.skipNumbers();
  }
  if (text.nextFilledLine()) text.fail("more lines than the header promises");
  return std::move(builder).finish(text);
}

}  // namespace cutwater::formats
