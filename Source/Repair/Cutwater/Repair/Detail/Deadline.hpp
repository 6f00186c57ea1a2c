#pragma once

#include <Cutwater/Core/Error.hpp>

#include <chrono>
#include <string>

namespace cutwater::detail {

/// The time limit of a step that may take long.
class Deadline {
 public:
  using Clock = std::chrono::steady_clock;

  /// Starts now. @throws Error(Argument) unless 0 < seconds; it may be infinite.
  Deadline(const char* caller, double seconds) : caller_(caller), seconds_(seconds) {
    if (!(seconds > 0)) {
      throw Error(ErrorKind::Argument,
                  std::string(caller) + ": need seconds > 0 (seconds = " + toText(seconds) + ")");
    }
  }

  [[nodiscard]] double elapsed() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }
  [[nodiscard]] bool isOver() const { return elapsed() > seconds_; }
  /// @throws Error(Limit) if the time is up.
  void check() const {
    if (!isOver()) return;
    throw Error(ErrorKind::Limit,
                std::string(caller_) + ": not done within " + toText(seconds_) + " seconds");
  }

 private:
  const char* caller_;
  double seconds_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace cutwater::detail
