#include <Cutwater/Polyhedra/Detail/FaceRows.hpp>
#include <Cutwater/Polyhedra/Detail/JoinedPolygons.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace cutwater {

namespace {

/// Numbers in the order of their keys, those of one key in their own; keys are less than `count`.
template <typename KeyOf>
std::vector<std::uint32_t> sortedBy(const std::vector<std::uint32_t>& numbers, std::size_t count,
                                    const KeyOf& keyOf) {
  std::vector<std::uint32_t> next(count + 1, 0);
  for (const auto n : numbers) ++next[keyOf(n) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::uint32_t> sorted(numbers.size());
  for (const auto n : numbers) sorted[next[keyOf(n)]++] = n;
  return sorted;
}

}  // namespace

void FaceRows::add(std::span<const std::uint32_t> corners, std::uint32_t cell, std::uint32_t other,
                   std::uint32_t patch) {
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  const bool isInner = other != kNone;
  if (isInner && other < cell) {
    std::swap(cell, other);
    std::reverse(corners_.begin() + static_cast<std::ptrdiff_t>(first_.back()), corners_.end());
  }
  for (const auto of : {cell, other}) {
    if (of == kNone) continue;
    if (of >= counts_.size()) counts_.resize(of + std::size_t{1}, 0);
    ++counts_[of];
  }
  first_.push_back(corners_.size());
  owner_.push_back(cell);
  other_.push_back(isInner ? other : patch);
  isInner_.push_back(isInner ? 1 : 0);
}

FluidMesh::Faces FaceRows::inOrder(std::size_t cells, std::span<const Vec3<double>> points,
                                   std::vector<FluidMesh::Patch>& patches) const {
  std::vector<std::uint32_t> inner;
  std::vector<std::uint32_t> outer;
  for (std::uint32_t n = 0; n < owner_.size(); ++n) {
    (isInner_[n] != 0 ? inner : outer).push_back(n);
  }
  const auto owner = [&](std::uint32_t n) { return owner_[n]; };
  const auto other = [&](std::uint32_t n) { return other_[n]; };
  inner = sortedBy(sortedBy(inner, cells, other), cells, owner);
  outer = sortedBy(sortedBy(outer, cells, owner), patches.size(), other);

  FluidMesh::Faces faces;
  faces.first.reserve(first_.size());
  faces.corners.reserve(corners_.size());
  faces.owner.reserve(owner_.size());
  const auto add = [&](std::span<const std::uint32_t> corners, std::uint32_t n) {
    faces.corners.insert(faces.corners.end(), corners.begin(), corners.end());
    faces.first.push_back(faces.corners.size());
    faces.owner.push_back(owner_[n]);
    if (isInner_[n] != 0) faces.neighbour.push_back(other_[n]);
  };
  for (std::size_t first = 0; first < inner.size();) {
    const auto n = inner[first];
    auto last = first + 1;
    while (last < inner.size() && owner_[inner[last]] == owner_[n] &&
           other_[inner[last]] == other_[n]) {
      ++last;
    }
    if (last == first + 1) {
      add(cornersOf(n), n);
    } else {
      const auto same = std::span(inner).subspan(first, last - first);
      for (const auto& loop : joined(same, points)) add(loop, n);
    }
    first = last;
  }
  for (const auto n : outer) {
    auto& patch = patches[other_[n]];
    if (patch.faceCount == 0) patch.firstFace = static_cast<std::uint32_t>(faces.count());
    ++patch.faceCount;
    add(cornersOf(n), n);
  }
  return faces;
}

std::vector<CornerLoop> FaceRows::joined(std::span<const std::uint32_t> faces,
                                         std::span<const Vec3<double>> points) const {
  std::vector<CornerLoop> loops;
  for (const auto face : faces) {
    const auto corners = cornersOf(face);
    loops.emplace_back(corners.begin(), corners.end());
  }
  return joinedPolygons(loops, [&](std::size_t a, std::size_t b) {
    return areInOnePlane(loops[a], loops[b], points);
  });
}

}  // namespace cutwater
