#pragma once

#include <Cutwater/Mesh/Formats/SoupBuilder.hpp>

namespace cutwater::formats {

/// Each feeds the whole content to the builder and returns what that makes of it; all of them
/// throw Error(File) with the line or byte.
SurfaceFile readAsciiStl(const Content& content, SoupBuilder& builder);
SurfaceFile readBinaryStl(const Content& content, SoupBuilder& builder);
SurfaceFile readObj(const Content& content, SoupBuilder& builder);
SurfaceFile readPly(const Content& content, SoupBuilder& builder);
SurfaceFile readOff(const Content& content, SoupBuilder& builder);
SurfaceFile readVtk(const Content& content, SoupBuilder& builder);

/// A function above.
using Reader = SurfaceFile (*)(const Content& content, SoupBuilder& builder);

struct Detected {
  SurfaceFormat format;
  Reader reader;
};

/// Which reader the content calls for; the file's name plays no role.
/// @throws Error(File) for content that is none of the formats.
[[nodiscard]] Detected detectFormat(const Content& content);

/// The statements of OBJ, by their first word.
[[nodiscard]] bool isObjStatement(std::string_view word);

/// The number of triangles in a binary STL's header, whether it is one or not. Needs 84 bytes.
[[nodiscard]] std::uint32_t binaryStlCount(std::string_view bytes);

inline constexpr std::uint64_t kBinaryStlHeader = 84;
inline constexpr std::uint64_t kBinaryStlTriangle = 50;

}  // namespace cutwater::formats
