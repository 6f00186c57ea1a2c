#pragma once

#include <Cutwater/Core/Parallel.hpp>

#include <chrono>
#include <string>

namespace cutwater::tool {

/// Shows the progress of work that takes longer than a moment, on stderr and only if that is a
/// terminal. Its line is erased when the bar goes out of scope.
class ProgressBar {
 public:
  /// @param shown  false: never shows anything.
  ProgressBar(std::string what, bool shown);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ProgressBar(ProgressBar&&) = delete;
  ProgressBar& operator=(ProgressBar&&) = delete;

  /// The callback for the options of the work; empty if nothing is shown. The bar must outlive it.
  [[nodiscard]] Progress callback();

 private:
  using Clock = std::chrono::steady_clock;

  void show(double fraction);

  std::string what_;
  bool shown_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::milliseconds(400);
};

}  // namespace cutwater::tool
