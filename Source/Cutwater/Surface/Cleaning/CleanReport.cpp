#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Cleaning/CleanReport.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlacesText.hpp>
#include <Cutwater/Text/ReportLine.hpp>

#include <algorithm>
#include <array>
#include <charconv>

namespace cutwater {

namespace detail {

std::string shortText(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, /*precision=*/9);
  return {buffer.data(), end.ptr};
}

std::string placesText(const Findings<Vec3<double>>& places) {
  std::string result;
  for (const auto& p : places.examples) {
    result += " (" + shortText(p.x) + ", " + shortText(p.y) + ", " + shortText(p.z) + ")";
  }
  return result + (places.count > places.examples.size() ? " ..." : "");
}

std::string changeText(const SurfaceMeasure& before, const SurfaceMeasure& after) {
  const auto change = [](const char* name, double from, double to) {
    return from == to ? std::string()
                      : std::string(", ") + name + shortText(from) + " -> " + shortText(to);
  };
  return change("area ", before.area, after.area) + change("volume ", before.volume, after.volume);
}

}  // namespace detail

const char* nameOf(CleanKind kind) {
  switch (kind) {
    case CleanKind::EqualPoints:
      return "equal points merged";
    case CleanKind::ClosePoints:
      return "close points merged";
    case CleanKind::DegenerateFaces:
      return "degenerate faces removed";
    case CleanKind::DuplicateFaces:
      return "duplicate faces removed";
    case CleanKind::OppositeFaces:
      return "faces cancelled by opposite ones";
    case CleanKind::Junctions:
      return "points put into edges";
    case CleanKind::UnusedPoints:
      return "unused points removed";
    case CleanKind::TurnedFaces:
      return "faces turned";
    case CleanKind::TurnedShells:
      return "shells turned";
    case CleanKind::UnorientableShells:
      return "shells that cannot be oriented";
  }
  return "";
}

bool CleanReport::changedNothing() const {
  return std::ranges::none_of(steps, [](const CleanStep& step) {
    return step.kind != CleanKind::UnorientableShells && step.correction;
  });
}

std::size_t CleanReport::count(CleanKind kind) const {
  std::size_t sum = 0;
  for (const auto& step : steps) sum += step.kind == kind ? step.correction.places.count : 0;
  return sum;
}

std::string CleanReport::text() const {
  std::string result;
  for (const auto& [kind, correction, before, after] : steps) {
    const auto& places = correction.places;
    std::string value = detail::toText(static_cast<long long>(places.count));
    if (correction.largest > 0) value += ", largest " + detail::shortText(correction.largest);
    value += detail::changeText(before, after);
    if (!places.examples.empty()) value += "; at" + detail::placesText(places);
    result += text::reportLine(nameOf(kind), value);
  }
  return result;
}

}  // namespace cutwater
