#include <Cutwater/Render/Detail/PixelTiles.hpp>
#include <Cutwater/Render/Detail/SparseLight.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

constexpr float kSmooth = 0.9F;      // cosine of the angle between normals of one sheet
constexpr double kFlatness = 0.5;    // distance from the tangent plane, over that of the pixels
constexpr double kEnoughOf1 = 0.05;  // weight that is certain enough

bool isLit(const SurfaceSample& sample) {
  return (sample.isHit() || sample.passed != kNone) && !sample.isCut();
}

}  // namespace

PlotArea SparseLight::nodes() const {
  return {0, 0, (area_.width + spacing_ - 1) / spacing_, (area_.height + spacing_ - 1) / spacing_};
}

PicturePoint SparseLight::place(int column, int row) const {
  return {area_.x0 + column * spacing_ + 0.5, area_.y0 + row * spacing_ + 0.5};
}

void SparseLight::prepare(std::span<const SurfaceSample> middles, const ParallelOptions& options) {
  if (spacing_ == 1) return;
  const auto area = nodes();
  const auto width = static_cast<std::size_t>(area.width);
  nodes_.resize(width * static_cast<std::size_t>(area.height));
  const PixelTiles tiles(area);
  parallelFor(tiles.count(), options, [&](std::size_t begin, std::size_t end) {
    std::vector<PicturePoint> points;
    std::vector<SurfaceSample> samples;
    for (auto tile = begin; tile < end; ++tile) {
      points.clear();
      samples.clear();
      tiles.forPixels(tile, [&](int column, int row) {
        points.push_back(place(column, row));
        samples.push_back(middles[static_cast<std::size_t>(row * spacing_) *
                                      static_cast<std::size_t>(area_.width) +
                                  static_cast<std::size_t>(column * spacing_)]);
      });
      light_(points, samples);
      auto sample = samples.begin();
      tiles.forPixels(tile, [&](int column, int row) {
        nodes_[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] =
            *sample++;
      });
    }
  });
}

bool SparseLight::areOneSheet(const SurfaceSample& a, const PicturePoint& atA,
                              const SurfaceSample& b, const PicturePoint& atB) const {
  if (!isLit(b) || !(dot(a.normal, b.normal) > kSmooth)) return false;
  const auto apart = camera_.ray(atB.x, atB.y).at(b.along) - camera_.ray(atA.x, atA.y).at(a.along);
  const double most = kFlatness * spacing_ * camera_.pixelSize(std::min(a.along, b.along));
  return std::abs(dot(apart, Vec3<double>(a.normal))) < most &&
         std::abs(dot(apart, Vec3<double>(b.normal))) < most;
}

bool SparseLight::isInterpolated(const PicturePoint& at, SurfaceSample& sample) const {
  const auto area = nodes();
  const double x = (at.x - area_.x0 - 0.5) / spacing_;
  const double y = (at.y - area_.y0 - 0.5) / spacing_;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  double sum = 0, open = 0;
  for (int k = 0; k < 4; ++k) {
    const int i = column + k % 2, j = row + k / 2;
    if (i < 0 || j < 0 || i >= area.width || j >= area.height) continue;
    const auto& node = nodes_[static_cast<std::size_t>(j) * static_cast<std::size_t>(area.width) +
                              static_cast<std::size_t>(i)];
    const double weight = (1 - std::abs(x - i)) * (1 - std::abs(y - j));
    if (!(weight > 0) || !areOneSheet(sample, at, node, place(i, j))) continue;
    sum += weight;
    open += weight * static_cast<double>(node.open);
  }
  if (!(sum > kEnoughOf1)) return false;
  sample.open = static_cast<float>(open / sum);
  return true;
}

void SparseLight::light(std::span<const PicturePoint> points,
                        std::span<SurfaceSample> samples) const {
  if (spacing_ == 1) {
    light_(points, samples);
    return;
  }
  std::vector<std::size_t> others;
  std::vector<PicturePoint> places;
  std::vector<SurfaceSample> lit;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!isLit(samples[i]) || isInterpolated(points[i], samples[i])) continue;
    others.push_back(i);
    places.push_back(points[i]);
    lit.push_back(samples[i]);
  }
  light_(places, lit);
  for (std::size_t k = 0; k < others.size(); ++k) samples[others[k]].open = lit[k].open;
}

}  // namespace cutwater::detail
