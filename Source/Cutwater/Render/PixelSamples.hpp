#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Render/Camera.hpp>
#include <Cutwater/Render/PictureStyle.hpp>
#include <Cutwater/Render/SurfaceSample.hpp>

#include <span>
#include <vector>

/// How render() works inside; for its parts only.
namespace cutwater::detail {

/// Colour of what is seen at a point of the picture.
using SampleShader = FunctionRef<Rgb(const SurfaceSample&, const PicturePoint&)>;
/// Whether two surfaces are one to the viewer: no line divides them unless an edge does.
using SurfaceMatcher = FunctionRef<bool(std::uint32_t, std::uint32_t)>;

/// What is seen through the pixels of an area: one sample each, and kSide^2 where neighbours
/// differ: at silhouettes, steps in depth, creases and borders of patches, and where the solid
/// comes close to a ray that misses it.
///
/// Of a pixel with so many samples that all miss, those see what passes them that have no sample
/// which hits it on its other side: thin parts are not lost, and seem once or twice as wide as the
/// samples are apart; silhouettes do not grow.
class PixelSamples {
 public:
  static constexpr int kSide = 3;

  /// The area must lie in a picture. The same samples whatever the threads.
  PixelSamples(const Camera& camera, const PlotArea& area, SampleTracer trace,
               const ParallelOptions& options);

  /// Paints the samples, with fine lines along what divides them. `lineWidth` in pixels, at most 1.
  void draw(Image& image, SampleShader shade, SurfaceMatcher areOne, double lineWidth,
            const ParallelOptions& options) const;

  /// What each of so many patches takes of the picture, in parts of a pixel: kSide^2 are one.
  [[nodiscard]] std::vector<std::size_t> areasOfPatches(std::size_t count) const;

  /// The sample in the middle of a pixel, counted from the area's corner.
  [[nodiscard]] const SurfaceSample& at(int x, int y) const { return samples_[index(x, y)]; }

 private:
  static constexpr int kSquare = kSide * kSide;
  /// An edge is a border and a crease.
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
  /// Of the picture divided into kSide times as many columns and rows.
  [[nodiscard]] PicturePoint finePoint(int x, int y) const;
  [[nodiscard]] const SurfaceSample& fineSample(int x, int y) const;
  [[nodiscard]] Difference difference(const SurfaceSample& a, const PicturePoint& atA,
                                      const SurfaceSample& b, const PicturePoint& atB) const;
  [[nodiscard]] bool isOnLine(int x, int y, int reach, SurfaceMatcher areOne) const;
  [[nodiscard]] bool differsFromNeighbours(int x, int y) const;
  void tracePixels(SampleTracer trace, const ParallelOptions& options);
  void refine(SampleTracer trace, const ParallelOptions& options);
  /// Of pixels [first, first + count) of those that have more samples.
  void traceFinely(SampleTracer trace, std::size_t first, std::size_t count);
  [[nodiscard]] std::pair<int, int> fineCorner(std::size_t pixel) const;
  void showWhatIsThin();
  [[nodiscard]] bool hidesBetween(int x, int y) const;
  void drawPixel(Image& image, SampleShader shade, SurfaceMatcher areOne, int x, int y,
                 int reach) const;

  const Camera& camera_;
  PlotArea area_;
  std::vector<SurfaceSample> samples_;  // of the pixels' middles, row by row
  std::vector<std::uint32_t> refined_;  // of each pixel: which of those that have more
  std::vector<std::size_t> pixels_;     // those, in the order of their samples
  std::vector<SurfaceSample> fine_;     // theirs, kSquare each
};

}  // namespace cutwater::detail
