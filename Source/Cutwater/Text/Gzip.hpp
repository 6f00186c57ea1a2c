#pragma once

#include <Cutwater/Text/LoadFile.hpp>

#include <span>

namespace cutwater::text {

/// Whether the bytes begin as a gzip file does.
[[nodiscard]] bool isGzip(std::string_view bytes);

/// Inflates a gzip file: all of its members, one after another.
/// @throws Error(File) if the stream is truncated or corrupt, or if the library was built without
/// zlib; Error(Limit) beyond `maxBytes`.
[[nodiscard]] Bytes gunzip(const std::string& name, std::string_view compressed,
                           std::uint64_t maxBytes);

/// Inflates a block of zlib's own format, whose size is known. Returns false unless it is intact
/// and has this size.
/// @throws Error(File) if the library was built without zlib.
[[nodiscard]] bool inflateBlock(const std::string& name, std::string_view compressed,
                                std::span<char> into);

}  // namespace cutwater::text
