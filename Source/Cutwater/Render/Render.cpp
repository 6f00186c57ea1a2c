#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/PartInSight.hpp>
#include <Cutwater/Render/PatchColors.hpp>
#include <Cutwater/Render/PixelSamples.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Render/RenderLayout.hpp>
#include <Cutwater/Render/Shading.hpp>
#include <Cutwater/Render/SphereTracer.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

using detail::Camera;
using detail::KeptRegion;
using detail::LegendEntry;
using detail::PicturePoint;
using detail::PixelSamples;
using detail::RenderLayout;
using detail::SphereTracer;
using detail::SurfaceSample;

constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;
constexpr double kUsualFieldOfView = 30;
constexpr double kRoom = 1e-3;       // around a bounding box, so that a flat one can be looked into
constexpr double kOcclusion = 0.07;  // how far to look for it; both in diagonals of what is shown
constexpr double kLineWidth = 0.7;   // pixels

bool isProper(const Box<double>& box) {
  return isFinite(box) && !box.empty() && std::isfinite(box.diagonal()) && box.diagonal() > 0;
}

void check(const RenderOptions& options) {
  require(options.width >= 320 && options.height >= 240 &&
              std::int64_t{options.width} * options.height <= kMostPixels,
          "render: need at least 320 x 240 and at most 2^26 pixels", Named{"width", options.width},
          Named{"height", options.height});
  require(options.fieldOfView >= 0 && options.fieldOfView <= 150,
          "render: need a field of view from 0 to 150 degrees",
          Named{"fieldOfView", options.fieldOfView});
  for (const auto& box : {options.region, options.show}) {
    require(!box || isProper(*box), "render: need a finite box that is not empty");
  }
}

/// What is looked into: all of the solid, or what is in the region.
template <std::floating_point T>
Box<double> lookedInto(const SignedDistanceFunction<T>& solid, const RenderOptions& options) {
  const auto bounds = solid.boundingBox();
  require(!bounds.empty(), "render: the solid is empty");
  Box<double> box{Vec3<double>(bounds.lower), Vec3<double>(bounds.upper)};
  require(options.region || isFinite(box),
          "render: the solid is unbounded, so say which region to show");
  // Infinite sides stay where they are.
  box = box.grown(kRoom * (options.region ? options.region->diagonal() : box.diagonal()));
  if (options.region) box = box.intersection(*options.region);
  require(isProper(box), "render: nothing is left to show");
  return box;
}

Camera cameraFor(const RenderOptions& options, const Box<double>& rest,
                 const detail::Frame& frame) {
  if (options.eye) {
    const double angle = options.fieldOfView > 0 ? options.fieldOfView : kUsualFieldOfView;
    return {*options.eye, frame, angle};
  }
  return {options.view, options.show.value_or(rest), frame, options.fieldOfView};
}

/// The largest ones in sight first.
std::vector<LegendEntry> legendOf(const PixelSamples& samples, std::span<const std::string> names) {
  const auto pixels = samples.pixelsOfPatches(names.size());
  std::vector<std::size_t> patches;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (pixels[i] > 0) patches.push_back(i);
  }
  std::stable_sort(patches.begin(), patches.end(),
                   [&](std::size_t a, std::size_t b) { return pixels[a] > pixels[b]; });
  std::vector<LegendEntry> entries;
  for (const auto i : patches) entries.push_back({names[i], patchColor(i)});
  return entries;
}

template <std::floating_point T>
auto calls(const SphereTracer<T>& tracer) {
  return [&](std::span<const PicturePoint> points, double spacing, std::span<SurfaceSample> found) {
    tracer.trace(points, spacing, found);
  };
}

void drawSamples(Image& image, const PixelSamples& samples, const Camera& camera, double scale,
                 bool byPatch, const RenderOptions& options) {
  const detail::Shading shading(camera.view(), scale);
  const Rgb one = options.color.value_or(*colorNamed("steel"));
  samples.draw(image,
               [&](const SurfaceSample& sample, const PicturePoint& at) {
                 if (sample.isCut()) return shading.cutFace(options.cutColor, at);
                 return shading.surface(sample, byPatch ? patchColor(sample.surface) : one);
               },
               options.lines ? kLineWidth : 0, {.threads = options.threads, .progress = {}});
}

}  // namespace

template <std::floating_point T>
Image render(const SignedDistanceFunction<T>& solid, const RenderOptions& options) {
  check(options);
  const KeptRegion region(lookedInto(solid, options), options.cuts, options.region.has_value());
  const auto rest = region.rest();
  require(isProper(rest), "render: the cuts leave nothing to show");

  const auto names = solid.patchNames();
  const bool byPatch = !options.color && names.size() > 1;
  const bool hasLegend = byPatch && options.legend;
  const RenderLayout layout(options.width, options.height,
                            {.title = !options.title.empty(),
                             .axes = options.axes,
                             .legend = hasLegend ? std::span(names) : std::span(names).first(0)});
  auto camera = cameraFor(options, rest, layout.frame());
  const detail::TraceOptions trace{.sheets = options.sheets,
                                   .occlusionRadius = kOcclusion * rest.diagonal()};
  if (!options.show && !options.eye) {
    const SphereTracer<T> overview(solid, region, camera, {.sheets = options.sheets});
    // Parts that these few rays cannot know of might be beyond the picture then.
    const auto part = overview.knowsDistances() ? partInSight(calls(overview), layout.frame(),
                                                              {.threads = options.threads})
                                                : std::nullopt;
    if (part) camera = camera.zoomed(*part, layout.frame());
  }
  const SphereTracer<T> tracer(solid, region, camera, trace);
  const PixelSamples samples(camera, layout.area(), calls(tracer),
                             {.threads = options.threads, .progress = options.progress});

  auto image = options.transparent ? Image::transparent(options.width, options.height)
                                   : Image(options.width, options.height);
  drawSamples(image, samples, camera, layout.scale(), byPatch, options);
  if (!options.title.empty()) layout.drawTitle(image, options.title);
  if (hasLegend) layout.drawLegend(image, legendOf(samples, names));
  if (options.axes) {
    layout.drawAxes(image, camera.view());
    if (camera.isOrthographic()) layout.drawScaleBar(image, camera.pixelSize(0), options.unit);
  }
  return image;
}

template Image render(const SignedDistanceFunction<float>&, const RenderOptions&);
template Image render(const SignedDistanceFunction<double>&, const RenderOptions&);

}  // namespace cutwater
