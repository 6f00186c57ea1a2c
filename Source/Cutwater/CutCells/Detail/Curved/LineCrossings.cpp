#include <Cutwater/CutCells/Detail/Curved/LineCrossings.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater {

/// Where to look next: the zero of the chord, or the middle if chords have gained too little.
double LineCrossings::Bracket::next() const {
  const auto [low, high] = std::minmax(body, fluid);
  const double middle = low + 0.5 * (high - low);
  if (isAlong) return middle;
  if (steps > 0 && steps % 3 == 0 && high - low > 0.5 * widthBefore) return middle;
  const double chord = body + (fluid - body) * (bodyValue / (bodyValue - fluidValue));
  return chord > low && chord < high ? chord : middle;
}

/// Anderson and Bjoerck 1973: the value at an end that stays twice is scaled down.
void LineCrossings::Bracket::take(double at, double value) {
  constexpr int kMostSteps = 120;
  if (steps % 3 == 0) widthBefore = std::abs(fluid - body);
  ++steps;
  root = at;
  isDone = (value == 0 && !isAlong) || at == body || at == fluid || steps == kMostSteps;
  if (isDone) return;
  const bool isFluid = value > 0;
  const int side = isFluid ? 1 : -1;
  auto& near = isFluid ? fluid : body;
  auto& nearValue = isFluid ? fluidValue : bodyValue;
  auto& farValue = isFluid ? bodyValue : fluidValue;
  if (side == lastSide) {
    const double scale = 1 - value / nearValue;
    farValue *= scale > 0 ? scale : 0.5;
  }
  near = at;
  nearValue = value;
  lastSide = side;
}

void LineCrossings::find(std::span<const AxisLine> lines) {
  if (field_->knowsSurfaces() && !lines.empty()) {
    Box<double> around;
    for (const auto& line : lines) around.extend(Box<double>{line.start, line.endPoint()});
    return find(lines, field_->surfacesNear(around));
  }
  begin();
  evaluateEnds(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    startsInFluid_.push_back(ends_[2 * i] > 0 ? 1 : 0);
    addBrackets(lines[i], ends_[2 * i], ends_[2 * i + 1]);
    first_.push_back(brackets_.size());
  }
  solve();
  for (const auto& bracket : brackets_) positions_.push_back(bracket.root);
}

void LineCrossings::find(std::span<const AxisLine> lines,
                         std::span<const FluidField* const> surfaces) {
  begin();
  findRoots(lines, surfaces);
  evaluateStretches(lines);
  auto root = roots_.begin();
  auto middle = values_.begin();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto first = root;
    while (root != roots_.end() && root->line == i) ++root;
    const auto stretches = root - first + 1;
    addCrossings(lines[i], zeroEnds_[i], {first, root}, {middle, middle + stretches});
    middle += stretches;
    first_.push_back(positions_.size());
  }
}

void LineCrossings::begin() {
  brackets_.clear();
  positions_.clear();
  surfaceOf_.clear();
  startsInFluid_.clear();
  first_.assign(1, 0);
}

void LineCrossings::addBrackets(const AxisLine& line, double from, double to) {
  double at = 0;
  double value = 0;
  if ((from > 0) != (to > 0)) {
    addBracket(line, line.start[line.axis], from, line.end, to);
  } else if (line.mayTurn && !field_->facts().isFlat &&
             (findTurn(line, from, to, at, value) || findHidden(line, from, to, at, value))) {
    addBracket(line, line.start[line.axis], from, at, value);
    addBracket(line, at, value, line.end, to);
  }
}

/// Where lines cross the surfaces, each of which is asked for all lines.
void LineCrossings::findRoots(std::span<const AxisLine> lines,
                              std::span<const FluidField* const> surfaces) {
  roots_.clear();
  zeroEnds_.assign(lines.size(), {});
  starts_.assign(lines.size(), {});
  areSidesTold_ = surfaces.size() <= kMostTold;
  if (!ofSurface_) ofSurface_ = std::make_unique<LineCrossings>(*field_);
  auto& found = *ofSurface_;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const auto* surface = surfaces[s];
    const auto bit = std::uint64_t{1} << s % kMostTold;
    found.field_ = surface;
    found.find(lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double start = found.ends_[2 * i];
      const double end = found.ends_[2 * i + 1];
      if (start == 0) zeroEnds_[i].start = surface;
      if (end == 0) zeroEnds_[i].end = surface;
      if (start > 0) starts_[i].above |= bit;
      if (start == 0 && end == 0) starts_[i].along |= bit;
      for (const double at : found.of(i)) roots_.push_back({i, at, surface, bit});
    }
  }
  std::ranges::stable_sort(roots_, [](const Root& a, const Root& b) {
    return a.line != b.line ? a.line < b.line : a.at < b.at;
  });
  mergeRoots(lines);
}

