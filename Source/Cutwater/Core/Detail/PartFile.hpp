#pragma once

#include <cstdio>
#include <filesystem>
#include <system_error>

namespace cutwater {

/// A file under a hidden name beside its target, ".cutwater-<target>-<n>.part", until it is
/// complete and moved into place. It is locked while it is written (flock()), so that one whose
/// lock can be had is known to be left over from a process that ended.
class PartFile {
 public:
  PartFile() = default;
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  PartFile(PartFile&&) = delete;
  PartFile& operator=(PartFile&&) = delete;

  /// Creates the file and locks it. Returns it, open for writing, to be closed by the caller; null,
  /// with the reason in errno, if it cannot be created.
  std::FILE* create(const std::filesystem::path& target);
  /// Empty if there is none.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Gives the file its target's name.
  std::error_code moveTo(const std::filesystem::path& target);
  /// Removes the file, if there is one.
  void remove();

 private:
  void forget();

  std::filesystem::path path_;
  int lock_ = -1;  // a descriptor that holds the lock until the file has its name
  int entry_ = -1;
};

/// Removes the part files that this process is writing; it must then end. For handlers of signals:
/// calls nothing that they may not.
void removePartFiles() noexcept;

/// Removes part files of this target, or of what it links to, that no process writes any more.
/// Returns how many. What cannot be removed is left.
std::size_t removeStaleParts(const std::filesystem::path& path);

/// The path with symbolic links followed, also to a file that does not exist yet. Empty for a link
/// without end, or to something that has no name, as /dev/stdout may be.
[[nodiscard]] std::filesystem::path withoutLinks(std::filesystem::path path);

}  // namespace cutwater
