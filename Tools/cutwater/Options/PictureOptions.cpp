#include "Options/PictureOptions.hpp"

#include <Cutwater/Render/Render.hpp>

#include "Options/Arguments.hpp"

namespace cutwater::tool {

namespace {

void addWindow(Command command, PictureOptions& options) {
  command.add("--window", "A0,B0,A1,B1",
              "Show this rectangle of the plane, by its corners in the plane's two coordinates "
              "[default: the whole surface]",
              [&](const std::string& text) {
                const auto v = numbers("--window", text, 4);
                if (!(v[0] < v[2] && v[1] < v[3])) {
                  refuse("--window", text, "the lower corner and then the upper one");
                }
                options.slice.window = SliceWindow<double>{{v[0], v[1]}, {v[2], v[3]}};
              });
}

}  // namespace

void addSizeOption(Command command, int& width, int& height) {
  command.add("--size", "WxH", "Pixels [default: 1600x1000]", [&](const std::string& text) {
    constexpr const char* kNeed =
        "WIDTHxHEIGHT from 320x240, up to 32768 along a side and 2^26 pixels in all";
    const auto size = sizes("--size", text, kNeed);
    if (size.size() != 2 || size[0] < 320 || size[1] < 240 || size[0] > Image::kMaxSize ||
        size[1] > Image::kMaxSize || std::int64_t{size[0]} * size[1] > RenderOptions::kMostPixels) {
      refuse("--size", text, kNeed);
    }
    width = size[0];
    height = size[1];
  });
}

void addPictureOptions(Command command, PictureOptions& options) {
  command.add("--axis", "AXIS", "The plane's normal: x, y or z [default: y]",
              [&](const std::string& text) { options.axis = axisOf("--axis", text); });
  command.add("--at", "VALUE",
              "Where on that axis [default: the middle of the surface, or 0 if that has no end]",
              [&](const std::string& text) { options.at = numbers("--at", text, 1).front(); });
  addWindow(command, options);
  addSizeOption(command, options.slice.width, options.slice.height);
  command.addText("--title", "What stands above", options.slice.title);
  command.addText("--unit", "Unit of lengths, for the labels: m", options.slice.unit);
}

}  // namespace cutwater::tool
