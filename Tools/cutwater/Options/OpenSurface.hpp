#pragma once

#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

#include <string>

#include "Options/SurfaceOptions.hpp"

namespace cutwater::tool {

/// What to do about a surface that is open at so many edges, or whose inside is so ambiguous, that
/// work on it is slow and much stays undecided: a line that names a repair which closes it. Empty
/// if there is none, or for a few openings. Takes about as long as `cutwater info`.
[[nodiscard]] std::string adviceOnOpenings(const PolygonSoup& soup, const SignReport& signs,
                                           const SurfaceOptions& options);

}  // namespace cutwater::tool
