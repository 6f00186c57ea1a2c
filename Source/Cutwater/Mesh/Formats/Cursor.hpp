#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cutwater::formats {

/// Where something stands in a file: a line, counted from 1, or a byte, counted from 0.
struct Place {
  enum class Unit : std::uint8_t { Line, Byte } unit = Unit::Byte;
  std::uint64_t value = 0;
};

/// A file's name and content, after decompression. Cursors refer to it; it must outlive them.
struct Content {
  std::string name;
  std::string_view bytes;
};

/// What every way of walking through a file has in common: it knows where it is, how much is left,
/// and how to complain.
class Cursor {
 public:
  explicit Cursor(const Content& content) : content_(&content) {}
  virtual ~Cursor() = default;

  [[nodiscard]] virtual Place place() const = 0;
  [[nodiscard]] std::uint64_t position() const { return position_; }
  [[nodiscard]] std::uint64_t bytesLeft() const { return bytes().size() - position_; }

  /// @throws Error(File) "name: line 7: message", here or at another place.
  [[noreturn]] void fail(const std::string& message) const { failAt(place(), message); }
  [[noreturn]] void failAt(const Place& where, const std::string& message) const;
  /// @throws Error(Limit), worded likewise.
  [[noreturn]] void failLimit(const std::string& message) const;

  /// The one check of what a file promises: fails unless `count` records of at least
  /// `smallestRecord` bytes can still follow. Text may end without its last separator: one byte
  /// short is enough. Nothing is reserved from a count that did not pass here.
  std::uint64_t requireRecords(std::int64_t count, std::uint64_t smallestRecord,
                               const char* what) const;

 protected:
  Cursor(const Cursor&) = default;
  Cursor(Cursor&&) = default;
  Cursor& operator=(const Cursor&) = default;
  Cursor& operator=(Cursor&&) = default;

  void moveTo(std::uint64_t position) { position_ = position; }
  [[nodiscard]] std::string_view bytes() const { return content_->bytes; }

 private:
  const Content* content_;
  std::uint64_t position_ = 0;
};

/// A piece of a file as it may stand in a message: short, printable; and between quotes.
[[nodiscard]] std::string shortened(std::string_view text);
[[nodiscard]] std::string quoted(std::string_view text);

}  // namespace cutwater::formats
