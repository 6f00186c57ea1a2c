#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/CutCells/Detail/Rows/RowFile.hpp>

#include <utility>

namespace cutwater {

namespace {

constexpr std::uint32_t kOtherByteOrder = 0x04030201;

[[noreturn]] void refuse(const std::string& why) {
  throw Error(ErrorKind::File, why);
}

std::string fileOf(const RowFileKind& kind) {
  return std::string("file of cut ") + kind.rows;
}

void requireUndamaged(bool ok, const RowFileKind& kind, const char* what) {
  if (!ok) refuse("the " + fileOf(kind) + " is damaged: " + what);
}

/// Checks the head against the bytes, and returns what follows it.
std::span<const std::byte> checkedBody(std::span<const std::byte> bytes, const RowFileKind& kind) {
  if (bytes.empty()) refuse("there is nothing in it");
  RowFileHead head{.magic = kind.magic};
  std::memcpy(&head, bytes.data(), std::min(bytes.size(), sizeof(head)));
  if (head.magic != kind.magic) refuse("this is no " + fileOf(kind));
  requireUndamaged(bytes.size() >= sizeof(head), kind, "it ends within its head");
  if (head.byteOrder == kOtherByteOrder) {
    refuse("the " + fileOf(kind) + " was written on a machine with another byte order");
  }
  if (head.version != kind.version) {
    refuse("the " + fileOf(kind) + " has version " + std::to_string(head.version) +
           ", this library reads version " + std::to_string(kind.version) + ": cut the " +
           kind.rows + " anew");
  }
  requireUndamaged(head.byteOrder == RowFileHead::kByteOrder, kind, "its head is none");
  requireUndamaged(bytes.size() >= head.fileBytes, kind, "it is shorter than its head tells");
  requireUndamaged(bytes.size() <= head.fileBytes, kind, "it is longer than its head tells");
  const auto body = bytes.subspan(sizeof(head));
  requireUndamaged(checksum(body) == head.checksum, kind, "its checksum is another");
  return body;
}

}  // namespace

std::vector<std::byte> RowWriter::finish(const RowFileKind& kind) && {
  const RowFileHead head{.magic = kind.magic,
                         .version = kind.version,
                         .fileBytes = bytes_.size(),
                         .checksum = checksum(std::span(bytes_).subspan(sizeof(RowFileHead)))};
  std::memcpy(bytes_.data(), &head, sizeof(head));
  return std::move(bytes_);
}

RowReader::RowReader(std::span<const std::byte> bytes, const RowFileKind& kind)
    : kind_(kind), rest_(checkedBody(bytes, kind)) {}

void RowReader::need(bool ok, const char* what) const {
  requireUndamaged(ok, kind_, what);
}

std::uint64_t RowReader::nextWord() {
  need(rest_.size() >= kRowWord, "it ends within a number");
  std::uint64_t word = 0;
  std::memcpy(&word, take(kRowWord).data(), kRowWord);
  return word;
}

std::size_t RowReader::count(std::size_t bytes) {
  std::uint64_t count = 0;
  (*this)(count);
  need(count <= rest_.size() / bytes, "it ends within an array");
  return count;
}

std::span<const std::byte> RowReader::take(std::size_t count) {
  const auto bytes = rest_.first(count);
  rest_ = rest_.subspan(count);
  const auto filling =
      rest_.first(std::min((kRowWord - count % kRowWord) % kRowWord, rest_.size()));
  need(std::ranges::count(filling, std::byte{0}) == std::ssize(filling),
       "there is something between its arrays");
  rest_ = rest_.subspan(filling.size());
  return bytes;
}

void saveRows(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace cutwater
