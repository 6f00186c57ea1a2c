#include "Options/OutputFile.hpp"

#include <Cutwater/Core/Error.hpp>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "Options/Arguments.hpp"
#include "Options/SurfaceOptions.hpp"
#include "Report/Format.hpp"

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

Option addOutput(Command command, const std::string& names, std::string& output,
                 const std::vector<std::string>& extensions, const std::string& meaning) {
  const auto name = names.substr(names.find(',') + 1);
  const auto value = extensions.size() == 1 ? "FILE" + extensions.front() : "FILE";
  return command.add(names, value, meaning, [=, &output](const std::string& path) {
    requireExtension(name, path, extensions);
    requireFolder(path);
    output = path;
  });
}

}  // namespace cutwater::tool
