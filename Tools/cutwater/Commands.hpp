#pragma once

namespace CLI {
class App;
}

/// One subcommand per file: each function adds a subcommand to the program, which runs once it has
/// been parsed.
namespace cutwater::tool {

void addInfo(CLI::App& program);
void addSample(CLI::App& program);
void addAmr(CLI::App& program);
void addSlice(CLI::App& program);
void addRender(CLI::App& program);
void addIsosurface(CLI::App& program);
void addConvert(CLI::App& program);
void addMake(CLI::App& program);
void addPrepare(CLI::App& program);
void addRepair(CLI::App& program);
void addScene(CLI::App& program);

}  // namespace cutwater::tool
