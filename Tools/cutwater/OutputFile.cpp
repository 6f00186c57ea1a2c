#include "OutputFile.hpp"

#include <Cutwater/Core/Error.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <system_error>

#include "Arguments.hpp"
#include "Format.hpp"
#include "Surface.hpp"

namespace cutwater::tool {

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

CLI::Option& addOutput(CLI::App& command, const std::string& names, std::string& output,
                       const std::vector<std::string>& extensions, const std::string& meaning) {
  const auto name = names.substr(names.find(',') + 1);
  return *command
              .add_option_function<std::string>(
                  names,
                  [=, &output](const std::string& path) {
                    requireExtension(name, path, extensions);
                    requireFolder(path);
                    output = path;
                  },
                  meaning)
              ->type_name(extensions.size() == 1 ? "FILE" + extensions.front() : "FILE");
}

}  // namespace cutwater::tool
