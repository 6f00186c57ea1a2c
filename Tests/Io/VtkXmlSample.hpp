#pragma once

#include <bit>
#include <charconv>
#include <cstring>
#include <string>
#include <vector>

#include "PointFile.hpp"

#ifdef CUTWATER_HAS_ZLIB
#include <zlib.h>
#endif

namespace cutwater::test {

/// How the arrays of a sample are encoded.
struct XmlEncoding {
  std::string format = "ascii";  ///< ascii, binary or appended
  std::string appended = "raw";  ///< or base64
  bool compressed = false;       ///< by zlib, in blocks of 16 bytes
  bool wide = false;             ///< sizes of 64 bits
  std::endian order = std::endian::little;
  bool apart = false;  ///< sizes are encoded by themselves, also without compression
};

inline std::string base64(const std::string& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63U];
    }
  }
  return text;
}

/// Builds a VTK XML file, array by array.
class VtkXmlSample {
 public:
  VtkXmlSample(std::string dataSet, XmlEncoding encoding)
      : dataSet_(std::move(dataSet)), encoding_(std::move(encoding)) {}

  /// Text of the file, as it stands.
  VtkXmlSample& operator<<(const std::string& text) {
    body_ += text;
    return *this;
  }
  /// An array, with further attributes.
  template <typename Number>
  VtkXmlSample& array(const std::string& type, const std::string& attributes,
                      const std::vector<Number>& numbers) {
    body_ +=
        "<DataArray type=\"" + type + "\" " + attributes + " format=\"" + encoding_.format + "\"";
    if (encoding_.format == "appended") {
      body_ += " offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
      appended_ += encoding_.appended == "raw" ? plain(numbers) : inBase64(numbers);
    } else {
      body_ += ">\n" + (encoding_.format == "ascii" ? words(numbers) : inBase64(numbers)) +
               "\n</DataArray>\n";
    }
    return *this;
  }

  [[nodiscard]] std::string text() const {
    std::string file = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + dataSet_ +
                       "\" version=\"1.0\" byte_order=\"" +
                       (encoding_.order == std::endian::little ? "LittleEndian" : "BigEndian") +
                       "\"";
    if (encoding_.wide) file += " header_type=\"UInt64\"";
    if (encoding_.compressed) file += " compressor=\"vtkZLibDataCompressor\"";
    file += ">\n<" + dataSet_ + ">\n" + body_ + "</" + dataSet_ + ">\n";
    if (encoding_.format == "appended") {
      file += "<AppendedData encoding=\"" + encoding_.appended + "\">\n _" + appended_ +
              "\n</AppendedData>\n";
    }
    return file + "</VTKFile>\n";
  }

 private:
  template <typename Number>
  [[nodiscard]] static std::string words(const std::vector<Number>& numbers) {
    std::string text;
    for (const auto number : numbers) {
      char digits[40];
      const auto end = std::to_chars(digits, digits + 40, number).ptr;
      text += " " + std::string(digits, end) + "\n";
    }
    return text;
  }

  template <typename Number>
  [[nodiscard]] std::string bytes(const std::vector<Number>& numbers) const {
    std::string all;
    for (const auto number : numbers) all += bytesOf<Number>({number}, encoding_.order);
    return all;
  }
  [[nodiscard]] std::string size(std::size_t value) const {
    return encoding_.wide
               ? bytesOf<std::uint64_t>({value}, encoding_.order)
               : bytesOf<std::uint32_t>({static_cast<std::uint32_t>(value)}, encoding_.order);
  }

  /// The sizes that stand before the data, and these.
  template <typename Number>
  [[nodiscard]] std::pair<std::string, std::string> parts(
      const std::vector<Number>& numbers) const {
    const auto all = bytes(numbers);
    if (!encoding_.compressed) return {size(all.size()), all};
    constexpr std::size_t kBlock = 16;
    std::string sizes =
        size((all.size() + kBlock - 1) / kBlock) + size(kBlock) + size(all.size() % kBlock);
    std::string packed;
    for (std::size_t i = 0; i < all.size(); i += kBlock) {
      const auto block = deflated(all.substr(i, kBlock));
      sizes += size(block.size());
      packed += block;
    }
    return {sizes, packed};
  }
  template <typename Number>
  [[nodiscard]] std::string plain(const std::vector<Number>& numbers) const {
    const auto [sizes, data] = parts(numbers);
    return sizes + data;
  }
  template <typename Number>
  [[nodiscard]] std::string inBase64(const std::vector<Number>& numbers) const {
    const auto [sizes, data] = parts(numbers);
    const bool apart = encoding_.compressed || encoding_.apart;
    return apart ? base64(sizes) + base64(data) : base64(sizes + data);
  }

  [[nodiscard]] static std::string deflated(const std::string& bytes) {
#ifdef CUTWATER_HAS_ZLIB
    uLongf size = compressBound(bytes.size());
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size,
             reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    packed.resize(size);
    return packed;
#else
    return bytes;
#endif
  }

  std::string dataSet_;
  XmlEncoding encoding_;
  std::string body_;
  std::string appended_;
};

/// Every way in which the arrays of a file may be encoded.
inline std::vector<XmlEncoding> xmlEncodings() {
  std::vector<XmlEncoding> all{{}};
  for (const auto order : {std::endian::little, std::endian::big}) {
    for (const bool wide : {false, true}) {
      for (const auto& [format, appended] :
           {std::pair("binary", "raw"), std::pair("appended", "raw"),
            std::pair("appended", "base64")}) {
        all.push_back({.format = format, .appended = appended, .wide = wide, .order = order});
        all.push_back(
            {.format = format, .appended = appended, .wide = wide, .order = order, .apart = true});
#ifdef CUTWATER_HAS_ZLIB
        all.push_back({.format = format,
                       .appended = appended,
                       .compressed = true,
                       .wide = wide,
                       .order = order});
#endif
      }
    }
  }
  return all;
}

}  // namespace cutwater::test
