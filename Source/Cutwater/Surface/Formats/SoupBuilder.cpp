#include <Cutwater/Core/Detail/MixedBits.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Formats/SoupBuilder.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace cutwater::formats {

void requireReadOptions(const ReadOptions& options) {
  require(options.scale > 0 && std::isfinite(options.scale),
          "readSurface: need 0 < scale < infinity", Named{"scale", options.scale});
  require(isFinite(options.placement.offset()), "readSurface: need a finite placement",
          Named{"offset", options.placement.offset()});
}

std::string patchNameOf(const std::string& file) {
  std::filesystem::path name = std::filesystem::path(file).filename();
  if (name.extension() == ".gz") name = name.stem();
  name = name.stem();
  return name.empty() ? "surface" : name.string();
}

SoupBuilder::SoupBuilder(const ReadOptions& options, std::string defaultPatch, std::uint64_t most)
    : options_(options), defaultPatch_(std::move(defaultPatch)), most_(most) {
  patchName_ = defaultPatch_;
}

void SoupBuilder::reservePolygons(std::uint64_t count, std::uint64_t corners) {
  soup_.offsets.reserve(soup_.offsets.size() + count);
  soup_.patches.reserve(soup_.patches.size() + count);
  soup_.corners.reserve(soup_.corners.size() + corners);
}

Vec3<double> SoupBuilder::placed(const Vec3<double>& asInFile, const Cursor& at) const {
  if (!isFinite(asInFile)) at.fail("a coordinate is not finite");
  const Vec3<double> scaled = options_.scale * asInFile;
  const bool moved = !options_.placement.isIdentity();
  const Vec3<double> point = moved ? options_.placement.toWorld(scaled) : scaled;
  if (!isFinite(point)) at.fail("a coordinate is not finite after scale and placement");
  return point;
}

void SoupBuilder::requireRoom(std::uint64_t count, const char* what, const Cursor& at) const {
  if (count < most_) return;
  at.failLimit("more than " + std::to_string(most_) + " " + what);
}

std::uint32_t SoupBuilder::appended(const Vec3<double>& point, const Cursor& at) {
  requireRoom(soup_.points.size(), "points", at);
  soup_.points.push_back(point);
  return static_cast<std::uint32_t>(soup_.points.size() - 1);
}

void SoupBuilder::addPoint(const Vec3<double>& asInFile, const Cursor& at) {
  static_cast<void>(appended(placed(asInFile, at), at));
  ++report_.pointsInFile;
}

void SoupBuilder::addCorner(std::int64_t index, const Cursor& at) {
  const auto point = static_cast<std::uint64_t>(index);
  if (index < 0 || point >= kMost) {
    at.fail("index " + std::to_string(index + (index < 0 ? 0 : firstIndex_)) + " is out of range");
  }
  if (point >= soup_.points.size() && point >= furthest_) {
    furthest_ = point + 1;
    furthestPlace_ = at.place();
  }
  soup_.corners.push_back(static_cast<std::uint32_t>(point));
}

void SoupBuilder::addCorner(const Vec3<double>& asInFile, const Cursor& at) {
  pointsByCorner_ = true;
  ++report_.pointsInFile;
  const Vec3<double> point = placed(asInFile, at);
  auto& points = soup_.points;
  std::uint32_t id = appended(point, at);
  if (options_.weld) {
    const std::uint32_t first = weld_.findOrInsert(
        id, [&](std::uint32_t i) { return detail::hashOf(points[i]); },
        [&](std::uint32_t i) { return points[i] == point; });
    if (first != id) points.pop_back();
    id = first;
  }
  soup_.corners.push_back(id);
}

void SoupBuilder::endPolygon(const Cursor& at) {
  const std::uint64_t corners = soup_.corners.size() - soup_.offsets.back();
  if (corners < 3) at.fail("a face has " + std::to_string(corners) + " corners");
  requireRoom(soup_.polygonCount(), "faces", at);
  soup_.offsets.push_back(soup_.corners.size());
  soup_.patches.push_back(patchId());
}

void SoupBuilder::addStripCorner(std::int64_t index, const Cursor& at) {
  if (cornersOfStrip_ >= 2) {
    const std::size_t turned = cornersOfStrip_ % 2;
    addCorner(lastOfStrip_[turned], at);
    addCorner(lastOfStrip_[1 - turned], at);
    addCorner(index, at);
    endPolygon(at);
  }
  lastOfStrip_ = {lastOfStrip_[1], index};
  ++cornersOfStrip_;
}

void SoupBuilder::endStrip(const Cursor& at) {
  if (cornersOfStrip_ < 3) at.fail("a strip has " + std::to_string(cornersOfStrip_) + " points");
  cornersOfStrip_ = 0;
}

void SoupBuilder::setPatch(std::string_view name) {
  if (name.empty()) name = defaultPatch_;
  if (name == patchName_) return;
  patchName_ = name;
  patch_ = kNone;
}

std::uint32_t SoupBuilder::patchId() {
  auto& names = soup_.patchNames;
  if (patch_ != kNone) return patch_;
  const auto candidate = static_cast<std::uint32_t>(names.size());
  names.emplace_back(patchName_);
  patch_ = patchTable_.findOrInsert(
      candidate,
      [&](std::uint32_t i) { return detail::mixed(std::hash<std::string_view>{}(names[i])); },
      [&](std::uint32_t i) { return names[i] == patchName_; });
  if (patch_ != candidate) names.pop_back();
  return patch_;
}

std::size_t SoupBuilder::countUnusedPoints() const {
  std::vector<bool> used(soup_.points.size());
  for (const std::uint32_t corner : soup_.corners) used[corner] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

SurfaceFile SoupBuilder::finish(const Cursor& at) && {
  if (furthest_ > soup_.points.size()) {
    const auto index = furthest_ - 1 + static_cast<std::uint64_t>(firstIndex_);
    at.failAt(furthestPlace_, "index " + std::to_string(index) + " is out of range: the file has " +
                                  std::to_string(soup_.points.size()) + " points");
  }
  if (soup_.polygonCount() == 0) at.fail("the file has no faces");
  report_.polygonsInFile = soup_.polygonCount();
  if (options_.weld && !pointsByCorner_) weldExactly(soup_);
  report_.pointsMerged = report_.pointsInFile - soup_.points.size();
  report_.pointsUnused = countUnusedPoints();
  soup_.points.shrink_to_fit();
  soup_.offsets.shrink_to_fit();
  soup_.corners.shrink_to_fit();
  soup_.patches.shrink_to_fit();
  return {std::move(soup_), std::move(report_)};
}

}  // namespace cutwater::formats
