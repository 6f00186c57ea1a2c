#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Formats/PatchRuns.hpp>
#include <Cutwater/Surface/Formats/Writers.hpp>

namespace cutwater::formats {

namespace {

void writePoints(Output& out, const PolygonSoup& soup, std::string_view before) {
  for (const auto& point : soup.points) out << before << point << '\n';
}

// Lines such as "4 0 1 2 3", which OFF and PLY share.
void writeFaces(Output& out, const PolygonSoup& soup, const std::string& name) {
  constexpr std::size_t kLongestIndex = 11;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto corners = soup.polygon(i);
    if ((corners.size() + 1) * kLongestIndex > TextCursor::kLongestLine) {
      throw Error(ErrorKind::Limit, name + ": face " + std::to_string(i) + " has " +
                                        std::to_string(corners.size()) +
                                        " corners, too many for a line of text (use binary PLY)");
    }
    out << std::uint64_t{corners.size()};
    for (const std::uint32_t corner : corners) out << ' ' << std::uint64_t{corner};
    out << '\n';
  }
}

void writeObjFace(Output& out, std::span<const std::uint32_t> corners) {
  constexpr std::size_t kCornersPerLine = 4096;
  out << 'f';
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (c > 0 && c % kCornersPerLine == 0) out << " \\\n";
    out << ' ' << std::uint64_t{corners[c]} + 1;
  }
  out << '\n';
}

}  // namespace

void writeAsciiStl(Output& out, const PolygonSoup& soup, const std::string&) {
  for (const auto& [name, polygons] : PatchRuns(soup)) {
    out << "solid " << name << '\n';
    for (const std::uint32_t i : polygons) {
      out << "facet normal " << facetNormal(soup, i) << "\nouter loop\n";
      for (const std::uint32_t c : soup.polygon(i)) out << "vertex " << soup.points[c] << '\n';
      out << "endloop\nendfacet\n";
    }
    out << "endsolid " << name << '\n';
  }
}

void writeAsciiPly(Output& out, const PolygonSoup& soup, const std::string& name) {
  writePlyHeader(out, soup, "ascii");
  writePoints(out, soup, "");
  writeFaces(out, soup, name);
}

void writeOff(Output& out, const PolygonSoup& soup, const std::string& name) {
  out << "OFF\n"
      << std::uint64_t{soup.points.size()} << ' ' << std::uint64_t{soup.polygonCount()} << " 0\n";
  writePoints(out, soup, "");
  writeFaces(out, soup, name);
}

void writeObj(Output& out, const PolygonSoup& soup, const std::string&) {
  out << "# Cutwater\n";
  writePoints(out, soup, "v ");
  for (const auto& [name, polygons] : PatchRuns(soup)) {
    if (!soup.patchNames.empty()) out << "g " << name << '\n';
    for (const std::uint32_t i : polygons) writeObjFace(out, soup.polygon(i));
  }
}

}  // namespace cutwater::formats
