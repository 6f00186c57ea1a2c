#pragma once

#include <Cutwater/Render/Detail/RenderLayout.hpp>
#include <Cutwater/Render/Render.hpp>

#include <algorithm>

namespace cutwater::test {

inline constexpr int kWidth = 480;
inline constexpr int kHeight = 400;

/// Nothing but the solid, before no background, to a known scale: a cube of side 2.4 fills it.
inline RenderOptions bare(const View& view) {
  RenderOptions options;
  options.view = view;
  options.show = Box<double>{{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}};
  options.width = kWidth;
  options.height = kHeight;
  options.transparent = true;
  options.lines = options.axes = options.legend = false;
  return options;
}

/// Of such a picture along an axis.
inline double pixelSize() {
  const auto frame = detail::RenderLayout(kWidth, kHeight, {}).frame();
  return 2.4 / std::min(frame.width, frame.height);
}

inline double covered(const Image& image) {
  double sum = 0;
  for (const auto opacity : image.opacities()) sum += opacity / 255.0;
  return sum;
}

}  // namespace cutwater::test
