#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Detail/PartInSight.hpp>
#include <Cutwater/Render/Detail/PixelSamples.hpp>
#include <Cutwater/Render/Detail/RenderLayout.hpp>
#include <Cutwater/Render/Detail/Shading.hpp>
#include <Cutwater/Render/Detail/SolidTracer.hpp>
#include <Cutwater/Render/PatchColors.hpp>
#include <Cutwater/Render/Render.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>

namespace cutwater {

namespace {

using detail::Camera;
using detail::Frame;
using detail::KeptRegion;
using detail::LegendEntry;
using detail::PicturePoint;
using detail::PixelSamples;
using detail::RenderLayout;
using detail::SolidPart;
using detail::SolidTracer;
using detail::SurfaceSample;

constexpr double kUsualFieldOfView = 30;
/// Margin around the solid, as a fraction of the picture: rays that pass it within this margin
/// detect that.
constexpr double kRoom = 0.01;
constexpr double kOcclusion = 0.07;  // range, in diagonals of the shown part
/// What a picture's quality means for its samples; see PixelSamples::Rays.
struct Sampling {
  int lightSpacing;
  int side;
};
constexpr Sampling kDraft{.lightSpacing = 4, .side = 2};
constexpr Sampling kFinal{.lightSpacing = 2, .side = 3};
constexpr int kMostLooks = 3;         // to find the visible part
constexpr double kLargeEnough = 0.6;  // of the frame: a further look would not help
constexpr double kLineWidth = 0.7;    // pixels
constexpr double kUnit = 1e-6;        // tolerance on lengths of unit vectors

bool isProper(const Box<double>& box) {
  return isFinite(box) && !box.empty() && std::isfinite(box.diagonal()) && box.diagonal() > 0;
}

bool isUnit(const Vec3<double>& direction) {
  return std::abs(length(direction) - 1) < kUnit;
}

void checkDirections(const RenderOptions& options) {
  const auto& view = options.view;
  require(isUnit(view.back) && isUnit(view.up) && std::abs(dot(view.back, view.up)) < kUnit,
          "render: need a view of unit directions at a right angle", Named{"back", view.back},
          Named{"up", view.up});
  for (const auto& cut : options.cuts) {
    require(isUnit(cut.normal) && std::isfinite(cut.offset),
            "render: need cuts with unit normals and finite offsets", Named{"normal", cut.normal},
            Named{"offset", cut.offset});
  }
}

void check(const RenderOptions& options) {
  require(options.width >= 320 && options.height >= 240 &&
              std::int64_t{options.width} * options.height <= RenderOptions::kMostPixels,
          "render: need at least 320 x 240 and at most 2^26 pixels", Named{"width", options.width},
          Named{"height", options.height});
  require(options.fieldOfView >= 0 && options.fieldOfView <= 150,
          "render: need a field of view from 0 to 150 degrees",
          Named{"fieldOfView", options.fieldOfView});
  for (const auto& box : {options.region, options.show}) {
    require(!box || isProper(*box), "render: need a finite box that is not empty");
  }
  const auto room = options.region.value_or(Box<double>{{0, 0, 0}, {1, 1, 1}}).size();
  require(std::min({room.x, room.y, room.z}) > 0, "render: need a region that is not flat",
          Named{"size", room});
  checkDirections(options);
}

/// The box to search: the whole solid with some margin around it, or its intersection with the
/// region.
template <std::floating_point T>
Box<double> lookedInto(const SignedDistanceFunction<T>& solid, const RenderOptions& options,
                       double room) {
  const auto bounds = solid.boundingBox();
  require(!bounds.empty(), "render: the solid is empty");
  // Infinite sides are unchanged.
  auto box = Box<double>{Vec3<double>(bounds.lower), Vec3<double>(bounds.upper)}.grown(room);
  require(options.region || isFinite(box),
          "render: the solid is unbounded, so say which region to show");
  if (options.region) box = box.intersection(*options.region);
  require(isProper(box), "render: nothing is left to show");
  return box;
}

/// The part of the search box that the cuts leave.
template <std::floating_point T>
Box<double> whatIsLeft(const SignedDistanceFunction<T>& solid, const RenderOptions& options) {
  const auto rest =
      KeptRegion(lookedInto(solid, options, 0), options.cuts, options.region.has_value()).rest();
  require(isProper(rest), "render: the cuts leave nothing to show");
  return rest;
}

Camera cameraFor(const RenderOptions& options, const Box<double>& rest, const Frame& frame) {
  if (options.eye) {
    const double angle = options.fieldOfView > 0 ? options.fieldOfView : kUsualFieldOfView;
    return {*options.eye, frame, angle};
  }
  return {options.view, options.show.value_or(rest), frame, options.fieldOfView};
}

/// The size of a pixel at the far end of the box.
double largestPixel(const Camera& camera, const Box<double>& box) {
  return camera.pixelSize(length(box.center() - camera.ray(0, 0).origin) + box.diagonal());
}

/// Colours of patches; those with the same name share one.
class PatchTable {
 public:
  explicit PatchTable(std::span<const std::string> names) {
    std::unordered_map<std::string_view, std::size_t> known;
    for (const auto& name : names) {
      const auto [entry, isNew] = known.try_emplace(name, names_.size());
      if (isNew) names_.push_back(name);
      ranks_.push_back(entry->second);
    }
  }

