#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/Detail/GeometryCheck.hpp>
#include <Cutwater/Mesh/Detail/GeometryHeader.hpp>

#include <algorithm>
#include <bit>
#include <cstring>

namespace cutwater::detail {

namespace {

constexpr std::size_t kAlignment = BlockWriter::kAlignment;
using Head = GeometryHead;
constexpr std::uint32_t kOtherByteOrder = 0x04030201;

/// Writes every number as a word of eight bytes.
class WordWriter {
 public:
  template <typename Number>
  void operator()(const Number& number) {
    if constexpr (std::is_floating_point_v<Number>) {
      words_.push_back(std::bit_cast<std::uint64_t>(double{number}));
    } else {
      words_.push_back(static_cast<std::uint64_t>(number));
    }
  }

  [[nodiscard]] const std::vector<std::uint64_t>& words() const { return words_; }

 private:
  std::vector<std::uint64_t> words_;
};

/// Reads as many numbers as a WordWriter has written.
class WordReader {
 public:
  explicit WordReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <typename Number>
  void operator()(Number& number) {
    std::uint64_t word = 0;
    std::memcpy(&word, rest_.data(), sizeof(word));
    rest_ = rest_.subspan(sizeof(word));
    if constexpr (std::is_floating_point_v<Number>) {
      number = static_cast<Number>(std::bit_cast<double>(word));
    } else {
      number = static_cast<Number>(word);
      requireIntact(static_cast<std::uint64_t>(number) == word, "a number is out of its range");
    }
  }

