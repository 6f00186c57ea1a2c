#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/OutputFile.hpp>

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
