#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Segment.hpp>

#include <optional>

namespace cutwater {

/// A part of a segment, and the whole segment's parameters at its ends.
struct ClippedSegment {
  Segment<double> part;
  double start = 0;
  double end = 1;
};

/// The part of the segment within the box; nothing if there is none. Ends outside are moved along
/// the segment, computed in twice the precision: however far they were, the part deviates from the
/// line by little more than the rounding of its own ends.
[[nodiscard]] std::optional<ClippedSegment> clipped(const Segment<double>& segment,
                                                    const Box<double>& box);

}  // namespace cutwater
