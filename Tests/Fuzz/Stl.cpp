#include "Fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace formats = cutwater::formats;
  const std::span bytes(data, size);
  cutwater::test::readBy(formats::readAsciiStl, bytes);
  if (size >= formats::kBinaryStlHeader) cutwater::test::readBy(formats::readBinaryStl, bytes);
  return 0;
}
