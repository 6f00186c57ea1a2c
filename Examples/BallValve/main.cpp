// A ball valve: a ball with a bore, turned shut. Asks for distances, closest points and boxes.

#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <cstdio>

using namespace cutwater;

int main() {
  // [README
  Solid<double> valve = Sphere<double>({0, 0, 0}, 1) - Cylinder<double>({-2, 0, 0}, {2, 0, 0}, 0.4);
  valve.rotate(90, 2);         // about the z axis: the bore now runs along y
  valve.translate({5, 0, 0});  // motions act in the order of the calls

  const double distance = valve.signedDistance({7, 0, 0});  // 1; negative would be inside
  const auto nearest = valve.closestPoint({7, 0, 0});       // (6, 0, 0), with its normal
  const auto cell = valve.classify({{5.5, -0.1, -0.1}, {5.7, 0.1, 0.1}});  // certainly all solid
  // README]

  std::printf("distance %g, nearest point (%g, %g, %g)\n", distance, nearest.point.x,
              nearest.point.y, nearest.point.z);
  const bool open = valve.signedDistance({5, 0.9, 0}) > 0 && valve.signedDistance({5.9, 0, 0}) < 0;
  std::printf("the bore runs along y: %s\n", open ? "yes" : "no");
  const bool right = distance == 1 && nearest.point == Vec3<double>{6, 0, 0} && open;
  return right && cell == BoxClass::Inside ? 0 : 1;
}
