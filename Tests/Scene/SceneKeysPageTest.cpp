// Docs/scenes.md against the library and the examples.
#include <set>

#include "Scenes.hpp"

namespace cutwater::test {
namespace {

const std::filesystem::path kSource(CUTWATER_SOURCE_FOLDER);

TEST(SceneKeysPageTest, IsInTheDocumentation) {
  const auto page = contentOf(kSource / "Docs/scenes.md");
  const auto start = page.find("### Every solid");
  ASSERT_NE(start, std::string::npos);
  EXPECT_EQ(page.substr(start), sceneKeys())
      << "write what 'cutwater scene --keys' prints to the end of Docs/scenes.md";
}

TEST(SceneKeysPageTest, HasEveryFormAndKey) {
  const auto page = sceneKeys();
  std::size_t forms = 0;
  for (const auto& group : scene::allSceneForms()) {
    for (const auto& form : group.forms) {
      ++forms;
      const auto title =
          form.kindKey.empty() ? form.name : form.kindKey + " = \"" + form.name + '"';
      const auto at = page.find("#### `" + title + "`\n");
      ASSERT_NE(at, std::string::npos) << title;
      const auto section = page.substr(at, page.find("\n#", at + 1) - at);
      for (const auto& key : form.keys) {
        EXPECT_NE(section.find("| `" + key.name + "` | "), std::string::npos) << key.name;
        EXPECT_FALSE(key.meaning.empty()) << key.name;
      }
    }
  }
  EXPECT_GE(forms, 40U);
}

TEST(SceneKeysPageTest, AWordChoosesSections) {
  const auto page = sceneKeys("TORUS");
  EXPECT_TRUE(page.starts_with("### Shapes\n\n")) << page;
  EXPECT_NE(page.find("#### `shape = \"torus\"`\n"), std::string::npos);
  EXPECT_NE(page.find("#### `shape = \"capped torus\"`\n"), std::string::npos);
  EXPECT_EQ(page.find("shape = \"sphere\""), std::string::npos);
  EXPECT_EQ(page.find("### Operators"), std::string::npos);
  EXPECT_EQ(sceneKeys("teapot"), "");
}

TEST(SceneKeysPageTest, TablesOfSeveralKindsAreToldApart) {
  const auto page = sceneKeys("turns_per_length");
  const auto either = page.find("| *either* | | *Cells along radius, angle and height");
  const auto radial = page.find("| `cell.radial_size` | ");
  const auto other = page.find("| *or* | | *Cells whose size");
  const auto x = page.find("| `cell.x` | ");
  EXPECT_LT(either, radial);
  EXPECT_LT(radial, other);
  EXPECT_LT(other, x);
  EXPECT_LT(x, page.size());
}

/// Scenes on the page are files that are read here and drawn by the tests of the command.
TEST(SceneKeysPageTest, ScenesOnThePageAreExamples) {
  std::set<std::string> examples;
  for (const auto& file : std::filesystem::directory_iterator(kSource / "Examples/Scenes")) {
    if (file.path().extension() != ".toml") continue;
    examples.insert(contentOf(file.path()));
    EXPECT_FALSE(readScene(file.path()).boundingBox().empty()) << file.path();
  }
  EXPECT_GE(examples.size(), 3U);
  const auto page = contentOf(kSource / "Docs/scenes.md");
  const std::string fence = "```toml\n";
  int shown = 0;
  for (auto at = page.find(fence); at != std::string::npos; at = page.find(fence, at + 1)) {
    const auto begin = at + fence.size();
    EXPECT_TRUE(examples.contains(page.substr(begin, page.find("```", begin) - begin)));
    ++shown;
  }
  EXPECT_GE(shown, 1);
}

}  // namespace
}  // namespace cutwater::test
