// Bad files, and odd but good ones, as make_corpus.py writes them: each gets the answer that is
// due, in bounded memory and time, with nothing printed, in the C locale and in one of decimal
// commas.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/PointData.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <charconv>
#include <clocale>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "Support/AllocationCount.hpp"
#include "Support/CpuTime.hpp"

namespace cutwater::test {
namespace {

const std::filesystem::path kCorpus = CUTWATER_CORPUS;
#ifdef CUTWATER_HAS_ZLIB
constexpr bool kReadsGzip = true;
#else
constexpr bool kReadsGzip = false;
#endif
#ifdef CUTWATER_HAS_EXPAT
constexpr bool kReadsXml = true;
#else
constexpr bool kReadsXml = false;
#endif
constexpr std::uint64_t kMostBytes = std::uint64_t{8} << 20U;

/// A line of the table: see make_corpus.py.
struct Answer {
  std::string name;
  std::string reader;
  std::string kind;  ///< "read", or that of the error
  std::string place;
  std::string part;
  std::size_t points = 0;
  std::size_t faces = 0;
  std::size_t patches = 0;
};

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::size_t toCount(const std::string& text) {
  std::size_t count = 0;
  std::from_chars(text.data(), text.data() + text.size(), count);
  return count;
}

std::vector<Answer> answers() {
  std::vector<Answer> result;
  for (const auto& line : split(contentOf(kCorpus / "answers.txt"), '\n')) {
    const auto fields = split(line, '\t');
    EXPECT_EQ(fields.size(), 8U) << line;
    if (fields.size() != 8) break;
    const auto& name = fields[0];
    const bool needsZlib = name.starts_with("gzip-") || name.find("-zlib") != std::string::npos;
    if ((needsZlib && !kReadsGzip) || (name.starts_with("xml-") && !kReadsXml)) continue;
    result.push_back({fields[0], fields[1], fields[2], fields[3], fields[4], toCount(fields[5]),
                      toCount(fields[6]), toCount(fields[7])});
  }
  return result;
}

const char* nameOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::Argument:
      return "Argument";
    case ErrorKind::File:
      return "File";
    case ErrorKind::Topology:
      return "Topology";
    case ErrorKind::Limit:
      break;
  }
  return "Limit";
}

/// From the bytes to a value: what a soup is refused for is said, too.
void ask(const PolygonSoup& soup) {
  try {
    const MeshSDF<double> mesh(soup, {.probes = 16});
    EXPECT_FALSE(std::isnan(mesh.signedDistance({0.1, 0.2, 0.3})));
  } catch (const Error& error) {
    EXPECT_TRUE(error.kind() == ErrorKind::Topology || error.kind() == ErrorKind::Argument);
  }
}

std::uint64_t expectSoup(const Answer& answer, std::span<const std::byte> bytes) {
  const auto file = readSurface(bytes, answer.name, {.maxBytes = kMostBytes});
  EXPECT_NO_THROW(file.soup.validate());
  EXPECT_EQ(file.soup.points.size(), answer.points);
  EXPECT_EQ(file.soup.polygonCount(), answer.faces);
  EXPECT_EQ(file.soup.patchNames.size(), answer.patches);
  return file.report.bytes;
}

template <typename T>
void expectMesh(const Answer& answer, const Block& bytes) {
  const auto mesh = MeshSDF<T>::view(bytes, {.threads = 1});
  EXPECT_EQ(mesh.triangleCount(), answer.faces);
  EXPECT_FALSE(std::isnan(mesh.signedDistance({T(0.1), T(0.2), T(0.3)})));
}

std::uint64_t expectPoints(const Answer& answer, std::span<const std::byte> bytes) {
  const auto data = readPointData(bytes, answer.name, {.maxBytes = kMostBytes});
  EXPECT_EQ(data.points.size(), answer.points);
  EXPECT_EQ(data.cells.count(), answer.faces);
  EXPECT_EQ(data.pointArrays.size() + data.cellArrays.size() + data.fieldArrays.size(),
            answer.patches);
  return bytes.size();
}

