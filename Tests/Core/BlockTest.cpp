#include <Cutwater/Core/Block.hpp>

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

struct Record {
  double value;
  std::uint32_t id;
};

TEST(Block, GivesBackWhatWasWritten) {
  const std::vector<Record> records{{1.5, 7}, {-2.5, 8}, {0.25, 9}};
  const std::array<std::uint32_t, 2> ids{3, 4};
  const std::vector<double> nothing;
  BlockWriter writer;
  const auto first = writer.add(records);
  const auto none = writer.add(nothing);
  const auto second = writer.add(std::span<const std::uint32_t>(ids));
  const Block block = writer.finish();

  const auto found = block.array<Record>(first);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[1].value, -2.5);
  EXPECT_EQ(found[2].id, 9U);
  EXPECT_TRUE(block.array<double>(none).empty());
  EXPECT_TRUE(std::ranges::equal(block.array<std::uint32_t>(second), ids));
}

TEST(Block, StartsEveryArrayOnACacheLine) {
  const std::vector<std::byte> odd(3, std::byte{1});
  BlockWriter writer;
  for (int i = 0; i < 3; ++i) {
    const auto section = writer.add(odd);
    EXPECT_EQ(section.offset, 64U * static_cast<unsigned>(i));
    EXPECT_EQ(section.count, 3U);
  }
  const Block block = writer.finish();
  EXPECT_EQ(block.bytes().size(), 192U);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.bytes().data()) % 64, 0U);
}

TEST(Block, HoldsArraysOfManyMegabytes) {
  std::vector<std::uint32_t> ids(3'000'001);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::uint32_t>(7 * i);
  BlockWriter writer;
  const auto section = writer.add(ids);
  const Block block = writer.finish();
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.bytes().data()) % BlockWriter::kAlignment, 0U);
  EXPECT_TRUE(std::ranges::equal(block.array<std::uint32_t>(section), ids));
}

TEST(Block, OfEqualArraysIsEqualBytes) {
  const auto written = [] {
    const std::vector<std::uint32_t> ids{1, 2, 3};
    const std::vector<double> values{0.5};
    BlockWriter writer;
    writer.add(ids);
    writer.add(values);
    return writer.finish();
  };
  EXPECT_TRUE(std::ranges::equal(written().bytes(), written().bytes()));  // gaps included
}

TEST(Block, KeepsItsMemoryWhileACopyLives) {
  auto owner = std::make_shared<std::array<double, 2>>(std::array{1.0, 2.0});
  const std::weak_ptr<void> watch = owner;
  Block copy;
  {
    const Block block(owner, std::as_bytes(std::span(*owner)));
    owner.reset();
    copy = block;
  }
  ASSERT_FALSE(watch.expired());
  EXPECT_EQ(copy.array<double>({sizeof(double), 1})[0], 2.0);
  copy = {};
  EXPECT_TRUE(watch.expired());
}

TEST(Block, SharesItsMemoryWithItsParts) {
  const std::vector<std::uint32_t> ids{1, 2, 3, 4};
  const auto end = [&] {
    BlockWriter writer;
    writer.add(ids);
    return writer.finish().from(4).first(8);  // the whole block is gone
  }();
  ASSERT_EQ(end.bytes().size(), 8U);
  const auto found = end.array<std::uint32_t>({.offset = 0, .count = 2});
  EXPECT_EQ(found[0], 2U);
  EXPECT_EQ(found[1], 3U);
}

TEST(Block, CopiesBytesToWhereArraysCanStand) {
  std::vector<std::byte> bytes(1000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i);
  for (const std::size_t shift : {0U, 1U, 63U, 1000U}) {
    const auto part = std::span<const std::byte>(bytes).subspan(shift);
    const auto copy = alignedCopy(part);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(copy.bytes().data()) % BlockWriter::kAlignment, 0U);
    EXPECT_NE(copy.bytes().data(), part.data());
    EXPECT_TRUE(std::ranges::equal(copy.bytes(), part));
  }
}

}  // namespace
}  // namespace cutwater::test
