#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Detail/PartFile.hpp>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <random>
#include <span>
#include <string>
#include <string_view>

#if defined(__unix__) || defined(__APPLE__)
#define CUTWATER_HAS_FLOCK
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace cutwater {

namespace {

namespace fs = std::filesystem;

/// The names of part files that are being written, where a handler of signals can read them: it may
/// neither lock nor allocate. Files beyond so many are left to removeStaleParts().
struct Entry {
  enum State : int { Free, Taken, Named };
  std::atomic<int> state = Free;
  std::array<char, 4096> path{};
};
constexpr int kEntries = 16;
std::array<Entry, kEntries> entries;
static_assert(std::atomic<int>::is_always_lock_free);

/// Returns the entry's number, or -1 if there is none for this name.
int enter(const fs::path& path) {
  const auto& name = path.native();
  if (name.size() >= entries.front().path.size()) return -1;
  for (int i = 0; i < kEntries; ++i) {
    auto& entry = entries[static_cast<std::size_t>(i)];
    int expected = Entry::Free;
    if (!entry.state.compare_exchange_strong(expected, Entry::Taken)) continue;
    std::memcpy(entry.path.data(), name.c_str(), name.size() + 1);
    entry.state = Entry::Named;
    return i;
  }
  return -1;
}

/// What names of part files begin with. It is as long for any target, whose name may be as long as
/// the file system allows.
std::string beginOf(const fs::path& target) {
  const auto name = target.filename().string();
  std::array<char, 16> digits{};
  const auto hash = xxHash64(std::as_bytes(std::span(name)));
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), hash, 16).ptr;
  return ".cutwater-" + std::string(digits.data(), end) + "-";
}

constexpr std::string_view kEnd = ".part";

fs::path nameBeside(const fs::path& target) {
  std::random_device entropy;
  return target.parent_path() / (beginOf(target) + std::to_string(entropy()) + std::string(kEnd));
}

#ifdef CUTWATER_HAS_FLOCK

/// Locks the file, and keeps the lock beyond its being closed, until the result is. -1 if file
/// systems cannot; then nobody can take the file for stale.
int lockOf(std::FILE* file) {
  const int own = fileno(file);
  int locked = -1;
  do {
    locked = flock(own, LOCK_EX);
  } while (locked != 0 && errno == EINTR);
  return locked == 0 ? fcntl(own, F_DUPFD_CLOEXEC, 0) : -1;
}

/// False if the file was taken for stale before it was locked.
bool hasName(std::FILE* file) {
  struct stat status {};
  return fstat(fileno(file), &status) != 0 || status.st_nlink > 0;
}

void release(int lock) {
  if (lock >= 0) close(lock);
}

bool removeIfStale(const fs::path& part) {
  const int file = open(part.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return false;
  const bool isStale = flock(file, LOCK_EX | LOCK_NB) == 0 && unlink(part.c_str()) == 0;
  close(file);
  return isStale;
}

#else

int lockOf(std::FILE*) {
  return -1;
}
bool hasName(std::FILE*) {
  return true;
}
void release(int) {}
bool removeIfStale(const fs::path&) {
  return false;
}

#endif

}  // namespace

PartFile::~PartFile() {
  remove();
}

std::FILE* PartFile::create(const fs::path& target) {
  for (;;) {
    path_ = nameBeside(target);
    entry_ = enter(path_);
    std::FILE* const file = std::fopen(path_.c_str(), "wbx");
    if (file == nullptr) {
      const int reason = errno;
      forget();
      errno = reason;
      return nullptr;
    }
    lock_ = lockOf(file);
    if (hasName(file)) return file;
    static_cast<void>(std::fclose(file));
    forget();
  }
}

std::error_code PartFile::moveTo(const fs::path& target) {
  std::error_code error;
  fs::rename(path_, target, error);
  if (!error) forget();
  return error;
}

void PartFile::remove() {
  if (path_.empty()) return;
  std::error_code ignored;
  fs::remove(path_, ignored);
  forget();
}

void PartFile::forget() {
  if (entry_ >= 0) entries[static_cast<std::size_t>(entry_)].state = Entry::Free;
  entry_ = -1;
  release(lock_);
  lock_ = -1;
  path_.clear();
}

void removePartFiles() noexcept {
#ifdef CUTWATER_HAS_FLOCK
  for (const auto& entry : entries) {
    if (entry.state == Entry::Named) unlink(entry.path.data());
  }
#endif
}

std::size_t removeStaleParts(const fs::path& path) {
  const auto target = withoutLinks(path);
  if (target.empty()) return 0;
  const auto folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const auto begin = beginOf(target);
  std::size_t count = 0;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const auto name = entry->path().filename().string();
    if (name.starts_with(begin) && name.ends_with(kEnd) && removeIfStale(entry->path())) ++count;
  }
  return count;
}

fs::path withoutLinks(fs::path path) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  for (int n = 0; n < kMostLinks; ++n) {
    if (!fs::is_symlink(path, error)) return path;
    path = path.parent_path() / fs::read_symlink(path, error);
    if (error) return {};
  }
  return {};
}

}  // namespace cutwater
