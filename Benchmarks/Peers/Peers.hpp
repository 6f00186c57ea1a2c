#pragma once

#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cutwater::benchmarks {

/// Something that answers what a MeshSDF answers.
class Peer {
 public:
  virtual ~Peer() = default;
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  /// One query after the other, on the calling thread.
  virtual void signedDistances(std::span<const Vec3<double>> points,
                               std::span<double> distances) const = 0;
};

/// A peer's distances in a band of cells around the surface.
class PeerBand {
 public:
  virtual ~PeerBand() = default;
  PeerBand() = default;
  PeerBand(const PeerBand&) = delete;
  PeerBand& operator=(const PeerBand&) = delete;

  [[nodiscard]] virtual double at(const Index3& cell) const = 0;
};

/// Surfaces are closed and oriented, and all their polygons are triangles.
struct PeerKind {
  std::string name;
  std::unique_ptr<Peer> (*build)(const PolygonSoup& triangles, int threads);
};

struct PeerBandKind {
  std::string name;
  /// `cells`: cubic ones. `band`: in cells, to both sides.
  std::unique_ptr<PeerBand> (*build)(const PolygonSoup& triangles, const Level<double>& cells,
                                     double band, int threads);
};

/// Those that were found on this machine.
[[nodiscard]] std::vector<PeerKind> peers();
[[nodiscard]] std::vector<PeerBandKind> peerBands();

// One file each.
std::unique_ptr<Peer> buildEmbree(const PolygonSoup& triangles, int threads);
std::unique_ptr<Peer> buildCgal(const PolygonSoup& triangles, int threads);
std::unique_ptr<PeerBand> buildOpenVdb(const PolygonSoup& triangles, const Level<double>& cells,
                                       double band, int threads);

}  // namespace cutwater::benchmarks
