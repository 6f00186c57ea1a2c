#pragma once

#include <Cutwater/Surface/Detail/IndexTable.hpp>
#include <Cutwater/Surface/Formats/TextNames.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <array>
#include <string_view>

namespace cutwater::formats {

/// @throws Error(Argument) unless scale and placement are possible.
void requireReadOptions(const ReadOptions& options);

/// The patch of faces without a name: "hull" for the file "models/hull.stl.gz".
[[nodiscard]] std::string patchNameOf(const std::string& file);

/// The only way from a file's numbers to a soup, and the only place that checks them: every
/// coordinate is finite after scale and placement, every index is in range, every polygon has at
/// least three corners, and nothing exceeds 32-bit indices. Readers only parse.
class SoupBuilder {
 public:
  /// With at most this many points and polygons, all indices are below kNone.
  static constexpr std::uint64_t kMost = kNone - 1;

  /// `most`: kMost, except in the tests of that limit.
  SoupBuilder(const ReadOptions& options, std::string defaultPatch, std::uint64_t most = kMost);
  SoupBuilder(const SoupBuilder&) = delete;
  SoupBuilder& operator=(const SoupBuilder&) = delete;
  SoupBuilder(SoupBuilder&&) = delete;
  SoupBuilder& operator=(SoupBuilder&&) = delete;
  ~SoupBuilder() = default;

  /// Reserves memory for this many more; counts must have passed Cursor::requireRecords().
  void reservePoints(std::uint64_t count) { soup_.points.reserve(pointCount() + count); }
  void reservePolygons(std::uint64_t count, std::uint64_t corners);
  /// Sets the file's number for its first point, for messages; 0 by default.
  void countPointsFrom(std::int64_t first) { firstIndex_ = first; }

  [[nodiscard]] std::uint64_t pointCount() const { return soup_.points.size(); }

  void addPoint(const Vec3<double>& asInFile, const Cursor& at);
  /// Adds a corner of the current polygon, by index; the point may follow later in the file.
  void addCorner(std::int64_t index, const Cursor& at);
  /// Adds a corner by its coordinates, as in STL; it is welded at once if that is requested.
  void addCorner(const Vec3<double>& asInFile, const Cursor& at);
  /// Ends the current polygon.
  void endPolygon(const Cursor& at);
  /// Add a strip of triangles corner by corner, by index; every second triangle has the opposite
  /// orientation.
  void addStripCorner(std::int64_t index, const Cursor& at);
  void endStrip(const Cursor& at);

  /// Sets the patch of the polygons that follow; an empty name stands for the default. A patch is
  /// created with its first polygon; equal names are one patch. The name is not copied until then,
  /// as it is part of the file.
  void setPatch(std::string_view name);

  ReadReport& report() { return report_; }
  void note(std::string sentence) { report_.notes.push_back(std::move(sentence)); }

  /// Makes the last checks, welds and counts. `at` is the end of the file.
  SurfaceFile finish(const Cursor& at) &&;

 private:
  [[nodiscard]] Vec3<double> placed(const Vec3<double>& asInFile, const Cursor& at) const;
  [[nodiscard]] std::uint32_t appended(const Vec3<double>& point, const Cursor& at);
  [[nodiscard]] std::uint32_t patchId();
  void requireRoom(std::uint64_t count, const char* what, const Cursor& at) const;
  [[nodiscard]] std::size_t countUnusedPoints() const;

  ReadOptions options_;
  std::string defaultPatch_;
  std::uint64_t most_;
  std::int64_t firstIndex_ = 0;
  std::string_view patchName_;
  std::uint32_t patch_ = kNone;  // its id, once it has one
  // The largest index beyond the points known when it was read, and its place in the file.
  std::uint64_t furthest_ = 0;
  Place furthestPlace_;
  bool pointsByCorner_ = false;
  std::array<std::int64_t, 2> lastOfStrip_{};
  std::uint64_t cornersOfStrip_ = 0;
  detail::IndexTable weld_;
  detail::IndexTable patchTable_;
  PolygonSoup soup_;
  ReadReport report_;
};

}  // namespace cutwater::formats
