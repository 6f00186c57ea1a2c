#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cutwater::detail {

/// "1 open edge", "7 open edges".
[[nodiscard]] std::string counted(std::size_t count, std::string_view singular,
                                  std::string_view plural);

}  // namespace cutwater::detail
