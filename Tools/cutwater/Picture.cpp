#include "Picture.hpp"

#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <vector>

#include "Arguments.hpp"
#include "Format.hpp"
#include "ProgressBar.hpp"

namespace cutwater::tool {

namespace {

void addWindow(CLI::App& command, PictureOptions& options) {
  command
      .add_option_function<std::string>(
          "--window",
          [&](const std::string& text) {
            const auto v = numbers("--window", text, 4);
            if (!(v[0] < v[2] && v[1] < v[3])) {
              refuse("--window", text, "the lower corner and then the upper one");
            }
            options.slice.window = SliceWindow<double>{{v[0], v[1]}, {v[2], v[3]}};
          },
          "Show this rectangle of the plane, by its corners in the plane's two coordinates; "
          "without it: the whole surface")
      ->type_name("A0,B0,A1,B1");
}

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

void addSizeOption(CLI::App& command, int& width, int& height) {
  command
      .add_option_function<std::string>(
          "--size",
          [&](const std::string& text) {
            constexpr const char* kNeed =
                "WIDTHxHEIGHT from 320x240, up to 32768 along a side and 2^26 pixels in all";
            const auto size = sizes("--size", text, kNeed);
            if (size.size() != 2 || size[0] < 320 || size[1] < 240 || size[0] > Image::kMaxSize ||
                size[1] > Image::kMaxSize ||
                std::int64_t{size[0]} * size[1] > RenderOptions::kMostPixels) {
              refuse("--size", text, kNeed);
            }
            width = size[0];
            height = size[1];
          },
          "Pixels; without it: 1600x1000")
      ->type_name("WxH");
}

void addPictureOptions(CLI::App& command, PictureOptions& options) {
  command
      .add_option_function<std::string>(
          "--axis", [&](const std::string& text) { options.axis = axisOf("--axis", text); },
          "The plane's normal: x, y or z; without it: y")
      ->type_name("AXIS");
  command
      .add_option_function<std::string>(
          "--at", [&](const std::string& text) { options.at = numbers("--at", text, 1).front(); },
          "Where on that axis; without it: the middle of the surface, or 0 if that has no end")
      ->type_name("VALUE");
  addWindow(command, options);
  addSizeOption(command, options.slice.width, options.slice.height);
  command.add_option("--title", options.slice.title, "What stands above");
  command.add_option("--unit", options.slice.unit, "Unit of lengths, for the labels: m");
}

void writePicture(const Solid<double>& solid, const SurfaceOptions& surface,
                  PictureOptions options) {
  auto& slice = options.slice;
  const auto box = boxAround(solid);
  const double middle = box.center()[options.axis];
  const double at = options.at.value_or(std::isfinite(middle) ? middle : 0);
  const auto plane = SlicePlane<double>::across(options.axis, at);
  if (!slice.window && !isFinite(solid.boundingBox()) && isFinite(box)) {
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
  std::cout << "wrote " << options.output << ": " << slice.width << " x " << slice.height
            << " pixels of the plane " << axis << " = " << number(at) << ", in "
            << duration(watch.lap()) << '\n';
  if (isFreeOfSurface(solid, shownOf(plane, slice.window, box, options.axis), options.axis)) {
    std::cout << "the plane does not meet the surface"
              << (slice.window ? " in this window\n" : "\n");
  }
}

}  // namespace cutwater::tool