 private:
  std::span<const std::byte> rest_;
};

template <typename Words, typename T>
void visitVector(Words& words, Vec3<T>& v) {
  words(v.x);
  words(v.y);
  words(v.z);
}

template <typename Words>
void visitFrame(Words& words, BvhFrame& frame, int& depth) {
  visitVector(words, frame.center);
  words(frame.scale);
  words(depth);
}

template <typename Words>
void visitSigns(Words& words, SignReport& signs) {
  words(signs.scheme);
  for (auto* count :
       {&signs.unbalancedEdges, &signs.shells, &signs.turnedFaces, &signs.turnedShells,
        &signs.unorientable, &signs.probes, &signs.unsound, &signs.ambiguous}) {
    words(*count);
  }
  bool wereCounted = signs.selfIntersections.has_value();
  std::size_t selfIntersections = signs.selfIntersections.value_or(0);
  words(wereCounted);
  words(selfIntersections);
  signs.selfIntersections.reset();
  if (wereCounted) signs.selfIntersections = selfIntersections;
  words(signs.touchingEdges);
  words(signs.isProven);
}

template <typename Words, typename T>
void visitPlacement(Words& words, RigidTransform<T>& placement) {
  std::array axes{placement.axis(0), placement.axis(1), placement.axis(2)};
  Vec3<T> offset = placement.offset();
  for (auto& axis : axes) visitVector(words, axis);
  visitVector(words, offset);
  placement = RigidTransform<T>(axes, offset);
}

/// Visits everything in the header after its first bytes, in one order for writing and reading.
template <typename Words, typename T>
void visitRecord(Words& words, MeshRecord<T>& record) {
  auto& layout = record.layout;
  visitArrays(layout, [&](auto type, Section& section) {
    using Record = typename decltype(type)::type;
    std::uint64_t elementBytes = sizeof(Record);
    words(section.offset);
    words(section.count);
    words(elementBytes);
    requireIntact(elementBytes == sizeof(Record), "an array's elements are of another size");
  });
  words(layout.surface.scale);
  words(layout.surface.size);
  visitVector(words, layout.surface.box.lower);
  visitVector(words, layout.surface.box.upper);
  visitFrame(words, layout.frame, layout.depth);
  visitFrame(words, layout.winding.frame, layout.winding.depth);
  words(layout.reach);
  words(record.options.signs);
  words(record.options.requireWatertight);
  words(record.options.findSelfIntersections);
  words(record.options.probes);
  visitSigns(words, record.signs);
  visitPlacement(words, record.placement);
  words(record.patches);
}

template <std::floating_point T>
std::vector<std::uint64_t> wordsOf(MeshRecord<T> record) {
  WordWriter writer;
  visitRecord(writer, record);
  return writer.words();
}

constexpr std::size_t roundedUp(std::size_t bytes) {
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

/// Includes room for the checksum at the end.
constexpr std::size_t headerBytesFor(std::size_t words) {
  return roundedUp(sizeof(Head) + (words + 1) * sizeof(std::uint64_t));
}

[[noreturn]] void fail(const std::string& what) {
  throw Error(ErrorKind::File, what);
}

/// Checks the first bytes, and the checksum of the whole header.
template <std::floating_point T>
Head checkedHead(std::span<const std::byte> bytes) {
  if (bytes.empty()) fail("there is nothing in it");
  if (!isGeometry(bytes)) fail("this is no geometry file");
  requireIntact(bytes.size() >= sizeof(Head), "it ends within its header");
  const Head head = geometryHead(bytes);
  if (head.byteOrder == kOtherByteOrder) {
    fail("the geometry file was written on a machine with another byte order");
  }
  if (head.version != kGeometryFileVersion) {
    fail("the geometry file has version " + std::to_string(head.version) +
         ", this library reads version " + std::to_string(kGeometryFileVersion) +
         ": prepare it anew");
  }
  if (head.bytesPerNumber != sizeof(T) && (head.bytesPerNumber == 4 || head.bytesPerNumber == 8)) {
    fail(sizeof(T) == 4 ? "the geometry file is of double precision, not single"
                        : "the geometry file is of single precision, not double");
  }
  const auto headerBytes = headerBytesFor(wordsOf(MeshRecord<T>()).size());
  requireIntact(bytes.size() >= headerBytes, "it ends within its header");
  constexpr std::size_t kWord = sizeof(std::uint64_t);
  std::uint64_t expected = 0;
  std::memcpy(&expected, bytes.data() + headerBytes - kWord, kWord);
  requireIntact(expected == xxHash64(bytes.first(headerBytes - kWord)),
                "the checksum of its header is another");
  requireIntact(head.byteOrder == Head::kByteOrder && head.bytesPerNumber == sizeof(T) &&
                    head.headerBytes == headerBytes,
                "its header is none");
  requireIntact(bytes.size() >= head.fileBytes, "it is shorter than its header tells");
  requireIntact(bytes.size() <= head.fileBytes, "it is longer than its header tells");
  return head;
}

/// Checks that arrays follow each other as a BlockWriter places them, up to the end of the block.
/// No sum can overflow, as an array too long for the rest of the block is found first.
template <std::floating_point T>
void checkSections(MeshLayout<T>& layout, std::uint64_t blockBytes) {
  std::uint64_t at = 0;
  visitArrays(layout, [&](auto type, const Section& section) {
    using Record = typename decltype(type)::type;
    requireIntact(section.offset == at && section.count <= (blockBytes - at) / sizeof(Record),
                  "an array does not lie where it should");
    at = std::min<std::uint64_t>(roundedUp(at + section.count * sizeof(Record)), blockBytes);
  });
  requireIntact(at == blockBytes && at % kAlignment == 0, "its arrays do not fill it");
}

template <std::floating_point T>
MeshRecord<T> recordOf(std::span<const std::byte> bytes, const Head& head) {
  MeshRecord<T> record;
  record.source = head.source;
  WordReader words(bytes.subspan(sizeof(Head)));
  try {
    visitRecord(words, record);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::Argument) throw;
    failDamaged("its placement is no rigid motion");
  }
  using enum SignScheme;
  const auto isScheme = [](SignScheme scheme) {
    return scheme == Automatic || scheme == NearestFeature || scheme == WindingNumber;
  };
  requireIntact(isScheme(record.options.signs) && isScheme(record.signs.scheme) &&
                    record.signs.scheme != Automatic,
                "a sign scheme is none");
  return record;
}

}  // namespace

bool isGeometry(std::span<const std::byte> bytes) {
  const GeometryHead own;
  const auto magic = std::as_bytes(std::span(own.magic));
  const auto present = std::min(bytes.size(), magic.size());
  return present > 0 && std::ranges::equal(bytes.first(present), magic.first(present));
}

GeometryHead geometryHead(std::span<const std::byte> bytes) {
  GeometryHead head;
  std::memcpy(&head, bytes.data(), std::min(bytes.size(), sizeof(head)));
  return head;
}

template <std::floating_point T>
std::vector<std::byte> geometryHeader(const MeshRecord<T>& record,
                                      std::span<const std::byte> block) {
  const auto words = wordsOf(record);
  std::vector<std::byte> header(headerBytesFor(words.size()));
  Head head;
  head.bytesPerNumber = sizeof(T);
  head.headerBytes = header.size();
  head.fileBytes = header.size() + block.size();
  head.source = record.source;
  head.blockChecksum = checksum(block);
  std::memcpy(header.data(), &head, sizeof(head));
  const auto bytes = std::as_bytes(std::span(words));
  std::ranges::copy(bytes, header.begin() + sizeof(head));
  const auto covered = std::span(header).first(header.size() - sizeof(std::uint64_t));
  const std::uint64_t own = xxHash64(covered);
  std::memcpy(header.data() + covered.size(), &own, sizeof(own));
  return header;
}

template <std::floating_point T>
Geometry<T> readGeometry(const Block& bytes, const MeshViewOptions& options) {
  const Head head = checkedHead<T>(bytes.bytes());
  Geometry<T> result{recordOf<T>(bytes.bytes(), head), bytes.from(head.headerBytes)};
  auto& layout = result.record.layout;
  checkSections(layout, result.block.bytes().size());
  checkLayout(layout);
  if (!options.verifyPayload) return result;
  requireIntact(checksum(result.block.bytes(), options.threads) == head.blockChecksum,
                "the checksum of its arrays is another");
  checkArrays(layout, result.block, result.record.patches, options.threads);
  return result;
}

template std::vector<std::byte> geometryHeader(const MeshRecord<float>&,
                                               std::span<const std::byte>);
template std::vector<std::byte> geometryHeader(const MeshRecord<double>&,
                                               std::span<const std::byte>);
template Geometry<float> readGeometry(const Block&, const MeshViewOptions&);
template Geometry<double> readGeometry(const Block&, const MeshViewOptions&);

}  // namespace cutwater::detail
