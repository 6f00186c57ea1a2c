#include <Cutwater/Render/Detail/PixelSamples.hpp>
#include <Cutwater/Render/Detail/PixelTiles.hpp>
#include <Cutwater/Render/Detail/SparseLight.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater::detail {

namespace {

constexpr double kStep = 2;           // pixels from the tangent plane; beyond: another sheet
constexpr double kLevel = 0.5;        // pixels along neighbouring rays that are no step
constexpr double kCrease = 0.94;      // cosine of a visible angle
constexpr std::uint32_t kWanted = 0;  // not kNone; a pixel's number follows once all are marked
constexpr Rgb kLine{28, 32, 38};
constexpr double kLineOpacity = 0.62;

}  // namespace

PixelSamples::PixelSamples(const Camera& camera, const PlotArea& area, const Rays& rays,
                           const ParallelOptions& options)
    : camera_(camera),
      area_(area),
      side_(rays.side),
      square_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)) {
  const auto count = static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height);
  samples_.resize(count);
  refined_.assign(count, kNone);
  const auto part = [&](double from, double to) {
    auto some = options;
    if (options.progress) {
      some.progress = [=, &options](double f) { options.progress(from + f * (to - from)); };
    }
    return some;
  };
  tracePixels(rays.trace, part(0, 0.5));
  SparseLight light(camera, area, rays.lightSpacing, rays.light);
  light.prepare(samples_, {.threads = options.threads, .progress = {}});
  lightPixels(light, part(0.5, 0.6));
  refine(rays.trace, light, part(0.6, 1));
}

const SurfaceSample& PixelSamples::fineSample(int x, int y) const {
  const auto pixel = index(x / side_, y / side_);
  if (refined_[pixel] == kNone) return samples_[pixel];
  return fine_[std::size_t{refined_[pixel]} * square_ +
               static_cast<std::size_t>(y % side_ * side_ + x % side_)];
}

void PixelSamples::tracePixels(SampleTracer trace, const ParallelOptions& options) {
  const PixelTiles tiles(area_);
  parallelFor(tiles.count(), options, [&](std::size_t begin, std::size_t end) {
    std::vector<PicturePoint> points;
    std::vector<SurfaceSample> found(kMostRays);
    for (std::size_t tile = begin; tile < end; ++tile) {
      points.clear();
      tiles.forPixels(tile, [&](int x, int y) { points.push_back(middle(x, y)); });
      trace(points, {}, std::span(found).first(points.size()));
      auto sample = found.begin();
      tiles.forPixels(tile, [&](int x, int y) { samples_[index(x, y)] = *sample++; });
    }
  });
}

void PixelSamples::lightPixels(const SparseLight& light, const ParallelOptions& options) {
  const PixelTiles tiles(area_);
  parallelFor(tiles.count(), options, [&](std::size_t begin, std::size_t end) {
    std::vector<PicturePoint> points;
    std::vector<SurfaceSample> samples;
    for (std::size_t tile = begin; tile < end; ++tile) {
      points.clear();
      samples.clear();
      tiles.forPixels(tile, [&](int x, int y) {
        points.push_back(middle(x, y));
        samples.push_back(samples_[index(x, y)]);
      });
      light.light(points, samples);
      auto sample = samples.begin();
      tiles.forPixels(tile, [&](int x, int y) { samples_[index(x, y)] = *sample++; });
    }
  });
}

/// Both are on one sheet if either point is near the other's tangent plane. So they are if the two,
/// which are at most sqrt(2) pixels apart in the picture, are about as far away.
bool PixelSamples::isStep(const SurfaceSample& a, const PicturePoint& atA, const SurfaceSample& b,
                          const PicturePoint& atB) const {
  const double pixel = camera_.pixelSize(std::min(a.along, b.along));
  if (std::abs(a.along - b.along) < kLevel * pixel) return false;
  const auto p = camera_.ray(atA.x, atA.y).at(a.along);
  const auto q = camera_.ray(atB.x, atB.y).at(b.along);
  const double height = std::min(std::abs(dot(q - p, Vec3<double>(a.normal))),
                                 std::abs(dot(q - p, Vec3<double>(b.normal))));
  return height > kStep * pixel;
}

