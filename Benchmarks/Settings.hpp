#pragma once

#include <cstddef>
#include <filesystem>

namespace cutwater::benchmarks {

struct Settings {
  std::filesystem::path data = {};     ///< folder with the files of surfaces
  std::size_t triangles = 10'000'000;  ///< surfaces with more are left out
  int rounds = 5;      ///< contestants take turns; the best of a contestant's rounds counts
  int longRounds = 3;  ///< for what takes seconds: grids that we fill, OpenVDB, building, reading
  std::size_t points = 100'000;
  double seconds = 0.5;       ///< a contestant's share of a round; the slow answer fewer points
  double fillSeconds = 10;    ///< the same where we fill a grid
  std::size_t checked = 200;  ///< answers per contestant that brute force checks

  static Settings quick() {
    return {.triangles = 2'000'000,
            .rounds = 3,
            .longRounds = 2,
            .points = 20'000,
            .seconds = 0.1,
            .fillSeconds = 0.5,
            .checked = 40};
  }
};

}  // namespace cutwater::benchmarks
