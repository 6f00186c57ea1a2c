#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/UnaryOperation.hpp>
#include <Cutwater/Render/PatchColors.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>

#include <cmath>
#include <iostream>
#include <memory>
#include <unistd.h>

#include "Commands/Commands.hpp"
#include "Commands/Picture.hpp"
#include "Options/Arguments.hpp"
#include "Options/Choice.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/OutputFile.hpp"
#include "Report/Format.hpp"
#include "Report/ProgressBar.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

struct Cut {
  int axis;
  double value;
  std::optional<CutPlane::Keep> keep;  // without it: the part farther from the viewer
};

struct RenderSettings {
  SurfaceOptions surface;
  RenderOptions render;
  std::vector<Cut> cuts;
  std::string output;
  std::optional<PictureQuality> quality;
  bool solid = false;
  bool noAxes = false;
};

/// The sheets of a mesh, which enclose nothing: distances without signs are faster to compute.
class Sheets final : public UnaryOperation<double> {
 public:
  explicit Sheets(const MeshSDF<double>& mesh)
      : UnaryOperation(mesh.signedByNearest()), box_(mesh.surfaceBox()) {}

 private:
  double localSignedDistance(const Vec3<double>& p) const override {
    return std::abs(operand().signedDistance(p));
  }
  void localSignedDistances(std::span<const Vec3<double>> points,
                            std::span<double> distances) const override {
    operandValues(points, distances);
    for (auto& distance : distances) distance = std::abs(distance);
  }
  SurfacePoint<double> localClosestPoint(const Vec3<double>& p) const override {
    return operand().closestPoint(p);
  }
  void localClosestPoints(std::span<const Vec3<double>> points,
                          std::span<SurfacePoint<double>> results) const override {
    operandPoints(points, results);
  }
  bool localFacetsIn(const OrientedBox<double>& box, FacetVisitor<double> visit) const override {
    return facetsOf(operand(), box, visit);
  }
  Guarantee<double> localGuarantee() const override {
    return Guarantee<double>::exact(operand().guarantee().size);
  }
  Box<double> localBoundingBox() const override { return box_; }
  std::string localName() const override { return "Sheets"; }

  Box<double> box_;
};

/// "z=0.5", "z=0.5:upper".
Cut cutOf(const std::string& text) {
  const auto colon = text.find(':');
  const auto side = colon == std::string::npos ? "" : text.substr(colon);
  const bool isKnown = side.empty() || side == ":lower" || side == ":upper";
  if (text.find('=') != 1 || !isKnown) {
    refuse("--cut", text, "an axis, a value, and perhaps the side to keep: z=0.5 or y=0:upper");
  }
  Cut cut{axisOf("--cut", text.substr(0, 1)),
          numbers("--cut", text.substr(0, colon).substr(2), 1).front(),
          {}};
  if (!side.empty()) cut.keep = side == ":upper" ? CutPlane::Keep::Upper : CutPlane::Keep::Lower;
  return cut;
}

View viewOf(const std::string& text) {
  constexpr const char* kNeed =
      "+x, -x, +y, -y, +z, -z, iso, or AZIMUTH,ELEVATION in degrees: 30,20";
  try {
    if (text.find(',') == std::string::npos) return View::named(text);
    const auto angles = numbers("--view", text, 2);
    return View::fromAngles(angles[0], angles[1]);
  } catch (const Error&) {
    refuse("--view", text, kNeed);
  }
}

std::optional<Rgb> colorOf(const std::string& text) {
  if (text == "patches") return {};
  const auto color = colorNamed(text);
  if (!color) {
    refuse("--color", text,
           "patches, steel, white, grey, graphite, sand, copper, red, green, blue, or #RRGGBB");
  }
  return color;
}

void addCameraOptions(Command command, RenderSettings& options) {
  auto& render = options.render;
  command.add("--view", "VIEW",
              "Where the viewer is: +x, -x, +y, -y, +z, -z, iso, or degrees from +x towards +y and "
              "above the xy plane [default: iso]",
              [&](const std::string& text) { render.view = viewOf(text); });
  command.addNumber("--perspective", "DEGREES",
                    "Draw in perspective, the longer side of the picture as wide as this angle",
                    render.fieldOfView, {0.1, 150.0});
  command.addRepeated(
      "--cut", "AXIS=VALUE[:lower|:upper]",
      "Take away what is on one side of a plane; without a side to keep: what is nearer to the "
      "viewer; may be repeated",
      [&](const std::string& text) { options.cuts.push_back(cutOf(text)); }, Values::Several);
  command.add("--show", "X0,Y0,Z0,X1,Y1,Z1",
              "The box that fills the picture, by its corners [default: all of the surface]",
              [&](const std::string& text) { render.show = boxOf("--show", text); });
  command.addFlag("--solid",
                  "Of a surface that is not closed, show only what bounds a solid, as the signs "
                  "have it, and not every sheet; slow where holes are large",
                  options.solid);
}

