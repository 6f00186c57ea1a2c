#pragma once

#include <cstdlib>

namespace cutwater::test {

/// A number of probes, times CUTWATER_TEST_SCALE from the environment where a long run sets it.
inline int scaled(int count) {
  static const char* const text = std::getenv("CUTWATER_TEST_SCALE");
  static const int factor = text != nullptr ? std::atoi(text) : 1;
  return factor > 0 ? count * factor : count;
}

}  // namespace cutwater::test
