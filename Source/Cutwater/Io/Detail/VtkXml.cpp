#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/VtkXml.hpp>

#include <bit>

namespace cutwater::detail {

namespace {

template <typename Value>
struct Components {
  using Number = Value;
  static constexpr int kCount = 1;
};
template <typename T>
struct Components<Vec3<T>> {
  using Number = T;
  static constexpr int kCount = 3;
};

std::span<const std::byte> bytesOf(const VtkArray& array) {
  return std::visit([](const auto& values) { return std::as_bytes(values); }, array.values);
}

/// VTK's name for the type of an array's numbers, and the number of components.
struct Numbers {
  std::string_view type;
  int components;
};

Numbers numbersOf(const VtkArray& array) {
  return std::visit(
      [](const auto& values) {
        using Value = Components<std::remove_cvref_t<decltype(values[0])>>;
        return Numbers{vtkType<typename Value::Number>(), Value::kCount};
      },
      array.values);
}

std::size_t lengthOf(const VtkArray& array) {
  return std::visit([](const auto& values) { return values.size(); }, array.values);
}

[[noreturn]] void refuse(const std::string& caller, const std::string& why) {
  throw Error(ErrorKind::Argument, caller + ": " + why);
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

VtkXml::VtkXml(std::string_view dataSet, Attributes attributes) : dataSet_(dataSet) {
  const std::string order =
      std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  text_ = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + dataSet_ +
          "\" version=\"1.0\" byte_order=\"" + order + "\" header_type=\"UInt64\">\n";
  open(dataSet, attributes);
}

void VtkXml::tag(std::string_view element, Attributes attributes, std::string_view end) {
  text_.append(2 * depth_, ' ').append("<").append(element);
  for (const auto& [name, value] : attributes) {
    text_.append(" ").append(name).append("=\"").append(escaped(value)).append("\"");
  }
  text_.append(end).append("\n");
}

void VtkXml::line(std::string_view text) {
  text_.append(2 * depth_, ' ').append(text).append("\n");
}

void VtkXml::open(std::string_view element, Attributes attributes) {
  tag(element, attributes, ">");
  ++depth_;
}

void VtkXml::close(std::string_view element) {
  --depth_;
  text_.append(2 * depth_, ' ').append("</").append(element).append(">\n");
}

void VtkXml::empty(std::string_view element, Attributes attributes) {
  tag(element, attributes, "/>");
}

void VtkXml::array(std::string_view name, std::string_view type, int components,
                   std::uint64_t bytes) {
  tag("DataArray",
      {{"type", std::string(type)},
       {"Name", std::string(name)},
       {"NumberOfComponents", toText(static_cast<long long>(components))},
       {"format", "appended"},
       {"offset", toText(static_cast<long long>(offset_))}},
      "/>");
  offset_ += sizeof(std::uint64_t) + bytes;
}

void VtkXml::fieldArray(std::string_view name, std::string_view type, int components,
                        std::uint64_t tuples, std::uint64_t bytes) {
  empty("DataArray", {{"type", std::string(type)},
                      {"Name", std::string(name)},
                      {"NumberOfComponents", toText(static_cast<long long>(components))},
                      {"NumberOfTuples", toText(static_cast<long long>(tuples))},
                      {"format", "appended"},
                      {"offset", toText(static_cast<long long>(offset_))}});
  offset_ += sizeof(std::uint64_t) + bytes;
}

void VtkXml::openArrays(std::string_view element, const VtkArray& first) {
  open(element, {{numbersOf(first).components > 1 ? "Vectors" : "Scalars", first.name}});
}

void VtkXml::arrays(std::string_view element, std::span<const VtkArray> arrays) {
  openArrays(element, arrays.front());
  for (const auto& array : arrays) {
    const auto [type, components] = numbersOf(array);
    this->array(array.name, type, components, bytesOf(array).size());
  }
  close(element);
}

void VtkXml::patchNames(const std::vector<std::string>& names) {
  if (names.empty()) return;
  open("FieldData");
  patchNamesArray(names);
  close("FieldData");
}

void VtkXml::patchNamesArray(const std::vector<std::string>& names) {
  if (names.empty()) return;
  open("Array", {{"type", "String"},
                 {"Name", "patch names"},
                 {"NumberOfTuples", toText(static_cast<long long>(names.size()))},
                 {"format", "ascii"}});
  for (const auto& name : names) {
    std::string codes;
    for (const char c : name) codes += std::to_string(static_cast<unsigned char>(c)) + ' ';
    line(codes + '0');
  }
  close("Array");
}

void VtkXml::declaration(std::string_view name, std::string_view type, int components) {
  empty("PDataArray", {{"type", std::string(type)},
                       {"Name", std::string(name)},
                       {"NumberOfComponents", toText(static_cast<long long>(components))}});
}

void VtkXml::declarations(std::string_view element, std::span<const VtkArray> arrays) {
  openArrays(element, arrays.front());
  for (const auto& array : arrays) {
    const auto [type, components] = numbersOf(array);
    declaration(array.name, type, components);
  }
  close(element);
}

std::string VtkXml::finishedAlone() {
  close(dataSet_);
  return text_ + "</VTKFile>\n";
}

std::string VtkXml::finished() {
  close(dataSet_);
  return text_ + "  <AppendedData encoding=\"raw\">\n_";
}

void checkVtkNames(const std::string& caller, std::span<const VtkArray> arrays) {
  if (arrays.empty()) refuse(caller, "need at least one array");
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    const auto& name = arrays[a].name;
    if (name.empty()) refuse(caller, "every array needs a name");
    for (std::size_t b = 0; b < a; ++b) {
      if (name == arrays[b].name) refuse(caller, "two arrays named '" + name + "'");
    }
  }
}

void checkVtkArrays(const std::string& caller, std::span<const VtkArray> arrays,
                    std::size_t count) {
  checkVtkNames(caller, arrays);
  for (const auto& array : arrays) {
    const auto length = lengthOf(array);
    if (length == count) continue;
    refuse(caller, "array '" + array.name + "' needs " + toText(static_cast<long long>(count)) +
                       " values (values = " + toText(static_cast<long long>(length)) + ")");
  }
}

void writeVtkSize(OutputFile& file, std::uint64_t bytes) {
  file.write(std::as_bytes(std::span(&bytes, 1)));
}

void writeVtkArrays(OutputFile& file, std::span<const VtkArray> arrays) {
  for (const auto& array : arrays) {
    const auto bytes = bytesOf(array);
    writeVtkSize(file, bytes.size());
    file.write(bytes);
  }
}

}  // namespace cutwater::detail
