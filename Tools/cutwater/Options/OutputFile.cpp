#include "Options/OutputFile.hpp"

#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Detail/PartFile.hpp>
#include <Cutwater/Core/Error.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <unistd.h>

#include "Options/Arguments.hpp"
#include "Options/SurfaceOptions.hpp"
#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

/// Calls only what handlers of signals may. The signal is blocked until this returns, and then ends
/// the program, as its default action is back.
extern "C" void endBySignal(int number) {
  removePartFiles();
  if (number == SIGXCPU) {
    constexpr std::string_view kWhy =
        "cutwater: error: the limit on processor time (ulimit -t) is reached\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, kWhy.data(), kWhy.size());
  }
  static_cast<void>(raise(number));
}

}  // namespace

void requireExtension(const std::string& option, const std::string& path,
                      const std::vector<std::string>& extensions) {
  const bool isGood =
      path.starts_with("/dev/") || std::ranges::count(extensions, extensionOf(path)) > 0;
  if (isGood) return;
  refuse(option, path, "a name that ends in " + listed(extensions));
}

void requireFolder(const std::string& path) {
  const auto folder = std::filesystem::path(path).parent_path();
  std::error_code ignored;
  if (folder.empty() || std::filesystem::is_directory(folder, ignored)) return;
  throw Error(ErrorKind::File, path + ": there is no folder " + folder.string());
}

void prepareOutput(const std::string& path) {
  requireFolder(path);
  removeStaleParts(path);
}

void writeText(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

void removeOutputsOnSignals() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU}) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
    action.sa_handler = endBySignal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(number, &action, nullptr);
  }
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
}

Option addOutput(Command command, const std::string& names, std::string& output,
                 const std::vector<std::string>& extensions, const std::string& meaning) {
  const auto name = names.substr(names.find(',') + 1);
  const auto value = extensions.size() == 1 ? "FILE" + extensions.front() : "FILE";
  return command.add(names, value, meaning, [=, &output](const std::string& path) {
    requireExtension(name, path, extensions);
    prepareOutput(path);
    output = path;
  });
}

}  // namespace cutwater::tool
