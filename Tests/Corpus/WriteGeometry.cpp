#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <filesystem>

// Intact geometry files for make_corpus.py to damage: one closed, one open, in either precision.
// Usage: WriteGeometry FOLDER

namespace cutwater::test {
namespace {

template <typename T>
void write(const std::filesystem::path& folder, const std::string& precision) {
  auto soup = tessellation::box({-1, -2, -3}, {1, 2, 3}, 1);
  MeshSDF<T>(soup).save(folder / ("closed-" + precision));
  soup.patches.pop_back();  // the last face
  soup.offsets.pop_back();
  soup.corners.resize(soup.offsets.back());
  MeshSDF<T>(soup).save(folder / ("open-" + precision));
}

}  // namespace
}  // namespace cutwater::test

int main(int /*count*/, char** words) {
  const std::filesystem::path folder = words[1];
  std::filesystem::create_directories(folder);
  cutwater::test::write<float>(folder, "float");
  cutwater::test::write<double>(folder, "double");
  return 0;
}
