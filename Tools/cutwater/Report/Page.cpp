#include "Report/Page.hpp"

#include <algorithm>

namespace cutwater::tool {

namespace {

/// The end of the piece of text from `at` on that must stay on one line: a word, a number with
/// blanks between its digits, text in parentheses.
std::size_t endOfPiece(const std::string& words, std::size_t at) {
  const auto isDigit = [&](std::size_t i) {
    return i < words.size() && '0' <= words[i] && words[i] <= '9';
  };
  int depth = 0;
  for (; at < words.size(); ++at) {
    if (words[at] == '(') ++depth;
    if (words[at] == ')') --depth;
    if (words[at] == ' ' && depth <= 0 && !(isDigit(at - 1) && isDigit(at + 1))) break;
  }
  return at;
}

}  // namespace

void Page::wrapped(const std::string& head, const std::string& words) {
  constexpr std::size_t kWidth = 98;
  std::string now = head;
  bool isFresh = true;
  for (std::size_t at = 0; at < words.size();) {
    const auto end = endOfPiece(words, at);
    if (!isFresh && now.size() + 1 + end - at > kWidth) {
      plain(now);
      now.assign(head.size(), ' ');
      isFresh = true;
    }
    if (!isFresh) now += ' ';
    now.append(words, at, end - at);
    isFresh = false;
    at = end + 1;
  }
  plain(now);
}

void Page::lines(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find('\n', at), text.size());
    plain(text.substr(at, end - at));
    at = end + 1;
  }
}

}  // namespace cutwater::tool
