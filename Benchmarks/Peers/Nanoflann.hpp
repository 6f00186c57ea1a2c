#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cstdint>
#include <memory>
#include <span>

namespace cutwater::benchmarks {

/// nanoflann's kd-tree over points, with its default leaves of 10.
class NanoflannTree {
 public:
  explicit NanoflannTree(std::span<const Vec3<double>> points);
  ~NanoflannTree();
  NanoflannTree(const NanoflannTree&) = delete;
  NanoflannTree& operator=(const NanoflannTree&) = delete;

  /// As many as there is room for, in order; squares of distances.
  void nearest(const Vec3<double>& p, std::span<std::uint32_t> ids,
               std::span<double> squares) const;
  /// How many there are, as pairs in a list, in no order.
  [[nodiscard]] std::size_t within(const Vec3<double>& p, double radius) const;

 private:
  struct Index;

  std::unique_ptr<Index> index_;
};

}  // namespace cutwater::benchmarks
