#pragma once

#include <Cutwater/Surface/Cleaning/CleanReport.hpp>
#include <Cutwater/Surface/Shells.hpp>

namespace cutwater {

/// What orientFaces() turned.
struct OrientationCorrections {
  Correction faces;              ///< turned to agree with their neighbours
  Correction shells;             ///< turned as a whole: the middle of the first face of each
  std::size_t unorientable = 0;  ///< parts like a Moebius strip
};

/// Turns faces so that the surface faces outward, as orientShells() determines. Points, corners and
/// their order within a face stay the same, except for the direction.
/// @throws Error(Argument) as DcelMesh does.
OrientationCorrections orientFaces(PolygonSoup& soup,
                                   NestedShells nested = NestedShells::AsTheyAre);

}  // namespace cutwater
