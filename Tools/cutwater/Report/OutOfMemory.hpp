#pragma once

#include <Cutwater/Core/Error.hpp>

#include <new>
#include <string>

namespace cutwater::tool {

/// Runs the work, and returns its result. If memory runs out in it, the error says during what.
/// @param what  as in "hull.stl: out of memory while reading it".
template <typename Work>
auto namingMemory(const std::string& what, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::Limit, what);
  }
}

}  // namespace cutwater::tool