/// Reads as the table tells; the number of bytes after decompression.
std::uint64_t readAs(const Answer& answer, std::span<const std::byte> bytes) {
  if (answer.reader == "surface") return expectSoup(answer, bytes);
  if (answer.reader == "points") return expectPoints(answer, bytes);
  const auto block = alignedCopy(bytes);
  if (answer.reader == "geometry-float") {
    expectMesh<float>(answer, block);
  } else {
    expectMesh<double>(answer, block);
  }
  return bytes.size();
}

void expectError(const Answer& answer, const Error& error) {
  const std::string message = error.what();
  EXPECT_EQ(nameOf(error.kind()), answer.kind) << message;
  EXPECT_NE(message.find(answer.part), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  if (answer.reader != "surface" && answer.reader != "points") return;
  const std::string begin = answer.name + ": " + (answer.place.empty() ? "" : answer.place + ": ");
  EXPECT_TRUE(message.starts_with(begin)) << message << "\n  expected " << begin;
}

/// Nothing, if it is read; without a word printed. (What a sanitizer has to say is not shown then
/// either: ASAN_OPTIONS=log_path=... keeps it.)
std::optional<Error> errorOf(const Answer& answer, std::span<const std::byte> bytes) {
  std::optional<Error> found;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  constexpr std::size_t kConstant = 400'000;  // messages, tables and first chunks
  const AllocationCount count;
  std::uint64_t size = 0;
  try {
    size = readAs(answer, bytes);
  } catch (const Error& error) {
    found = error;
    size = error.kind() == ErrorKind::Limit ? kMostBytes : bytes.size();
  }
  const std::size_t peak = count.peakBytes();
  const std::string complained = testing::internal::GetCapturedStderr();
  const std::string printed = testing::internal::GetCapturedStdout();
  EXPECT_EQ(complained, "");
  EXPECT_EQ(printed, "");
  EXPECT_LE(peak, 16 * size + kConstant);
  return found;
}

void expectAnswer(const Answer& answer) {
  SCOPED_TRACE(answer.name);
  const std::string content = contentOf(kCorpus / "files" / answer.name);
  // Of exactly the right size: AddressSanitizer sees a read beyond its end.
  const auto view = std::as_bytes(std::span(content));
  const std::vector<std::byte> bytes(view.begin(), view.end());
  if (const auto error = errorOf(answer, bytes)) {
    expectError(answer, *error);
  } else {
    EXPECT_EQ(answer.kind, "read");
  }
}

void expectAnswers() {
  const auto all = answers();
  EXPECT_GE(all.size(), 250U);
  const double seconds = cpuSeconds([&] {
    for (const auto& answer : all) expectAnswer(answer);
  });
  EXPECT_LT(seconds, 60) << "a second on an ordinary machine, for all of them";
}

TEST(CorpusTest, EveryFileGetsItsAnswer) {
  expectAnswers();
}

TEST(CorpusTest, GoodFilesComeAllTheWayToAnAnswer) {
  std::size_t read = 0;
  for (const auto& answer : answers()) {
    if (answer.kind != "read" || answer.reader != "surface") continue;
    SCOPED_TRACE(answer.name);
    ask(readSurface(kCorpus / "files" / answer.name, {.maxBytes = kMostBytes}).soup);
    ++read;
  }
  EXPECT_GE(read, 100U);
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// By the locale that make_corpus.py made.
TEST(CorpusTest, LocalesWithDecimalCommasHaveNoEffect) {
  const auto locales = kCorpus / "locale";
  if (!std::filesystem::exists(locales / "comma")) GTEST_SKIP() << "there was no localedef";
  ASSERT_EQ(setenv("LOCPATH", locales.c_str(), 1), 0);
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  ASSERT_NE(std::setlocale(LC_NUMERIC, "comma"), nullptr);
  ASSERT_EQ(std::string(std::localeconv()->decimal_point), ",");
  expectAnswers();
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace cutwater::test
