#include <Cutwater/Io/Detail/LegacyVtkArrays.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>
#include <charconv>
#include <utility>

namespace cutwater::detail {

namespace {

using text::inQuotes;
using text::ScalarType;
using text::VtkCursor;

/// A keyword for an array of this many components; 0: their number follows the name.
struct VtkAttribute {
  std::string_view keyword;
  std::uint64_t components;
};

constexpr std::array<VtkAttribute, 8> kVtkAttributes = {{{"VECTORS", 3},
                                                         {"NORMALS", 3},
                                                         {"TENSORS", 9},
                                                         {"TENSORS6", 6},
                                                         {"TEXTURE_COORDINATES", 0},
                                                         {"GLOBAL_IDS", 1},
                                                         {"PEDIGREE_IDS", 1},
                                                         {"EDGE_FLAGS", 1}}};

/// Names have %20 for a blank.
std::string decodedName(std::string_view name) {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned code = 0;
    if (name[i] == '%' && i + 2 < name.size()) {
      const char* const digits = name.data() + i + 1;
      const auto [end, error] = std::from_chars(digits, digits + 2, code, 16);
      if (error == std::errc{} && end == digits + 2) {
        result += static_cast<char>(code);
        i += 2;
        continue;
      }
    }
    result += name[i];
  }
  return result;
}

}  // namespace

void LegacyVtkArrays::begin(std::vector<DataArray>& arrays, std::size_t rows) {
  const auto count = text().integer();
  if (count < 0 || static_cast<std::uint64_t>(count) != rows) {
    text().fail("data for " + std::to_string(count) + " of " + std::to_string(rows));
  }
  arrays_ = &arrays;
  rows_ = rows;
}

bool LegacyVtkArrays::read(std::string_view keyword) {
  if (is(keyword, "FIELD")) {
    readFields();
    return true;
  }
  if (is(keyword, "LOOKUP_TABLE")) {
    skipColours();
    return true;
  }
  const bool areScalars = is(keyword, "SCALARS");
  const bool areColours = is(keyword, "COLOR_SCALARS");
  const auto* const found = std::ranges::find_if(
      kVtkAttributes, [&](const VtkAttribute& a) { return is(keyword, a.keyword); });
  if (!areScalars && !areColours && found == kVtkAttributes.end()) return false;
  if (arrays_ == nullptr) text().fail(inQuotes(keyword) + " before POINT_DATA or CELL_DATA");
  const auto name = text().word();
  if (name.empty()) text().fail("an array without a name");
  if (areScalars) {
    readScalars(name);
  } else if (areColours) {
    const auto type = file_.isBinary() ? ScalarType::UInt8 : ScalarType::Float32;
    readArray(name, type, components(text().word()));
  } else {
    const auto width = found->components == 0 ? components(text().word()) : found->components;
    readArray(name, file_.scalarType(), width);
  }
  return true;
}

std::uint64_t LegacyVtkArrays::components(std::string_view word) {
  constexpr std::int64_t kMost = 1'000'000;
  const auto count = text().toInteger(word);
  if (count < 1 || count > kMost)
    text().fail("an array of " + std::to_string(count) + " components");
  return static_cast<std::uint64_t>(count);
}

/// "SCALARS name type components", of which the last may be missing, "LOOKUP_TABLE name".
void LegacyVtkArrays::readScalars(std::string_view name) {
  const auto type = file_.scalarType();
  const auto word = text().word();
  const auto width = word.empty() ? 1 : components(word);
  const auto next = text().wordOfFile();
  if (!is(next, "LOOKUP_TABLE")) text().fail("expected LOOKUP_TABLE, found " + inQuotes(next));
  static_cast<void>(text().word());
  readArray(name, type, width);
}

/// "LOOKUP_TABLE name size", and four numbers for each colour.
void LegacyVtkArrays::skipColours() {
  const auto type = file_.isBinary() ? ScalarType::UInt8 : ScalarType::Float32;
  static_cast<void>(text().word());
  const auto count = text().requireRecords(text().integer(), 4 * file_.smallest(type), "colours");
  file_.beginData();
  for (std::uint64_t i = 0; i < 4 * count; ++i) static_cast<void>(file_.number(type));
  file_.endData();
  data_.notes.emplace_back("A table of colours is not kept.");
}

void LegacyVtkArrays::readFields() {
  file_.readFields([this](const VtkCursor::Field& field) {
    if (arrays_ != nullptr && field.tuples != rows_) {
      text().fail("the array " + inQuotes(field.name) + " has " + std::to_string(field.tuples) +
                  " rows for " + std::to_string(rows_));
    }
    addArray(arrays_ == nullptr ? data_.fieldArrays : *arrays_, field);
  });
}

void LegacyVtkArrays::readArray(std::string_view name, ScalarType type, std::uint64_t components) {
  text().requireRecords(static_cast<std::int64_t>(rows_), components * file_.smallest(type),
                        "rows");
  file_.beginData();
  addArray(*arrays_, {name, components, rows_, type});
  file_.endData();
}

/// Reads numbers that the file has room for.
void LegacyVtkArrays::addArray(std::vector<DataArray>& arrays, const VtkCursor::Field& field) {
  const auto name = decodedName(field.name);
  requireNewName(arrays, name, text());
  auto numbers = numbersOfType(field.type, field.components * field.tuples);
  std::visit([&](auto& values) { readNumbers(values, field.type); }, numbers);
  arrays.push_back({name, std::move(numbers), field.components});
}

template <typename Number>
void LegacyVtkArrays::readNumbers(std::vector<Number>& values, ScalarType type) {
  for (auto& value : values) {
    file_.beginRecord();
    if constexpr (std::is_floating_point_v<Number>) {
      value = static_cast<Number>(file_.number(type));
    } else {
      const auto number = file_.integer(type);
      if (!std::in_range<Number>(number)) {
        file_.numbers().fail(std::to_string(number) + " is out of range");
      }
      value = static_cast<Number>(number);
    }
  }
}

}  // namespace cutwater::detail
