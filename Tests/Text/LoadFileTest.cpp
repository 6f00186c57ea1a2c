#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Text/ChunkedBytes.hpp>
#include <Cutwater/Text/LoadFile.hpp>

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

TEST(LoadFileTest, ReadsTheWholeFileUpToItsLimit) {
  const TemporaryFolder folder;
  const auto path = folder / "a";
  const std::string content = std::string("a\0b\n", 4) + std::string(100'000, 'c');
  std::ofstream(path, std::ios::binary) << content;
  EXPECT_EQ(text::loadFile(path, content.size()).view(), content);
  try {
    static_cast<void>(text::loadFile(path, content.size() - 1));
    ADD_FAILURE() << "read more than the limit";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Limit);
  }
  EXPECT_THROW(static_cast<void>(text::loadFile(folder / "missing", 1)), Error);
  EXPECT_THROW(static_cast<void>(text::loadFile(folder / "", 1)), Error);
}

TEST(LoadFileTest, ChunksAreJoinedInOrder) {
  text::ChunkedBytes bytes;
  std::string expected;
  for (const char letter : {'a', 'b', 'c'}) {
    const auto chunk = bytes.next();
    const std::size_t used = chunk.size - static_cast<std::size_t>(letter - 'a');
    std::fill_n(chunk.data, used, letter);
    bytes.filled(used);
    expected.append(used, letter);
  }
  ASSERT_EQ(bytes.size(), expected.size());
  const auto size = static_cast<std::size_t>(bytes.size());
  const auto all = std::move(bytes).joined();
  EXPECT_EQ(std::string_view(all.get(), size), expected);
}

}  // namespace
}  // namespace cutwater::test
