#include <Cutwater/Core/Detail/UnitVector.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Detail/MeshLines.hpp>
#include <Cutwater/Render/Detail/SliceField.hpp>
#include <Cutwater/Render/Detail/SliceFrame.hpp>
#include <Cutwater/Render/Detail/Ticks.hpp>
#include <Cutwater/Render/Slice.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

using detail::LineSpacing;
using detail::PlotArea;
using detail::SliceField;
using detail::SliceLayout;

constexpr double kLinesOutside = 16;  // about this many, or slightly fewer
constexpr double kLinesInside = 8;
constexpr double kMostLines = 1000;
constexpr double kLeastSide = 1e-6;   // of the range: what is less is not called a side
constexpr double kMostRounded = 2.5;  // roundStep() is at most as many times its argument
constexpr Rgb kMeshInk{40, 44, 52};

template <std::floating_point T>
SliceWindow<T> boundsInPlane(const Box<T>& box, const SlicePlane<T>& plane) {
  require(!box.empty() && isFinite(box),
          "renderSlice: the solid is empty or unbounded, so say which window to show");
  SliceWindow<T> window{{Box<T>::kInf, Box<T>::kInf}, {-Box<T>::kInf, -Box<T>::kInf}};
  for (int c = 0; c < 8; ++c) {
    const auto p = box.corner(c) - plane.origin;
    const std::array<T, 2> at{dot(p, plane.right), dot(p, plane.up)};
    for (std::size_t i = 0; i < 2; ++i) {
      window.lower[i] = std::min(window.lower[i], at[i]);
      window.upper[i] = std::max(window.upper[i], at[i]);
    }
  }
  return window;
}

template <std::floating_point T>
void addRoom(SliceWindow<T>& window) {
  const T room =
      T(0.08) * std::max(window.upper[0] - window.lower[0], window.upper[1] - window.lower[1]);
  for (std::size_t i = 0; i < 2; ++i) {
    window.lower[i] -= room;
    window.upper[i] += room;
  }
}

/// Grows the window to the proportions of width : height.
template <std::floating_point T>
void widen(SliceWindow<T>& window, int width, int height) {
  const T perPixel = std::max((window.upper[0] - window.lower[0]) / static_cast<T>(width),
                              (window.upper[1] - window.lower[1]) / static_cast<T>(height));
  const std::array<T, 2> size{perPixel * static_cast<T>(width), perPixel * static_cast<T>(height)};
  for (std::size_t i = 0; i < 2; ++i) {
    const T more = (size[i] - (window.upper[i] - window.lower[i])) / 2;
    window.lower[i] -= more;
    window.upper[i] += more;
  }
}

/// All of the mesh, if there is one: beyond it there is nothing to show. Otherwise the solid, with
/// as much around it as fills the picture.
template <std::floating_point T>
SliceWindow<T> usualWindow(const SignedDistanceFunction<T>& solid, const SlicePlane<T>& plane,
                           const Octree<T>* mesh, const PlotArea& room) {
  if (mesh != nullptr) return boundsInPlane(mesh->domain().box(), plane);
  auto window = boundsInPlane(solid.boundingBox(), plane);
  addRoom(window);
  widen(window, room.width, room.height);
  return window;
}

/// For values up to `most` in size on one side of the surface, of `range` on both. A thin body has
/// fewer lines than there is room for elsewhere, but at least one.
double spacingFor(double most, double range, double lines) {
  const double step = roundStep(std::max(most, 0.1 * range) / lines);
  const bool hasSome = most > kLeastSide * range;
  return hasSome ? std::min(step, roundStep(most / kMostRounded)) : step;
}

/// Each side of the surface has its own line spacing.
LineSpacing lineSpacing(double least, double greatest, double wanted) {
  const double range = std::max({greatest, -least, 1e-30});
  LineSpacing spacing{wanted, wanted};
  if (wanted == 0) {
    spacing.outside = spacingFor(greatest, range, kLinesOutside);
    spacing.inside = spacingFor(-least, range, kLinesInside);
  }
  require(-least / spacing.inside <= kMostLines && greatest / spacing.outside <= kMostLines,
          "renderSlice: too many lines of equal distance", Named{"isolineSpacing", wanted},
          Named{"largest distance", range});
  return spacing;
}

