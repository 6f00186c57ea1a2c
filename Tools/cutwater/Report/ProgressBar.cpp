#include "Report/ProgressBar.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <unistd.h>
#include <utility>

#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

constexpr int kWidth = 30;
constexpr std::chrono::milliseconds kInterval{100};

}  // namespace

ProgressBar::ProgressBar(std::string what, bool shown)
    : what_(std::move(what)), shown_(shown && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::cerr << "\r\033[K" << std::flush;
}

Progress ProgressBar::callback() {
  if (!shown_) return {};
  return [this](double fraction) { show(fraction); };
}

void ProgressBar::show(double fraction) {
  const auto now = Clock::now();
  if (now < next_ || fraction <= 0) return;
  next_ = now + kInterval;
  drawn_ = true;
  const auto full = static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * kWidth));
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const auto left = std::ceil(elapsed / fraction * (1 - fraction));
  std::string bar(static_cast<std::size_t>(full), '#');
  bar.resize(kWidth, '.');
  std::cerr << '\r' << what_ << " [" << bar << "] " << static_cast<int>(std::floor(100 * fraction))
            << " %, " << duration(left) << " left\033[K" << std::flush;
}

}  // namespace cutwater::tool