PixelSamples::Difference PixelSamples::difference(const SurfaceSample& a, const PicturePoint& atA,
                                                  const SurfaceSample& b,
                                                  const PicturePoint& atB) const {
  if (!a.isHit() && !b.isHit()) return Difference::None;
  if (a.isHit() != b.isHit()) return Difference::Step;
  if (isStep(a, atA, b, atB)) return Difference::Step;
  const bool isCrease = dot(a.normal, b.normal) < static_cast<float>(kCrease);
  if (a.surface != b.surface) return isCrease ? Difference::Edge : Difference::Border;
  return isCrease ? Difference::Crease : Difference::None;
}

bool PixelSamples::differsFromNeighbours(int x, int y) const {
  const auto& here = samples_[index(x, y)];
  if (here.passed != kNone) return true;
  for (int j = y - 1; j <= y + 1; ++j) {
    for (int i = x - 1; i <= x + 1; ++i) {
      if (!contains(i, j)) continue;
      const auto& there = samples_[index(i, j)];
      if (difference(here, middle(x, y), there, middle(i, j)) != Difference::None) return true;
    }
  }
  return false;
}

void PixelSamples::refine(SampleTracer trace, const SparseLight& light,
                          const ParallelOptions& options) {
  const ParallelOptions rows{.threads = options.threads, .grain = 8, .progress = {}};
  parallelFor(static_cast<std::size_t>(area_.height), rows,
              [&](std::size_t begin, std::size_t end) {
                for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
                  for (int x = 0; x < area_.width; ++x) {
                    if (differsFromNeighbours(x, y)) refined_[index(x, y)] = kWanted;
                  }
                }
              });
  const PixelTiles tiles(area_);
  for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
    tiles.forPixels(tile, [&](int x, int y) {
      if (!isRefined(x, y)) return;
      refined_[index(x, y)] = static_cast<std::uint32_t>(pixels_.size());
      pixels_.push_back(index(x, y));
    });
  }
  fine_.resize(pixels_.size() * square_);
  const auto atOnce = kMostRays / square_;
  const auto packets = (pixels_.size() + atOnce - 1) / atOnce;
  parallelFor(packets, options, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      traceFinely(trace, light, i * atOnce, std::min(atOnce, pixels_.size() - i * atOnce));
    }
  });
  showWhatIsThin();
}

std::pair<int, int> PixelSamples::fineCorner(std::size_t pixel) const {
  const auto width = static_cast<std::size_t>(area_.width);
  return {side_ * static_cast<int>(pixel % width), side_ * static_cast<int>(pixel / width)};
}

void PixelSamples::traceFinely(SampleTracer trace, const SparseLight& light, std::size_t first,
                               std::size_t count) {
  std::vector<PicturePoint> points;
  for (const auto pixel : std::span(pixels_).subspan(first, count)) {
    const auto [x, y] = fineCorner(pixel);
    for (int j = y; j < y + side_; ++j) {
      for (int i = x; i < x + side_; ++i) points.push_back(finePoint(i, j));
    }
  }
  const auto samples = std::span(fine_).subspan(first * square_, points.size());
  trace(points, {.spacing = 1.0 / side_, .group = square_}, samples);
  light.light(points, samples);
}

/// Whether a sample nearly meets a part, and the next sample beyond that part misses, too.
bool PixelSamples::hidesBetween(int x, int y) const {
  const auto& sample = fineSample(x, y);
  if (sample.passed == kNone) return false;
  const auto& view = camera_.view();
  const Vec3<double> beyond = -Vec3<double>(sample.normal);
  const int column = x + static_cast<int>(std::lround(dot(beyond, view.right())));
  const int row = y - static_cast<int>(std::lround(dot(beyond, view.up)));
  return !contains(column / side_, row / side_) || column < 0 || row < 0 ||
         !fineSample(column, row).isHit();
}

