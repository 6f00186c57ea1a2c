#pragma once

#include <Cutwater/P4est/DistributedOctree.hpp>

namespace cutwater::detail {

/// Of cut leaves of a part of an octree, those of `count` leaves from `first` on. `volumes`: of
/// each of these; `numbers`: of the leaves of the part among all.
[[nodiscard]] DistributedCut ownLeaves(const CutLeaves& part, std::uint32_t first,
                                       std::span<const double> volumes,
                                       std::span<const std::uint64_t> numbers);

}  // namespace cutwater::detail
