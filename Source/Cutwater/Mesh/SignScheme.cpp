#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Text/Numbers.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

using text::counted;

std::string percent(double share) {
  return detail::toText(std::round(1000 * share) / 10) + " %";
}

}  // namespace

double SignReport::doubt() const {
  if (isProven) return 0;
  if (probes == 0) return 1;
  const auto n = static_cast<double>(probes);
  const double share = static_cast<double>(isClosed() ? unsound : ambiguous) / n;
  return share == 0 ? std::min(1.0, 3 / n)
                    : std::min(1.0, share + 2 * std::sqrt(share * (1 - share) / n));
}

std::string SignReport::summary() const {
  std::string text = scheme == SignScheme::WindingNumber ? "winding number: " : "nearest feature: ";
  text += isClosed() ? "closed" : counted(unbalancedEdges, "unbalanced edge", "unbalanced edges");
  if (unorientable > 0) text += ", " + counted(unorientable, "part", "parts") + " not orientable";
  if (selfIntersections) {
    text += ", " + counted(*selfIntersections, "self-intersection", "self-intersections");
  }
  if (isProven) {
    text += "; sound everywhere";
  } else if (probes > 0) {
    const std::size_t bad = isClosed() ? unsound : ambiguous;
    text += "; " + counted(probes, "probe", "probes") + ", ";
    text += bad == 0 ? "all " : detail::toText(static_cast<long long>(bad)) + ' ';
    text += isClosed() ? (bad == 0 ? "sound" : "unsound") : (bad == 0 ? "clear" : "ambiguous");
    text += " (at most " + percent(doubt()) + " of the " + (isClosed() ? "surface" : "box");
    text += std::string(isClosed() ? " unsound" : " ambiguous") + ", 95 % confidence)";
  }
  if (turnedFaces > 0) text += "; " + counted(turnedFaces, "face", "faces") + " turned";
  if (turnedShells > 0) {
    text += "; " + counted(turnedShells, "shell", "shells") + " stood inside out";
  }
  return text;
}

}  // namespace cutwater
