#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Render/CutPlane.hpp>
#include <Cutwater/Render/Image.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <optional>
#include <string>
#include <vector>

namespace cutwater {

/// How much work goes into a picture.
enum class PictureQuality : std::uint8_t {
  /// Half the time or less, except for meshes: rays take fewer steps, there are fewer of them at
  /// edges, and light is computed at fewer pixels.
  Draft,
  Final,
};

/// How a solid is shown. Lengths are in the solid's units.
struct RenderOptions {
  View view = View::named("iso");
  double fieldOfView = 0;  ///< degrees along the longer side; 0: orthographic
  /// Used instead of `view` and `show`; `fieldOfView` is then 30 degrees unless it is set.
  std::optional<Eye> eye = {};
  std::vector<CutPlane> cuts = {};  ///< each removes a part
  /// Only the part of the solid in this box is shown, cut off at its sides; the box must not be
  /// flat. Without it: the bounding box.
  std::optional<Box<double>> region = {};
  /// The box that fills the picture, to look at a detail. Without it: everything that is shown;
  /// where only signs are known, the bounding box, or all triangles.
  std::optional<Box<double>> show = {};
  /// Also shows sheets of an open surface, which bound no solid. Except for their sign, values must
  /// be distances to the surface, as those of meshes are.
  bool sheets = false;

  /// Colour of all surfaces. Without it each patch has a colour of its own, if there are several;
  /// patches with the same name share one.
  std::optional<Rgb> color = {};
  Rgb cutColor{238, 214, 170};

  /// Of a picture, in all.
  static constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;
  int width = 1600;          ///< of the picture, pixels
  int height = 1000;         ///< of the picture, pixels
  bool transparent = false;  ///< background, instead of white
  bool lines = true;   ///< along silhouettes, and between patches of two colours or at an angle
  bool axes = true;    ///< directions of the axes, and a scale bar if orthographic
  bool legend = true;  ///< of the visible patches, if they have colours of their own
  std::string title = {};
  std::string unit = {};  ///< of lengths, e.g. "m"
  PictureQuality quality = PictureQuality::Final;
  int threads = 0;  ///< see ParallelOptions
  Progress progress = {};
};

/// Renders a picture of a solid by tracing rays. It does not depend on the number of threads.
///
/// Where the surface consists of triangles and values are distances, a ray hits the first triangle
/// that it meets. No other ray steps through a part, however thin, as far as the solid's guarantee
/// excludes that; it hits what is within 1/40 of a pixel, or, in a draft, the tangent plane of what
/// is within half a pixel. Silhouettes have nine rays per pixel, in a draft four; parts between
/// these are found by their distance, if values are distances or bounds of them. Where only signs
/// are known, or a ray runs along the surface for more than 256 steps, crossings() decides. Where
/// values may be off by more than 1/4 of a pixel, parts thinner than that may be lost. All this
/// holds for each operand of a union by itself, and the nearest is seen. Light is dimmed where
/// other parts of the surface are near, as far as values show it.
/// @throws Error if the picture is smaller than 320 x 240 or larger than 2^26 pixels, an angle, a
/// direction or a box is impossible, the region or cuts across the axes leave nothing of the
/// solid's box, the solid is unbounded and no region is given, or, in perspective, the viewer is
/// within the solid.
template <std::floating_point T>
[[nodiscard]] Image render(const SignedDistanceFunction<T>& solid,
                           const RenderOptions& options = {});

extern template Image render(const SignedDistanceFunction<float>&, const RenderOptions&);
extern template Image render(const SignedDistanceFunction<double>&, const RenderOptions&);

}  // namespace cutwater
