#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/VtkXmlNumbers.hpp>
#include <Cutwater/Text/Gzip.hpp>
#include <Cutwater/Text/TextCursor.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>

namespace cutwater::detail {

namespace {

using text::inQuotes;
using text::ScalarType;

constexpr std::array<std::string_view, 10> kXmlTypes{
    "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64", "Float32", "Float64"};
constexpr std::string_view kXmlBlanks = " \t\r\n";

/// Walks through the words of an element's text.
class XmlWords final : public text::Cursor {
 public:
  XmlWords(const text::Content& content, const XmlElement& element)
      : Cursor(content), rest_(element.text), line_(element.textLine) {}

  [[nodiscard]] text::Place place() const override { return {text::Place::Unit::Line, line_}; }
  /// The next word; empty at the end.
  std::string_view next() {
    std::size_t begin = 0;
    while (begin < rest_.size() && kXmlBlanks.find(rest_[begin]) != std::string_view::npos) {
      line_ += rest_[begin++] == '\n' ? 1 : 0;
    }
    rest_.remove_prefix(begin);
    const auto word = rest_.substr(0, rest_.find_first_of(kXmlBlanks));
    rest_.remove_prefix(word.size());
    return word;
  }

 private:
  std::string_view rest_;
  std::uint64_t line_;
};

std::span<char> rawBytes(DataNumbers& numbers) {
  return std::visit(
      [](auto& values) {
        return std::span(reinterpret_cast<char*>(values.data()), values.size() * sizeof(values[0]));
      },
      numbers);
}

void reverseEach(std::span<char> bytes, std::size_t size) {
  for (std::size_t i = 0; i < bytes.size(); i += size) {
    std::ranges::reverse(bytes.subspan(i, size));
  }
}

}  // namespace

std::string_view vtkXmlType(ScalarType type) {
  return kXmlTypes[static_cast<std::size_t>(type)];
}

VtkXmlNumbers::VtkXmlNumbers(const text::Content& content, const XmlElement& root,
                             std::uint64_t maxBytes)
    : content_(content), bytesLeft_(maxBytes) {
  readRoot(root);
  if (const auto* const element = root.child("AppendedData")) readAppended(*element);
}

void VtkXmlNumbers::readRoot(const XmlElement& root) {
  if (const auto* const order = root.attribute("byte_order")) {
    const bool isLittle = *order == "LittleEndian";
    if (!isLittle && *order != "BigEndian") fail(root, "unknown byte order " + inQuotes(*order));
    hasOrder_ = true;
    isSwapped_ = isLittle != (std::endian::native == std::endian::little);
  }
  // Without this attribute, sizes have 32 bits.
  if (const auto* const sizes = root.attribute("header_type")) {
    hasWideSizes_ = *sizes == "UInt64";
    if (!hasWideSizes_ && *sizes != "UInt32") fail(root, "unknown header type " + inQuotes(*sizes));
  }
  const auto* const compressor = root.attribute("compressor");
  if (compressor == nullptr || compressor->empty()) return;
  if (*compressor != "vtkZLibDataCompressor") {
    fail(root, "data compressed by " + inQuotes(*compressor) +
                   " are not read, only by vtkZLibDataCompressor or not at all");
  }
  compression_ = Compression::Zlib;
}

/// Behind the start tag and an underscore, the data; then the end tags of this and of VTKFile.
void VtkXmlNumbers::readAppended(const XmlElement& element) {
  const auto* const encoding = element.attribute("encoding");
  const bool isRaw = encoding != nullptr && *encoding == "raw";
  if (!isRaw && (encoding == nullptr || *encoding != "base64")) {
    fail(element, "appended data need the encoding raw or base64");
  }
  appendedEncoding_ = isRaw ? EncodedBytes::Encoding::Raw : EncodedBytes::Encoding::Base64;
  auto rest = element.text;
  const auto begin = rest.find_first_not_of(kXmlBlanks);
  if (begin == std::string_view::npos || rest[begin] != '_') {
    fail(element, "appended data must begin with an underscore");
  }
  rest.remove_prefix(begin + 1);
  for (const std::string_view tag : {"</VTKFile>", "</AppendedData>"}) {
    const auto last = rest.find_last_not_of(kXmlBlanks);
    rest = rest.substr(0, last == std::string_view::npos ? 0 : last + 1);
    if (!rest.ends_with(tag)) {
      fail(element, "the file ends too early: it should end with " + std::string(tag));
    }
    rest.remove_suffix(tag.size());
  }
  appended_ = rest;
}

ScalarType VtkXmlNumbers::typeOfArray(const XmlElement& array) const {
  const auto* const type = array.attribute("type");
  if (type == nullptr) fail(array, "an array without a type");
  const auto* const found = std::ranges::find(kXmlTypes, *type);
  if (found == kXmlTypes.end()) fail(array, "unknown number type " + inQuotes(*type));
  return static_cast<ScalarType>(found - kXmlTypes.begin());
}

DataNumbers VtkXmlNumbers::read(const XmlElement& array, std::uint64_t count) {
  const auto* const format = array.attribute("format");
  const std::string_view name = format == nullptr ? "" : std::string_view(*format);
  if (name == "ascii") return readText(array, count);
  if (!hasOrder_) fail(array, "binary data, and VTKFile has no byte_order");
  if (name == "appended") {
    auto bytes = appended(array);
    return readBytes(array, bytes, count);
  }
  if (name != "binary")
    fail(array, "need the format ascii, binary or appended, found " + inQuotes(name));
  EncodedBytes bytes(array.text, EncodedBytes::Encoding::Base64);
  if (count == 0 && bytes.isAtEnd()) return numbersOfType(typeOfArray(array), 0);
  auto numbers = readBytes(array, bytes, count);
  if (count > 0 && !bytes.isAtEnd()) fail(array, "data behind the last number");
  return numbers;
}

/// Numbers, set to 0, if they may be in `mostBytes` of the file.
DataNumbers VtkXmlNumbers::reserved(const XmlElement& array, std::uint64_t count,
                                    std::uint64_t mostBytes) {
  const auto type = typeOfArray(array);
  const auto size = text::sizeOf(type);
  if (count > mostBytes / size) {
    fail(array, "the file promises " + std::to_string(count) + " numbers, but there is room for " +
                    std::to_string(mostBytes / size));
  }
  if (count * size > bytesLeft_) {
    throw Error(ErrorKind::Limit, content_.name + ": line " + std::to_string(array.line) +
                                      ": the arrays take more bytes than the limit");
  }
  bytesLeft_ -= count * size;
  return numbersOfType(type, count);
}

DataNumbers VtkXmlNumbers::readText(const XmlElement& array, std::uint64_t count) {
  // Each number has a digit, and a blank before the next.
  const auto most = (array.text.size() + 1) / 2 * text::sizeOf(typeOfArray(array));
  auto numbers = reserved(array, count, most);
  XmlWords words(content_, array);
  std::visit(
      [&](auto& values) {
        std::uint64_t found = 0;
        for (auto& value : values) {
          const auto word = words.next();
          if (word.empty()) {
            words.fail("the array needs " + std::to_string(count) + " numbers, and has " +
                       std::to_string(found));
          }
          ++found;
          value = text::numberOf<std::remove_reference_t<decltype(value)>>(words, word);
        }
      },
      numbers);
  const auto more = words.next();
  if (!more.empty()) {
    words.fail("the array has more than " + std::to_string(count) + " numbers: " + inQuotes(more));
  }
  return numbers;
}

EncodedBytes VtkXmlNumbers::appended(const XmlElement& array) const {
  const auto* const text = array.attribute("offset");
  std::uint64_t offset = 0;
  if (text == nullptr) fail(array, "appended data without an offset");
  const char* const end = text->data() + text->size();
  const auto parsed = std::from_chars(text->data(), end, offset);
  if (parsed.ec != std::errc{} || parsed.ptr != end || offset > appended_.size()) {
    fail(array, "the offset " + inQuotes(*text) + " is not within the " +
                    std::to_string(appended_.size()) + " bytes of appended data");
  }
  return {appended_.substr(offset), appendedEncoding_};
}

std::uint64_t VtkXmlNumbers::readSize(const XmlElement& array, EncodedBytes& bytes) const {
  std::array<char, 8> raw{};
  const auto used = std::span(raw).first(hasWideSizes_ ? 8 : 4);
  if (!bytes.read(used)) fail(array, "the data end too early, or are no base64");
  if (isSwapped_) std::ranges::reverse(used);
  if (hasWideSizes_) return std::bit_cast<std::uint64_t>(raw);
  std::uint32_t narrow = 0;
  std::memcpy(&narrow, raw.data(), sizeof(narrow));
  return narrow;
}

DataNumbers VtkXmlNumbers::readBytes(const XmlElement& array, EncodedBytes& bytes,
                                     std::uint64_t count) {
  // zlib's deflate packs at most 1032 bytes into one.
  const std::uint64_t ratio = compression_ == Compression::None ? 1 : 1032;
  auto numbers = reserved(array, count, ratio * bytes.mostLeft());
  const auto into = rawBytes(numbers);
  if (compression_ == Compression::Zlib) {
    readBlocks(array, bytes, into);
  } else {
    const auto size = readSize(array, bytes);
    if (size != into.size()) {
      fail(array, "the array has " + std::to_string(size) + " bytes, and its " +
                      std::to_string(count) + " numbers need " + std::to_string(into.size()));
    }
    if (!bytes.read(into)) fail(array, "the data end too early, or are no base64");
  }
  if (isSwapped_) reverseEach(into, text::sizeOf(typeOf(numbers)));
  return numbers;
}

void VtkXmlNumbers::readBlocks(const XmlElement& array, EncodedBytes& bytes, std::span<char> into) {
  const auto blocks = readSize(array, bytes);
  if (blocks == 0 && into.empty()) return;
  const auto blockSize = readSize(array, bytes);
  const auto lastSize = readSize(array, bytes);
  if (blocks > bytes.mostLeft() / (hasWideSizes_ ? 8 : 4)) {
    fail(array, "the data promise " + std::to_string(blocks) + " blocks, and " +
                    std::to_string(bytes.mostLeft()) + " bytes are left");
  }
  const auto whole = lastSize == 0 || blocks == 0 ? blocks : blocks - 1;
  const bool fits = lastSize <= into.size() &&
                    (whole == 0 || blockSize <= (into.size() - lastSize) / whole) &&
                    whole * blockSize + (blocks == 0 ? 0 : lastSize) == into.size();
  if (!fits) {
    fail(array, "the array has " + std::to_string(blocks) + " blocks of " +
                    std::to_string(blockSize) + " bytes, the last of " + std::to_string(lastSize) +
                    ", and its numbers need " + std::to_string(into.size()));
  }
  std::vector<std::uint64_t> sizes(blocks);
  for (auto& size : sizes) size = readSize(array, bytes);
  std::vector<char> packed;
  for (std::size_t i = 0; i < blocks; ++i) {
    if (sizes[i] > bytes.mostLeft()) fail(array, "the data end too early");
    packed.resize(sizes[i]);
    if (!bytes.read(packed)) fail(array, "the data end too early, or are no base64");
    const auto block = into.subspan(i * blockSize, i < whole ? blockSize : lastSize);
    if (!text::inflateBlock(content_.name, {packed.data(), packed.size()}, block)) {
      fail(array, "compressed block " + std::to_string(i) + " is corrupt");
    }
  }
}

}  // namespace cutwater::detail
