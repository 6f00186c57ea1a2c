#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/PointFormats.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>
#include <charconv>
#include <optional>

// NumPy's format: "numpy.lib.format", https://numpy.org/doc/stable/reference/generated/
// numpy.lib.format.html. A magic word, the version, the length of a header, the header, which is a
// dictionary in Python's notation, and the numbers.

namespace cutwater::detail {

namespace {

using text::inQuotes;

constexpr std::string_view kMagic = "\x93NUMPY";

/// Reads the dictionary, in which every key must occur once.
class NpyHeader {
 public:
  NpyHeader(std::string_view header, const text::Cursor& at) : rest_(header), at_(at) {}

  void read() {
    expect("{");
    while (!accepts("}")) {
      const auto key = quoted();
      expect(":");
      readValue(key);
      if (!accepts(",")) {
        expect("}");
        break;
      }
    }
    skipBlanks();
    if (!rest_.empty()) at_.fail("expected the end of the header, found " + inQuotes(rest_));
    if (!type_ || !columnMajor_ || !shape_) {
      at_.fail("the header needs 'descr', 'fortran_order' and 'shape'");
    }
  }

  [[nodiscard]] std::string_view type() const { return *type_; }
  [[nodiscard]] bool isColumnMajor() const { return *columnMajor_; }
  [[nodiscard]] const std::vector<std::uint64_t>& shape() const { return *shape_; }

 private:
  void readValue(std::string_view key) {
    if (key == "descr" && !type_) {
      skipBlanks();
      if (rest_.starts_with('[')) at_.fail("structures are not read, only arrays of numbers");
      type_ = quoted();
    } else if (key == "fortran_order" && !columnMajor_) {
      columnMajor_ = accepts("True");
      if (!*columnMajor_) expect("False");
    } else if (key == "shape" && !shape_) {
      shape_ = tuple();
    } else {
      at_.fail("unexpected key " + inQuotes(key));
    }
  }

  void skipBlanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\n"), rest_.size()));
  }
  bool accepts(std::string_view word) {
    skipBlanks();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  void expect(std::string_view word) {
    if (!accepts(word)) at_.fail("expected " + inQuotes(word) + ", found " + inQuotes(rest_));
  }

  std::string_view quoted() {
    const std::string_view mark = accepts("\"") ? "\"" : "'";
    if (mark == "'") expect(mark);
    const auto end = rest_.find(mark);
    if (end == std::string_view::npos) at_.fail("a text without end in the header");
    const auto text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return text;
  }

  std::vector<std::uint64_t> tuple() {
    std::vector<std::uint64_t> numbers;
    expect("(");
    while (!accepts(")")) {
      std::uint64_t number = 0;
      skipBlanks();
      const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
      if (error != std::errc{}) at_.fail("expected a number, found " + inQuotes(rest_));
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
      numbers.push_back(number);
      if (!accepts(",")) {
        expect(")");
        break;
      }
    }
    return numbers;
  }

  std::string_view rest_;
  const text::Cursor& at_;
  std::optional<std::string_view> type_;
  std::optional<bool> columnMajor_;
  std::optional<std::vector<std::uint64_t>> shape_;
};

std::string shapeText(const std::vector<std::uint64_t>& shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(shape[i]);
  }
  return text + (shape.size() == 1 ? ",)" : ")");
}

/// The length of the header, which stands behind the magic word.
std::uint64_t headerLength(text::ByteCursor& bytes) {
  const auto major = bytes.read<std::uint8_t>();
  const auto minor = bytes.read<std::uint8_t>();
  if (major < 1 || major > 3 || minor != 0) {
    bytes.fail("version " + std::to_string(major) + "." + std::to_string(minor) +
               " is none of 1.0, 2.0 and 3.0");
  }
  const std::uint64_t length =
      major == 1 ? bytes.read<std::uint16_t>() : bytes.read<std::uint32_t>();
  if (length > bytes.bytesLeft()) bytes.fail("the file ends within its header");
  return length;
}

text::ScalarType typeOfPoints(const NpyHeader& header, const text::Cursor& at) {
  const auto type = header.type();
  if (type != "<f4" && type != "<f8") {
    at.fail("numbers of type " + inQuotes(type) +
            " are not read: need little-endian floats or doubles, \"<f4\" or \"<f8\"");
  }
  const auto& shape = header.shape();
  if (shape.size() != 2 || shape[1] != 3) {
    at.fail("need points, an array of shape (n, 3), found " + shapeText(shape));
  }
  if (header.isColumnMajor()) at.fail("need C order, found Fortran order");
  return type == "<f4" ? text::ScalarType::Float32 : text::ScalarType::Float64;
}

/// An array in NumPy's notation: ('u', '<f8', (3,)).
std::string npyField(const std::string& name, text::ScalarType type, std::size_t components) {
  constexpr std::array<std::string_view, 10> kTypes{"|i1", "|u1", "<i2", "<u2", "<i4",
                                                    "<u4", "<i8", "<u8", "<f4", "<f8"};
  std::string field = "('";
  for (const char c : name) {
    if (!text::isPrintable(c)) continue;
    if (c == '\'' || c == '\\') field += '\\';
    field += c;
  }
  field.append("', '").append(kTypes[static_cast<std::size_t>(type)]).append("'");
  if (components > 1) field += ", (" + std::to_string(components) + ",)";
  return field + ")";
}

std::string npyHeader(const PointData& data) {
  const auto ofPoints =
      data.singlePrecision ? text::ScalarType::Float32 : text::ScalarType::Float64;
  std::string header = "{'descr': [" + npyField("points", ofPoints, 3);
  for (const auto& [name, numbers, components] : data.pointArrays) {
    header += ", " + npyField(name, typeOf(numbers), components);
  }
  return header + "], 'fortran_order': False, 'shape': (" + std::to_string(data.points.size()) +
         ",), }";
}

}  // namespace

