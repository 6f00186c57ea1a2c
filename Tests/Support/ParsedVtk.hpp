#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {

/// A reader of its own for the part of the format that is written, by the format's description:
/// attributes are looked up in the text, arrays by their offsets behind the underscore.
class ParsedVtk {
 public:
  explicit ParsedVtk(std::string content) : content_(std::move(content)) {
    const std::string mark = "<AppendedData encoding=\"raw\">\n_";
    data_ = content_.find(mark);
    EXPECT_NE(data_, std::string::npos);
    header_ = content_.substr(0, data_);
    data_ += mark.size();
  }

  [[nodiscard]] std::string attribute(const std::string& element, const std::string& name,
                                      std::size_t from = 0) const {
    const auto start = header_.find("<" + element + " ", from);
    if (start == std::string::npos) return "";
    const auto tag = header_.substr(start, header_.find('>', start) - start);
    const auto at = tag.find(" " + name + "=\"");
    if (at == std::string::npos) return "";
    const auto begin = at + name.size() + 3;
    return tag.substr(begin, tag.find('"', begin) - begin);
  }

  template <typename V>
  [[nodiscard]] std::vector<V> array(const std::string& name, const std::string& type) const {
    const auto start = elementOf(name);
    EXPECT_EQ(attribute("DataArray", "type", start), type);
    const auto text = attribute("DataArray", "offset", start);
    std::size_t offset = 0;
    std::from_chars(text.data(), text.data() + text.size(), offset);
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, content_.data() + data_ + offset, sizeof(bytes));
    std::vector<V> values(bytes / sizeof(V));
    std::memcpy(values.data(), content_.data() + data_ + offset + sizeof(bytes), bytes);
    end_ = data_ + offset + sizeof(bytes) + bytes;
    return values;
  }

  [[nodiscard]] std::string components(const std::string& array) const {
    return attribute("DataArray", "NumberOfComponents", elementOf(array));
  }

  /// Texts of field data, each a zero behind the numbers of its bytes.
  [[nodiscard]] std::vector<std::string> texts(const std::string& name) const {
    const auto field = header_.find("<FieldData>");
    const auto start = header_.find("Name=\"" + name + "\"", field);
    if (field == std::string::npos || start == std::string::npos) return {};
    const auto begin = header_.find('>', start) + 1;
    std::istringstream numbers(header_.substr(begin, header_.find('<', begin) - begin));
    std::vector<std::string> texts{""};
    for (int code = 0; numbers >> code;) {
      if (code == 0) {
        texts.emplace_back();
      } else {
        texts.back() += static_cast<char>(code);
      }
    }
    EXPECT_EQ(texts.back(), "");
    texts.pop_back();
    return texts;
  }

  /// What stands behind the array that was read last.
  [[nodiscard]] std::string rest() const { return content_.substr(end_); }
  [[nodiscard]] const std::string& header() const { return header_; }

 private:
  [[nodiscard]] std::size_t elementOf(const std::string& array) const {
    const auto at = header_.find("Name=\"" + array + "\"");
    EXPECT_NE(at, std::string::npos) << array;
    return header_.rfind("<DataArray", at);
  }

  std::string content_;
  std::string header_;
  std::size_t data_ = 0;
  mutable std::size_t end_ = 0;
};

}  // namespace cutwater::test
