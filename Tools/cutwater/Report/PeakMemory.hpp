#pragma once

#include <cstddef>
#include <optional>

namespace cutwater::tool {

/// The most memory, in bytes, that this process has had resident at a time so far, with everything:
/// the program's code, what it read, and what the allocator keeps. None if the system does not
/// tell.
[[nodiscard]] std::optional<std::size_t> peakResidentBytes();

}  // namespace cutwater::tool
