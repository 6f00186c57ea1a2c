#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Formats/PatchRuns.hpp>
#include <Cutwater/Surface/Formats/TextNames.hpp>

#include <algorithm>
#include <map>

namespace cutwater::formats {

namespace {

void requireOneLine(std::string_view name) {
  const bool oneLine = std::none_of(name.begin(), name.end(),
                                    [](char c) { return static_cast<unsigned char>(c) < ' '; });
  const bool kept = name.empty() || (name.front() != ' ' && name.back() != ' ');
  constexpr std::size_t kLongest = 1024;
  if (!oneLine || !kept || name.ends_with('\\') || name.size() > kLongest) {
    throw Error(ErrorKind::Argument, "writeSurface: the patch name " + inQuotes(name) +
                                         " does not fit on a line of text");
  }
}

/// For each name the first patch with that name; at the end, that for patches without one.
std::vector<std::size_t> firstsOfNames(const std::vector<std::string>& names) {
  std::map<std::string_view, std::size_t> firsts;
  std::vector<std::size_t> result;
  for (const auto& name : names) {
    result.push_back(firsts.emplace(name, result.size()).first->second);
  }
  result.push_back(firsts.emplace("", result.size()).first->second);
  return result;
}

}  // namespace

PatchRuns::PatchRuns(const PolygonSoup& soup) : order_(soup.polygonCount()) {
  const auto& names = soup.patchNames;
  const auto firsts = firstsOfNames(names);
  const auto runOf = [&](std::size_t polygon) {
    return firsts[std::min(std::size_t{soup.patches[polygon]}, names.size())];
  };
  std::vector<std::size_t> begins(firsts.size() + 1);  // a counting sort: stable, and linear
  for (std::size_t i = 0; i < order_.size(); ++i) ++begins[runOf(i) + 1];
  for (std::size_t run = 0; run < firsts.size(); ++run) begins[run + 1] += begins[run];
  auto places = begins;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    order_[places[runOf(i)]++] = static_cast<std::uint32_t>(i);
  }
  for (std::size_t run = 0; run < firsts.size(); ++run) {
    const auto polygons =
        std::span<const std::uint32_t>(order_).subspan(begins[run], begins[run + 1] - begins[run]);
    if (polygons.empty()) continue;
    runs_.push_back({run < names.size() ? std::string_view(names[run]) : "", polygons});
    requireOneLine(runs_.back().name);
  }
}

}  // namespace cutwater::formats
