#pragma once

#include <Cutwater/Surface/Formats/SoupBuilder.hpp>

namespace cutwater::formats {

/// Each passes the whole content to the builder and returns its result; all throw Error(File) with
/// the line or byte.
SurfaceFile readAsciiStl(const Content& content, SoupBuilder& builder);
SurfaceFile readBinaryStl(const Content& content, SoupBuilder& builder);
SurfaceFile readObj(const Content& content, SoupBuilder& builder);
SurfaceFile readPly(const Content& content, SoupBuilder& builder);
SurfaceFile readOff(const Content& content, SoupBuilder& builder);
SurfaceFile readVtk(const Content& content, SoupBuilder& builder);

/// The type of the functions above.
using Reader = SurfaceFile (*)(const Content& content, SoupBuilder& builder);

struct Detected {
  SurfaceFormat format;
  Reader reader;
};

/// Returns the format and the reader for the content; the file's name is ignored.
/// @throws Error(File) for content in none of the formats.
[[nodiscard]] Detected detectFormat(const Content& content);

/// Whether a word begins a statement of OBJ.
[[nodiscard]] bool isObjStatement(std::string_view word);

/// The triangle count in a binary STL's header, whether it is one or not. Needs 84 bytes.
[[nodiscard]] std::uint32_t binaryStlCount(std::string_view bytes);

inline constexpr std::uint64_t kBinaryStlHeader = 84;
inline constexpr std::uint64_t kBinaryStlTriangle = 50;

}  // namespace cutwater::formats