void PixelSamples::showWhatIsThin() {
  std::vector<std::size_t> shown;  // collected first, as decisions depend on neighbours
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const auto samples = std::span(fine_).subspan(i * square_, square_);
    if (std::any_of(samples.begin(), samples.end(), [](auto& s) { return s.isHit(); })) continue;
    const auto [x, y] = fineCorner(pixels_[i]);
    for (std::size_t k = 0; k < square_; ++k) {
      const auto column = static_cast<int>(k) % side_, row = static_cast<int>(k) / side_;
      if (hidesBetween(x + column, y + row)) shown.push_back(i * square_ + k);
    }
  }
  for (const auto i : shown) fine_[i].surface = fine_[i].passed;
}

bool PixelSamples::isNearRefined(int x, int y) const {
  for (int j = y - 1; j <= y + 1; ++j) {
    for (int i = x - 1; i <= x + 1; ++i) {
      if (contains(i, j) && isRefined(i, j)) return true;
    }
  }
  return false;
}

/// Lines are drawn on the nearer of two surfaces, and on both sides of a border between patches.
bool PixelSamples::isOnLine(int x, int y, int reach, SurfaceMatcher areOne) const {
  const auto& here = fineSample(x, y);
  if (!here.isHit()) return false;
  for (int j = -reach; j <= reach; ++j) {
    for (int i = -reach; i <= reach; ++i) {
      if (i * i + j * j > reach * reach + 1 || (i == 0 && j == 0)) continue;
      const int column = std::clamp(x + i, 0, side_ * area_.width - 1);
      const int row = std::clamp(y + j, 0, side_ * area_.height - 1);
      const auto& there = fineSample(column, row);
      const auto kind = difference(here, finePoint(x, y), there, finePoint(column, row));
      if (kind == Difference::Step && here.along < there.along) return true;
      const bool divides = kind == Difference::Edge ||
                           (kind == Difference::Border && !areOne(here.surface, there.surface));
      if (divides && i * i + j * j <= 1) return true;
    }
  }
  return false;
}

void PixelSamples::drawPixel(Image& image, SampleShader shade, SurfaceMatcher areOne, int x, int y,
                             int reach) const {
  const int column = area_.x0 + x;
  const int row = area_.y0 + y;
  if (!isNearRefined(x, y)) {
    const auto& sample = samples_[index(x, y)];
    if (sample.isHit()) image.paint(column, row, shade(sample, {column + 0.5, row + 0.5}), 1);
    return;
  }
  std::array<double, 3> sum{};
  int hits = 0;
  const auto square = static_cast<int>(square_);
  for (int i = 0; i < square; ++i) {
    const int fineX = side_ * x + i % side_;
    const int fineY = side_ * y + i / side_;
    const auto& sample = fineSample(fineX, fineY);
    if (!sample.isHit()) continue;
    auto color = shade(sample, finePoint(fineX, fineY));
    if (reach > 0 && isOnLine(fineX, fineY, reach, areOne)) {
      color = blended(color, kLine, kLineOpacity);
    }
    sum[0] += color.red;
    sum[1] += color.green;
    sum[2] += color.blue;
    ++hits;
  }
  if (hits == 0) return;
  const auto mean = [&](double v) { return static_cast<std::uint8_t>(std::lround(v / hits)); };
  image.paint(column, row, {mean(sum[0]), mean(sum[1]), mean(sum[2])},
              static_cast<double>(hits) / square);
}

void PixelSamples::draw(Image& image, SampleShader shade, SurfaceMatcher areOne, double lineWidth,
                        const ParallelOptions& options) const {
  const int reach = static_cast<int>(std::lround(std::clamp(lineWidth, 0.0, 1.0) * side_));
  const ParallelOptions rows{.threads = options.threads, .grain = 8, .progress = {}};
  parallelFor(static_cast<std::size_t>(area_.height), rows,
              [&](std::size_t begin, std::size_t end) {
                for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
                  for (int x = 0; x < area_.width; ++x)
                    drawPixel(image, shade, areOne, x, y, reach);
                }
              });
}

std::vector<std::size_t> PixelSamples::areasOfPatches(std::size_t count) const {
  std::vector<std::size_t> areas(count);
  const auto add = [&](const SurfaceSample& sample, std::size_t area) {
    if (sample.surface < count) areas[sample.surface] += area;
  };
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (refined_[i] == kNone) add(samples_[i], square_);
  }
  for (const auto& sample : fine_) add(sample, 1);
  return areas;
}

}  // namespace cutwater::detail
