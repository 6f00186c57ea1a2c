// A program of somebody else's that reads a scene.
#include <Cutwater/Scene.hpp>

#include <cstdio>
#include <fstream>

int main() {
  std::ofstream("scene.toml") << "[ball]\nshape = \"sphere\"\nradius = 2\n";
  const auto solid = cutwater::readScene("scene.toml");
  std::printf("distance %.1f\n", solid.signedDistance({3, 0, 0}));
  return solid.signedDistance({3, 0, 0}) == 1 ? 0 : 1;
}
