#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Scene/Detail/SceneForm.hpp>
#include <Cutwater/Scene/ReadScene.hpp>

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "Support/Random.hpp"
#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {

/// Scenes written to a folder and read from there.
class SceneTest : public ::testing::Test {
 protected:
  [[nodiscard]] Solid<double> read(const std::string& text,
                                   const ReadSceneOptions& options = {}) const {
    std::ofstream(file, std::ios::binary) << text;
    return readScene(file, options);
  }
  /// The message, without the file's name.
  [[nodiscard]] std::string refusal(const std::string& text,
                                    ErrorKind kind = ErrorKind::File) const {
    try {
      static_cast<void>(read(text));
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.kind(), kind) << message;
      EXPECT_TRUE(message.starts_with(file.string() + ": ")) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message.substr(file.string().size() + 2);
    }
    return "nothing";
  }

  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "test.toml";
};

/// The same values to the bit, the same expression and patches.
inline void expectSame(const Solid<double>& read, const Solid<double>& made) {
  EXPECT_EQ(read.describe(), made.describe());
  EXPECT_EQ(read.patchNames(), made.patchNames());
  RandomPoints<double> points(3);
  for (int i = 0; i < 300; ++i) {
    const auto p = points.next();
    EXPECT_EQ(read.signedDistance(p), made.signedDistance(p)) << p.x << ' ' << p.y << ' ' << p.z;
    EXPECT_EQ(read.closestPoint(p).owner.patch, made.closestPoint(p).owner.patch);
  }
}

/// The same, of a solid with one patch, which has the name of its table, [it].
inline void expectIt(const Solid<double>& read, const Solid<double>& made) {
  expectSame(read, named(made, "it"));
}

inline std::vector<std::string> namesOf(const std::vector<scene::SceneForm>& forms) {
  std::vector<std::string> names;
  for (const auto& form : forms) names.push_back(form.name);
  std::sort(names.begin(), names.end());
  return names;
}

/// What a table in a scene should make.
struct Expected {
  std::string name;  ///< of the form
  std::string text;
  Solid<double> solid;
};

/// Each of the forms at least once.
inline void expectAll(const std::vector<Expected>& cases,
                      const std::vector<scene::SceneForm>& forms) {
  std::vector<std::string> tried;
  for (const auto& one : cases) tried.push_back(one.name);
  std::sort(tried.begin(), tried.end());
  tried.erase(std::unique(tried.begin(), tried.end()), tried.end());
  EXPECT_EQ(tried, namesOf(forms));
}

}  // namespace cutwater::test
