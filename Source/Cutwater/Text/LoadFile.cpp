#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Text/ChunkedBytes.hpp>
#include <Cutwater/Text/LoadFile.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace cutwater::text {

namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void failSystem(const std::string& name, const char* what, int code) {
  throw Error(ErrorKind::File, name + ": " + what + ": " + std::generic_category().message(code));
}

}  // namespace

void requireSize(const std::string& name, std::uint64_t size, std::uint64_t maxBytes) {
  if (size <= maxBytes) return;
  throw Error(ErrorKind::Limit, name + ": byte " + std::to_string(maxBytes) +
                                    ": the file is longer than the limit of " +
                                    std::to_string(maxBytes) + " bytes");
}

Bytes loadFile(const std::filesystem::path& path, std::uint64_t maxBytes) {
  const std::string name = path.string();
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) failSystem(name, "cannot read", EISDIR);
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) failSystem(name, "cannot open", errno);
  // A regular file has a size and is read in one go; the chunks handle pipes and growing files.
  std::error_code noSize;
  const std::uintmax_t expected = std::filesystem::file_size(path, noSize);
  if (!noSize) requireSize(name, expected, maxBytes);
  Bytes bytes;
  if (!noSize && expected > 0) {
    bytes.data = std::make_unique_for_overwrite<char[]>(expected);
    bytes.size = std::fread(bytes.data.get(), 1, expected, file.get());
  }
  ChunkedBytes more;
  while (std::feof(file.get()) == 0) {
    const auto chunk = more.next();
    more.filled(std::fread(chunk.data, 1, chunk.size, file.get()));
    if (std::ferror(file.get()) != 0) failSystem(name, "cannot read", errno);
    requireSize(name, bytes.size + more.size(), maxBytes);
  }
  if (more.size() == 0) return bytes;
  const std::uint64_t size = bytes.size + more.size();
  auto all = std::make_unique_for_overwrite<char[]>(size);
  std::copy_n(bytes.data.get(), bytes.size, all.get());
  const std::uint64_t moreSize = more.size();
  std::copy_n(std::move(more).joined().get(), moreSize, all.get() + bytes.size);
  return {std::move(all), size};
}

}  // namespace cutwater::text
