#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Curved/CertainParts.hpp>

#include <vector>

namespace cutwater {

/// How many pieces the fluid in a box certainly is. Parts that share a face are neighbours: the
/// fluid, which is open, cannot lead through edges alone. Where it is thin beside a face or an edge
/// of the box, finer parts of these tell what is connected.
class PieceProof {
 public:
  /// Views the field. `options`: what limits the number of parts, and their size.
  PieceProof(const FluidField& field, const Box<double>& box, const CertifyOptions& options);

  /// See Certifier::arePieces(). Once for each object.
  [[nodiscard]] bool has(std::size_t count);

 private:
  static constexpr std::size_t kLow = 1;
  static constexpr std::size_t kHigh = 2;
  /// A face or an edge of the box.
  struct Side {
    CertainParts parts;
    CertainParts::Place ends{};  ///< of each axis across it, at which end it lies: kLow or kHigh
    int levels = 0;              ///< by which its parts are smaller than those of the box
  };
  [[nodiscard]] bool halve(CertainParts& parts);
  [[nodiscard]] bool refineSides();
  [[nodiscard]] bool areApart(std::size_t count) const;
  template <typename Join>
  void joinThrough(const Side& side, const Join& join) const;

  const CertifyOptions& options_;
  CertainParts volume_;
  std::vector<Side> sides_;
  std::size_t looked_ = 0;
};

}  // namespace cutwater
