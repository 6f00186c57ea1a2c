#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#if defined(__unix__) || defined(__APPLE__)
#define CUTWATER_HAS_RLIMIT
#include <sys/resource.h>
#endif

namespace cutwater {

namespace {

namespace fs = std::filesystem;

/// The system's words, with the limit where it is one that was set for this process.
std::string wordsFor(int systemError) {
  std::string words = std::error_code(systemError, std::generic_category()).message();
#ifdef CUTWATER_HAS_RLIMIT
  rlimit limit{};
  if (systemError == EFBIG && getrlimit(RLIMIT_FSIZE, &limit) == 0 &&
      limit.rlim_cur != RLIM_INFINITY) {
    words += ": files of this process are limited to " + std::to_string(limit.rlim_cur) +
             " bytes (ulimit -f)";
  }
#endif
  return words;
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)), target_(withoutLinks(path_)) {
  std::error_code ignored;
  const auto status = fs::status(path_, ignored);
  const bool isNamed = !target_.empty() && fs::exists(target_, ignored) == fs::exists(status);
  const bool inPlace = !isNamed || (fs::exists(status) && !fs::is_regular_file(status));
  file_.reset(inPlace ? std::fopen(path_.c_str(), "wb") : part_.create(target_));
  if (!file_) fail("cannot create", errno);
  if (!inPlace && fs::exists(status)) fs::permissions(part_.path(), status.permissions(), ignored);
}

OutputFile::~OutputFile() {
  file_.reset();
  part_.remove();
}

void OutputFile::write(std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) {
    fail("cannot write", errno);
  }
}

void OutputFile::write(std::string_view text) {
  write(std::as_bytes(std::span(text)));
}

void OutputFile::commit() {
  if (std::fclose(file_.release()) != 0) fail("cannot write", errno);
  if (part_.path().empty()) return;
  if (const auto error = part_.moveTo(target_)) fail("cannot put in place", error.value());
}

void OutputFile::fail(const char* what, int systemError) const {
  throw Error(ErrorKind::File, path_.string() + ": " + what + ": " + wordsFor(systemError));
}

}  // namespace cutwater
