#pragma once

#include <string>

namespace cutwater::tool {

/// Shows which step of a work is being done, on stderr and only if that is a terminal. Its line is
/// erased when it goes out of scope.
class StepLine {
 public:
  /// @param shown  false: never shows anything.
  explicit StepLine(bool shown);
  ~StepLine();
  StepLine(const StepLine&) = delete;
  StepLine& operator=(const StepLine&) = delete;
  StepLine(StepLine&&) = delete;
  StepLine& operator=(StepLine&&) = delete;

  /// Replaces the step before: "reading hull.stl".
  void show(const std::string& step);

 private:
  bool shown_;
};

}  // namespace cutwater::tool
