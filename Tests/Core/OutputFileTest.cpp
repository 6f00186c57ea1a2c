#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>

#include <array>
#include <cstdio>
#include <memory>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

namespace fs = std::filesystem;

std::string errorOf(const auto& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::File);
    return error.what();
  }
  return "";
}

TEST(OutputFileTest, AppearsWhenCommitted) {
  const TemporaryFolder folder;
  OutputFile file(folder / "a.txt");
  file.write("first ");
  file.write("second");
  EXPECT_FALSE(fs::exists(folder / "a.txt"));
  file.commit();
  EXPECT_EQ(contentOf(folder / "a.txt"), "first second");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(OutputFileTest, LeavesTheOldFileAndNoLitterWithoutCommit) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.txt") << "old";
  {
    OutputFile file(folder / "a.txt");
    file.write("new");
  }
  EXPECT_EQ(contentOf(folder / "a.txt"), "old");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(OutputFileTest, FollowsSymbolicLinks) {
  const TemporaryFolder folder;
  std::ofstream(folder / "real.txt") << "old";
  fs::create_symlink("real.txt", folder / "link.txt");
  OutputFile file(folder / "link.txt");
  file.write("new");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(contentOf(folder / "real.txt"), "new");
}

TEST(OutputFileTest, FollowsLinksToFilesThatDoNotExistYet) {
  const TemporaryFolder folder;
  fs::create_symlink("later.txt", folder / "second");
  fs::create_symlink("second", folder / "first");
  OutputFile file(folder / "first");
  file.write("new");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(folder / "first"));
  EXPECT_TRUE(fs::is_symlink(folder / "second"));
  EXPECT_EQ(contentOf(folder / "later.txt"), "new");
}

TEST(OutputFileTest, RefusesLinksWithoutEnd) {
  const TemporaryFolder folder;
  fs::create_symlink("loop", folder / "loop");
  EXPECT_NE(errorOf([&] { OutputFile file(folder / "loop"); }), "");
  EXPECT_TRUE(fs::is_symlink(folder / "loop"));
}

// /dev/stdout may lead to one.
TEST(OutputFileTest, WritesIntoFilesThatHaveNoNameAnyMore) {
  if (!fs::exists("/proc/self/fd")) GTEST_SKIP() << "no names for open files";
  const TemporaryFolder folder;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> open(std::fopen((folder / "gone").c_str(), "w+b"),
                                                       &std::fclose);
  fs::remove(folder / "gone");
  const auto link = folder / "link";
  fs::create_symlink("/proc/self/fd/" + std::to_string(fileno(open.get())), link);
  OutputFile file(link);
  file.write("new");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(link));
  std::array<char, 8> content{};
  EXPECT_EQ(std::fread(content.data(), 1, content.size(), open.get()), 3U);
  EXPECT_STREQ(content.data(), "new");
}

TEST(OutputFileTest, WritesTheLongestNames) {
  const TemporaryFolder folder;
  const auto path = folder / std::string(255, 'n');
  OutputFile file(path);
  file.write("new");
  file.commit();
  EXPECT_EQ(contentOf(path), "new");
}

TEST(OutputFileTest, KeepsThePermissionsOfTheFileItReplaces) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.txt") << "old";
  fs::permissions(folder / "a.txt", fs::perms::owner_read | fs::perms::owner_write);
  OutputFile file(folder / "a.txt");
  file.commit();
  EXPECT_EQ(fs::status(folder / "a.txt").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(OutputFileTest, NamesThePathOfWhatFails) {
  const TemporaryFolder folder;
  const auto missing = folder / "no/such/file";
  EXPECT_NE(errorOf([&] { OutputFile file(missing); }).find(missing.string()), std::string::npos);
  fs::create_directory(folder / "folder");
  EXPECT_NE(errorOf([&] { OutputFile file(folder / "folder"); }), "");
}

TEST(OutputFileTest, TellsOfAFullDisk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no device that is always full";
  const std::string large(1 << 20, 'x');
  EXPECT_NE(errorOf([&] {
              OutputFile file("/dev/full");
              file.write(large);
              file.commit();
            }).find("/dev/full"),
            std::string::npos);
  EXPECT_NE(errorOf([] {
              OutputFile file("/dev/full");  // small: fails only as the buffer is emptied
              file.write("x");
              file.commit();
            }),
            "");
}

}  // namespace
}  // namespace cutwater::test
