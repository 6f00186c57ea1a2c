#include "Commands/Picture.hpp"

#include <Cutwater/Render/Png.hpp>

#include <cmath>
#include <iostream>
#include <vector>

#include "Options/LoadSurface.hpp"
#include "Report/Format.hpp"
#include "Report/ProgressBar.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

/// Whether it is certain that there is no surface in a flat box.
bool isFreeOfSurface(const Solid<double>& solid, const Box<double>& flat, int axis) {
  constexpr int kHalvings = 12;
  struct Piece {
    Box<double> box;
    int halvings;
  };
  std::vector<Piece> pending{{flat, 0}};
  while (!pending.empty()) {
    auto [box, halvings] = pending.back();
    pending.pop_back();
    const auto found = solid.classify(box);
    if (found == BoxClass::Inside || found == BoxClass::Outside) continue;
    if (found == BoxClass::Cut || halvings == kHalvings) return false;
    const int side = (axis + 1 + halvings % 2) % 3;
    auto other = box;
    box.upper[side] = other.lower[side] = box.center()[side];
    pending.push_back({box, halvings + 1});
    pending.push_back({other, halvings + 1});
  }
  return true;
}

/// The part of the plane that the picture shows.
Box<double> shownOf(const SlicePlane<double>& plane,
                    const std::optional<SliceWindow<double>>& window, Box<double> box, int axis) {
  if (window) {
    const auto [lower, upper] = *window;
    box = {plane.origin + lower[0] * plane.right + lower[1] * plane.up,
           plane.origin + upper[0] * plane.right + upper[1] * plane.up};
  }
  box.lower[axis] = box.upper[axis] = plane.origin[axis];
  return box;
}

/// The box in the plane, with a tenth of its size around it.
SliceWindow<double> windowAround(const Box<double>& box, const SlicePlane<double>& plane) {
  const auto shown = box.grown(0.1 * maxComponent(box.size()));
  const auto lower = shown.lower - plane.origin;
  const auto upper = shown.upper - plane.origin;
  return {{dot(lower, plane.right), dot(lower, plane.up)},
          {dot(upper, plane.right), dot(upper, plane.up)}};
}

}  // namespace

void writePicture(const Solid<double>& solid, const SurfaceOptions& surface,
                  PictureOptions options) {
  auto& slice = options.slice;
  const auto box = boxAround(solid);
  const double middle = box.center()[options.axis];
  const double at = options.at.value_or(std::isfinite(middle) ? middle : 0);
  const auto plane = SlicePlane<double>::across(options.axis, at);
  if (!slice.window && slice.mesh == nullptr && !isFinite(solid.boundingBox()) && isFinite(box)) {
    slice.window = windowAround(box, plane);
  }
  const auto axis = "xyz"[options.axis];
  if (slice.title.empty()) {
    slice.title = fileName(surface) + ", " + axis + " = " + number(at, 4) +
                  (slice.unit.empty() ? "" : " " + slice.unit);
  }
  Stopwatch watch;
  {
    ProgressBar bar("drawing", !surface.quiet);
    slice.threads = surface.threads;
    slice.progress = bar.callback();
    writePng(options.output, renderSlice(solid, plane, slice));
  }
  if (surface.quiet) return;
  std::cout << "wrote " << onOneLine(options.output) << ": " << slice.width << " x " << slice.height
            << " pixels of the plane " << axis << " = " << number(at) << ", in "
            << duration(watch.lap()) << '\n';
  if (isFreeOfSurface(solid, shownOf(plane, slice.window, box, options.axis), options.axis)) {
    std::cout << "the plane does not meet the surface"
              << (slice.window ? " in this window\n" : "\n");
  }
}

}  // namespace cutwater::tool
