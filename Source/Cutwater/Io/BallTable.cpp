#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/CsvRows.hpp>
#include <Cutwater/Io/Tables.hpp>
#include <Cutwater/Text/Words.hpp>

#include <cmath>

namespace cutwater {

namespace {

bool namesColumns(const detail::CsvRows& rows) {
  using text::equalIgnoringCase;
  return rows.fields() == 4 && equalIgnoringCase(rows.text(0), "x") &&
         equalIgnoringCase(rows.text(1), "y") && equalIgnoringCase(rows.text(2), "z") &&
         (equalIgnoringCase(rows.text(3), "r") || equalIgnoringCase(rows.text(3), "radius"));
}

Ball<double> ballOf(const detail::CsvRows& rows, double scale) {
  rows.requireFields(4);
  const Ball<double> ball{scale * rows.point(0), scale * rows.number(3)};
  if (!(ball.radius > 0)) rows.fail("need a radius above 0, found " + std::string(rows.text(3)));
  if (!isFinite(ball.center) || !std::isfinite(ball.radius)) rows.fail("the scale is too large");
  return ball;
}

}  // namespace

std::vector<Ball<double>> readBalls(const std::filesystem::path& path,
                                    const ReadTableOptions& options) {
  require(options.scale > 0 && std::isfinite(options.scale), "readBalls: need 0 < scale < infinity",
          Named{"scale", options.scale});
  detail::CsvRows rows(path, options.maxBytes);
  std::vector<Ball<double>> balls;
  bool isFirst = true;
  while (rows.next()) {
    if (isFirst && namesColumns(rows)) {
      isFirst = false;
      continue;
    }
    isFirst = false;
    if (balls.size() == kNone - 1) rows.failLimit("more than 2^32 - 2 balls");
    balls.push_back(ballOf(rows, options.scale));
  }
  if (balls.empty()) rows.fail("the file ends without a ball");
  return balls;
}

}  // namespace cutwater
