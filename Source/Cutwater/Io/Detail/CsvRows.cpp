#include <Cutwater/Io/Detail/CsvRows.hpp>
#include <Cutwater/Text/Gzip.hpp>
#include <Cutwater/Text/Words.hpp>

#include <cmath>

namespace cutwater::detail {

namespace {

text::Bytes load(const std::filesystem::path& path, std::uint64_t maxBytes) {
  auto bytes = text::loadFile(path, maxBytes);
  if (!text::isGzip(bytes.view())) return bytes;
  return text::gunzip(path.string(), bytes.view(), maxBytes);
}

std::string_view trimmed(std::string_view field) {
  constexpr std::string_view kBlanks = " \t\v\f";
  const auto first = field.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return field.substr(first, field.find_last_not_of(kBlanks) + 1 - first);
}

}  // namespace

CsvRows::CsvRows(const std::filesystem::path& path, std::uint64_t maxBytes)
    : bytes_(load(path, maxBytes)),
      content_{path.string(), text::withoutByteOrderMark(bytes_.view())},
      text_(content_, {.comments = text::TextCursor::Comments::AtWords}) {}

CsvRows::CsvRows(const text::Content& content)
    : content_(content), text_(content_, {.comments = text::TextCursor::Comments::AtWords}) {}

bool CsvRows::next() {
  if (!text_.nextFilledLine()) return false;
  fields_.clear();
  auto rest = text_.rest();
  for (auto comma = rest.find(','); comma != std::string_view::npos; comma = rest.find(',')) {
    fields_.push_back(trimmed(rest.substr(0, comma)));
    rest.remove_prefix(comma + 1);
  }
  fields_.push_back(trimmed(rest));
  return true;
}

double CsvRows::numberOrNan(std::size_t field) const {
  if (fields_[field].empty()) fail("field " + std::to_string(field + 1) + " is empty");
  return text_.toNumber(fields_[field]);
}

double CsvRows::number(std::size_t field) const {
  const double value = numberOrNan(field);
  if (!std::isfinite(value)) fail("need finite numbers, found " + text::inQuotes(fields_[field]));
  return value;
}

std::uint32_t CsvRows::index(std::size_t field, std::size_t count, const char* what) const {
  if (fields_[field].empty()) fail("field " + std::to_string(field + 1) + " is empty");
  const auto value = text_.toInteger(fields_[field]);
  if (value < 0 || static_cast<std::uint64_t>(value) >= count) {
    fail("there is no " + std::string(what) + " " + std::to_string(value) + " among the " +
         std::to_string(count) + " before");
  }
  return static_cast<std::uint32_t>(value);
}

void CsvRows::requireFields(std::size_t count) const {
  if (fields_.size() == count) return;
  fail("need " + std::to_string(count) + " fields, found " + std::to_string(fields_.size()));
}

}  // namespace cutwater::detail
