#include "Fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cutwater;
  const std::span bytes(data, size);
  test::readBy(formats::readAsciiStl, bytes);
  if (size >= formats::kBinaryStlHeader) test::readBy(formats::readBinaryStl, bytes);
  return 0;
}