/// Says which lines there are; empty if there is none.
std::string noteAbout(const LineSpacing& spacing, double least, double greatest,
                      const std::string& unit) {
  const auto length = [&](double value) { return lengthLabel(value, unit); };
  const bool inside = -least >= spacing.inside;
  const bool outside = greatest >= spacing.outside;
  if (!inside && !outside) return "";
  if (inside && outside && spacing.inside == spacing.outside) {
    return "lines every " + length(spacing.inside);
  }
  return "lines every " + (outside ? length(spacing.outside) + " outside" : "") +
         (inside && outside ? ", " : "") + (inside ? length(spacing.inside) + " inside" : "");
}

}  // namespace

template <std::floating_point T>
SlicePlane<T> SlicePlane<T>::across(int axis, T value) {
  require(axis >= 0 && axis <= 2, "SlicePlane: need an axis 0, 1 or 2", Named{"axis", axis});
  require(std::isfinite(value), "SlicePlane: need a finite position", Named{"value", value});
  SlicePlane plane;
  plane.origin[axis] = value;
  const int right = axis == 0 ? 1 : 0;
  const int up = axis == 2 ? 1 : 2;
  plane.right[right] = 1;
  plane.up[up] = 1;
  constexpr std::array kAxes{"x", "y", "z"};
  plane.labels = {kAxes[static_cast<std::size_t>(right)], kAxes[static_cast<std::size_t>(up)]};
  return plane;
}

template <std::floating_point T>
SlicePlane<T> SlicePlane<T>::through(const Vec3<T>& point, const Vec3<T>& right,
                                     const Vec3<T>& up) {
  require(isFinite(point), "SlicePlane: need a finite point", Named{"point", point});
  const auto a = detail::unitVector("SlicePlane", "direction to the right", right);
  const auto b = detail::unitVector("SlicePlane", "direction up", up);
  const auto across = b - dot(b, a) * a;
  require(length(across) > 16 * std::numeric_limits<T>::epsilon(),
          "SlicePlane: the directions span no plane", Named{"right", right}, Named{"up", up});
  return {point, a, normalized(across), {"a", "b"}};
}

template <std::floating_point T>
Image renderSlice(const SignedDistanceFunction<T>& solid, const SlicePlane<T>& plane,
                  const SliceOptions<T>& options) {
  require(options.width >= 320 && options.height >= 240,
          "renderSlice: need at least 320 x 240 pixels", Named{"width", options.width},
          Named{"height", options.height});
  require(options.isolineSpacing >= 0 && std::isfinite(options.isolineSpacing),
          "renderSlice: need a finite isolineSpacing >= 0",
          Named{"isolineSpacing", options.isolineSpacing});
  Image image(options.width, options.height);
  const SliceLayout layout(options.width, options.height);
  const auto room = layout.room();
  const auto window =
      options.window ? *options.window : usualWindow(solid, plane, options.mesh, room);
  const auto area =
      detail::fitted(room, detail::checkedRange(window, 0), detail::checkedRange(window, 1));

  const SliceField<T> field(solid, plane, window, area, options);
  const auto spacing =
      lineSpacing(field.least(), field.greatest(), static_cast<double>(options.isolineSpacing));
  field.draw(image, spacing, layout.scale());
  if (options.mesh != nullptr) {
    image.drawStrokes(detail::meshLines(*options.mesh, plane, window, area),
                      std::max(layout.scale(), 1.0), kMeshInk);
  }
  const auto inUnits = [&](const std::string& name) {
    return options.unit.empty() ? name : name + " [" + options.unit + "]";
  };
  layout.drawAxes(image, area, {detail::axisRange(window, 0), detail::axisRange(window, 1)},
                  {inUnits(plane.labels[0]), inUnits(plane.labels[1])});
  layout.drawColorBar(image, area, {field.least(), field.greatest()}, spacing,
                      inUnits("signed distance"));
  layout.drawTitle(image, area, options.title,
                   noteAbout(spacing, field.least(), field.greatest(), options.unit));
  return image;
}

template struct SlicePlane<float>;
template struct SlicePlane<double>;
template Image renderSlice(const SignedDistanceFunction<float>&, const SlicePlane<float>&,
                           const SliceOptions<float>&);
template Image renderSlice(const SignedDistanceFunction<double>&, const SlicePlane<double>&,
                           const SliceOptions<double>&);

}  // namespace cutwater
