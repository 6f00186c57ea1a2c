#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeFill.hpp>

#include <array>
#include <atomic>
#include <cstring>

namespace cutwater {

namespace {

/// The bytes of one cell and its values, without padding.
template <std::floating_point T>
class Record {
 public:
  template <typename Value>
  void add(const Value& value) {
    static_assert(std::has_unique_object_representations_v<Value> || std::is_same_v<Value, T> ||
                  std::is_same_v<Value, Vec3<T>>);
    std::memcpy(bytes_.data() + size_, &value, sizeof(value));
    size_ += sizeof(value);
  }
  [[nodiscard]] std::span<const std::byte> bytes() const { return std::span(bytes_).first(size_); }

 private:
  static constexpr std::size_t kMost =
      2 + sizeof(Index3) + sizeof(T) + sizeof(Vec3<T>) + sizeof(std::uint32_t);

  std::array<std::byte, kMost> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace

template <std::floating_point T>
std::uint64_t checksum(const OctreeCells<T>& mesh, const OctreeTargets<T>& values, int threads) {
  constexpr std::size_t kGrain = 4096;
  const auto cells = mesh.cells();
  values.check(cells.size());
  require(threads >= 0, "checksum: need threads >= 0", Named{"threads", threads});
  std::atomic<std::uint64_t> sum{0};
  parallelFor(cells.size(), {.threads = threads, .grain = kGrain},
              [&](std::size_t begin, std::size_t end) {
                std::uint64_t part = 0;
                for (auto n = begin; n < end; ++n) {
                  Record<T> record;
                  record.add(cells[n].level);
                  record.add(cells[n].kind);
                  record.add(cells[n].index);
                  if (!values.distance.empty()) record.add(values.distance[n]);
                  if (!values.normal.empty()) record.add(values.normal[n]);
                  if (!values.patch.empty()) record.add(values.patch[n]);
                  part += xxHash64(record.bytes());
                }
                sum += part;
              });
  return sum;
}

template std::uint64_t checksum(const OctreeCells<float>&, const OctreeTargets<float>&, int);
template std::uint64_t checksum(const OctreeCells<double>&, const OctreeTargets<double>&, int);

}  // namespace cutwater
