#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutPeriod.hpp>
#include <Cutwater/Sdf/FluidSide.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cutwater {

/// The fluid beside a solid as a field: its value is positive in the fluid.
///
/// What lies in the surface, within rounding, has the value 0 and counts as body, whichever side
/// the fluid is on: so a wall in a plane of the grid belongs to the cell whose fluid it bounds.
class FluidField {
 public:
  /// What is known of all values.
  struct Facts {
    double steepness = 0;   ///< a Lipschitz constant; 0: none is known
    Box<double> domain;     ///< where it holds
    bool isSingle = false;  ///< boxes must be numbers of single precision
    bool isFlat = false;    ///< the surface is a plane
    std::vector<std::string> patchNames;
  };
  explicit FluidField(Facts facts) : facts_(std::move(facts)) {}
  FluidField(const FluidField&) = delete;
  FluidField& operator=(const FluidField&) = delete;
  virtual ~FluidField() = default;

  /// The solid's values with the sign of the fluid; 0 within rounding.
  virtual void values(std::span<const Vec3<double>> points, std::span<double> values) const = 0;
  [[nodiscard]] double value(const Vec3<double>& point) const {
    double result = 0;
    values({&point, 1}, {&result, 1});
    return result;
  }
  /// Of the value; zero where it is not defined.
  [[nodiscard]] virtual Vec3<double> gradient(const Vec3<double>& point) const = 0;
  /// What the surface at a point belongs to.
  [[nodiscard]] virtual SurfaceOwner owner(const Vec3<double>& surfacePoint) const = 0;

  /// Whether the surface may be in a box, for all that is known for certain.
  [[nodiscard]] virtual bool mayBeCut(const Box<double>& box, BoxHint& hint) const = 0;
  /// What share of a box is fluid: certainly encloses it. A box without extent along an axis or two
  /// is a rectangle or a segment. The search ends where the share is known to within `width`, after
  /// so many boxes, and where it learns nothing.
  [[nodiscard]] virtual Interval<double> shareOf(const Box<double>& box, double width,
                                                 std::size_t boxes) const = 0;

  /// A bound of the difference of values, by distance, in a box; 0 if none is known.
  [[nodiscard]] double steepness(const Box<double>& box) const {
    return facts_.domain.covers(box) ? facts_.steepness : 0;
  }
  /// A bound of the difference over half a diagonal of a box; 0 if none is known.
  [[nodiscard]] double changeToCorners(const Box<double>& box) const {
    return 0.5 * (1 + 1e-12) * steepness(box) * box.diagonal();
  }
  /// Whether the surface may meet a box, or a segment, as far as the value in its middle tells.
  [[nodiscard]] bool mayReach(const Box<double>& box) const {
    const double reach = changeToCorners(box);
    return reach == 0 || std::abs(value(box.center())) <= reach;
  }
  [[nodiscard]] const std::vector<std::string>& patchNames() const { return facts_.patchNames; }
  [[nodiscard]] const Facts& facts() const { return facts_; }

  /// One of the surfaces in which walls lie, each smooth as far as is known.
  struct Surface {
    std::shared_ptr<const FluidField> field;    ///< zero in it
    std::shared_ptr<const FluidField> operand;  ///< in whose surface walls lie as well; null: none

    [[nodiscard]] bool mayMeet(const Box<double>& box) const {
      return field->mayReach(box) && (operand == nullptr || operand->mayReach(box));
    }
  };
  using Surfaces = std::vector<Surface>;
  /// Those that walls in a box lie in, and perhaps others; none, if the only one is that of this
  /// field itself. If there are more than `most`, one more than these.
  [[nodiscard]] virtual Surfaces surfacesIn(const Box<double>& box, std::size_t most) const = 0;
  /// Whether the field knows them, of all of itself: see fieldIn().
  [[nodiscard]] virtual bool knowsSurfaces() const { return false; }
  /// Those that may meet a box, then. They follow from the box alone.
  [[nodiscard]] virtual std::vector<const FluidField*> surfacesNear(
      const Box<double>& /*box*/) const {
    return {};
  }

 private:
  Facts facts_;
};

/// A field for boxes that lie in one: it knows the surfaces in which walls lie there. Null, if
/// there is none but the field's own, or too many. Views the field. For one thread at a time.
[[nodiscard]] std::unique_ptr<const FluidField> fieldIn(const FluidField& field,
                                                        const Box<double>& box);

/// Of a solid, with the fluid on this side of its surface.
template <std::floating_point T>
[[nodiscard]] std::shared_ptr<const FluidField> fluidBeside(const Solid<T>& solid, FluidSide side);
/// Of a solid with its images, where cells are cut.
template <std::floating_point T>
[[nodiscard]] std::shared_ptr<const FluidField> fluidBeside(const Solid<T>& solid, FluidSide side,
                                                            const CutPeriod& period);

/// The section of a field at a height, the same at all heights. Views it.
[[nodiscard]] std::unique_ptr<const FluidField> sectionAt(const FluidField& field, double z);

extern template std::shared_ptr<const FluidField> fluidBeside(const Solid<float>&, FluidSide);
extern template std::shared_ptr<const FluidField> fluidBeside(const Solid<double>&, FluidSide);
extern template std::shared_ptr<const FluidField> fluidBeside(const Solid<float>&, FluidSide,
                                                              const CutPeriod&);
extern template std::shared_ptr<const FluidField> fluidBeside(const Solid<double>&, FluidSide,
                                                              const CutPeriod&);

}  // namespace cutwater
