#include "Fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cutwater::test::readBy(cutwater::formats::readPly, {data, size});
  return 0;
}
