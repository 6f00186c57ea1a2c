#include <Cutwater/Text/LoadFile.hpp>
#include <Cutwater/Text/MappedFile.hpp>

#include <limits>

#if defined(__unix__) || defined(__APPLE__)
#define CUTWATER_HAS_MMAP
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace cutwater::text {

namespace {

#ifdef CUTWATER_HAS_MMAP

/// Returns nothing if the file is not regular or cannot be mapped.
Block mapped(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};  // a pipe opens only once
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return {};
  struct stat status {};
  const bool isKnown = fstat(file, &status) == 0 && status.st_size > 0;
  const auto size = static_cast<std::size_t>(isKnown ? status.st_size : 0);
  void* const start = isKnown ? mmap(nullptr, size, PROT_READ, MAP_SHARED, file, 0) : MAP_FAILED;
  close(file);  // the mapping remains valid
  if (start == MAP_FAILED) return {};
  const std::shared_ptr<const void> owner(start, [size](void* p) { munmap(p, size); });
  return {owner, {static_cast<const std::byte*>(start), size}};
}

#else

Block mapped(const std::filesystem::path&) {
  return {};
}

#endif

}  // namespace

Block mapFile(const std::filesystem::path& path) {
  if (auto block = mapped(path); !block.bytes().empty()) return block;
  const auto content = loadFile(path, std::numeric_limits<std::uint64_t>::max());
  return alignedCopy(std::as_bytes(std::span(content.view())));
}

}  // namespace cutwater::text
