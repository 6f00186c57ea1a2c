// What one gyroid parts space into: its wall, half of the wall, and both channels. See README.md.
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <cstdio>

using namespace cutwater;

int main(int argc, char** argv) {
  // [DOCS
  const TpmsField<double> gyroid(TpmsPattern::gyroid(), 10);
  const Cuboid<double> box({0, 0, 0}, {20, 20, 20});
  std::vector<Solid<double>> row;
  for (const auto part :
       {TpmsPart::Wall, TpmsPart::WallInA, TpmsPart::ChannelA, TpmsPart::ChannelB}) {
    const auto place = 26.0 * double(row.size());
    row.push_back(translated(box & TpmsSolid<double>(gyroid, part, 0.4), {place, 0, 0}));
  }
  // DOCS]
  // A point is in the wall, or in one channel.
  int lost = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3<double> p{0.5 + 19 * (i % 17) / 17.0, 0.5 + 19 * (i % 29) / 29.0,
                         0.5 + 19 * (i % 41) / 41.0};
    int parts = 0;
    for (const std::size_t n : {0U, 2U, 3U}) {
      parts += row[n].signedDistance(p + Vec3<double>{26.0 * double(n), 0, 0}) < 0 ? 1 : 0;
    }
    lost += parts == 1 ? 0 : 1;
  }
  std::printf("of 4000 points %d are in no part, or in two\n", lost);
  if (argc > 1) {
    RenderOptions options;
    options.view = View::fromAngles(-80, 22);
    options.title = "Wall, half of it, channel A and channel B";
    options.width = 2000;
    options.height = 800;
    writePng(argv[1], render(unionOf(row), options));
  }
  return lost == 0 ? 0 : 1;
}
