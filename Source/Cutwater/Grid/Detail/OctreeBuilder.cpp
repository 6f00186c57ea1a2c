#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/OctreeBuilder.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

template <std::floating_point T>
void requireLevel(const OctreeDomain<T>& domain, int deepest) {
  require(deepest <= domain.deepest(), "Octree: need fewer levels for so many roots",
          Named{"level", deepest}, Named{"finest possible", domain.deepest()});
}

void requireCells(double cells, int level, std::size_t most) {
  if (cells <= static_cast<double>(most)) return;
  throw Error(ErrorKind::Limit, "Octree: down to level " + std::to_string(level) + " there are " +
                                    toText(static_cast<long long>(cells)) + " cells, at most " +
                                    toText(static_cast<long long>(most)) +
                                    " are allowed: use fewer levels");
}

template <std::floating_point T>
OctreeCodes rootCodes(const OctreeDomain<T>& domain) {
  const auto& n = domain.roots();
  OctreeCodes codes;
  for (std::int32_t k = 0; k < n.k; ++k) {
    for (std::int32_t j = 0; j < n.j; ++j) {
      for (std::int32_t i = 0; i < n.i; ++i) codes.push_back(mortonCode({i, j, k}));
    }
  }
  std::ranges::sort(codes);
  return codes;
}

template <std::floating_point T>
std::vector<OctreeCell> OctreeBuilder<T>::run(int deepest) {
  deepest_ = deepest;
  divide();
  balanceOctree(domain_, options_.balance, divided_);
  requireFew(0, deepest_);
  std::vector<Leaf> leaves;
  Cells cells = std::move(found_.front());
  for (int level = 0;; ++level) {
    collect(leaves, level, cells);
    if (level == deepest_) break;
    cells = cellsOf(level + 1);
  }
  std::vector<OctreeCell> result(leaves.size());
  std::ranges::transform(leaves, result.begin(), &Leaf::cell);
  return result;
}

template <std::floating_point T>
void OctreeBuilder<T>::divide() {
  found_.push_back({rootCodes(domain_), {}});
  found_.back().tags.resize(found_.back().codes.size());
  std::vector<BoxHint> hints;  // of the parents
  for (int level = 0;; ++level) {
    auto& [codes, tags] = found_.back();
    hints = tagCells(level, found_.back(), hints, progressOf(level));
    if (level == deepest_) break;
    requireFew(static_cast<std::size_t>(std::ranges::count(tags, true, &CellTag::isRefined)),
               level + 1);
    Cells next;
    auto& divided = divided_.emplace_back();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < codes.size(); ++i) {
      if (!tags[i].isRefined) continue;
      divided.push_back(codes[i]);
      hints[kept++] = hints[i];
      for (MortonCode child = 0; child < 8; ++child) next.codes.push_back(8 * codes[i] + child);
    }
    hints.resize(kept);
    next.tags.resize(next.codes.size());
    found_.push_back(std::move(next));
  }
  if (options_.progress)
    options_.progress(1.0);  // also where no cell of the last levels is divided
}

template <std::floating_point T>
void OctreeBuilder<T>::requireFew(std::size_t more, int level) const {
  auto divided = static_cast<double>(more);
  for (const auto& codes : divided_) divided += static_cast<double>(codes.size());
  const auto& n = domain_.roots();
  requireCells(1.0 * n.i * n.j * n.k + 7 * divided, level, options_.maxCells);
}

template <std::floating_point T>
Progress OctreeBuilder<T>::progressOf(int level) const {
  if (!options_.progress) return {};
  // Each level has several times as many cells as the one before: progress assumes twice as many.
  const double width = std::ldexp(1.0, std::max(level, 1) - 1 - deepest_);
  const double first = level == 0 ? 0 : width;
  return [=, this](double fraction) { options_.progress(first + fraction * width); };
}

template <std::floating_point T>
std::vector<BoxHint> OctreeBuilder<T>::tagCells(int level, Cells& cells,
                                                std::span<const BoxHint> parents,
                                                const Progress& progress) const {
  // Cells of the finest level have no children that need hints.
  std::vector<BoxHint> hints(level < deepest_ ? cells.codes.size() : 0);
  const auto before = [&](std::size_t first, std::span<BoxHint> some) {
    for (std::size_t i = 0; i < some.size(); ++i) {
      some[i] = parents.empty() ? BoxHint{} : parents[(first + i) / 8];
    }
  };
  const auto after = [&](std::size_t first, std::span<const BoxHint> some) {
    if (!hints.empty()) std::ranges::copy(some, std::span(hints).subspan(first).begin());
  };
  tagger_.tag({.level = level,
               .grid = domain_.level(level),
               .codes = cells.codes,
               .hintsBefore = before,
               .hintsAfter = after},
              cells.tags, {.threads = options_.threads, .progress = progress});
  return hints;
}

template <std::floating_point T>
auto OctreeBuilder<T>::cellsOf(int level) const -> Cells {
  const auto& known = found_[static_cast<std::size_t>(level)];
  Cells cells;
  Cells more;  // cells that the rules did not ask for
  std::vector<std::size_t> places;
  std::size_t next = 0;  // position in those known
  for (const auto parent : divided_[static_cast<std::size_t>(level) - 1]) {
    const bool isKnown = next < known.codes.size() && known.codes[next] == 8 * parent;
    for (MortonCode child = 0; child < 8; ++child) {
      if (!isKnown) {
        places.push_back(cells.codes.size());
        more.codes.push_back(8 * parent + child);
      }
      cells.codes.push_back(8 * parent + child);
      cells.tags.push_back(isKnown ? known.tags[next++] : CellTag{});
    }
  }
  more.tags.resize(more.codes.size());
  static_cast<void>(tagCells(level, more, {}, {}));
  for (std::size_t i = 0; i < places.size(); ++i) cells.tags[places[i]] = more.tags[i];
  return cells;
}

template <std::floating_point T>
void OctreeBuilder<T>::collect(std::vector<Leaf>& leaves, int level, const Cells& cells) const {
  static const OctreeCodes kNoCodes;
  const auto& divided = level < deepest_ ? divided_[static_cast<std::size_t>(level)] : kNoCodes;
  const auto before = static_cast<std::ptrdiff_t>(leaves.size());
  auto next = divided.begin();
  for (std::size_t i = 0; i < cells.codes.size(); ++i) {
    const auto code = cells.codes[i];
    if (next != divided.end() && *next == code) {
      ++next;
      continue;
    }
    leaves.push_back({code << 3 * (deepest_ - level),
                      {indexOf(code), static_cast<std::uint8_t>(level), cells.tags[i].kind}});
  }
  std::ranges::inplace_merge(leaves, leaves.begin() + before, {}, &Leaf::place);
}

template void requireLevel(const OctreeDomain<float>&, int);
template void requireLevel(const OctreeDomain<double>&, int);
template OctreeCodes rootCodes(const OctreeDomain<float>&);
template OctreeCodes rootCodes(const OctreeDomain<double>&);
template class OctreeBuilder<float>;
template class OctreeBuilder<double>;

}  // namespace cutwater::detail
