#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Text/ByteCursor.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using text::ByteCursor;
using text::Content;
using text::ScalarType;

template <typename Action>
std::string byteRefusal(std::string_view bytes, const Action& action) {
  const Content content{"it", bytes};
  ByteCursor cursor(content, std::endian::little);
  try {
    action(cursor);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::File);
    return error.what();
  }
  return "none";
}

TEST(ByteCursorTest, ReadsEitherByteOrder) {
  const Content content{"it", std::string_view("\x01\x02\x00\x00\x80\x3f", 6)};
  ByteCursor little(content, std::endian::little);
  EXPECT_EQ(little.read<std::uint16_t>(), 0x0201);
  EXPECT_EQ(little.number(ScalarType::Float32), 1);
  EXPECT_EQ(little.bytesLeft(), 0U);
  ByteCursor big(content, std::endian::big);
  EXPECT_EQ(big.integer(ScalarType::Int16), 0x0102);
  big.seek(4);
  EXPECT_EQ(big.integer(ScalarType::Int16), -0x7fc1);
}

TEST(ByteCursorTest, KnowsItsTypes) {
  EXPECT_EQ(text::sizeOf(ScalarType::UInt8), 1U);
  EXPECT_EQ(text::sizeOf(ScalarType::Float64), 8U);
  EXPECT_TRUE(text::isInteger(ScalarType::UInt64));
  EXPECT_FALSE(text::isInteger(ScalarType::Float32));
}

TEST(ByteCursorTest, RefusalsNameTheRecord) {
  const auto readRecord = [](ByteCursor& cursor) {
    cursor.skip(1);
    cursor.beginRecord();
    static_cast<void>(cursor.read<std::uint8_t>());
    static_cast<void>(cursor.read<std::uint32_t>());
  };
  EXPECT_EQ(byteRefusal("abcdef", readRecord), "none");
  EXPECT_EQ(byteRefusal("abcde", readRecord), "it: byte 1: the file ends too early");
  const auto skipThree = [](ByteCursor& cursor) { cursor.skip(3); };
  EXPECT_EQ(byteRefusal("ab", skipThree), "it: byte 0: the file ends too early");
  const auto readLargest = [](ByteCursor& cursor) {
    static_cast<void>(cursor.integer(ScalarType::UInt64));
  };
  EXPECT_EQ(byteRefusal(std::string(8, '\xff'), readLargest),
            "it: byte 0: 18446744073709551615 is out of range");
}

TEST(ByteCursorTest, OnlyPaddingMayFollow) {
  const auto end = [](ByteCursor& cursor) {
    cursor.skip(1);
    cursor.requireOnlyPadding();
  };
  EXPECT_EQ(byteRefusal(std::string_view("a\0 \n", 4), end), "none");
  EXPECT_EQ(byteRefusal("a \nb", end),
            "it: byte 3: data behind the last element: a count in the header is too small");
}

}  // namespace
}  // namespace cutwater::test