PointData readNpy(const text::Content& content, std::uint64_t /*maxBytes*/) {
  text::ByteCursor bytes(content, std::endian::little);
  bytes.skip(kMagic.size());
  bytes.beginRecord();
  const auto length = headerLength(bytes);
  bytes.beginRecord();
  NpyHeader header(content.bytes.substr(bytes.position(), length), bytes);
  header.read();
  const auto type = typeOfPoints(header, bytes);
  bytes.skip(length);
  bytes.beginRecord();
  const auto count = header.shape()[0];
  if (count > bytes.bytesLeft() / (3 * sizeOf(type)) ||
      count * 3 * sizeOf(type) != bytes.bytesLeft()) {
    bytes.fail("the header promises " + std::to_string(count) + " points, and " +
               std::to_string(bytes.bytesLeft()) + " bytes follow");
  }
  PointData data;
  data.isBinary = true;
  data.singlePrecision = type == text::ScalarType::Float32;
  data.points.resize(count);
  for (auto& p : data.points) {
    bytes.beginRecord();
    p = {bytes.number(type), bytes.number(type), bytes.number(type)};
    if (!isFinite(p)) bytes.fail("a coordinate is not finite");
  }
  return data;
}

void requireFitsNpy(const PointData& data, const std::string& name) {
  if (data.cells.count() == 0) return;
  throw Error(ErrorKind::Argument, name + ": .npy holds points only, and the data have cells");
}

void writeNpy(text::Output& out, const PointData& data) {
  auto header = npyHeader(data);
  // Version 1 has 16 bits for the header's length, 2 has 32, 3 is in UTF-8. Padded to a multiple of
  // 64.
  const bool isAscii =
      std::ranges::all_of(header, [](char c) { return static_cast<unsigned char>(c) < 128; });
  const bool isLong = header.size() > 65000 || !isAscii;
  const std::size_t before = kMagic.size() + 2 + (isLong ? 4 : 2);
  header.append(63 - (before + header.size()) % 64, ' ').append("\n");
  out << kMagic << (!isAscii ? '\3' : isLong ? '\2' : '\1') << '\0';
  if (isLong) {
    out.binary(static_cast<std::uint32_t>(header.size()));
  } else {
    out.binary(static_cast<std::uint16_t>(header.size()));
  }
  out << header;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (data.singlePrecision) {
        out.binary(static_cast<float>(data.points[i][axis]));
      } else {
        out.binary(data.points[i][axis]);
      }
    }
    for (const auto& [ignored, numbers, components] : data.pointArrays) {
      std::visit(
          [&, each = components](const auto& values) {
            for (std::size_t k = i * each; k < (i + 1) * each; ++k) out.binary(values[k]);
          },
          numbers);
    }
  }
}

}  // namespace cutwater::detail
