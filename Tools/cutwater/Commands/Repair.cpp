#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

#include "Commands/Commands.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/RepairSteps.hpp"
#include "Options/SurfaceOutput.hpp"
#include "Report/DiagnosisPage.hpp"
#include "Report/Format.hpp"
#include "Report/JsonViews.hpp"
#include "Report/OutOfMemory.hpp"
#include "Report/Page.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

struct RepairSettings {
  SurfaceOptions surface;
  std::string output;
  RepairOptions repair;
  WriteOptions write;
  bool requireWatertight = false;
  bool json = false;
};

struct StepDone {
  std::string name;
  StepReport report;
  double seconds = 0;
};

/// Everything that `cutwater repair` reports: the page and the JSON are views of it.
struct RepairFacts {
  MeshReport before;
  std::size_t pointsBefore = 0;
  std::vector<StepDone> steps;
  SurfaceOutput written;
  Diagnosis after;
  std::vector<Advice> next;
};

/// A step's refusal in words of the command: its option in place of the library's function.
std::string inWordsOfOptions(const RepairStep& step, std::string message) {
  const auto colon = message.find(": ");
  if (message.find(' ') == colon + 1) message.erase(0, colon + 2);
  constexpr std::string_view kFunction = "extendTo()";
  if (const auto at = message.find(kFunction); at != std::string::npos) {
    message.replace(at, kFunction.size(), "--extend");
  }
  return "--" + step.name + ": " + message;
}

StepReport run(const RepairStep& step, PolygonSoup& soup) {
  try {
    return namingMemory("out of memory", [&] { return step.run(soup); });
  } catch (const Error& error) {
    if (step.name == "clean") throw;  // always done, without an option
    throw Error(error.kind(), inWordsOfOptions(step, error.what()));
  }
}

std::vector<StepDone> repaired(PolygonSoup& soup, const std::vector<RepairStep>& steps) {
  std::vector<StepDone> done;
  Stopwatch watch;
  for (const auto& step : steps) {
    auto report = run(step, soup);
    done.push_back({step.name, std::move(report), watch.lap()});
  }
  return done;
}

std::vector<Advice> adviceFor(const std::string& output, const std::vector<Defect>& defects) {
  const auto file = fileWord(output);
  std::vector<Advice> next;
  if (!defects.empty()) {
    next.push_back({"cutwater info " + file,
                    "all about it, and a repair that would help further, if there is one"});
  }
  std::ranges::move(usesOf(file), std::back_inserter(next));
  return next;
}

RepairFacts repair(const RepairSettings& options) {
  auto wanted = options.repair;
  wanted.mending.isShown = !options.surface.quiet;
  const auto steps = stepsOf(wanted);  // before any work, as an option may be wrong
  auto soup = load(options.surface).soup;
  const auto before = check(DcelMesh<double>(soup));
  const std::size_t points = soup.points.size();
  auto done = repaired(soup, steps);
  if (soup.polygonCount() == 0) {
    throw Error(ErrorKind::Topology, options.surface.file + ": cleaning leaves no face");
  }
  auto written = asWritten(options.output, std::move(soup), options.write);
  auto after = diagnose(written.soup, {.tryTreatments = false});
  auto next = adviceFor(options.output, after.defects);
  return {.before = before,
          .pointsBefore = points,
          .steps = std::move(done),
          .written = std::move(written),
          .after = std::move(after),
          .next = std::move(next)};
}

std::string volumeOf(const MeshReport& report) {
  return report.isClosed() ? number(report.volume) : "not closed";
}

std::string pageOf(const RepairSettings& options, const RepairFacts& facts) {
  Page page;
  for (const auto& step : facts.steps) {
    page.section(step.name + ", in " + duration(step.seconds));
    page.lines(text(step.report));
  }
  const auto& after = facts.after.report;
  page.section("Changed");
  page.line("area", number(facts.before.area) + " -> " + number(after.area));
  page.line("volume", volumeOf(facts.before) + " -> " + volumeOf(after));
  page.line("before", facts.before.summary());
  page.line("after", after.summary());
  page.section("Result");
  page.line("wrote", options.output + ": " + sizeOf(facts.written));
  for (const auto& loss : facts.written.losses) page.wrapped("", loss);
  page.line("watertight", after.isClosedOriented() ? "yes" : "no");
  if (facts.after.signs) page.line("signs", facts.after.signs->summary());
  page.line("verdict", facts.after.verdict());
  describe(page, facts.after.defects);
  describe(page, facts.next);
  return page.text();
}

std::string jsonOf(const RepairSettings& options, const RepairFacts& facts) {
  Json steps = Json::array();
  for (const auto& step : facts.steps) {
    Json json{{"name", step.name}, {"seconds", step.seconds}};
    json.append(toJson(step.report));
    steps.push(std::move(json));
  }
  const auto measured = [](const MeshReport& report, std::size_t points) {
    Json json{{"polygons", report.faces}, {"points", points}, {"area", report.area}};
    json["volume"] = report.isClosed() ? Json(report.volume) : Json(nullptr);
    json["summary"] = report.summary();
    return json;
  };
  Json json{{"input", options.surface.file},
            {"output", options.output},
            {"steps", std::move(steps)},
            {"before", measured(facts.before, facts.pointsBefore)},
            {"losses", facts.written.losses},
            {"after", measured(facts.after.report, facts.written.soup.points.size())},
            {"check", checkJson(facts.after)},
            {"defects", toJson(facts.after.defects)}};
  json["signs"] = facts.after.signs ? toJson(*facts.after.signs) : Json(nullptr);
  json["next"] = toJson(facts.next);
  return json.text();
}

void run(const RepairSettings& options) {
  const auto facts = repair(options);
  if (options.requireWatertight && !facts.after.isSound()) {
    throw Error(ErrorKind::Topology,
                options.surface.file + ": the repaired surface does not bound a solid: " +
                    facts.after.report.summary() +
                    (facts.after.signs ? "; " + facts.after.signs->summary() : ""));
  }
  writeSurface(options.output, facts.written.soup, options.write);
  if (options.json) {
    std::cout << jsonOf(options, facts);
  } else if (!options.surface.quiet) {
    std::cout << pageOf(options, facts);
  }
}

}  // namespace

void addRepair(Program& program) {
  const auto options = std::make_shared<RepairSettings>();
  auto command = program.addCommand(
      "repair", "Clean a surface and close its openings, and say what was done and what is left");
  addSurfaceOptions(command, options->surface);
  addSurfaceOutput(command, "-o,--output", options->output, options->write);
  addRepairOptions(command, options->repair);
  command.addFlag("--require-watertight",
                  "Write nothing, and fail, unless the result bounds a solid",
                  options->requireWatertight);
  command.addFlag("--json", "Say what was done in JSON, for programs", options->json);
  command.setFooter(
      "Examples:\n"
      "  cutwater repair part.stl -o clean.stl\n"
      "  cutwater repair half.stl --weld 1e-6 --mirror y=0 -o whole.stl\n"
      "  cutwater repair duct.obj --cap x=0:inlet --cap x=2:outlet --tolerance 1e-5 -o duct.obj\n"
      "  cutwater repair terrain.stl --extend z=-100 -o ground.stl\n"
      "\n"
      "Always: equal points are merged, degenerate and duplicate faces and unused points removed,\n"
      "faces turned outward. 'cutwater info FILE' tells which options would help.\n"
      "Exit status 0 also if defects are left: they are listed.");
  command.setAction([=] { run(*options); });
}

}  // namespace cutwater::tool
