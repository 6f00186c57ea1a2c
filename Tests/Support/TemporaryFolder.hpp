#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>

namespace cutwater::test {

/// A folder's files by their names.
class Folder {
 public:
  explicit Folder(std::filesystem::path path) : path_(std::move(path)) {}

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }
  [[nodiscard]] std::size_t fileCount() const {
    const std::filesystem::directory_iterator files(path_);
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }

 private:
  std::filesystem::path path_;
};

/// An empty folder that is removed with everything in it.
class TemporaryFolder : public Folder {
 public:
  TemporaryFolder() : Folder(unusedPath()) { std::filesystem::create_directory(path()); }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path(), ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;

 private:
  static std::filesystem::path unusedPath() {
    std::random_device entropy;
    return std::filesystem::temp_directory_path() /
           ("cutwater-test-" + std::to_string(entropy()) + std::to_string(entropy()));
  }
};

inline std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace cutwater::test
