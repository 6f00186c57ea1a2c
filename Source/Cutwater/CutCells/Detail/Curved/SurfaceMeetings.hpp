#pragma once

#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>

#include <optional>
#include <span>

namespace cutwater {

/// The point of a region in which as many surfaces meet as it has dimensions, two or three: by
/// Newton's method from its middle. None if that ends outside, or nowhere.
[[nodiscard]] std::optional<Vec3<double>> meetingOf(std::span<const FluidField* const> surfaces,
                                                    const Box<double>& region);

}  // namespace cutwater
