#pragma once

#include <Cutwater/Io/Detail/EncodedBytes.hpp>
#include <Cutwater/Io/Detail/PointFormats.hpp>
#include <Cutwater/Io/Detail/XmlReader.hpp>

namespace cutwater::detail {

/// VTK's name for a type of numbers in XML, such as "Float64".
[[nodiscard]] std::string_view vtkXmlType(text::ScalarType type);

/// Reads the numbers of the arrays of a VTK XML file: as text, in base64 where the array stands, or
/// appended to the file, raw or in base64; compressed by zlib or not.
///
/// Format: "VTK File Formats", section XML, https://docs.vtk.org. Binary data begin with the number
/// of bytes or, if they are compressed, with the number of blocks, the size of a block, that of the
/// last one if it is smaller (0: it is not), and the compressed size of each.
class VtkXmlNumbers {
 public:
  /// `root`: the element VTKFile, which must outlive this.
  /// @throws Error(File) for other compressors, unknown byte orders, types of sizes or encodings of
  /// the appended data, and if the file does not end as it should.
  VtkXmlNumbers(const text::Content& content, const XmlElement& root, std::uint64_t maxBytes);

  /// The type of the numbers in an array. @throws Error(File) if there is no such type.
  [[nodiscard]] text::ScalarType typeOfArray(const XmlElement& array) const;
  /// `count` numbers. Nothing is allocated for more of them than the file can have.
  /// @throws Error(File) unless the array has exactly these; Error(Limit) beyond maxBytes in all.
  [[nodiscard]] DataNumbers read(const XmlElement& array, std::uint64_t count);

  [[noreturn]] void fail(const XmlElement& element, const std::string& message) const {
    failAtLine(content_, element.line, message);
  }

 private:
  enum class Compression : std::uint8_t { None, Zlib };

  void readRoot(const XmlElement& root);
  void readAppended(const XmlElement& element);
  [[nodiscard]] DataNumbers readText(const XmlElement& array, std::uint64_t count);
  [[nodiscard]] EncodedBytes appended(const XmlElement& array) const;
  [[nodiscard]] DataNumbers readBytes(const XmlElement& array, EncodedBytes& bytes,
                                      std::uint64_t count);
  void readBlocks(const XmlElement& array, EncodedBytes& bytes, std::span<char> into);
  [[nodiscard]] std::uint64_t readSize(const XmlElement& array, EncodedBytes& bytes) const;
  [[nodiscard]] DataNumbers reserved(const XmlElement& array, std::uint64_t count,
                                     std::uint64_t mostBytes);

  const text::Content& content_;
  std::uint64_t bytesLeft_;  // of maxBytes
  Compression compression_ = Compression::None;
  bool hasOrder_ = false;
  bool isSwapped_ = false;
  bool hasWideSizes_ = false;
  std::string_view appended_;
  EncodedBytes::Encoding appendedEncoding_ = EncodedBytes::Encoding::Raw;
};

}  // namespace cutwater::detail
