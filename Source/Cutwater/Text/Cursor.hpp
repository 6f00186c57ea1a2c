#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cutwater::text {

/// A position in a file: a line, counted from 1, or a byte, counted from 0.
struct Place {
  enum class Unit : std::uint8_t { Line, Byte } unit = Unit::Byte;
  std::uint64_t value = 0;
};

/// A file's name and content, after decompression. Cursors refer to it; it must outlive them.
struct Content {
  std::string name;
  std::string_view bytes;
};

/// What all ways of walking through a file have in common: the current position, the number of
/// bytes left, and error messages.
class Cursor {
 public:
  explicit Cursor(const Content& content) : content_(&content) {}
  virtual ~Cursor() = default;

  [[nodiscard]] virtual Place place() const = 0;
  [[nodiscard]] std::uint64_t position() const { return position_; }
  [[nodiscard]] std::uint64_t bytesLeft() const { return bytes().size() - position_; }

  /// @throws Error(File) "name: line 7: message", for the current position or another one.
  [[noreturn]] void fail(const std::string& message) const { failAt(place(), message + remark()); }
  [[noreturn]] void failAt(const Place& where, const std::string& message) const;
  /// @throws Error(Limit), with the same wording.
  [[noreturn]] void failLimit(const std::string& message) const;

  /// The only check of the counts that a file declares: fails unless `count` records of at least
  /// `smallestRecord` bytes can still follow. Text may end without its last separator, so one byte
  /// less is enough. Nothing is reserved for a count that has not passed this check.
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
  /// What a message about the current position should say beside its cause.
  [[nodiscard]] virtual std::string remark() const { return {}; }

  const Content* content_;
  std::uint64_t position_ = 0;
};

}  // namespace cutwater::text
