#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Camera.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using detail::Camera;
using detail::Frame;

void expectNear(const Vec3<double>& a, const Vec3<double>& b, double tolerance = 1e-12) {
  EXPECT_LT(length(a - b), tolerance) << a << " and " << b;
}

TEST(CameraTest, NamesAreDirections) {
  expectNear(View::named("-y").right(), {1, 0, 0}, 0x1p-1000);
  expectNear(View::named("-y").up, {0, 0, 1}, 0x1p-1000);
  expectNear(View::named("+x").back, {1, 0, 0}, 0x1p-1000);
  expectNear(View::named("+x").right(), {0, 1, 0}, 0x1p-1000);
  expectNear(View::named("+z").right(), {1, 0, 0}, 0x1p-1000);
  expectNear(View::named("+z").up, {0, 1, 0}, 0x1p-1000);
  expectNear(View::named("-z").right(), {-1, 0, 0}, 0x1p-1000);
  const auto iso = View::named("iso");
  // All axes look equally long.
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(std::hypot(iso.right()[axis], iso.up[axis]), std::sqrt(2 / 3.0), 1e-12);
  }
}

TEST(CameraTest, AnglesAreThoseOfTheGlobe) {
  expectNear(View::fromAngles(0, 0).back, {1, 0, 0}, 0x1p-1000);
  expectNear(View::fromAngles(90, 0).back, {0, 1, 0}, 0x1p-1000);
  expectNear(View::fromAngles(-90, 0).right(), {1, 0, 0}, 0x1p-1000);
  expectNear(View::fromAngles(-90, 90).up, {0, 1, 0}, 0x1p-1000);
  expectNear(View::fromAngles(30, 20).back,
             {std::cos(20 * M_PI / 180) * std::cos(30 * M_PI / 180),
              std::cos(20 * M_PI / 180) * std::sin(30 * M_PI / 180), std::sin(20 * M_PI / 180)});
  const auto view = View::fromAngles(30, 20);
  expectNear(view.up, View::from(view.back).up);
}

/// Pixel coordinates of a point, found by how far rays pass it.
std::array<double, 2> pixelOf(const Camera& camera, const Vec3<double>& p) {
  // In steps of one pixel: rays of neighbours differ linearly, up to the perspective division.
  std::array<double, 2> at{50, 50};
  for (int step = 0; step < 60; ++step) {
    const auto ray = camera.ray(at[0], at[1]);
    const auto off = p - ray.at(dot(p - ray.origin, ray.direction));
    const double pixel = camera.pixelSize(length(p - ray.origin));
    at[0] += dot(off, camera.view().right()) / pixel;
    at[1] -= dot(off, camera.view().up) / pixel;
  }
  return at;
}

TEST(CameraTest, BoxesFillTheFrame) {
  const Box<double> box{{1, 2, 3}, {5, 4, 4}};
  const Frame frame{80, 70, 100, 60};
  for (const double angle : {0.0, 20.0, 70.0}) {
    for (const auto* name : {"+x", "-y", "-z", "iso"}) {
      const Camera camera(View::named(name), box, frame, angle);
      double reach = 0;
      for (int i = 0; i < 8; ++i) {
        const auto [x, y] = pixelOf(camera, box.corner(i));
        reach = std::max({reach, std::abs(x - 80) / 50, std::abs(y - 70) / 30});
      }
      EXPECT_NEAR(reach, 1, 1e-6) << name << ' ' << angle;
    }
  }
}

TEST(CameraTest, ZoomsToAPart) {
  const Box<double> box{{-1, -1, -1}, {1, 1, 1}};
  const Frame frame{50, 50, 100, 100};
  for (const double angle : {0.0, 30.0}) {
    const Camera camera(View::named("iso"), box, frame, angle);
    const auto zoomed = camera.zoomed({30, 60, 20, 10}, frame);
    // Five times as large: the part's corners and middle.
    for (const auto& [from, to] : {std::pair{Frame{20, 60, 0, 0}, Frame{0, 50, 0, 0}},
                                   std::pair{Frame{40, 65, 0, 0}, Frame{100, 75, 0, 0}},
                                   std::pair{Frame{30, 60, 0, 0}, Frame{50, 50, 0, 0}}}) {
      const auto before = camera.ray(from.centerX, from.centerY);
      const auto after = zoomed.ray(to.centerX, to.centerY);
      expectNear(before.direction, after.direction);
      expectNear(before.origin, after.origin);
    }
    EXPECT_NEAR(zoomed.pixelSize(3), camera.pixelSize(3) / 5, 1e-12);
  }
}

TEST(CameraTest, ProjectsPointsToTheirRays) {
  for (const double angle : {0.0, 30.0}) {
    const Camera camera(View::named("iso"), {{-1, -1, -1}, {2, 1, 1}}, {50, 40, 100, 60}, angle);
    const auto seen = camera.zoomed({30, 60, 20, 10}, {50, 40, 100, 60});
    const auto [x, y] = seen.project(seen.ray(17, 81).at(3));
    EXPECT_NEAR(x, 17, 1e-9);
    EXPECT_NEAR(y, 81, 1e-9);
  }
}

TEST(CameraTest, AnEyeLooksAtItsTarget) {
  const Camera camera(Eye{{10, 0, 0}, {4, 0, 0}}, {50, 50, 100, 80}, 90);
  expectNear(camera.ray(50, 50).direction, {-1, 0, 0});
  expectNear(camera.ray(100, 50).direction, normalized(Vec3<double>{-1, 1, 0}));
  expectNear(camera.ray(50, 0).direction, normalized(Vec3<double>{-1, 0, 1}));
  EXPECT_EQ(camera.nearest(), 0);
}

TEST(CameraTest, DirectionsMayHaveAnyLength) {
  const auto wanted = View::from({3, 0, 4}, {0, 1, 0});
  for (const double length : {1e-310, 1e-200, 1e200, 4e307}) {
    const auto view = View::from({3 * length, 0, 4 * length}, {0, length, 0});
    expectNear(view.back, wanted.back);
    expectNear(view.up, wanted.up);
  }
}

TEST(CameraTest, RefusesWhatIsNoDirection) {
  EXPECT_THROW(View::from({0, 0, 0}), Error);
  EXPECT_THROW(View::from({1, 0, NAN}), Error);
  EXPECT_THROW(View::fromAngles(0, 91), Error);
  EXPECT_THROW(View::fromAngles(INFINITY, 0), Error);
  for (const auto* name : {"", "x", "+w", "++", "isometric", "+xy"}) {
    EXPECT_THROW(View::named(name), Error) << name;
  }
}

}  // namespace
}  // namespace cutwater::test
