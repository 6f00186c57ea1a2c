#pragma once

#include <Cutwater/Mesh/MeshSDF.hpp>

#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "Support/DamagedSoups.hpp"
#include "Support/FileRefusal.hpp"

namespace cutwater::test {

/// Bytes of a geometry file that can be changed, as they are in memory that can be viewed.
class EditableBytes {
 public:
  explicit EditableBytes(std::span<const std::byte> bytes, std::size_t room = 0)
      : owner_(alignedCopy(std::vector<std::byte>(bytes.size() + room))), size_(bytes.size()) {
    std::ranges::copy(bytes, data());
  }

  [[nodiscard]] std::byte* data() { return const_cast<std::byte*>(owner_.bytes().data()); }
  [[nodiscard]] std::span<const std::byte> bytes() const { return owner_.bytes().first(size_); }
  std::byte& operator[](std::size_t i) { return data()[i]; }

  template <typename Number>
  [[nodiscard]] Number read(std::size_t at) const {
    Number number;
    std::memcpy(&number, bytes().data() + at, sizeof(number));
    return number;
  }
  template <typename Number>
  void write(std::size_t at, Number number) {
    std::memcpy(data() + at, &number, sizeof(number));
  }

 private:
  Block owner_;
  std::size_t size_;
};

/// What is wrong with the bytes; nothing if they can be viewed.
template <typename T>
std::string refusal(std::span<const std::byte> bytes, const MeshViewOptions& options = {}) {
  return fileRefusal([&] { return MeshSDF<T>::view(bytes, options); });
}

/// Open, of several patches, with faces of four corners: every array has something in it.
inline PolygonSoup openBoxOfPatches() {
  auto soup = onlyFaces(insideOut(tessellation::box({-1, -2, -3}, {1, 2, 3}, 2)),
                        [](std::size_t i) { return i > 1; });
  soup.patchNames = {"hull", "", "deck and mast"};
  for (std::uint32_t i = 0; i < soup.patches.size(); ++i) soup.patches[i] = i % 3;
  return soup;
}

}  // namespace cutwater::test
