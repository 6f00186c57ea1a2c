// Holes of a surface filled, a fold smoothed out, and a wrap around what cannot be mended.
// See README.md and Docs/repair.md.
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Repair/FillHoles.hpp>
#include <Cutwater/Repair/RemoveSelfIntersections.hpp>
#include <Cutwater/Repair/Wrap.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <array>
#include <cstdio>
#include <utility>

using namespace cutwater;

namespace {

/// A torus without some of its faces.
PolygonSoup leakyTorus() {
  auto torus = tessellation::torus(2, 0.5, 64, 32);
  PolygonSoup soup;
  soup.points = std::move(torus.points);
  soup.patchNames = {"torus"};
  for (std::size_t i = 0; i < torus.polygonCount(); ++i) {
    if (i % 331 > 2) soup.addPolygon(torus.polygon(i));
  }
  return soup;
}

/// A ball on which two neighbouring points have changed places.
PolygonSoup crumpledBall() {
  auto ball = tessellation::icosphere(1, 4);
  std::swap(ball.points[ball.polygon(200)[0]], ball.points[ball.polygon(200)[1]]);
  return ball;
}

/// Pebbles: faces turned at random, every other one missing.
PolygonSoup pebbles() {
  PolygonSoup soup;
  soup.patchNames = {"pebbles"};
  for (int k = 0; k < 5; ++k) {
    const auto ball = tessellation::icosphere(1, 2);
    const auto shift = static_cast<std::uint32_t>(soup.points.size());
    for (const auto& p : ball.points) soup.points.push_back(p + Vec3<double>{1.6 * k, 0.2 * k, 0});
    for (std::size_t i = 0; i < ball.polygonCount(); i += 2) {
      const auto c = ball.polygon(i);
      const bool turn = i % 3 == 0;
      soup.addPolygon(std::array{c[0] + shift, c[turn ? 2 : 1] + shift, c[turn ? 1 : 2] + shift});
    }
  }
  return soup;
}

bool boundsSolid(const PolygonSoup& soup, const char* what) {
  const MeshSDF<double> solid(soup);
  std::printf("%s: %s\n\n", what, solid.signReport().summary().c_str());
  return solid.signReport().isSound();
}

}  // namespace

int main() {
  // [DOCS
  PolygonSoup torus = leakyTorus();
  const HoleReport holes = fillHoles(torus, {.widest = 1.5, .patch = "filled"});
  std::printf("%s", holes.text().c_str());

  PolygonSoup ball = crumpledBall();
  const auto mended = removeSelfIntersections(ball);
  std::printf("%s", mended.text().c_str());

  PolygonSoup bed = pebbles();
  const WrapReport wrapped = wrap(bed, {.gap = 0.8, .offset = 0.02, .seconds = 60});
  std::printf("%s", wrapped.text().c_str());
  // DOCS]
  const bool sound =
      boundsSolid(torus, "torus") && boundsSolid(ball, "ball") && boundsSolid(bed, "pebbles");
  return sound && holes.left() == 0 && mended.pairsAfter == 0 ? 0 : 1;
}
