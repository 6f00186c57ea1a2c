#include <Cutwater/Surface/Formats/Readers.hpp>

#include <algorithm>
#include <array>

namespace cutwater::formats {

namespace {

bool isText(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) {
    const bool blank = c >= '\t' && c <= '\r';
    return (static_cast<unsigned char>(c) < ' ' && !blank) || c == '\x7f';
  });
}

// The first word outside comments; no longer than any keyword.
std::string_view firstWord(std::string_view bytes) {
  constexpr std::string_view kBlanks = " \t\v\f\r\n";
  constexpr std::string_view kWordEnds = " \t\v\f\r\n#";
  constexpr std::size_t kLongestKeyword = 16;
  for (;;) {
    bytes.remove_prefix(std::min(bytes.find_first_not_of(kBlanks), bytes.size()));
    if (!bytes.starts_with('#')) break;
    bytes.remove_prefix(std::min(bytes.find_first_of("\r\n"), bytes.size()));
  }
  return bytes.substr(
      0, std::min(bytes.substr(0, kLongestKeyword).find_first_of(kWordEnds), kLongestKeyword));
}

// OFF, with optional prefixes for texture coordinates, colours or normals: STOFF, COFF, NOFF,
// CNOFF, ...
bool isOffKeyword(std::string_view word) {
  if (word.size() < 3 || !equalIgnoringCase(word.substr(word.size() - 3), "OFF")) return false;
  return word.substr(0, word.size() - 3).find_first_not_of("STCN") == std::string_view::npos;
}

// Recognises a broken file that should have been a binary STL, so that the message can describe the
// fault. Where it begins with "solid", it differs from ASCII only by a first header line that is
// not text.
bool isBrokenBinaryStl(std::string_view bytes, bool beginsWithSolid) {
  if (bytes.size() < kBinaryStlHeader) return false;
  const std::string_view header = bytes.substr(0, kBinaryStlHeader);
  return !isText(beginsWithSolid ? header.substr(0, header.find_first_of("\r\n")) : header);
}

struct ForeignFormat {
  std::string_view magic;
  const char* name;
};

constexpr std::array<ForeignFormat, 11> kForeignFormats = {{
    {"\x89\x43utwat", "a prepared geometry file (for MeshSDF::open)"},
    {"PK\x03\x04", "a zip archive"},
    {"\xfd\x37zXZ", "an xz archive"},
    {"BZh", "a bzip2 archive"},
    {"\x28\xb5\x2f\xfd", "a zstd archive"},
    {"\x1f\x8b", "a gzip file in a gzip file"},
    {"\x89PNG", "a PNG image"},
    {"glTF", "a glTF file"},
    {"<", "an XML file (readAnySurface() and the command read .vtp; save others as STL or PLY)"},
    {"ISO-10303-21", "a STEP file"},
    {"\x7f\x45LF", "a program"},
}};

bool isForeign(std::string_view bytes) {
  return std::any_of(
      kForeignFormats.begin(), kForeignFormats.end(),
      [bytes](const ForeignFormat& foreign) { return bytes.starts_with(foreign.magic); });
}

// The file is complete by its own count, and not text: the count of an ASCII file, read from its
// letters, is always beyond the file's end. The word "solid" in the header proves nothing; but
// where more bytes follow, another format's mark at the beginning rules out STL.
bool isCompleteBinaryStl(std::string_view bytes) {
  if (bytes.size() < kBinaryStlHeader + kBinaryStlTriangle) return false;
  const std::uint64_t count = binaryStlCount(bytes);
  const std::uint64_t size = kBinaryStlHeader + kBinaryStlTriangle * count;
  if (count == 0 || bytes.size() < size || isText(bytes.substr(80, 512))) return false;
  return bytes.size() == size || !isForeign(bytes);
}

constexpr std::string_view kVtk = "# vtk DataFile";

/// Whether the file ends before the word that some format begins with does.
bool isCutWithinFirstWord(std::string_view bytes) {
  constexpr std::array<std::string_view, 4> kFirst = {kVtk, "ply", "solid", "OFF"};
  const auto isBeginOf = [bytes](std::string_view first) {
    return bytes.size() < first.size() && equalIgnoringCase(bytes, first.substr(0, bytes.size()));
  };
  return std::any_of(kFirst.begin(), kFirst.end(), isBeginOf);
}

[[noreturn]] void failUnknown(const Content& content) {
  const TextCursor text(content);
  for (const auto& [magic, name] : kForeignFormats) {
    if (content.bytes.starts_with(magic)) {
      text.failAt({Place::Unit::Byte, 0}, std::string("this is ") + name + ", not a surface");
    }
  }
  if (isCutWithinFirstWord(content.bytes)) {
    text.failAt({Place::Unit::Byte, 0}, "the file is too short: it ends within its first word");
  }
  if (content.bytes.size() < kBinaryStlHeader) {
    text.failAt({Place::Unit::Byte, 0},
                "the file is too short: " + std::to_string(content.bytes.size()) + " of the " +
                    std::to_string(kBinaryStlHeader) +
                    " bytes of a binary STL's header; and its text begins like none of " +
                    surfaceFormats("and"));
  }
  text.failAt({Place::Unit::Byte, 0}, "the content is none of " + surfaceFormats("and"));
}

}  // namespace

Detected detectFormat(const Content& content) {
  const std::string_view bytes = content.bytes;
  if (equalIgnoringCase(bytes.substr(0, kVtk.size()), kVtk)) return {SurfaceFormat::Vtk, readVtk};
  const std::string_view word = firstWord(bytes);
  if (word == "ply") return {SurfaceFormat::Ply, readPly};
  if (isCompleteBinaryStl(bytes)) return {SurfaceFormat::Stl, readBinaryStl};
  const bool solid = equalIgnoringCase(word, "solid");
  if (solid && !isBrokenBinaryStl(bytes, solid)) return {SurfaceFormat::Stl, readAsciiStl};
  if (isOffKeyword(word)) return {SurfaceFormat::Off, readOff};
  if (isObjStatement(word)) return {SurfaceFormat::Obj, readObj};
  if (isForeign(bytes) || !isBrokenBinaryStl(bytes, solid)) failUnknown(content);
  return {SurfaceFormat::Stl, readBinaryStl};
}

}  // namespace cutwater::formats
