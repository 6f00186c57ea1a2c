#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Render/Camera.hpp>
#include <Cutwater/Render/Detail/PictureStyle.hpp>
#include <Cutwater/Render/Detail/SurfaceSample.hpp>

#include <span>
#include <vector>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// Returns the colour of the surface seen at a point of the picture.
using SampleShader = FunctionRef<Rgb(const SurfaceSample&, const PicturePoint&)>;
/// Whether two surfaces count as one for the viewer: no line is drawn between them unless there is
/// an edge.
using SurfaceMatcher = FunctionRef<bool(std::uint32_t, std::uint32_t)>;

class SparseLight;

/// Samples of what is visible through the pixels of an area: one per pixel, but a square of them
/// where neighbours differ: at silhouettes, steps in depth, creases and borders of patches, and
/// where the solid comes close to a ray that misses it.
///
/// If all samples of such a pixel miss, one that narrowly misses a part counts as seeing it,
/// unless the next sample on the part's other side hits. So thin parts are not lost, and appear one
/// or two sample spacings wide; silhouettes do not grow.
class PixelSamples {
 public:
  struct Rays {
    SampleTracer trace;
    SampleLighter light;
    int lightSpacing = 1;  ///< see SparseLight
    int side = 3;          ///< samples along both axes of a pixel whose neighbours differ
  };

  /// The area must lie in a picture. Samples do not depend on the number of threads.
  PixelSamples(const Camera& camera, const PlotArea& area, const Rays& rays,
               const ParallelOptions& options);

  /// Paints the samples, with fine lines along silhouettes and borders. `lineWidth` in pixels, at
  /// most 1.
  void draw(Image& image, SampleShader shade, SurfaceMatcher areOne, double lineWidth,
            const ParallelOptions& options) const;

  /// The area that each of `count` patches covers in the picture, in samples of pixels whose
  /// neighbours differ.
  [[nodiscard]] std::vector<std::size_t> areasOfPatches(std::size_t count) const;

  /// The sample in the middle of a pixel, counted from the area's corner.
  [[nodiscard]] const SurfaceSample& at(int x, int y) const { return samples_[index(x, y)]; }

 private:
  /// An edge is both a border and a crease.
  enum class Difference : std::uint8_t { None, Crease, Border, Edge, Step };

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(area_.width) +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] bool contains(int x, int y) const {
    return 0 <= x && x < area_.width && 0 <= y && y < area_.height;
  }
  [[nodiscard]] bool isRefined(int x, int y) const { return refined_[index(x, y)] != kNone; }
  [[nodiscard]] bool isNearRefined(int x, int y) const;
  [[nodiscard]] PicturePoint middle(int x, int y) const {
    return {area_.x0 + x + 0.5, area_.y0 + y + 0.5};
  }
  /// A point of the fine grid, which has side_ times as many columns and rows as the picture.
  [[nodiscard]] PicturePoint finePoint(int x, int y) const {
    return {area_.x0 + (x + 0.5) / side_, area_.y0 + (y + 0.5) / side_};
  }
  [[nodiscard]] const SurfaceSample& fineSample(int x, int y) const;
  [[nodiscard]] Difference difference(const SurfaceSample& a, const PicturePoint& atA,
                                      const SurfaceSample& b, const PicturePoint& atB) const;
  [[nodiscard]] bool isStep(const SurfaceSample& a, const PicturePoint& atA, const SurfaceSample& b,
                            const PicturePoint& atB) const;
  [[nodiscard]] bool isOnLine(int x, int y, int reach, SurfaceMatcher areOne) const;
  [[nodiscard]] bool differsFromNeighbours(int x, int y) const;
  void tracePixels(SampleTracer trace, const ParallelOptions& options);
  void lightPixels(const SparseLight& light, const ParallelOptions& options);
  void refine(SampleTracer trace, const SparseLight& light, const ParallelOptions& options);
  /// Traces the samples of refined pixels [first, first + count).
  void traceFinely(SampleTracer trace, const SparseLight& light, std::size_t first,
                   std::size_t count);
  [[nodiscard]] std::pair<int, int> fineCorner(std::size_t pixel) const;
  void showWhatIsThin();
  [[nodiscard]] bool hidesBetween(int x, int y) const;
  void drawPixel(Image& image, SampleShader shade, SurfaceMatcher areOne, int x, int y,
                 int reach) const;

  const Camera& camera_;
  PlotArea area_;
  int side_;                            // of a pixel that is refined, in samples
  std::size_t square_;                  // of that
  std::vector<SurfaceSample> samples_;  // at the pixels' centres, row by row
  std::vector<std::uint32_t> refined_;  // for each pixel: its number among refined ones
  std::vector<std::size_t> pixels_;     // the refined ones, in the order of their samples
  std::vector<SurfaceSample> fine_;     // samples of these, square_ each
};

}  // namespace cutwater::detail
