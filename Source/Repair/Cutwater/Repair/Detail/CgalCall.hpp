#pragma once

#include <Cutwater/Core/Error.hpp>

#include <string>
#include <utility>

#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

namespace cutwater::detail {

/// During its lifetime, CGAL prints nothing about failures, which it also throws. CGAL's handlers
/// are global to the program.
class QuietCgal {
 public:
  QuietCgal()
      : errors_(CGAL::set_error_handler(&ignore)), warnings_(CGAL::set_warning_handler(&ignore)) {}
  ~QuietCgal() {
    CGAL::set_error_handler(errors_);
    CGAL::set_warning_handler(warnings_);
  }
  QuietCgal(const QuietCgal&) = delete;
  QuietCgal& operator=(const QuietCgal&) = delete;

 private:
  static void ignore(const char*, const char*, const char*, int, const char*) {}

  CGAL::Failure_function errors_;
  CGAL::Failure_function warnings_;
};

/// Returns the result of `call`. @throws Error(Topology) where CGAL fails.
template <typename Call>
auto callCgal(const char* caller, Call&& call) {
  const QuietCgal quiet;
  try {
    return std::forward<Call>(call)();
  } catch (const CGAL::Failure_exception& failure) {
    throw Error(
        ErrorKind::Topology,
        std::string(caller) + ": CGAL cannot go on with this surface: " + failure.expression());
  }
}

}  // namespace cutwater::detail
