#pragma once

#include <cstddef>

namespace cutwater::tool {

/// The memory, in bytes, that this process can have at most: that of the machine, or less where a
/// control group (a container, a batch job) or `ulimit -v` sets a limit.
[[nodiscard]] std::size_t memoryOfMachine();

}  // namespace cutwater::tool
