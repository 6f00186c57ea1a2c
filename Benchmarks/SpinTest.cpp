#include "SpinTest.hpp"

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

#include "Seconds.hpp"

namespace cutwater::benchmarks {

namespace {

/// Steps of a chain in registers.
void spin() {
  std::uint64_t x = 1;
  for (int i = 0; i < 50'000'000; ++i) x = x * 6364136223846793005U + 1442695040888963407U;
  volatile auto sink = x;
  static_cast<void>(sink);
}

double secondsFor(int threads) {
  return secondsOf([&] {
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(spin);
    spin();
    for (auto& other : others) other.join();
  });
}

}  // namespace

double coresSeen(int threads) {
  double alone = 1e9;
  double together = 1e9;
  for (int round = 0; round < 5; ++round) {
    alone = std::min(alone, secondsFor(1));
    together = std::min(together, secondsFor(threads));
  }
  return threads * alone / together;
}

}  // namespace cutwater::benchmarks
