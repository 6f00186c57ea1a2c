#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/PointData.hpp>

#include <bit>
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {

/// Points in a file.
class PointFile : public ::testing::Test {
 protected:
  [[nodiscard]] PointData read(const std::string& bytes) const {
    return readPointData(std::as_bytes(std::span(bytes)), "points");
  }
  /// The message, without the file's name.
  [[nodiscard]] std::string refusal(const std::string& bytes) const {
    try {
      static_cast<void>(read(bytes));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::File);
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with("points: ")) << message;
      return message.substr(8);
    }
    return "nothing";
  }
  /// The data, written as a file of this name and read again.
  [[nodiscard]] PointData again(const PointData& data, const std::string& name) const {
    writePointData(folder / name, data);
    return readPointData(folder / name);
  }
  /// What writing as a file of this name is refused with; it must leave nothing behind.
  [[nodiscard]] std::string writeRefusal(const PointData& data, const std::string& name) const {
    const auto before = folder.fileCount();
    std::string message;
    try {
      writePointData(folder / name, data);
    } catch (const Error& error) {
      message = error.what();
    }
    EXPECT_EQ(folder.fileCount(), before);
    return message;
  }

  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "points";
};

/// All numbers of an array, as doubles.
inline std::vector<double> numbersOf(const DataArray& array) {
  return std::visit(
      [](const auto& values) { return std::vector<double>(values.begin(), values.end()); },
      array.numbers);
}

inline void expectSameData(const PointData& a, const PointData& b) {
  EXPECT_EQ(a.mesh, b.mesh);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.singlePrecision, b.singlePrecision);
  EXPECT_EQ(a.pointArrays, b.pointArrays);
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.cellArrays, b.cellArrays);
  EXPECT_EQ(a.fieldArrays, b.fieldArrays);
}

/// The bytes of numbers, in either order.
template <typename Number>
std::string bytesOf(std::initializer_list<Number> numbers,
                    std::endian order = std::endian::little) {
  std::string bytes;
  for (const auto number : numbers) {
    char raw[sizeof(Number)];
    std::memcpy(raw, &number, sizeof(Number));
    if (order != std::endian::native) std::reverse(std::begin(raw), std::end(raw));
    bytes.append(raw, sizeof(Number));
  }
  return bytes;
}

}  // namespace cutwater::test
