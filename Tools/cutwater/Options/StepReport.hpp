#pragma once

#include <Cutwater/Surface/Cleaning/CleanReport.hpp>
#include <Cutwater/Surface/Cleaning/Openings.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>
#ifdef CUTWATER_HAS_REPAIR
#include <Cutwater/Repair/FillHoles.hpp>
#include <Cutwater/Repair/RemoveSelfIntersections.hpp>
#include <Cutwater/Repair/Wrap.hpp>
#endif

#include <functional>
#include <string>
#include <variant>

namespace cutwater::tool {

/// The library's report on what a step of a repair found and did.
#ifdef CUTWATER_HAS_REPAIR
using StepReport =
    std::variant<CleanReport, OpeningReport, HoleReport, SelfIntersectionRepairReport, WrapReport>;
#else
using StepReport = std::variant<CleanReport, OpeningReport>;
#endif

/// A step of a repair.
struct RepairStep {
  std::string name;  ///< "clean", or the option that asked for it: "cap z=0:inlet"
  std::function<StepReport(PolygonSoup&)> run;
};

}  // namespace cutwater::tool