void addLookOptions(Command command, RenderSettings& options) {
  auto& render = options.render;
  command.add(
      "--color", "patches|NAME",
      "One colour for each patch, or one for all: steel, white, grey, graphite, sand, copper, red, "
      "green, blue or #RRGGBB [default: patches]",
      [&](const std::string& text) { render.color = colorOf(text); });
  addSizeOption(command, render.width, render.height);
  command.addText("--title", "The picture's title [default: the file's name]", render.title);
  addChoice<std::optional<PictureQuality>>(
      command, "--quality", options.quality,
      {{"draft", PictureQuality::Draft}, {"final", PictureQuality::Final}},
      "How much work goes into the picture [default: draft if the command writes to a terminal, "
      "final if not, as in scripts]");
  command.addText("--unit", "Unit of lengths, for the scale bar: m", render.unit);
  command.addFlag("--no-axes", "Neither axes nor a scale bar", options.noAxes);
  command.addFlag("--transparent", "No background instead of a white one", render.transparent);
}

void run(RenderSettings options) {
  auto solid = loadSolid(options.surface);
  auto& render = options.render;
  const auto* const mesh = solid.as<MeshSDF<double>>();
  render.sheets = mesh != nullptr && !mesh->signReport().isClosed() && !options.solid;
  if (render.sheets && options.cuts.empty()) {
    Solid<double> quicker(Sheets{*mesh});
    quicker.setPlacement(solid.placement());
    solid = std::move(quicker);
  }
  // An unbounded solid ends at the box that is shown.
  if (!isFinite(solid.boundingBox())) {
    render.region = render.show;
    if (const auto box = boxAround(solid); !render.show && isFinite(box)) render.region = box;
  }
  render.axes = !options.noAxes;
  const auto usual = isatty(STDOUT_FILENO) == 1 ? PictureQuality::Draft : PictureQuality::Final;
  render.quality = options.quality.value_or(usual);
  if (render.title.empty()) render.title = fileName(options.surface);
  for (const auto& cut : options.cuts) {
    const auto farther =
        render.view.back[cut.axis] < 0 ? CutPlane::Keep::Upper : CutPlane::Keep::Lower;
    render.cuts.push_back(CutPlane::across(cut.axis, cut.value, cut.keep.value_or(farther)));
  }
  Stopwatch watch;
  {
    ProgressBar bar("drawing", !options.surface.quiet);
    render.threads = options.surface.threads;
    render.progress = bar.callback();
    writePng(options.output, cutwater::render(solid, render));
  }
  if (options.surface.quiet) return;
  std::cout << "wrote " << onOneLine(options.output) << ": " << render.width << " x "
            << render.height << " pixels, in " << duration(watch.lap()) << '\n';
  if (!options.quality && render.quality == PictureQuality::Draft) {
    std::cout << "a draft, as it is for a terminal; --quality final takes longer\n";
  }
  if (render.sheets) {
    std::cout << "the surface is not closed: all of it is shown; --solid shows what the signs make "
                 "of it\n";
  }
}

}  // namespace

void addRender(Program& program) {
  const auto options = std::make_shared<RenderSettings>();
  auto command = program.addCommand(
      "render", "Draw the surface as a PNG picture, shaded, with cuts and colours of patches");
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  addSignOptions(command, options->surface);
  addOutput(command, "-o,--output", options->output, {".png"}, "The picture to write").required();
  addCameraOptions(command, *options);
  addLookOptions(command, *options);
  command.setFooter(
      "Examples:\n"
      "  cutwater render hull.stl -o hull.png\n"
      "  cutwater render hull.stl --cut z=0.244 --view=-60,25 --unit m --title Waterline -o "
      "water.png\n"
      "  cutwater render car.obj --view=-y --color patches --size 2400x1200 -o side.png");
  command.setAction([=] { run(*options); });
}

}  // namespace cutwater::tool
