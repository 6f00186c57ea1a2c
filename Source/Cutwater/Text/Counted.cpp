#include <Cutwater/Text/Counted.hpp>

namespace cutwater::detail {

std::string counted(std::size_t count, std::string_view singular, std::string_view plural) {
  return std::to_string(count).append(" ").append(count == 1 ? singular : plural);
}

}  // namespace cutwater::detail
