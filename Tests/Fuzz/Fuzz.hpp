#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Surface/Formats/Readers.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>

// What every fuzzer asks of a reader: the soup is whole, or an Error says where the bytes are bad.
// Anything else ends the process, by which libFuzzer and the replay know.

/// libFuzzer's entry, one for each program.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace cutwater::test {

inline void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

inline constexpr const char* kFuzzName = "fuzz";

inline void expectWhole(const SurfaceFile& file) {
  try {
    file.soup.validate();
  } catch (const Error& error) {
    expect(false, error.what());
  }
  const auto& soup = file.soup;
  const auto& report = file.report;
  expect(soup.polygonCount() > 0, "there are faces");
  expect(report.polygonsInFile == soup.polygonCount(), "every face is in the report");
  expect(report.pointsInFile == soup.points.size() + report.pointsMerged, "so is every point");
  for (const auto patch : soup.patches)
    expect(patch < soup.patchNames.size(), "patches have names");
}

/// Nothing where a reader of the file refuses, as it should: with its name and a place, or its
/// size; and by an error of one of these kinds.
template <typename Read>
auto answerOrRefusal(const std::string& file, const Read& read,
                     std::initializer_list<ErrorKind> kinds = {ErrorKind::File, ErrorKind::Limit})
    -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const Error& error) {
    const std::string message = error.what();
    expect(std::find(kinds.begin(), kinds.end(), error.kind()) != kinds.end(), "the error's kind");
    expect(message.starts_with(file + ": "), "messages begin with the file");
    expect(message.size() < 600, "messages are short");
    expect(message.find('\n') == std::string::npos, "messages are one line");
  }
  return std::nullopt;
}

inline std::optional<SurfaceFile> readOrRefuse(FunctionRef<SurfaceFile()> read) {
  auto file = answerOrRefusal(kFuzzName, read);
  if (file) expectWhole(*file);
  return file;
}

/// By one reader, whatever the bytes look like.
inline std::optional<SurfaceFile> readBy(formats::Reader reader,
                                         std::span<const std::uint8_t> bytes) {
  const std::string_view view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return readOrRefuse([&] {
    const formats::Content content{kFuzzName, view};
    formats::SoupBuilder builder({}, "patch");
    return reader(content, builder);
  });
}

/// As a caller reads them: compressed or not, of any format.
inline std::optional<SurfaceFile> readAny(std::span<const std::uint8_t> bytes) {
  ReadOptions options;
  options.maxBytes = std::uint64_t{16} << 20U;
  return readOrRefuse([&] { return readSurface(std::as_bytes(bytes), kFuzzName, options); });
}

}  // namespace cutwater::test
