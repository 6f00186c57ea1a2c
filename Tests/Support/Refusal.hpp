#pragma once
#include <Cutwater/Core/Error.hpp>

#include <string>

namespace cutwater::test {

/// What an action is refused with; empty if it is not.
template <typename Action>
std::string refusal(const Action& action) {
  try {
    (void)action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace cutwater::test
