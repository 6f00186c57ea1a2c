#pragma once

#include <Cutwater/Core/Detail/PartFile.hpp>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace cutwater {

/// A file that appears under its name only once it is complete: it is written to a temporary file
/// beside it, which commit() renames. Without commit() nothing remains, and an existing file of
/// that name is unchanged. Anything existing that is not a regular file with a name (a pipe, a
/// device, a link to a deleted file) is written in place.
class OutputFile {
 public:
  /// @throws Error(File) if it cannot be created.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile(OutputFile&&) = delete;
  OutputFile& operator=(OutputFile&&) = delete;

  /// Writes through a buffer. @throws Error(File), e.g. when the disk is full.
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  /// @throws Error(File) if the content could not be stored or moved into place.
  void commit();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
  };

  [[noreturn]] void fail(const char* what, int systemError) const;

  std::filesystem::path path_;
  std::filesystem::path target_;  // path_ with symbolic links followed
  PartFile part_;                 // without a path: written in place
  std::unique_ptr<std::FILE, Closer> file_;
};

}  // namespace cutwater
