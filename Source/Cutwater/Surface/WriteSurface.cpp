#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Formats/Writers.hpp>
#include <Cutwater/Surface/WriteSurface.hpp>
#include <Cutwater/Text/Words.hpp>

#include <array>

namespace cutwater {

namespace {

using Writer = void (*)(text::Output&, const PolygonSoup&, const std::string& name);

struct Format {
  std::string_view extension;
  Writer binary;
  Writer ascii;
};

constexpr std::array<Format, 5> kFormats = {{
    {".stl", formats::writeBinaryStl, formats::writeAsciiStl},
    {".ply", formats::writeBinaryPly, formats::writeAsciiPly},
    {".obj", formats::writeObj, formats::writeObj},
    {".off", formats::writeOff, formats::writeOff},
    {".vtk", formats::writeBinaryVtk, formats::writeAsciiVtk},
}};

const Format& formatOf(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  for (const Format& format : kFormats) {
    if (text::equalIgnoringCase(extension, format.extension)) return format;
  }
  throw Error(ErrorKind::Argument,
              path.string() + ": unknown extension \"" + extension +
                  "\": surfaces are written as .stl, .ply, .obj, .off or .vtk");
}

void requireTriangles(const std::string& name, const PolygonSoup& soup) {
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const std::size_t corners = soup.polygon(i).size();
    if (corners == 3) continue;
    throw Error(ErrorKind::Topology, name + ": STL holds triangles only, but face " +
                                         std::to_string(i) + " has " + std::to_string(corners) +
                                         " corners");
  }
}

}  // namespace

void writeSurface(const std::filesystem::path& path, const PolygonSoup& soup,
                  const WriteOptions& options) {
  const Format& format = formatOf(path);
  soup.validate();
  const std::string name = path.string();
  if (soup.polygonCount() == 0) {
    throw Error(ErrorKind::Argument, name + ": there is no polygon to write");
  }
  if (format.extension == ".stl") requireTriangles(name, soup);
  OutputFile file(path);
  text::Output out(file);
  (options.ascii ? format.ascii : format.binary)(out, soup, name);
  out.flush();
  file.commit();
}

}  // namespace cutwater
