#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Formats/Writers.hpp>

#include <limits>

// Legacy VTK, version 3, POLYDATA, with the patch index of each polygon as cell data. (VTK User's
// Guide, "VTK File Formats".)

namespace cutwater::formats {

namespace {

/// Writes numbers as text, or in big-endian binary.
class VtkNumbers {
 public:
  VtkNumbers(Output& out, bool ascii) : out_(out), ascii_(ascii) {}

  void point(const Vec3<double>& p) {
    if (ascii_) {
      out_ << p << '\n';
      return;
    }
    for (int axis = 0; axis < 3; ++axis) out_.binaryBigEndian(p[axis]);
  }
  void integer(std::uint64_t value, char after) {
    if (ascii_) {
      out_ << value << after;
    } else {
      out_.binaryBigEndian(static_cast<std::uint32_t>(value));
    }
  }
  void end() {
    if (!ascii_) out_ << '\n';
  }

 private:
  Output& out_;
  bool ascii_;
};

void write(Output& out, const PolygonSoup& soup, const std::string& name, bool ascii) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
  const std::uint64_t polygons = soup.polygonCount();
  const std::uint64_t numbers = polygons + soup.corners.size();
  if (soup.points.size() > kMost || numbers > kMost) {
    throw Error(ErrorKind::Limit, name + ": legacy VTK counts to 2^31 - 1 only");
  }
  VtkNumbers print(out, ascii);
  out << "# vtk DataFile Version 3.0\nCutwater\n"
      << (ascii ? "ASCII" : "BINARY") << "\nDATASET POLYDATA\nPOINTS "
      << std::uint64_t{soup.points.size()} << " double\n";
  for (const auto& point : soup.points) print.point(point);
  print.end();
  out << "POLYGONS " << polygons << ' ' << numbers << '\n';
  for (std::size_t i = 0; i < polygons; ++i) {
    const auto corners = soup.polygon(i);
    print.integer(corners.size(), ' ');
    for (std::size_t c = 0; c < corners.size(); ++c) {
      print.integer(corners[c], c + 1 < corners.size() ? ' ' : '\n');
    }
  }
  print.end();
  out << "CELL_DATA " << polygons << "\nSCALARS patch int 1\nLOOKUP_TABLE default\n";
  for (const auto patch : soup.patches) print.integer(patch, '\n');
  print.end();
}

}  // namespace

void writeBinaryVtk(Output& out, const PolygonSoup& soup, const std::string& name) {
  write(out, soup, name, false);
}

void writeAsciiVtk(Output& out, const PolygonSoup& soup, const std::string& name) {
  write(out, soup, name, true);
}

}  // namespace cutwater::formats
