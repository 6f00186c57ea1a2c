#include <Cutwater/Surface/Detail/DistinctCorners.hpp>

namespace cutwater::detail {

void takeDistinct(std::span<const std::uint32_t> polygon, std::vector<std::uint32_t>& corners) {
  corners.clear();
  const auto drop = [&] { corners.pop_back(); };
  for (const std::uint32_t corner : polygon) {
    const auto n = corners.size();
    if (n >= 2 && corners[n - 2] == corner) {
      drop();
    } else if (n == 0 || corners[n - 1] != corner) {
      corners.push_back(corner);
    }
  }
  // The same where the end meets the beginning.
  auto first = corners.begin();
  while (corners.end() - first >= 2) {
    if (*first == corners.back()) {
      drop();
    } else if (*first == *(corners.end() - 2)) {
      drop();
    } else if (*(first + 1) == corners.back()) {
      ++first;
    } else {
      break;
    }
  }
  corners.erase(corners.begin(), first);
}

}  // namespace cutwater::detail
