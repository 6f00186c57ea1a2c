#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/OutputFile.hpp>
#include <Cutwater/Io/Vti.hpp>

#include <array>
#include <bit>
#include <string_view>

// Format: "VTK File Formats", section XML, https://docs.vtk.org; appended data with encoding="raw":
// behind an underscore, each array's bytes follow their number as a UInt64.

namespace cutwater {

namespace {

using detail::toText;

std::string_view vtkType(const VtiArray& array) {
  constexpr std::array<std::string_view, 3> kTypes{"Float32", "Float64", "UInt32"};
  return kTypes[array.values.index()];
}

std::span<const std::byte> bytesOf(const VtiArray& array) {
  return std::visit([](const auto& values) { return std::as_bytes(values); }, array.values);
}

std::size_t lengthOf(const VtiArray& array) {
  return std::visit([](const auto& values) { return values.size(); }, array.values);
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

template <std::floating_point T>
std::string numbers(const Vec3<T>& v) {
  return toText(static_cast<double>(v.x)) + " " + toText(static_cast<double>(v.y)) + " " +
         toText(static_cast<double>(v.z));
}

/// VTK's extent counts points, also for cell data: n cells lie between n + 1 points.
std::string extentOf(const IndexBox& box, Centering centering) {
  const long long last = centering == Centering::Cell ? 1 : 0;
  std::string text;
  for (const auto& [lo, hi] : {std::pair(box.lo.i, box.hi.i), std::pair(box.lo.j, box.hi.j),
                               std::pair(box.lo.k, box.hi.k)}) {
    if (!text.empty()) text += ' ';
    text += toText(static_cast<long long>(lo)) + ' ' + toText(hi + last);
  }
  return text;
}

void checkArguments(const IndexBox& box, std::span<const VtiArray> arrays) {
  require(!box.empty(), "writeVti: need a patch that is not empty");
  require(!arrays.empty(), "writeVti: need at least one array");
  constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
  require(box.hi.i < kMost && box.hi.j < kMost && box.hi.k < kMost,
          "writeVti: need indices below 2^31 - 1");
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    require(!arrays[a].name.empty(), "writeVti: every array needs a name");
    require(lengthOf(arrays[a]) == box.count(), "writeVti: need one value per index of the patch",
            Named{"values", lengthOf(arrays[a])}, Named{"indices", box.count()});
    for (std::size_t b = 0; b < a; ++b) {
      if (arrays[a].name != arrays[b].name) continue;
      throw Error(ErrorKind::Argument, "writeVti: two arrays named '" + arrays[a].name + "'");
    }
  }
}

template <std::floating_point T>
std::string header(const Patch<T>& patch, std::span<const VtiArray> arrays) {
  const auto& level = patch.level;
  const auto extent = extentOf(patch.indices, level.centering());
  const bool cells = level.centering() == Centering::Cell;
  const std::string data = cells ? "CellData" : "PointData";
  const std::string order =
      std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\"";
  text += " byte_order=\"" + order + "\" header_type=\"UInt64\">\n";
  text += "  <ImageData WholeExtent=\"" + extent + "\" Origin=\"" + numbers(level.origin()) +
          "\" Spacing=\"" + numbers(level.spacing()) + "\">\n";
  text += "    <Piece Extent=\"" + extent + "\">\n";
  text += "      <" + data + " Scalars=\"" + escaped(arrays.front().name) + "\">\n";
  std::uint64_t offset = 0;
  for (const auto& array : arrays) {
    text += "        <DataArray type=\"" + std::string(vtkType(array)) + "\" Name=\"" +
            escaped(array.name) + "\" format=\"appended\" offset=\"" +
            toText(static_cast<long long>(offset)) + "\"/>\n";
    offset += sizeof(std::uint64_t) + bytesOf(array).size();
  }
  text += "      </" + data + ">\n      <" + (cells ? "PointData" : "CellData") + "/>\n";
  text += "    </Piece>\n  </ImageData>\n  <AppendedData encoding=\"raw\">\n_";
  return text;
}

}  // namespace

template <std::floating_point T>
void writeVti(const std::filesystem::path& path, const Patch<T>& patch,
              std::span<const VtiArray> arrays) {
  checkArguments(patch.indices, arrays);
  OutputFile file(path);
  file.write(header(patch, arrays));
  for (const auto& array : arrays) {
    const auto bytes = bytesOf(array);
    const std::uint64_t count = bytes.size();
    file.write(std::as_bytes(std::span(&count, 1)));
    file.write(bytes);
  }
  file.write("\n  </AppendedData>\n</VTKFile>\n");
  file.commit();
}

template void writeVti(const std::filesystem::path&, const Patch<float>&,
                       std::span<const VtiArray>);
template void writeVti(const std::filesystem::path&, const Patch<double>&,
                       std::span<const VtiArray>);

}  // namespace cutwater
