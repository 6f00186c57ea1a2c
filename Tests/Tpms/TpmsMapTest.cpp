#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Tpms/TpmsMap.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

TEST(TpmsMapTest, RefusesWhatIsNoMap) {
  EXPECT_THROW(TpmsMap<double>(0.0), Error);
  EXPECT_THROW((TpmsMap<double>(Vec3<double>{1, -1, 1})), Error);
  EXPECT_THROW(static_cast<void>(TpmsMap<double>::cylindrical({1, 0, 1})), Error);
  EXPECT_THROW(static_cast<void>(TpmsMap<double>::cylindrical({0, 4, 1})), Error);
  EXPECT_THROW(static_cast<void>(TpmsMap<double>::cylindrical({1, 4, std::nan("")})), Error);
  EXPECT_THROW(static_cast<void>(TpmsMap<double>::cylindrical({1, 4, 1, Box<double>::kInf})),
               Error);
  const TpmsMap<double> map(1.0);
  EXPECT_THROW(static_cast<void>(map.deformed({.amplitude = -1, .spacing = {1, 1, 1}})), Error);
  EXPECT_THROW(static_cast<void>(map.deformed({.amplitude = 1, .spacing = {1, 0, 1}})), Error);
  const auto once = map.deformed({.amplitude = 0.1, .spacing = {1, 1, 1}});
  EXPECT_THROW(static_cast<void>(once.deformed({.amplitude = 0.1, .spacing = {1, 1, 1}})), Error);
}

}  // namespace
}  // namespace cutwater::test
