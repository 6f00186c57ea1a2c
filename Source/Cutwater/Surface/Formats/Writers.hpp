#pragma once

#include <Cutwater/Surface/Formats/TextNames.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater::formats {

/// Each writes a soup that passed PolygonSoup::validate(); `name` is for messages.
void writeBinaryStl(Output& out, const PolygonSoup& soup, const std::string& name);
void writeAsciiStl(Output& out, const PolygonSoup& soup, const std::string& name);
void writeBinaryPly(Output& out, const PolygonSoup& soup, const std::string& name);
void writeAsciiPly(Output& out, const PolygonSoup& soup, const std::string& name);
void writeObj(Output& out, const PolygonSoup& soup, const std::string& name);
void writeOff(Output& out, const PolygonSoup& soup, const std::string& name);
void writeBinaryVtk(Output& out, const PolygonSoup& soup, const std::string& name);
void writeAsciiVtk(Output& out, const PolygonSoup& soup, const std::string& name);

/// Writes the header for either encoding.
void writePlyHeader(Output& out, const PolygonSoup& soup, std::string_view encoding);

/// The unit normal of triangle i, zero if it has no area.
[[nodiscard]] Vec3<double> facetNormal(const PolygonSoup& soup, std::size_t i);

}  // namespace cutwater::formats
