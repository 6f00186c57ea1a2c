#pragma once

#include <algorithm>
#include <cstdlib>

namespace cutwater::test {

/// A number of probes, times CUTWATER_TEST_SCALE from the environment: more for a long run, fewer
/// under a sanitizer.
inline int scaled(int count) {
  static const char* const text = std::getenv("CUTWATER_TEST_SCALE");
  static const double factor = text != nullptr ? std::atof(text) : 1;
  return factor > 0 ? std::max(1, static_cast<int>(count * factor)) : count;
}

}  // namespace cutwater::test
