#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <string_view>

namespace cutwater::formats {

/// The polygons of a patch, in the order of the soup.
struct PatchRun {
  std::string_view name;  ///< empty: it has none
  std::span<const std::uint32_t> polygons;
};

/// The polygons of a soup patch by patch, as formats with groups write them: each name once, in the
/// order of patchNames. Patches with the same name are one, and so are those without a name, which
/// come last unless an empty name is in patchNames.
class PatchRuns {
 public:
  /// @throws Error(Argument) for the name of a patch with polygons that a reader would not recover
  /// from a line of text.
  explicit PatchRuns(const PolygonSoup& soup);
  PatchRuns(const PatchRuns&) = delete;  // runs_ views order_
  PatchRuns& operator=(const PatchRuns&) = delete;
  ~PatchRuns() = default;

  [[nodiscard]] auto begin() const { return runs_.begin(); }
  [[nodiscard]] auto end() const { return runs_.end(); }

 private:
  std::vector<std::uint32_t> order_;
  std::vector<PatchRun> runs_;
};

}  // namespace cutwater::formats
