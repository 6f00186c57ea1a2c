#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <algorithm>
#include <string>

#include "Support/Soups.hpp"

namespace cutwater::test {

/// All of it is one patch.
inline PolygonSoup called(const std::string& name, PolygonSoup soup) {
  soup.patchNames = {name};
  std::ranges::fill(soup.patches, 0U);
  return soup;
}
/// As together(), but with patches of its own.
inline PolygonSoup beside(const PolygonSoup& soup, PolygonSoup added) {
  for (auto& patch : added.patches) patch += static_cast<std::uint32_t>(soup.patchNames.size());
  auto result = together(soup, added);
  result.patchNames.insert(result.patchNames.end(), added.patchNames.begin(),
                           added.patchNames.end());
  return result;
}
/// A parallelogram, a patch called "fin".
inline PolygonSoup sheet(const Vec3<double>& corner, const Vec3<double>& u, const Vec3<double>& v) {
  PolygonSoup soup;
  soup.patchNames = {"fin"};
  soup.points = {corner, corner + u, corner + u + v, corner + v};
  soup.addPolygon(std::array{0U, 1U, 2U});
  soup.addPolygon(std::array{0U, 2U, 3U});
  return soup;
}

}  // namespace cutwater::test
