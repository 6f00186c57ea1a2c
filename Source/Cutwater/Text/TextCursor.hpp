#pragma once

#include <Cutwater/Text/Cursor.hpp>

namespace cutwater::text {

/// Splits text into lines and words for all ASCII formats.
///
/// Lines end with LF, CRLF or a lone CR; words are separated by spaces, tabs, vertical tabs and
/// form feeds. A NUL byte is refused with its line number, and so is a line beyond 64 kB unless
/// long ones are allowed: so a binary file is never taken for text. Every byte is examined a fixed
/// number of times.
class TextCursor final : public Cursor {
 public:
  /// Where a # begins a comment, which extends to the end of the line.
  enum class Comments : std::uint8_t { None, AtWords, Anywhere };
  struct Rules {
    Comments comments = Comments::None;
    bool continuation = false;  ///< a line that ends with \ continues on the next
  };
  static constexpr std::uint64_t kLongestLine = std::uint64_t{64} << 10U;

  explicit TextCursor(const Content& content) : TextCursor(content, Rules{}) {}
  TextCursor(const Content& content, const Rules& rules) : Cursor(content), rules_(rules) {}

  /// The line, or the byte if the text is part of a binary file.
  Place place() const override;
  void reportBytes() { unit_ = Place::Unit::Byte; }
  /// For formats in which an array may be one line.
  void allowLongLines() { longestLine_ = bytes().size(); }

  /// Goes to the beginning of the next line; false at the end of the file.
  bool nextLine();
  /// Goes to the next line that has a word; false at the end of the file.
  bool nextFilledLine();
  /// Continues reading behind binary data.
  void seek(std::uint64_t position);
  /// Where the bytes behind the current line begin.
  [[nodiscard]] std::uint64_t nextLineBegin() const { return next_; }

  /// The next word of this line (and of those that continue it); empty at its end.
  std::string_view word();
  /// The next word of the file; fails at its end.
  std::string_view wordOfFile();
  /// The same, but empty at the end of the file.
  std::string_view wordOfFileOrNone();
  /// The rest of this line without leading and trailing blanks.
  std::string_view rest();
  /// Skips the rest of this line and those that continue it.
  void skipLine();

  /// The next word of this line as a number; fails if there is none. NaN and infinity are numbers
  /// here: code that uses the value as a coordinate refuses them.
  double number() { return toNumber(word()); }
  std::int64_t integer() { return toInteger(word()); }
  [[nodiscard]] double toNumber(std::string_view word) const;
  [[nodiscard]] std::int64_t toInteger(std::string_view word) const;

  /// Fails unless the rest of the line is numbers (colours, normals, ..., which are not kept).
  void skipNumbers();
  /// Fails if the line has another word.
  void requireLineEnd();

 private:
  [[nodiscard]] std::string remark() const override;
  [[nodiscard]] std::uint64_t findLineEnd(std::uint64_t begin) const;
  void skipTerminator();
  void skipBlanks();

  Rules rules_;
  Place::Unit unit_ = Place::Unit::Line;
  std::uint64_t longestLine_ = kLongestLine;
  std::uint64_t line_ = 0;
  std::uint64_t lineEnd_ = 0;
  std::uint64_t next_ = 0;
  bool continued_ = false;
  // The first line ended with a lone CR: then an LF behind a CR is data.
  bool loneReturns_ = false;
};

/// A word as a number of this type, in the C locale; messages name the cursor's place. NaN and
/// infinity are floating-point numbers.
/// @throws Error(File) if it is none, or out of the type's range.
template <typename Number>
[[nodiscard]] Number numberOf(const Cursor& at, std::string_view word);

/// The text without the byte order mark that some programs put before UTF-8.
[[nodiscard]] std::string_view withoutByteOrderMark(std::string_view text);

}  // namespace cutwater::text
