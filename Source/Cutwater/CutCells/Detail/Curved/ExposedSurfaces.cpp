#include <Cutwater/CutCells/Detail/Curved/BoxView.hpp>
#include <Cutwater/CutCells/Detail/Curved/ExposedSurfaces.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// Looks for parts of a box that both the wall and a surface may reach.
class Exposure {
 public:
  Exposure(const FluidField& field, int flatAxis) : field_(field), flatAxis_(flatAxis) {}

  /// Halves a box so many times, along each axis.
  void search(const Box<double>& box, std::span<const FluidField* const> surfaces, int halvings) {
    std::vector<const FluidField*> near;
    std::ranges::copy_if(surfaces, std::back_inserter(near), [&](const FluidField* surface) {
      return !isExposed(surface) && surface->mayReach(box);
    });
    if (near.empty() || !field_.mayReach(box)) return;
    if (halvings == 0) {
      exposed_.insert(exposed_.end(), near.begin(), near.end());
      return;
    }
    const auto parts = partsAround(box, box.center(), flatAxis_);
    for (std::size_t i = 0; i < parts.count; ++i) search(parts.boxes[i], near, halvings - 1);
  }
  [[nodiscard]] bool isExposed(const FluidField* surface) const {
    return std::ranges::find(exposed_, surface) != exposed_.end();
  }

 private:
  const FluidField& field_;
  int flatAxis_;
  std::vector<const FluidField*> exposed_;
};

}  // namespace

std::vector<const FluidField*> exposedIn(const FluidField& field, const Box<double>& box,
                                         std::span<const FluidField* const> surfaces) {
  constexpr int kHalvings = 2;
  std::vector<const FluidField*> result(surfaces.begin(), surfaces.end());
  if (surfaces.size() <= 1) return result;
  Exposure exposure(field, flatAxisOf(box));
  exposure.search(box, surfaces, kHalvings);
  std::erase_if(result, [&](const FluidField* surface) { return !exposure.isExposed(surface); });
  return result;
}

}  // namespace cutwater
