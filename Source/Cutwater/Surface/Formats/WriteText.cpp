#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Formats/Writers.hpp>

#include <algorithm>

namespace cutwater::formats {

namespace {

bool startsPatch(const PolygonSoup& soup, std::size_t i) {
  return i == 0 || soup.patches[i] != soup.patches[i - 1];
}

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

}  // namespace

std::string_view patchNameOf(const PolygonSoup& soup, std::size_t i) {
  if (soup.patches[i] >= soup.patchNames.size()) return {};
  const std::string_view name = soup.patchNames[soup.patches[i]];
  const bool oneLine = std::none_of(name.begin(), name.end(),
                                    [](char c) { return static_cast<unsigned char>(c) < ' '; });
  const bool kept = name.empty() || (name.front() != ' ' && name.back() != ' ');
  constexpr std::size_t kLongest = 1024;
  if (!oneLine || !kept || name.ends_with('\\') || name.size() > kLongest) {
    throw Error(ErrorKind::Argument, "writeSurface: the patch name " + inQuotes(name) +
                                         " does not fit on a line of text");
  }
  return name;
}

void writeAsciiStl(Output& out, const PolygonSoup& soup, const std::string&) {
  std::string_view name;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    if (startsPatch(soup, i)) {
      if (i > 0) out << "endsolid " << name << '\n';
      name = patchNameOf(soup, i);
      out << "solid " << name << '\n';
    }
    const auto corners = soup.polygon(i);
    out << "facet normal " << facetNormal(soup, i) << "\nouter loop\n";
    for (const std::uint32_t corner : corners) out << "vertex " << soup.points[corner] << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid " << name << '\n';
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
  constexpr std::size_t kCornersPerLine = 4096;
  out << "# Cutwater\n";
  writePoints(out, soup, "v ");
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    if (startsPatch(soup, i) && !soup.patchNames.empty()) {
      out << "g " << patchNameOf(soup, i) << '\n';
    }
    const auto corners = soup.polygon(i);
    out << 'f';
    for (std::size_t c = 0; c < corners.size(); ++c) {
      if (c > 0 && c % kCornersPerLine == 0) out << " \\\n";
      out << ' ' << std::uint64_t{corners[c]} + 1;
    }
    out << '\n';
  }
}

}  // namespace cutwater::formats
