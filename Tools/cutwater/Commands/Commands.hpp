#pragma once

#include "Options/Program.hpp"

/// One subcommand per file: each function adds a subcommand to the program, which runs once it has
/// been parsed.
namespace cutwater::tool {

void addInfo(Program& program);
void addSample(Program& program);
void addQuery(Program& program);
void addAmr(Program& program);
void addCells(Program& program);
void addMesh(Program& program);
void addSlice(Program& program);
void addRender(Program& program);
void addIsosurface(Program& program);
void addConvert(Program& program);
void addMake(Program& program);
void addPrepare(Program& program);
void addRepair(Program& program);
void addScene(Program& program);

}  // namespace cutwater::tool
