#include <Cutwater/CutCells/Detail/Curved/KinkSweep.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

constexpr double kBend = 0.98;  // cosine of 11 degrees: an edge, if normals differ by more

}  // namespace

void KinkSweep::run(const SweepAxes& axes, bool isGraph) {
  axes_ = axes;
  isGraph_ = isGraph;
  measure(true);
  if (isGraph) return;
  if (view_.flatAxis() >= 0) {
    std::swap(axes_.line, axes_.row);
    return measure(false);
  }
  for (int turn = 0; turn < 2; ++turn) {
    axes_ = {axes_.row, axes_.slice, axes_.line};
    measure(false);
  }
}

KinkSweep::State KinkSweep::stateOf(const AxisLine& line) {
  --linesLeft_;
  found_.find({&line, 1});
  State state{line.axis, found_.startsInFluid(0), {}};
  for (const double at : found_.of(0)) {
    state.passages.push_back({at, wallNormal(field_, line.at(at), view_.flatAxis())});
  }
  return state;
}

KinkSweep::Change KinkSweep::changeBetween(const States& a, const States& b) const {
  Change change;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].startsInFluid != b[i].startsInFluid || a[i].passages.size() != b[i].passages.size()) {
      return {.isAny = true, .before = &a[i], .after = &b[i]};
    }
    for (std::size_t n = 0; n < a[i].passages.size(); ++n) {
      const auto& before = a[i].passages[n].normal;
      const auto& after = b[i].passages[n].normal;
      if (before == Vec3<double>{} || after == Vec3<double>{}) continue;
      const bool turns = !isGraph_ && nearestAxis(before) != nearestAxis(after);
      if (!turns && dot(before, after) >= kBend) continue;
      change = {.isAny = true, .before = &a[i], .after = &b[i], .passage = n};
    }
  }
  return change;
}

/// Where a change is expected between two places along an axis of the box: where tangents of the
/// wall meet each other or the end of a line, or the axis nearest to its normal changes.
double KinkSweep::predicted(int axis, double from, double to, const Change& change) const {
  const auto& before = *change.before;
  const auto& after = *change.after;
  const int along = before.axis;
  struct Tangent {
    double at = 0;  // at `from`
    double slope = 0;
  };
  const auto tangent = [&](const Passage& p, double place) {
    const double slope = -p.normal[axis] / p.normal[along];
    return Tangent{p.at - slope * (place - from), slope};
  };
  const auto meeting = [&](const Tangent& a, const Tangent& b) {
    return from + (b.at - a.at) / (a.slope - b.slope);
  };
  const auto isBetween = [&](double x) { return x > from && x < to; };
  if (change.passage) {
    const auto& p = before.passages[*change.passage];
    const auto& q = after.passages[*change.passage];
    const double kink = meeting(tangent(p, from), tangent(q, to));
    if (isBetween(kink) && dot(p.normal, q.normal) < kBend) return kink;
    const int first = nearestAxis(p.normal);
    const int second = nearestAxis(q.normal);
    const auto lead = [&](const Vec3<double>& n) {
      return std::abs(n[first]) - std::abs(n[second]);
    };
    const double turn = from + (to - from) * lead(p.normal) / (lead(p.normal) - lead(q.normal));
    if (first != second && isBetween(turn)) return turn;
  } else {
    const bool isBefore = before.passages.size() > after.passages.size();
    const auto& more = isBefore ? before.passages : after.passages;
    std::vector<Tangent> tangents{{box_.lower[along], 0}};
    for (const auto& p : more) tangents.push_back(tangent(p, isBefore ? from : to));
    tangents.push_back({box_.upper[along], 0});
    for (std::size_t n = 0; n + 1 < tangents.size(); ++n) {
      const double end = meeting(tangents[n], tangents[n + 1]);
      if (isBetween(end)) return end;
    }
  }
  return 0.5 * (from + to);
}

