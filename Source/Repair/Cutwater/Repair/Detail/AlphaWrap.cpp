#include <Cutwater/Repair/Detail/AlphaWrap.hpp>
#include <Cutwater/Repair/Detail/CgalCall.hpp>
#include <Cutwater/Repair/Detail/SurfaceMesh.hpp>

#include <CGAL/alpha_wrap_3.h>

namespace cutwater::detail {
namespace {

/// Visitor that CGAL calls for every facet it processes; throws when the time is up.
class WrapWatch : public CGAL::Alpha_wraps_3::internal::Wrapping_default_visitor {
 public:
  explicit WrapWatch(const Deadline& deadline) : deadline_(&deadline) {}

  template <typename Wrapper, typename Gate>
  void before_facet_treatment(const Wrapper&, const Gate&) {
    constexpr unsigned kEvery = 256;  // reading the clock takes time
    if (++facets_ % kEvery == 0) deadline_->check();
  }

 private:
  const Deadline* deadline_;
  unsigned facets_ = 0;
};

}  // namespace

PolygonSoup alphaWrap(const PolygonSoup& triangles, double alpha, double offset,
                      const Deadline& deadline) {
  CgalMesh wrap;
  callCgal("wrap", [&] {
    WrapWatch watch(deadline);
    CGAL::alpha_wrap_3(cgalPoints(triangles.points), cgalTriangles(triangles), alpha, offset, wrap,
                       CGAL::parameters::default_values(),
                       CGAL::parameters::visitor(std::ref(watch)));
  });
  return soupOf(wrap);
}

}  // namespace cutwater::detail
