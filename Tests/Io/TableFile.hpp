#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Tables.hpp>

#include <fstream>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {

/// A table in a file, read by `Read(path, options)`.
template <auto Read>
class TableFile : public ::testing::Test {
 protected:
  [[nodiscard]] auto read(const std::string& text, const ReadTableOptions& options = {}) const {
    std::ofstream(file, std::ios::binary) << text;
    return Read(file, options);
  }
  /// The message, without the file's name.
  [[nodiscard]] std::string refusal(const std::string& text) const {
    try {
      static_cast<void>(read(text));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::File);
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(file.string() + ": ")) << message;
      return message.substr(file.string().size() + 2);
    }
    return "nothing";
  }

  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "table.csv";
};

}  // namespace cutwater::test
