#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#include <tbb/global_control.h>

#include "Peers/Peers.hpp"

namespace cutwater::benchmarks {

namespace {

/// The soup as OpenVDB reads meshes: corners in units of cells, with cell centres at integers.
struct Adapter {
  const PolygonSoup& soup;
  Vec3<double> firstCentre;
  double spacing;

  [[nodiscard]] std::size_t polygonCount() const { return soup.polygonCount(); }
  [[nodiscard]] std::size_t pointCount() const { return soup.points.size(); }
  [[nodiscard]] static std::size_t vertexCount(std::size_t) { return 3; }
  void getIndexSpacePoint(std::size_t polygon, std::size_t vertex, openvdb::Vec3d& position) const {
    const auto p = (soup.points[soup.corners[3 * polygon + vertex]] - firstCentre) / spacing;
    position = {p.x, p.y, p.z};
  }
};

class OpenVdb final : public PeerBand {
 public:
  OpenVdb(const Adapter& mesh, float band)
      : grid_(openvdb::tools::meshToVolume<openvdb::FloatGrid>(
            mesh, *openvdb::math::Transform::createLinearTransform(mesh.spacing), band, band)) {}

  double at(const Index3& cell) const override {
    return grid_->tree().getValue({cell.i, cell.j, cell.k});
  }

 private:
  openvdb::FloatGrid::Ptr grid_;
};

}  // namespace

std::unique_ptr<PeerBand> buildOpenVdb(const PolygonSoup& triangles, const Level<double>& cells,
                                       double band, int threads) {
  static const bool kReady = (openvdb::initialize(), true);
  static_cast<void>(kReady);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  const double spacing = cells.spacing().x;
  const auto half = 0.5 * cells.spacing();
  return std::make_unique<OpenVdb>(Adapter{triangles, cells.origin() + half, spacing},
                                   static_cast<float>(band));
}

}  // namespace cutwater::benchmarks
