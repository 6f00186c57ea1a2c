#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {

/// Puts a binary file together.
class ByteWriter {
 public:
  explicit ByteWriter(std::endian order = std::endian::little) : order_(order) {}

  ByteWriter& text(const std::string& piece) {
    bytes_ += piece;
    return *this;
  }
  template <typename Number>
  ByteWriter& numbers(std::initializer_list<Number> values) {
    for (const Number value : values) {
      char raw[sizeof(Number)];
      std::memcpy(raw, &value, sizeof(Number));
      const std::string piece(raw, sizeof(Number));
      bytes_ += order_ == std::endian::native ? piece : std::string(piece.rbegin(), piece.rend());
    }
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::endian order_;
  std::string bytes_;
};

inline SurfaceFile readText(const std::string& bytes, const ReadOptions& options = {},
                            const std::string& name = "test") {
  // A copy of exactly the right size: AddressSanitizer sees a read beyond its end.
  const std::vector<std::byte> exact(
      reinterpret_cast<const std::byte*>(bytes.data()),
      reinterpret_cast<const std::byte*>(bytes.data()) + bytes.size());
  return readSurface(exact, name, options);
}

/// What readText() says about a bad file; a test failure if it is read.
inline std::string failure(const std::string& bytes, const ReadOptions& options = {},
                           ErrorKind kind = ErrorKind::File) {
  try {
    const auto file = readText(bytes, options);
    ADD_FAILURE() << "read " << file.soup.polygonCount() << " polygons from\n" << bytes;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    return error.what();
  }
  return {};
}

/// `at` is "line 7" or "byte 84", `part` a part of the message.
inline void expectFailure(const std::string& bytes, const std::string& at, const std::string& part,
                          const ReadOptions& options = {}) {
  const std::string message = failure(bytes, options);
  EXPECT_EQ(message.substr(0, message.find(": ", 6)), "test: " + at) << message << "\n" << bytes;
  EXPECT_NE(message.find(part), std::string::npos) << message << "\n" << bytes;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

inline std::vector<std::uint32_t> corners(const PolygonSoup& soup, std::size_t polygon) {
  const auto span = soup.polygon(polygon);
  return {span.begin(), span.end()};
}

using Corners = std::vector<std::uint32_t>;

/// A binary STL of triangles (0 0 0), (1 0 0), (0 1 i).
inline std::string binaryStl(std::uint32_t triangles, std::uint32_t count,
                             const std::string& header = "") {
  ByteWriter file;
  std::string padded = header;
  padded.resize(80, '\0');
  file.text(padded).numbers<std::uint32_t>({count});
  for (std::uint32_t i = 0; i < triangles; ++i) {
    file.numbers<float>({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, static_cast<float>(i)});
    file.numbers<std::uint16_t>({static_cast<std::uint16_t>(i)});
  }
  return file.bytes();
}
inline std::string binaryStl(std::uint32_t triangles) {
  return binaryStl(triangles, triangles);
}

}  // namespace cutwater::test
