#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater::detail {

/// Leaves out repeats (a a) and spikes (a b a): edges of no extent, or traversed to and fro.
void takeDistinct(std::span<const std::uint32_t> polygon, std::vector<std::uint32_t>& corners);

}  // namespace cutwater::detail
