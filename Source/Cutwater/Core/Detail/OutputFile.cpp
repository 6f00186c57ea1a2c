#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>

#include <cerrno>
#include <random>
#include <string>
#include <system_error>
#include <utility>

namespace cutwater {

namespace {

namespace fs = std::filesystem;

/// A hidden name in the same folder, hence on the same file system, which no other writer uses. It
/// does not grow with the target's, which may be as long as the file system allows.
fs::path nameBeside(const fs::path& target) {
  std::random_device entropy;
  return target.parent_path() / (".cutwater-" + std::to_string(entropy()) + ".part");
}

/// The path with symbolic links followed, also to a file that does not exist yet. Empty for a link
/// without end, or to something that has no name, as /dev/stdout may be.
fs::path resolved(fs::path path) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  for (int n = 0; n < kMostLinks; ++n) {
    if (!fs::is_symlink(path, error)) return path;
    path = path.parent_path() / fs::read_symlink(path, error);
    if (error) return {};
  }
  return {};
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)), target_(resolved(path_)) {
  std::error_code ignored;
  const auto status = fs::status(path_, ignored);
  const bool isNamed = !target_.empty() && fs::exists(target_, ignored) == fs::exists(status);
  const bool inPlace = !isNamed || (fs::exists(status) && !fs::is_regular_file(status));
  if (!inPlace) temporary_ = nameBeside(target_);
  const auto& name = inPlace ? path_ : temporary_;
  file_.reset(std::fopen(name.c_str(), inPlace ? "wb" : "wbx"));
  if (!file_) fail("cannot create", errno);
  if (!inPlace && fs::exists(status)) fs::permissions(temporary_, status.permissions(), ignored);
}

OutputFile::~OutputFile() {
  file_.reset();
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
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
  if (temporary_.empty()) return;
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail("cannot put in place", error.value());
  temporary_.clear();
}

void OutputFile::fail(const char* what, int systemError) const {
  throw Error(ErrorKind::File, path_.string() + ": " + what + ": " +
                                   std::error_code(systemError, std::generic_category()).message());
}

}  // namespace cutwater
