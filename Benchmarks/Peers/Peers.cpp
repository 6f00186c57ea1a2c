#include "Peers/Peers.hpp"

namespace cutwater::benchmarks {

std::vector<PeerKind> peers() {
  std::vector<PeerKind> found;
#ifdef CUTWATER_BENCHMARK_EMBREE
  found.push_back({"Embree", buildEmbree});
#endif
#ifdef CUTWATER_BENCHMARK_CGAL
  found.push_back({"CGAL", buildCgal});
#endif
  return found;
}

std::vector<PeerBandKind> peerBands() {
  std::vector<PeerBandKind> found;
#ifdef CUTWATER_BENCHMARK_OPENVDB
  found.push_back({"OpenVDB", buildOpenVdb});
#endif
  return found;
}

}  // namespace cutwater::benchmarks
