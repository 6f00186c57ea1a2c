#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Detail/PartFile.hpp>

#include <atomic>
#include <csignal>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

namespace fs = std::filesystem;

/// Starts to write the file in a process of its own, and kills that.
void leavePartOf(const fs::path& path) {
  const pid_t child = fork();
  if (child == 0) {
    OutputFile file(path);
    file.write("half of");
    raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(PartFileTest, ThoseOfProcessesThatEndedAreStale) {
  const TemporaryFolder folder;
  leavePartOf(folder / "a.txt");
  leavePartOf(folder / "a.txt");
  leavePartOf(folder / "b.txt");
  ASSERT_EQ(folder.fileCount(), 3U);
  EXPECT_EQ(removeStaleParts(folder / "c.txt"), 0U);
  EXPECT_EQ(removeStaleParts(folder / "a.txt"), 2U);
  EXPECT_EQ(removeStaleParts(folder / "a.txt"), 0U);
  fs::create_symlink("b.txt", folder / "link");
  EXPECT_EQ(removeStaleParts(folder / "link"), 1U);
  EXPECT_EQ(removeStaleParts(folder / "no/such/file"), 0U);
}

TEST(PartFileTest, ThoseBeingWrittenAreNotStale) {
  const TemporaryFolder folder;
  OutputFile file(folder / "a.txt");
  OutputFile other(folder / "a.txt");
  file.write("whole");
  EXPECT_EQ(removeStaleParts(folder / "a.txt"), 0U);
  EXPECT_EQ(folder.fileCount(), 2U);
  file.commit();
  EXPECT_EQ(removeStaleParts(folder / "a.txt"), 0U);
  EXPECT_EQ(contentOf(folder / "a.txt"), "whole");
}

/// Between creating and locking a file, another process may take it for stale.
TEST(PartFileTest, FilesSurviveOthersThatClear) {
  const TemporaryFolder folder;
  std::atomic<bool> isDone = false;
  std::thread clearing([&] {
    while (!isDone) removeStaleParts(folder / "a.txt");
  });
  for (int n = 0; n < 300; ++n) {
    OutputFile file(folder / "a.txt");
    file.write(std::to_string(n));
    file.commit();
    EXPECT_EQ(contentOf(folder / "a.txt"), std::to_string(n));
  }
  isDone = true;
  clearing.join();
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(PartFileTest, HandlersOfSignalsRemoveAllThatAreBeingWritten) {
  const TemporaryFolder folder;
  {
    OutputFile first(folder / "a.txt");
    OutputFile second(folder / "b.txt");
    second.commit();
    OutputFile third(folder / "c.txt");
    EXPECT_EQ(folder.fileCount(), 3U);
    removePartFiles();
    EXPECT_EQ(folder.fileCount(), 1U);
  }
  OutputFile next(folder / "d.txt");
  next.commit();
  removePartFiles();
  EXPECT_EQ(folder.fileCount(), 2U);
}

/// More files at a time than can be remembered for handlers of signals.
TEST(PartFileTest, ManyAtATime) {
  const TemporaryFolder folder;
  std::vector<std::unique_ptr<OutputFile>> files;
  for (int n = 0; n < 40; ++n) {
    files.push_back(std::make_unique<OutputFile>(folder / std::to_string(n)));
  }
  for (auto& file : files) file->commit();
  EXPECT_EQ(folder.fileCount(), 40U);
}

}  // namespace
}  // namespace cutwater::test
