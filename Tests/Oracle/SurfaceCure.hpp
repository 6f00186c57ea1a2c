#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <string>

namespace cutwater::test {

/// What was done to make a solid of a surface.
struct Cure {
  /// By clean(), with points welded within 1e-6 of the diagonal where that closes something.
  std::size_t corrections = 0;
  std::size_t capped = 0;  ///< openings closed on planes across an axis
  bool extended = false;   ///< a terrain, down to a plane below it
  std::size_t holes = 0;   ///< filled
  bool wrapped = false;
  double gap = 0;  ///< of the wrap, a length
  std::string failure = {};

  /// "clean, 2 caps, 1 hole".
  [[nodiscard]] std::string text() const;
};

/// Makes a closed surface as somebody would who looks at what is wrong: cleans, extends a terrain
/// to a plane below, caps what is open on planes, fills small holes, and wraps what is still open.
[[nodiscard]] Cure cure(PolygonSoup& soup);

}  // namespace cutwater::test