  /// The names, each once.
  [[nodiscard]] std::span<const std::string> names() const { return names_; }
  [[nodiscard]] Rgb color(std::uint32_t patch) const {
    return patchColor(patch < ranks_.size() ? ranks_[patch] : 0);
  }

  /// Whether two patches have the same name.
  [[nodiscard]] bool areOne(std::uint32_t a, std::uint32_t b) const {
    return a < ranks_.size() && b < ranks_.size() && ranks_[a] == ranks_[b];
  }

  /// Entries for the visible patches, largest first.
  [[nodiscard]] std::vector<LegendEntry> legend(const PixelSamples& samples) const {
    std::vector<std::size_t> areas(names_.size());
    const auto ofPatches = samples.areasOfPatches(ranks_.size());
    for (std::size_t i = 0; i < ranks_.size(); ++i) areas[ranks_[i]] += ofPatches[i];
    std::vector<std::size_t> inSight;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      if (areas[i] > 0) inSight.push_back(i);
    }
    std::stable_sort(inSight.begin(), inSight.end(),
                     [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
    std::vector<LegendEntry> entries;
    for (const auto i : inSight) entries.push_back({names_[i], patchColor(i)});
    return entries;
  }

 private:
  std::vector<std::string> names_;
  std::vector<std::size_t> ranks_;  // index of each patch's name
};

template <std::floating_point T>
auto calls(const SolidTracer<T>& tracer) {
  return [&](std::span<const PicturePoint> points, const detail::RaySpread& spread,
             std::span<SurfaceSample> found) { tracer.trace(points, spread, found); };
}

/// From inside a solid nothing is visible.
template <std::floating_point T>
void checkEye(const SignedDistanceFunction<T>& solid, const KeptRegion& region,
              const Camera& camera) {
  const auto eye = camera.ray(0, 0).origin;
  require(camera.isOrthographic() || region.clearance(eye) > 0 ||
              !(solid.signedDistance(Vec3<T>(eye)) < 0),
          "render: the viewer is within the solid", Named{"eye", eye});
}

/// The camera turned to the visible part of the solid, which may be much smaller than its box.
template <std::floating_point T>
Camera aimed(Camera camera, const SignedDistanceFunction<T>& solid,
             std::span<const SolidPart<T>> parts, const KeptRegion& region, const Frame& frame,
             const RenderOptions& options) {
  for (int look = 0; look < kMostLooks; ++look) {
    const SolidTracer<T> tracer(solid, parts, region, camera, {.sheets = options.sheets});
    if (!tracer.knowsDistances()) {
      // Few rays could miss parts, which might then end up outside the picture.
      const auto part = detail::partOfFacets(solid, camera, frame);
      return part ? camera.zoomed(*part, frame) : camera;
    }
    const auto part = partInSight(calls(tracer), frame, {.threads = options.threads});
    if (!part) break;
    camera = camera.zoomed(*part, frame);
    if (std::max(part->width / frame.width, part->height / frame.height) > kLargeEnough) break;
  }
  return camera;
}

void drawSamples(Image& image, const PixelSamples& samples, const detail::Shading& shading,
                 const PatchTable& patches, const RenderOptions& options) {
  const bool byPatch = !options.color && patches.names().size() > 1;
  const Rgb one = options.color.value_or(*colorNamed("steel"));
  samples.draw(
      image,
      [&](const SurfaceSample& sample, const PicturePoint& at) {
        if (sample.isCut()) return shading.cutFace(options.cutColor, at);
        return shading.surface(sample, byPatch ? patches.color(sample.surface) : one);
      },
      [&](std::uint32_t a, std::uint32_t b) {
        const bool areCut = ((a | b) & SurfaceSample::kCutFace) != 0;
        return byPatch ? patches.areOne(a, b) : !areCut;
      },
      options.lines ? kLineWidth : 0, {.threads = options.threads, .progress = {}});
}

}  // namespace

template <std::floating_point T>
Image render(const SignedDistanceFunction<T>& solid, const RenderOptions& options) {
  check(options);
  const auto rest = whatIsLeft(solid, options);
  const PatchTable patches(solid.patchNames());
  const bool hasLegend = !options.color && patches.names().size() > 1 && options.legend;
  const RenderLayout layout(
      options.width, options.height,
      {.title = !options.title.empty(),
       .axes = options.axes,
       .legend = patches.names().first(hasLegend ? patches.names().size() : 0)});
  const auto frame = layout.frame();
  auto camera = cameraFor(options, rest, frame);
  const double room = kRoom * std::max(frame.width, frame.height) * largestPixel(camera, rest);
  const KeptRegion region(lookedInto(solid, options, room), options.cuts,
                          options.region.has_value());
  if (!options.sheets) checkEye(solid, region, camera);
  const auto parts = detail::partsOf(solid, region.box(), options.sheets, options.threads);
  if (!options.show && !options.eye) {
    camera = aimed<T>(camera, solid, parts, region, frame, options);
  }
  const bool isDraft = options.quality == PictureQuality::Draft;
  const SolidTracer<T> tracer(solid, parts, region, camera,
                              {.sheets = options.sheets,
                               .occlusionRadius = kOcclusion * rest.diagonal(),
                               .isDraft = isDraft});
  const auto trace = calls(tracer);
  const auto light = [&](std::span<const PicturePoint> points, std::span<SurfaceSample> seen) {
    tracer.light(points, seen);
  };
  const auto& lightSpacing = (isDraft ? kDraft : kFinal).lightSpacing;
  // Rays that meet flat pieces cost little.
  const auto hasFacets = [](const auto& part) { return part.facets.has_value(); };
  const bool isFlat = std::ranges::all_of(parts, hasFacets);
  const int side = (isDraft && !isFlat ? kDraft : kFinal).side;
  const PixelSamples samples(
      camera, layout.area(),
      {.trace = trace, .light = light, .lightSpacing = lightSpacing, .side = side},
      {.threads = options.threads, .progress = options.progress});

  auto image = options.transparent ? Image::transparent(options.width, options.height)
                                   : Image(options.width, options.height);
  drawSamples(image, samples, detail::Shading(camera.view(), layout.scale()), patches, options);
  if (!options.title.empty()) layout.drawTitle(image, options.title);
  if (hasLegend) layout.drawLegend(image, patches.legend(samples));
  if (options.axes) {
    layout.drawAxes(image, camera.view());
    if (camera.isOrthographic()) layout.drawScaleBar(image, camera.pixelSize(0), options.unit);
  }
  return image;
}

template Image render(const SignedDistanceFunction<float>&, const RenderOptions&);
template Image render(const SignedDistanceFunction<double>&, const RenderOptions&);

}  // namespace cutwater