/// Surfaces that coincide are crossed once.
void LineCrossings::mergeRoots(std::span<const AxisLine> lines) {
  constexpr double kSame = 1e-13;  // of a line
  std::size_t kept = 0;
  for (const auto& root : roots_) {
    if (kept > 0) {
      auto& last = roots_[kept - 1];
      if (last.line == root.line && root.at - last.at <= kSame * lines[root.line].length()) {
        last.crossed ^= root.crossed;
        continue;
      }
    }
    roots_[kept++] = root;
  }
  roots_.resize(kept);
}

std::size_t LineCrossings::alikeOf(const Sides& sides) {
  auto known = alike_.end();
  if (areSidesTold_) known = std::ranges::find(alike_, sides, &Alike::sides);
  if (known == alike_.end()) known = alike_.insert(known, {.sides = sides, .point = {}});
  return static_cast<std::size_t>(known - alike_.begin());
}

/// Finds a value for each stretch between roots.
void LineCrossings::evaluateStretches(std::span<const AxisLine> lines) {
  alike_.clear();
  alikeOf_.clear();
  auto root = roots_.begin();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    double from = lines[i].start[lines[i].axis];
    auto sides = starts_[i];
    const auto add = [&](double to) {
      const auto number = alikeOf(sides);
      alikeOf_.push_back(number);
      auto& alike = alike_[number];
      if (to - from > alike.length || alike.length == 0) {
        alike.length = to - from;
        alike.point = lines[i].at(0.5 * (from + to));
      }
      from = to;
    };
    for (; root != roots_.end() && root->line == i; ++root) {
      add(root->at);
      sides.above ^= root->crossed;
    }
    add(lines[i].end);
  }
  points_.clear();
  for (const auto& alike : alike_) points_.push_back(alike.point);
  ofAlike_.resize(points_.size());
  field_->values(points_, ofAlike_);
  values_.clear();
  for (const auto number : alikeOf_) values_.push_back(ofAlike_[number]);
}

/// Where the side changes between stretches. An end that lies in the wall is in the body.
void LineCrossings::addCrossings(const AxisLine& line, const ZeroEnds& zero,
                                 std::span<const Root> roots, std::span<const double> middles) {
  const auto add = [&](double at, const FluidField* surface) {
    positions_.push_back(at);
    surfaceOf_.push_back(surface);
  };
  const auto isInWall = [&](const FluidField* surface, const Vec3<double>& end) {
    return surface != nullptr && !(field_->value(end) > 0);
  };
  const bool startsInWall = middles.front() > 0 && isInWall(zero.start, line.start);
  startsInFluid_.push_back(middles.front() > 0 && !startsInWall ? 1 : 0);
  if (startsInWall) add(line.start[line.axis], zero.start);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if ((middles[i + 1] > 0) != (middles[i] > 0)) add(roots[i].at, roots[i].surface);
  }
  if (middles.back() > 0 && isInWall(zero.end, line.endPoint())) add(line.end, zero.end);
}

void LineCrossings::evaluateEnds(std::span<const AxisLine> lines) {
  points_.clear();
  for (const auto& line : lines) {
    points_.push_back(line.start);
    points_.push_back(line.endPoint());
  }
  ends_.resize(points_.size());
  field_->values(points_, ends_);
}

void LineCrossings::addBracket(const AxisLine& line, double from, double fromValue, double to,
                               double toValue) {
  constexpr double kBeside = 1e-6;  // of the way to the fluid
  Bracket bracket{
      .line = line, .body = from, .bodyValue = fromValue, .fluid = to, .fluidValue = toValue};
  if (fromValue > 0) {
    std::swap(bracket.body, bracket.fluid);
    std::swap(bracket.bodyValue, bracket.fluidValue);
  }
  bracket.root = bracket.body;
  if (bracket.bodyValue == 0) {
    // In the surface, with fluid or body behind it.
    const double beside = bracket.body + kBeside * (bracket.fluid - bracket.body);
    const double value = field_->value(line.at(beside));
    bracket.isDone = value > 0;
    bracket.isAlong = value == 0;
    if (value <= 0) bracket.body = beside, bracket.bodyValue = value;
  }
  brackets_.push_back(bracket);
  surfaceOf_.push_back(nullptr);
}