void KinkSweep::refine(int axis, const Place& from, const Place& to, const StatesAt& statesAt,
                       std::vector<double>& found) {
  constexpr double kNarrow = 0x1p-44;  // of the box
  constexpr double kResolved = 0x1p-26;
  const auto change = changeBetween(from.states, to.states);
  if (!change.isAny || linesLeft_ <= 0) return;
  const double narrow = kNarrow * (box_.upper[axis] - box_.lower[axis]);
  const double width = to.at - from.at;
  const double guess = predicted(axis, from.at, to.at, change);
  if (width <= kResolved * (box_.upper[axis] - box_.lower[axis])) {
    found.push_back(guess);
    return;
  }
  // Around what is expected: closely first, then in a share of the way.
  constexpr double kShare = 0.02;
  for (const double reach : {narrow, kShare * width}) {
    Place low{std::max(guess - reach, 0.5 * (from.at + guess)), {}};
    Place high{std::min(guess + reach, 0.5 * (guess + to.at)), {}};
    if (!(from.at < low.at && low.at < high.at && high.at < to.at)) continue;
    low.states = statesAt(low.at);
    high.states = statesAt(high.at);
    if (reach > narrow) {
      refine(axis, from, low, statesAt, found);
      refine(axis, low, high, statesAt, found);
      refine(axis, high, to, statesAt, found);
      return;
    }
    const bool isWithin = !changeBetween(from.states, low.states).isAny &&
                          !changeBetween(high.states, to.states).isAny;
    if (!isWithin) continue;
    if (changeBetween(low.states, high.states).isAny) found.push_back(guess);
    return;
  }
  found.push_back(guess);
}

std::vector<double> KinkSweep::breaks(int axis, std::vector<double> known,
                                      const StatesAt& statesAt) {
  // Beside what is known, and in between.
  constexpr std::array kSamples{1e-7, 0.25, 0.5, 0.75, 1 - 1e-7};
  std::vector<double> found;
  std::ranges::sort(known);
  known.push_back(box_.upper[axis]);
  double low = box_.lower[axis];
  for (const double high : known) {
    if (!(high > low)) continue;
    if (linesLeft_ <= 0) {
      found.push_back(high);
      low = high;
      continue;
    }
    const auto placeAt = [&](double share) {
      const double at = low + share * (high - low);
      return Place{at, statesAt(at)};
    };
    auto from = placeAt(kSamples[0]);
    for (std::size_t i = 1; i < kSamples.size(); ++i) {
      auto to = placeAt(kSamples[i]);
      refine(axis, from, to, statesAt, found);
      from = std::move(to);
    }
    found.push_back(high);
    low = high;
  }
  return found;
}

std::vector<double> KinkSweep::breaksOfRow(double slice) {
  std::vector<double> known;
  for (const double end : {box_.lower[axes_.line], box_.upper[axes_.line]}) {
    const auto line = rimAt(box_, axes_, slice, end);
    found_.find({&line, 1});
    const auto ends = found_.of(0);
    known.insert(known.end(), ends.begin(), ends.end());
  }
  const StatesAt statesAt = [&](double row) {
    return States{stateOf(lineAt(box_, axes_, slice, row))};
  };
  return breaks(axes_.row, std::move(known), statesAt);
}

/// What is met at the ends of a row, and by the ends of its lines; a little inside, as sides may
/// lie in a wall.
KinkSweep::States KinkSweep::statesOfRow(double slice) {
  constexpr double kInside = 1e-9;
  States states;
  const auto size = box_.size();
  for (const double share : {kInside, 1 - kInside}) {
    states.push_back(
        stateOf(lineAt(box_, axes_, slice, box_.lower[axes_.row] + share * size[axes_.row])));
  }
  for (const double share : {kInside, 1 - kInside}) {
    states.push_back(
        stateOf(rimAt(box_, axes_, slice, box_.lower[axes_.line] + share * size[axes_.line])));
  }
  return states;
}

void KinkSweep::measure(bool withFluid) {
  sweep_ = to_.sweeps++;
  if (view_.flatAxis() >= 0) return addSlice({box_.lower[axes_.slice], 1, 0}, withFluid);
  const StatesAt statesAt = [&](double slice) { return statesOfRow(slice); };
  forStretches(gauss_, box_.lower[axes_.slice],
               breaks(axes_.slice, view_.crossingsAlong(axes_.slice), statesAt),
               [&](double at, double weight, std::uint32_t stretch) {
                 addSlice({at, weight, stretch}, withFluid);
               });
}

void KinkSweep::addSlice(const SweptSlice& slice, bool withFluid) {
  const auto takesWall = [&](const FluidField*, const Vec3<double>& normal) {
    return isGraph_ || nearestAxis(normal) == axes_.line;
  };
  SweptLines swept{.sweep = sweep_};
  auto ends = breaksOfRow(slice.at);
  swept.addRow(gauss_, box_, axes_, slice, ends);
  for (std::size_t i = 0; i < swept.lines.size(); ++i) {
    found_.find({&swept.lines[i], 1});
    addLinePoints(field_, {found_, 0, {swept.lines[i], swept.weights[i]}},
                  {view_.flatAxis(), withFluid, swept.places[i]}, takesWall, to_);
  }
}

}  // namespace cutwater
