#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/CsvRows.hpp>
#include <Cutwater/Io/Detail/PointFormats.hpp>
#include <Cutwater/Text/Words.hpp>

#include <charconv>
#include <optional>

// Points as text tables.

namespace cutwater::detail {

namespace {

std::string_view unquoted(std::string_view name) {
  const bool isQuoted = name.size() >= 2 && name.front() == '"' && name.back() == '"';
  return isQuoted ? name.substr(1, name.size() - 2) : name;
}

bool isNumber(std::string_view field) {
  double value = 0;
  if (field.starts_with('+')) field.remove_prefix(1);
  const char* const end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, value);
  return result.ec != std::errc::invalid_argument && result.ptr == end;
}

/// Which columns are the coordinates, and what the others are called.
class Columns {
 public:
  explicit Columns(const CsvRows& rows) : count_(rows.fields()) {
    constexpr std::size_t kMost = 1024;  // what is kept for each is much longer than a column
    if (count_ > kMost) rows.fail("more than " + std::to_string(kMost) + " columns");
    bool hasNames = false;
    for (std::size_t i = 0; i < count_; ++i) hasNames = hasNames || !isNumber(rows.text(i));
    if (hasNames) {
      readNames(rows);
    } else {
      number(rows);
    }
  }

  [[nodiscard]] bool areNamed() const { return areNamed_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const std::array<std::size_t, 3>& coordinates() const { return coordinates_; }
  /// For each column; nothing for coordinates.
  [[nodiscard]] const std::vector<std::optional<std::string>>& names() const { return names_; }

 private:
  void readNames(const CsvRows& rows) {
    areNamed_ = true;
    names_.resize(count_);
    for (std::size_t i = 0; i < count_; ++i) names_[i] = unquoted(rows.text(i));
    const bool isParaView = find("Points:0") < count_;
    const std::array<const char*, 3> wanted =
        isParaView ? std::array{"Points:0", "Points:1", "Points:2"} : std::array{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      coordinates_[axis] = find(wanted[axis]);
      if (coordinates_[axis] == count_) {
        rows.fail("need columns named x, y and z, with commas between them; there is no " +
                  std::string(wanted[axis]));
      }
    }
    for (const auto column : coordinates_) names_[column].reset();
    checkNames(rows);
  }

  /// The first column of this name, or their number.
  [[nodiscard]] std::size_t find(std::string_view name) const {
    std::size_t column = 0;
    while (column < count_ && !text::equalIgnoringCase(*names_[column], name)) ++column;
    return column;
  }

  void checkNames(const CsvRows& rows) const {
    std::vector<std::string_view> sorted;
    for (std::size_t i = 0; i < count_; ++i) {
      if (!names_[i]) continue;
      if (names_[i]->empty()) rows.fail("column " + std::to_string(i + 1) + " has no name");
      sorted.push_back(*names_[i]);
    }
    std::ranges::sort(sorted);
    const auto twice = std::ranges::adjacent_find(sorted);
    if (twice != sorted.end()) rows.fail("two columns named " + text::inQuotes(*twice));
  }

  void number(const CsvRows& rows) {
    if (count_ < 3) rows.fail("need at least 3 fields, found " + std::to_string(count_));
    coordinates_ = {0, 1, 2};
    names_.resize(count_);
    for (std::size_t i = 3; i < count_; ++i) names_[i] = "column " + std::to_string(i + 1);
  }

  std::size_t count_;
  bool areNamed_ = false;
  std::array<std::size_t, 3> coordinates_{};
  std::vector<std::optional<std::string>> names_;
};

bool fitsTable(std::string_view name) {
  return name.find_first_of(",\"\r\n") == std::string_view::npos && !name.starts_with('#');
}

}  // namespace

PointData readPointTable(const text::Content& content, std::uint64_t /*maxBytes*/) {
  CsvRows rows(content);
  if (!rows.next()) rows.fail("the file ends without a point");
  const Columns columns(rows);
  if (columns.areNamed() && !rows.next()) rows.fail("the file ends without a point");
  PointData data;
  std::vector<std::vector<double>> values(columns.count());
  do {
    rows.requireFields(columns.count());
    const auto& [x, y, z] = columns.coordinates();
    data.points.emplace_back(rows.number(x), rows.number(y), rows.number(z));
    for (std::size_t i = 0; i < columns.count(); ++i) {
      if (columns.names()[i]) values[i].push_back(rows.numberOrNan(i));
    }
  } while (rows.next());
  for (std::size_t i = 0; i < columns.count(); ++i) {
    if (columns.names()[i]) data.pointArrays.push_back({*columns.names()[i], std::move(values[i])});
  }
  return data;
}

void requireFitsTable(const PointData& data, const std::string& name) {
  if (data.cells.count() > 0) {
    throw Error(ErrorKind::Argument, name + ": tables hold points only, and the data have cells");
  }
  for (const auto& array : data.pointArrays) {
    if (fitsTable(array.name)) continue;
    throw Error(ErrorKind::Argument, name + ": the name of the array " +
                                         text::inQuotes(array.name) + " does not fit a table");
  }
}

void writePointTable(text::Output& out, const PointData& data) {
  out << "x,y,z";
  for (const auto& array : data.pointArrays) {
    for (const auto& column : columnNames(array)) out << ',' << column;
  }
  out << '\n';
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const auto& p = data.points[i];
    out << p.x << ',' << p.y << ',' << p.z;
    for (const auto& [ignored, numbers, components] : data.pointArrays) {
      std::visit(
          [&, each = components](const auto& values) {
            for (std::size_t k = i * each; k < (i + 1) * each; ++k) {
              out << ',';
              out.decimal(values[k]);
            }
          },
          numbers);
    }
    out << '\n';
  }
}

}  // namespace cutwater::detail
