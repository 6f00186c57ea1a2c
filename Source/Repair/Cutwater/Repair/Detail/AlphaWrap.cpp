#include <Cutwater/Repair/Detail/AlphaWrap.hpp>
#include <Cutwater/Repair/Detail/CgalCall.hpp>
#include <Cutwater/Repair/Detail/SurfaceMesh.hpp>

#include <algorithm>

#include <CGAL/alpha_wrap_3.h>

namespace cutwater::detail {
namespace {

/// Visitor that CGAL calls for every facet it processes; tells of the progress, and throws when the
/// time is up.
class WrapWatch : public CGAL::Alpha_wraps_3::internal::Wrapping_default_visitor {
 public:
  WrapWatch(const Deadline& deadline, double points, const Progress& progress)
      : deadline_(&deadline), points_(points), progress_(&progress) {}

  template <typename Wrapper, typename Gate>
  void before_facet_treatment(const Wrapper& wrapper, const Gate&) {
    constexpr unsigned kEvery = 256;  // reading the clock takes time
    if (++facets_ % kEvery != 0) return;
    deadline_->check();
    if (!*progress_ || points_ <= 0) return;
    const auto done = static_cast<double>(wrapper.triangulation().number_of_vertices());
    (*progress_)(std::min(done / points_, 0.99));
  }

 private:
  const Deadline* deadline_;
  double points_;
  const Progress* progress_;
  unsigned facets_ = 0;
};

}  // namespace

PolygonSoup alphaWrap(const PolygonSoup& triangles, double alpha, double offset,
                      const Deadline& deadline, double points, const Progress& progress) {
  CgalMesh wrap;
  callCgal("wrap", [&] {
    WrapWatch watch(deadline, points, progress);
    CGAL::alpha_wrap_3(cgalPoints(triangles.points), cgalTriangles(triangles), alpha, offset, wrap,
                       CGAL::parameters::default_values(),
                       CGAL::parameters::visitor(std::ref(watch)));
  });
  return soupOf(wrap);
}

}  // namespace cutwater::detail
