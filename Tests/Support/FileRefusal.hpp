#pragma once

#include <Cutwater/Core/Error.hpp>

#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {

/// What a reader of bytes says of them, in one line; empty if it takes them.
template <typename Read>
std::string fileRefusal(const Read& read) {
  try {
    (void)read();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::File) << error.what();
    const std::string message = error.what();
    EXPECT_FALSE(message.empty());
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }
  return "";
}

/// What a reader of files, read(path), says of one with this content, without its name.
template <typename Read>
std::string fileRefusal(std::string_view content, const Read& read) {
  const TemporaryFolder folder;
  const auto path = folder / "file";
  std::ofstream(path, std::ios::binary) << content;
  const auto message = fileRefusal([&] { return read(path); });
  if (message.empty()) return "";
  const auto name = path.string() + ": ";
  EXPECT_TRUE(message.starts_with(name)) << message;
  return message.substr(std::min(message.size(), name.size()));
}

}  // namespace cutwater::test
