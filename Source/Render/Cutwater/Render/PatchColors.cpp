#include <Cutwater/Render/Detail/Oklch.hpp>
#include <Cutwater/Render/PatchColors.hpp>

#include <array>
#include <charconv>
#include <utility>

namespace cutwater {

namespace {

using detail::Lch;

/// Hues in an order that keeps neighbours distinct. Lightness varies with hue as in pigments, so
/// that the colours remain distinct for people who see fewer hues.
constexpr std::array<Lch, 12> kPatches{{{0.64, 0.100, 250},
                                        {0.74, 0.125, 65},
                                        {0.68, 0.105, 150},
                                        {0.60, 0.140, 25},
                                        {0.60, 0.110, 300},
                                        {0.82, 0.110, 95},
                                        {0.70, 0.085, 200},
                                        {0.70, 0.105, 355},
                                        {0.55, 0.060, 55},
                                        {0.76, 0.120, 125},
                                        {0.52, 0.090, 270},
                                        {0.66, 0.010, 250}}};

constexpr std::array<std::pair<std::string_view, Lch>, 9> kNames{{{"steel", {0.70, 0.055, 245}},
                                                                  {"white", {0.95, 0.004, 90}},
                                                                  {"grey", {0.72, 0.005, 250}},
                                                                  {"graphite", {0.45, 0.012, 260}},
                                                                  {"sand", {0.84, 0.055, 85}},
                                                                  {"copper", {0.66, 0.105, 50}},
                                                                  {"red", {0.60, 0.160, 27}},
                                                                  {"green", {0.66, 0.110, 150}},
                                                                  {"blue", {0.60, 0.120, 255}}}};

}  // namespace

Rgb patchColor(std::size_t patch) {
  auto color = kPatches[patch % kPatches.size()];
  constexpr std::array kLighter{0.0, 0.11, -0.13};
  color.lightness += kLighter[patch / kPatches.size() % kLighter.size()];
  return detail::toRgb(color);
}

std::optional<Rgb> colorNamed(std::string_view name) {
  for (const auto& [known, color] : kNames) {
    if (name == known) return detail::toRgb(color);
  }
  if (name.size() != 7 || name[0] != '#') return {};
  unsigned code = 0;
  const auto* const end = name.data() + name.size();
  const auto result = std::from_chars(name.data() + 1, end, code, 16);
  if (result.ec != std::errc() || result.ptr != end) return {};
  const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>(code >> shift & 255U); };
  return Rgb{byte(16), byte(8), byte(0)};
}

}  // namespace cutwater
