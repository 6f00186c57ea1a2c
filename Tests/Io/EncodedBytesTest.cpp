#include <Cutwater/Io/Detail/EncodedBytes.hpp>

#include <string>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using detail::EncodedBytes;
using Encoding = EncodedBytes::Encoding;

/// The first bytes of a text in base64, or "refused".
std::string decoded(std::string_view text, std::size_t count) {
  EncodedBytes bytes(text, Encoding::Base64);
  std::string result(count, '?');
  return bytes.read(result) ? result : "refused";
}

/// The examples of RFC 4648, section 10.
TEST(EncodedBytesTest, DecodesTheExamplesOfItsDescription) {
  EXPECT_EQ(decoded("", 0), "");
  EXPECT_EQ(decoded("Zg==", 1), "f");
  EXPECT_EQ(decoded("Zm8=", 2), "fo");
  EXPECT_EQ(decoded("Zm9v", 3), "foo");
  EXPECT_EQ(decoded("Zm9vYg==", 4), "foob");
  EXPECT_EQ(decoded("Zm9vYmE=", 5), "fooba");
  EXPECT_EQ(decoded("Zm9vYmFy", 6), "foobar");
  EXPECT_EQ(decoded("//79+/A=", 5), "\xff\xfe\xfd\xfb\xf0");
}

TEST(EncodedBytesTest, BlanksAndPaddingMayStandBetweenGroups) {
  EXPECT_EQ(decoded(" Zm\n9v\r\n\tYmFy \n", 6), "foobar");
  EXPECT_EQ(decoded("Zg==Zm8=Zm9v", 6), "ffofoo");
}

TEST(EncodedBytesTest, ReadsInPiecesAndKnowsItsEnd) {
  EncodedBytes bytes("Zm9vYmE= ", Encoding::Base64);
  EXPECT_EQ(bytes.mostLeft(), 6U);
  std::string one(1, ' ');
  std::string all;
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(bytes.isAtEnd());
    EXPECT_TRUE(bytes.read(one));
    all += one;
  }
  EXPECT_EQ(all, "fooba");
  EXPECT_TRUE(bytes.isAtEnd());
  EXPECT_FALSE(bytes.read(one));
}

TEST(EncodedBytesTest, RefusesWhatIsNoBase64) {
  for (const char* text :
       {"Zg", "Zg=", "Z===", "====", "Z-==", "Zm9!", "Zg=a", "Zh==", "Zm9=", "\xffm9v"}) {
    EXPECT_EQ(decoded(text, 1), "refused") << text;
  }
  EXPECT_EQ(decoded("Zm9v", 4), "refused");
}

TEST(EncodedBytesTest, RawBytesAreTakenAsTheyStand) {
  EncodedBytes bytes(" =a", Encoding::Raw);
  EXPECT_EQ(bytes.mostLeft(), 3U);
  std::string two(2, ' ');
  EXPECT_TRUE(bytes.read(two));
  EXPECT_EQ(two, " =");
  EXPECT_FALSE(bytes.isAtEnd());
  EXPECT_FALSE(bytes.read(two));
}

}  // namespace
}  // namespace cutwater::test
