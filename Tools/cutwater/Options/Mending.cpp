#include "Options/Mending.hpp"

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <unistd.h>

#include "Options/Arguments.hpp"
#include "Options/SurfaceOptions.hpp"
#include "Report/Format.hpp"
#include "Report/ProgressBar.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

double widthOf(const std::string& text) {
  if (text == "all") return std::numeric_limits<double>::infinity();
  return positiveNumber("--holes", text, "all, or a length above 0");
}

MendingOptions::Wrap wrapOf(const std::string& text) {
  constexpr const char* kNeed = "a gap, or a gap and an offset, both lengths: 0.1 or 0.1,0.002";
  const auto values = numbers("--wrap", text, kNeed);
  const bool isGood = (values.size() == 1 || values.size() == 2) &&
                      std::ranges::all_of(values, [](double v) { return v > 0; });
  if (!isGood) refuse("--wrap", text, kNeed);
  MendingOptions::Wrap wrap{.gap = values[0]};
  if (values.size() == 2) wrap.offset = values[1];
  return wrap;
}

std::string textOf(const MendingOptions::Wrap& wrap) {
  return exactly(wrap.gap) + (wrap.offset ? "," + exactly(*wrap.offset) : "");
}

std::string textOfWidth(double widest) {
  return std::isinf(widest) ? "all" : exactly(widest);
}

/// What is expected to fit into the time: "--wrap 0.05 should fit".
std::string remedyOf(const WrapEstimate& expected, double seconds) {
  constexpr double kSafe = 0.7;  // of the time, as this is an estimate
  const double gap = expected.gapWithin(kSafe * seconds);
  return (std::isfinite(gap) ? "--wrap " + exactly(gap) + " should fit, and " : "") +
         "--budget gives it more";
}

/// @throws Error(Limit) if it is certain enough that there is too little time.
void requireTime(const WrapEstimate& expected, const MendingOptions& options) {
  constexpr double kDoubt = 1.5;
  const auto text = "about " + grouped(static_cast<std::size_t>(rounded(expected.triangles, 2))) +
                    " triangles, " + roughDuration(expected.seconds);
  if (expected.seconds > kDoubt * options.seconds) {
    throw Error(ErrorKind::Limit, "this would take " + text + ", and there are " +
                                      duration(options.seconds) + "; " +
                                      remedyOf(expected, options.seconds));
  }
  if (options.isShown && isatty(STDERR_FILENO) == 1) std::cerr << "wrap: " << text << '\n';
}

/// Runs the work, and adds to the error of one that is late what would help.
template <typename Work>
auto withRemedy(const std::string& remedy, double seconds, const Work& work) {
  Stopwatch watch;
  try {
    return work();
  } catch (const Error& error) {
    const bool isLate = error.kind() == ErrorKind::Limit && watch.lap() > seconds;
    if (!isLate) throw;
    throw Error(ErrorKind::Limit, std::string(error.what()) + "; " + remedy);
  }
}

WrapReport wrapped(PolygonSoup& soup, const MendingOptions& options) {
  constexpr double kFew = 20'000;  // triangles, about: not worth an estimate
  const double seconds = options.seconds;
  WrapOptions how{.gap = options.wrap->gap, .offset = options.wrap->offset, .seconds = seconds};
  std::string remedy = "--budget gives it more";
  if (8 * measure(soup).area > kFew * how.gap * how.gap) {
    const auto expected = withRemedy(remedy, seconds, [&] { return estimateWrap(soup, how); });
    requireTime(expected, options);
    // Should it be late, the machine is slower than expected, and no gap takes less than it says.
    remedy = remedyOf(expected, std::min(seconds, expected.seconds));
  }
  ProgressBar bar("wrapping", options.isShown);
  how.progress = bar.callback();
  return withRemedy(remedy, seconds, [&] { return wrap(soup, how); });
}

}  // namespace

bool canMend() {
  return true;
}

HoleFilling holeFilling() {
  return [](PolygonSoup& soup, double widest) {
    return fillHoles(soup, {.widest = widest, .seconds = MendingOptions().seconds}).filled.count;
  };
}

void addMendingOptions(Command command, MendingOptions& options) {
  command.add(
      "--holes", "LENGTH|all",
      "Then fill holes that are no wider than this, or all, with faces between the points of "
      "their rims",
      [&](const std::string& text) { options.widestHole = widthOf(text); });
  command.addFlag("--intersections",
                  "Then mend places where the surface folds over or passes through itself a "
                  "little; only where it is oriented and manifold",
                  options.selfIntersections);
  command.add("--wrap", "GAP[,OFFSET]",
              "In the end put a watertight surface around it all, so far away; what a ball of the "
              "diameter GAP does not pass is closed [default of OFFSET: a thirtieth of GAP]",
              [&](const std::string& text) { options.wrap = wrapOf(text); });
  command.add(
      "--budget", "SECONDS",
      "So much time for each of the three; holes and folds that are late stay, a late wrap is "
      "an error [default: 60]",
      [&](const std::string& text) { options.seconds = positiveNumber("--budget", text); });
}

std::string commandLine(const MendingOptions& options) {
  std::string result;
  if (options.widestHole) result += " --holes " + textOfWidth(*options.widestHole);
  if (options.selfIntersections) result += " --intersections";
  if (options.wrap) result += " --wrap " + textOf(*options.wrap);
  if (options.seconds != MendingOptions().seconds)
    result += " --budget " + exactly(options.seconds);
  return result;
}

void addMendingSteps(const MendingOptions& options, std::vector<RepairStep>& steps) {
  const double seconds = options.seconds;
  if (const auto widest = options.widestHole) {
    steps.push_back({"holes " + textOfWidth(*widest), [widest, seconds](PolygonSoup& soup) {
                       return fillHoles(soup, {.widest = *widest, .seconds = seconds});
                     }});
  }
  if (options.selfIntersections) {
    steps.push_back({"intersections", [seconds](PolygonSoup& soup) {
                       return removeSelfIntersections(soup, {.seconds = seconds});
                     }});
  }
  if (const auto how = options.wrap) {
    steps.push_back(
        {"wrap " + textOf(*how), [options](PolygonSoup& soup) { return wrapped(soup, options); }});
  }
}

}  // namespace cutwater::tool
