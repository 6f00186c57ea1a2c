#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Curved/PieceProof.hpp>

#include <algorithm>

namespace cutwater {

using Part = CertainParts::Part;

PieceProof::PieceProof(const FluidField& field, const Box<double>& box,
                       const CertifyOptions& options)
    : options_(options), volume_(field, box) {
  constexpr std::array<int, 3> kLevels{0, 2, 5};  // of faces and edges
  // Of each axis: along it, or at one of its two ends.
  constexpr int kCodes = 27;
  for (int code = 1; code < kCodes; ++code) {
    CertainParts::Place ends{};
    auto flat = box;
    std::size_t across = 0;
    int rest = code;
    for (int axis = 0; axis < 3; ++axis, rest /= 3) {
      if (rest % 3 == 0) continue;
      ++across;
      const bool isLow = rest % 3 == 1;
      ends[static_cast<std::size_t>(axis)] = isLow ? kLow : kHigh;
      flat.lower[axis] = flat.upper[axis] = isLow ? box.lower[axis] : box.upper[axis];
    }
    if (across < 3) sides_.push_back({{field, flat}, ends, kLevels[across]});
  }
}

bool PieceProof::has(std::size_t count) {
  while (volume_.openShare() > options_.width || !areApart(count)) {
    const bool isFine = volume_.openShare() <= options_.width;
    if (isFine && refineSides() && areApart(count)) return true;
    if (!halve(volume_)) return false;
  }
  return true;
}

/// False if that would take too many boxes.
bool PieceProof::halve(CertainParts& parts) {
  if (looked_ + parts.costOfHalving() > options_.boxes) return false;
  looked_ += parts.costOfHalving();
  parts.halve();
  return true;
}

bool PieceProof::refineSides() {
  for (auto& side : sides_) {
    while (side.parts.side() < volume_.side() << static_cast<unsigned>(side.levels)) {
      if (!halve(side.parts)) return false;
    }
  }
  return true;
}

/// Calls join(one, other) with parts of the volume that are fluid, and connected through a side.
template <typename Join>
void PieceProof::joinThrough(const Side& side, const Join& join) const {
  const auto& parts = side.parts.parts();
  detail::DisjointSets fluid(parts.size());
  side.parts.forNeighbours([&](std::uint32_t one, std::uint32_t other) {
    if (parts[one] == Part::Fluid && parts[other] == Part::Fluid) fluid.unite(one, other);
  });
  const auto finer = side.parts.side() / volume_.side();
  constexpr std::uint32_t kNoPart = 0xffffffff;
  std::vector<std::uint32_t> known(parts.size(), kNoPart);  // of a set: a part of the volume
  side.parts.forEach([&](std::uint32_t number, const CertainParts::Place& at) {
    if (parts[number] != Part::Fluid) return;
    std::size_t beside = 0;
    for (std::size_t a = 3; a-- > 0;) {
      const auto end = side.ends[a];
      const auto last = volume_.side() - 1;
      beside = beside * volume_.side() + (end == kLow ? 0 : end == kHigh ? last : at[a] / finer);
    }
    if (volume_.parts()[beside] != Part::Fluid) return;
    auto& other = known[fluid.find(number)];
    if (other == kNoPart) {
      other = static_cast<std::uint32_t>(beside);
    } else {
      join(other, static_cast<std::uint32_t>(beside));
    }
  });
}

bool PieceProof::areApart(std::size_t count) const {
  const auto& parts = volume_.parts();
  detail::DisjointSets fluid(parts.size());
  detail::DisjointSets notBody(parts.size());
  volume_.forNeighbours([&](std::uint32_t one, std::uint32_t other) {
    if (parts[one] == Part::Body || parts[other] == Part::Body) return;
    notBody.unite(one, other);
    if (parts[one] == Part::Fluid && parts[other] == Part::Fluid) fluid.unite(one, other);
  });
  for (const auto& side : sides_) {
    if (side.parts.side() <= volume_.side()) continue;
    joinThrough(side, [&](std::uint32_t one, std::uint32_t other) { fluid.unite(one, other); });
  }
  std::size_t fluidSets = 0;
  std::size_t notBodySets = 0;
  std::vector<std::uint32_t> withFluid;  // sets that are not body, one for each set that is fluid
  for (std::uint32_t n = 0; n < parts.size(); ++n) {
    if (parts[n] == Part::Body) continue;
    if (notBody.isRoot(n)) ++notBodySets;
    if (parts[n] != Part::Fluid || !fluid.isRoot(n)) continue;
    ++fluidSets;
    withFluid.push_back(notBody.find(n));
  }
  std::ranges::sort(withFluid);
  const bool areConnected = std::ranges::adjacent_find(withFluid) == withFluid.end();
  return areConnected && fluidSets <= count && count <= notBodySets;
}

}  // namespace cutwater
