#pragma once

#include <string>
#include <vector>

#include "Options/Command.hpp"

// Names of files to write, refused before any work where nothing good can come of it.
namespace cutwater::tool {

/// Every name is good for devices such as /dev/stdout.
/// @throws UsageError unless the name ends in one of the extensions (".vti"), in either
/// case.
void requireExtension(const std::string& option, const std::string& path,
                      const std::vector<std::string>& extensions);

/// @throws Error unless the folder that the file is to be in exists.
void requireFolder(const std::string& path);

/// Accepts the name of a file to write: removes what a run that was killed has left of it.
/// @throws Error as requireFolder().
void prepareOutput(const std::string& path);

/// Writes a file, which appears once it is complete.
void writeText(const std::string& path, const std::string& text);

/// Lets signals that end the program (Ctrl-C, SIGTERM, and others that can be caught) remove the
/// unfinished files first, and lets writing fail, with a message, at a limit on the size of files.
/// For main(). Signals that the caller ignores or handles stay as they are.
void removeOutputsOnSignals();

/// Adds an option, as in "-o,--output", for a file with one of the extensions in a folder that
/// exists. `output` must outlive the command.
Option addOutput(Command command, const std::string& names, std::string& output,
                 const std::vector<std::string>& extensions, const std::string& meaning);

}  // namespace cutwater::tool
