#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include <optional>

#include "Checks.hpp"
#include "Peers/Peers.hpp"
#include "SearchEffort.hpp"
#include "Settings.hpp"

namespace cutwater::benchmarks {

/// One surface with all who answer for it, each built when first asked.
class Arena {
 public:
  Arena(std::string surface, const Settings& settings, Report& report);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const PolygonSoup& soup() const { return soup_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] double diagonal() const { return diagonal_; }

  const MeshSDF<double>& ours();
  /// @throws std::out_of_range if there is no such peer.
  const Peer& peer(const std::string& name);

  /// Asks point by point, each thread a thousand in a row; `contestant` is ours or a peer.
  void ask(const std::string& contestant, std::span<const Vec3<double>> points,
           std::span<double> distances, int threads);

  /// Holds answers against the truth, which has the name given: to what MeshSDF promises for ours,
  /// to 1e-9 of the diagonal for others, unless the comparison says otherwise. Peers' signs are by
  /// the nearest triangle: they count only where the surface is simple.
  void check(const std::string& workload, const std::string& contestant, const std::string& truth,
             Comparison comparison);
  /// Holds ours against a peer's; without their signs where the surface is not simple.
  void checkAgainst(const std::string& peer, const std::string& workload, Comparison comparison);

  /// Notes what writing one value to all cells of the band's grid takes.
  void noteWriting(double seconds) { report_.surfaces[name_].writingSeconds = seconds; }

  /// Notes what our search takes to find the points' distances, which have no signs.
  void count(const std::string& workload, std::span<const Vec3<double>> points,
             std::span<double> distances);

 private:
  /// Whether it is closed and does not meet itself.
  bool isSimple();

  std::string name_;
  const Settings& settings_;
  Report& report_;
  PolygonSoup soup_;
  double diagonal_;
  double farthest_ = 0;  // of the points from the origin
  std::optional<MeshSDF<double>> ours_;
  std::optional<CountedSearch> counted_;
  std::map<std::string, std::unique_ptr<Peer>> peers_;
};

}  // namespace cutwater::benchmarks