/// Looks where the tangents at both ends meet, which is the edge of a wall that has one, and where
/// the derivative is zero if it is linear, in turns. Tangents that meet on the side of the ends end
/// the search.
bool LineCrossings::findTurn(const AxisLine& line, double from, double to, double& at,
                             double& value) const {
  constexpr int kMostSteps = 24;
  constexpr double kNarrow = 1e-7;
  constexpr double kMargin = 1e-3;  // from the ends of what is left
  struct End {
    double at, value, slope;  // on the side of the ends, both are positive
  };
  const double sign = from > 0 ? 1 : -1;
  const auto slopeAt = [&](double x) { return sign * field_->gradient(line.at(x))[line.axis]; };
  const double steepness = field_->steepness({line.start, line.endPoint()});
  End low{line.start[line.axis], std::abs(from), 0};
  End high{line.end, std::abs(to), 0};
  const auto isFree = [&] {
    return steepness > 0 && low.value + high.value > steepness * (high.at - low.at);
  };
  if (isFree()) return false;
  low.slope = slopeAt(low.at);
  high.slope = slopeAt(high.at);
  for (int step = 0; step < kMostSteps; ++step) {
    const double width = high.at - low.at;
    if (!(low.slope < 0 && high.slope > 0) || isFree() || width < kNarrow * line.length()) break;
    const double meeting = (low.value - high.value + high.slope * width) / (high.slope - low.slope);
    if (low.value + low.slope * meeting > 0) break;
    const double flat = width * low.slope / (low.slope - high.slope);
    const double margin = kMargin * width;
    at = low.at + std::clamp(step % 2 == 0 ? meeting : flat, margin, width - margin);
    value = field_->value(line.at(at));
    if ((value > 0) != (from > 0)) return true;
    const End middle{at, std::abs(value), slopeAt(at)};
    (middle.slope < 0 ? low : high) = middle;
  }
  return false;
}

/// Branch and bound for the least value of a function with a Lipschitz constant (Piyavskii 1972):
/// the stretch that may have the lowest one is divided where that would be.
bool LineCrossings::findHidden(const AxisLine& line, double from, double to, double& at,
                               double& value) const {
  constexpr std::size_t kMostValues = 12;
  const double steepness = field_->steepness({line.start, line.endPoint()});
  if (steepness == 0 || (from == 0 && to == 0)) return false;
  struct Stretch {
    double low, lowValue, high, highValue;
  };
  // Half of this is the lowest value that a stretch may have.
  const auto bound = [&](const Stretch& s) {
    return s.lowValue + s.highValue - steepness * (s.high - s.low);
  };
  std::array<Stretch, kMostValues + 1> open{
      {{line.start[line.axis], std::abs(from), line.end, std::abs(to)}}};
  std::size_t count = 1;
  for (std::size_t i = 0; i < kMostValues; ++i) {
    auto& lowest =
        *std::min_element(open.begin(), open.begin() + static_cast<std::ptrdiff_t>(count),
                          [&](const Stretch& a, const Stretch& b) { return bound(a) < bound(b); });
    if (bound(lowest) > 0) return false;
    at = 0.5 * (lowest.low + lowest.high) + 0.5 * (lowest.lowValue - lowest.highValue) / steepness;
    at = std::clamp(at, lowest.low, lowest.high);
    value = field_->value(line.at(at));
    if ((value > 0) != (from > 0)) return true;
    open[count++] = {at, std::abs(value), lowest.high, lowest.highValue};
    lowest.high = at;
    lowest.highValue = std::abs(value);
  }
  return false;
}

void LineCrossings::solve() {
  open_.clear();
  for (std::size_t i = 0; i < brackets_.size(); ++i) {
    if (!brackets_[i].isDone) open_.push_back(i);
  }
  while (!open_.empty()) {
    points_.clear();
    for (const auto i : open_) points_.push_back(brackets_[i].line.at(brackets_[i].next()));
    values_.resize(points_.size());
    field_->values(points_, values_);
    std::size_t kept = 0;
    for (std::size_t n = 0; n < open_.size(); ++n) {
      auto& bracket = brackets_[open_[n]];
      bracket.take(points_[n][bracket.line.axis], values_[n]);
      if (!bracket.isDone) open_[kept++] = open_[n];
    }
    open_.resize(kept);
  }
}

}  // namespace cutwater
