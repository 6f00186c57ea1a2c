#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Formats/Writers.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/WriteSurface.hpp>
#include <Cutwater/Text/Words.hpp>

namespace cutwater {

namespace {

using Writer = void (*)(text::Output&, const PolygonSoup&, const std::string& name);

struct Writers {
  Writer binary;
  Writer ascii;
};

Writers writersOf(SurfaceFormat format) {
  switch (format) {
    case SurfaceFormat::Stl:
      return {formats::writeBinaryStl, formats::writeAsciiStl};
    case SurfaceFormat::Obj:
      return {formats::writeObj, formats::writeObj};
    case SurfaceFormat::Ply:
      return {formats::writeBinaryPly, formats::writeAsciiPly};
    case SurfaceFormat::Off:
      return {formats::writeOff, formats::writeOff};
    case SurfaceFormat::Vtk:
      return {formats::writeBinaryVtk, formats::writeAsciiVtk};
    case SurfaceFormat::Vtp:
      break;
  }
  throw Error(ErrorKind::Argument, "writeSurface: VTP is only read");
}

SurfaceFormat formatOf(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  for (const auto& names : kReadSurfaceFormats) {
    if (text::equalIgnoringCase(extension, names.extension)) return names.format;
  }
  throw Error(ErrorKind::Argument, path.string() + ": unknown extension \"" + extension +
                                       "\": surfaces are written as " + surfaceExtensions("or"));
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
  const SurfaceFormat format = formatOf(path);
  soup.validate();
  const std::string name = path.string();
  if (soup.polygonCount() == 0) {
    throw Error(ErrorKind::Argument, name + ": there is no polygon to write");
  }
  if (format == SurfaceFormat::Stl) requireTriangles(name, soup);
  OutputFile file(path);
  text::Output out(file);
  const Writers writers = writersOf(format);
  (options.ascii ? writers.ascii : writers.binary)(out, soup, name);
  out.flush();
  file.commit();
}

}  // namespace cutwater
