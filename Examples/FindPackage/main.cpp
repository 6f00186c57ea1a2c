// A program in a project of its own. See README.md.
#include <Cutwater/Cutwater.hpp>

#include <cstdio>

using namespace cutwater;

int main() {
  const auto keel = Cuboid<double>({-1, -0.1, -0.5}, {1, 0.1, 0}) |
                    Capsule<double>({-0.8, 0, -0.5}, {0.8, 0, -0.5}, 0.2);
  const double distance = keel.signedDistance({0, 0, -1});  // 0.3, to the bulb
  std::printf("%g\n", distance);
  return distance == 0.5 - 0.2 ? 0 : 1;
}
