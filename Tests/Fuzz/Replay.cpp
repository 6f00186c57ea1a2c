#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "Fuzz.hpp"

// Runs a fuzzer once over every file of the folders given, where libFuzzer is not at hand. Whatever
// the fuzzer does not expect ends the program; so does a folder with nothing in it.

int main(int count, char** words) {
  std::vector<std::filesystem::path> files;
  for (const std::string folder : std::span(words, words + count).subspan(1)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  cutwater::test::expect(!files.empty(), "there are inputs");
  for (const auto& path : files) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    std::printf("%s\n", path.filename().c_str());
    std::fflush(stdout);  // the last name is that of the input which ends it
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::printf("%zu inputs\n", files.size());
  return 0;
}
