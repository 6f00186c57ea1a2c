#include <Cutwater/Text/Suggestion.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace cutwater::text {

namespace {

constexpr std::size_t kLongest = 64;  // longer words are not typing errors

/// Optimal string alignment, row by row of its table.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> rows(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      auto& edits = rows[i][j];
      if (i == 0 || j == 0) {
        edits = i + j;
        continue;
      }
      edits = std::min({rows[i - 1][j] + 1, rows[i][j - 1] + 1,
                        rows[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool isExchange = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (isExchange) edits = std::min(edits, rows[i - 2][j - 2] + 1);
    }
  }
  return rows[a.size()][b.size()];
}

const std::string* leastEdited(const std::string& word, const std::vector<std::string>& words) {
  std::size_t least = std::max<std::size_t>(word.size() / 3, 1) + 1;
  const std::string* nearest = nullptr;
  for (const auto& other : words) {
    const auto difference =
        word.size() < other.size() ? other.size() - word.size() : word.size() - other.size();
    if (difference >= least) continue;  // at least as many edits
    const auto edits = editDistance(word, other);
    if (edits >= least) continue;
    least = edits;
    nearest = &other;
  }
  return nearest;
}

struct Synonym {
  std::string_view said;   ///< elsewhere
  std::string_view known;  ///< what it is called here
};

/// Words that other programs use.
constexpr std::array<Synonym, 20> kSynonyms = {{
    {"box", "cuboid"},        {"block", "cuboid"},         {"brick", "cuboid"},
    {"cube", "cuboid"},       {"rectangle", "cuboid"},     {"ball", "sphere"},
    {"donut", "torus"},       {"doughnut", "torus"},       {"ring", "torus"},
    {"rod", "cylinder"},      {"pill", "capsule"},         {"egg", "ellipsoid"},
    {"check", "info"},        {"validate", "info"},        {"fix", "repair"},
    {"heal", "repair"},       {"wrap", "repair"},          {"help", "--help"},
    {"version", "--version"}, {"--resolution", "--cells"},
}};

const std::string* synonymOf(const std::string& word, const std::vector<std::string>& words) {
  for (const auto& [said, known] : kSynonyms) {
    if (said != word) continue;
    const auto found = std::ranges::find(words, known);
    if (found != words.end()) return &*found;
  }
  return nullptr;
}

const std::string* onlyOneThatBeginsWith(const std::string& word,
                                         const std::vector<std::string>& words) {
  constexpr std::size_t kFewest = 3;  // characters that tell what is meant
  const std::string* found = nullptr;
  for (const auto& other : words) {
    if (word.size() < kFewest || !other.starts_with(word)) continue;
    if (found != nullptr) return nullptr;
    found = &other;
  }
  return found;
}

}  // namespace

std::string suggestion(const std::string& word, const std::vector<std::string>& words) {
  if (word.size() > kLongest) return {};
  const auto* meant = synonymOf(word, words);
  if (meant == nullptr) meant = onlyOneThatBeginsWith(word, words);
  if (meant == nullptr) meant = leastEdited(word, words);
  return meant == nullptr ? std::string() : "; is it " + inQuotes(*meant) + "?";
}

}  // namespace cutwater::text
