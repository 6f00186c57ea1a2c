#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Formats/Writers.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cutwater::formats {

namespace {

constexpr std::size_t kMostShortCorners = std::numeric_limits<std::uint8_t>::max();

bool hasLongFaces(const PolygonSoup& soup) {
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    if (soup.polygon(i).size() > kMostShortCorners) return true;
  }
  return false;
}

// int is the most widely supported; uint is used only for larger indices.
const char* indexType(const PolygonSoup& soup) {
  constexpr std::size_t kMostForInt = std::numeric_limits<std::int32_t>::max();
  return soup.points.size() > kMostForInt ? "uint" : "int";
}

void writeSingle(Output& out, const Vec3<double>& p, const std::string& name) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto single = static_cast<float>(p[axis]);
    if (!std::isfinite(single)) {
      throw Error(ErrorKind::Argument,
                  name + ": coordinates of binary STL have single precision, too little for " +
                      detail::toText(p[axis]));
    }
    out.binary(single);
  }
}

}  // namespace

Vec3<double> facetNormal(const PolygonSoup& soup, std::size_t i) {
  const auto corners = soup.polygon(i);
  const auto& origin = soup.points[corners[0]];
  // Halved and scaled to magnitude 1, so that nothing overflows in any unit of length.
  Vec3<double> u = 0.5 * soup.points[corners[1]] - 0.5 * origin;
  Vec3<double> v = 0.5 * soup.points[corners[2]] - 0.5 * origin;
  const double size = std::max(maxComponent(abs(u)), maxComponent(abs(v)));
  if (!(size > 0)) return {};
  u = u / size;
  v = v / size;
  return normalized(cross(u, v));
}

void writePlyHeader(Output& out, const PolygonSoup& soup, std::string_view encoding) {
  out << "ply\nformat " << encoding << " 1.0\ncomment Cutwater\nelement vertex "
      << std::uint64_t{soup.points.size()}
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << std::uint64_t{soup.polygonCount()} << "\nproperty list "
      << (hasLongFaces(soup) ? "uint " : "uchar ") << indexType(soup)
      << " vertex_indices\nend_header\n";
}

void writeBinaryPly(Output& out, const PolygonSoup& soup, const std::string&) {
  writePlyHeader(out, soup, "binary_little_endian");
  for (const auto& point : soup.points) {
    for (int axis = 0; axis < 3; ++axis) out.binary(point[axis]);
  }
  const bool longFaces = hasLongFaces(soup);
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto corners = soup.polygon(i);
    if (longFaces) {
      out.binary(static_cast<std::uint32_t>(corners.size()));
    } else {
      out.binary(static_cast<std::uint8_t>(corners.size()));
    }
    for (const std::uint32_t corner : corners) out.binary(corner);
  }
}

void writeBinaryStl(Output& out, const PolygonSoup& soup, const std::string& name) {
  std::string header = "binary STL by Cutwater";  // must not begin with "solid"
  header.resize(80, ' ');
  out << header;
  out.binary(static_cast<std::uint32_t>(soup.polygonCount()));
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    writeSingle(out, facetNormal(soup, i), name);
    for (const std::uint32_t corner : soup.polygon(i)) writeSingle(out, soup.points[corner], name);
    out.binary(std::uint16_t{0});
  }
}

}  // namespace cutwater::formats
