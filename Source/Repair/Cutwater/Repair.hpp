#pragma once

/// Holes, self-intersections and wraps by CGAL: the component Repair.

#include <Cutwater/Repair/FillHoles.hpp>
#include <Cutwater/Repair/RemoveSelfIntersections.hpp>
#include <Cutwater/Repair/Wrap.hpp>
