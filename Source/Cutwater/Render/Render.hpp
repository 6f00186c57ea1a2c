#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Render/CutPlane.hpp>
#include <Cutwater/Render/Image.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <optional>
#include <string>
#include <vector>

namespace cutwater {

/// How a solid is shown. Lengths are in the solid's units.
struct RenderOptions {
  View view = View::named("iso");
  double fieldOfView = 0;  ///< degrees along the longer side; 0: orthographic
  /// In place of `view` and `show`; 30 degrees unless told otherwise.
  std::optional<Eye> eye = {};
  std::vector<CutPlane> cuts = {};  ///< each takes a part away
  /// Shown is only what lies in this box, cut off at its sides; it must not be flat. Without it:
  /// the bounding box.
  std::optional<Box<double>> region = {};
  /// Fills the picture, for a look at a detail. Without it: all that is shown.
  std::optional<Box<double>> show = {};
  /// Also what bounds no solid: sheets of a surface that is not closed. Values must be distances to
  /// the surface but for their sign, as those of meshes are.
  bool sheets = false;

  /// Of all surfaces; without it each patch has a colour of its own, if there are several. Patches
  /// of one name have one.
  std::optional<Rgb> color = {};
  Rgb cutColor{238, 214, 170};
  int width = 1600;          ///< of the picture, pixels
  int height = 1000;         ///< of the picture, pixels
  bool transparent = false;  ///< background, instead of white
  bool lines = true;         ///< along silhouettes and borders of patches
  bool axes = true;          ///< directions of the axes, and a scale bar if orthographic
  bool legend = true;        ///< of the patches in sight, if they have colours of their own
  std::string title = {};
  std::string unit = {};  ///< of lengths, e.g. "m"
  int threads = 0;        ///< see ParallelOptions
  Progress progress = {};
};

/// A picture of a solid by sphere tracing, the same whatever the threads.
///
/// No ray steps through a part, however thin, as far as the solid's guarantee excludes that. A ray
/// hits what is within 1/40 of a pixel; silhouettes have nine rays to a pixel; parts between these
/// are found by how near they are, if values are distances or bounds of them. Where only signs are
/// known, or a ray runs along the surface for more than 256 steps, crossings() tells. Where values
/// may be off by more than 1/4 of a pixel, parts thinner than that may be lost. Light is dimmed
/// where the surface is near, as far as the values around tell.
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
