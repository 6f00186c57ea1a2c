#pragma once

#include <chrono>
#include <utility>

namespace cutwater::tool {

class Stopwatch {
 public:
  /// Seconds since the start or the last call.
  double lap() {
    const auto before = std::exchange(start_, std::chrono::steady_clock::now());
    return std::chrono::duration<double>(start_ - before).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace cutwater::tool
