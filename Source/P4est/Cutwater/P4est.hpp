#pragma once

/// Octree meshes over MPI: the component P4est.

#include <Cutwater/P4est/Agreement.hpp>
#include <Cutwater/P4est/DistributedOctree.hpp>
#include <Cutwater/P4est/DistributedVtu.hpp>
#include <Cutwater/P4est/SharedGeometry.hpp>
