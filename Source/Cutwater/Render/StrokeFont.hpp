#pragma once

#include <Cutwater/Render/Image.hpp>

#include <string_view>
#include <vector>

namespace cutwater {

/// Which point of a text its position is.
enum class TextAnchor : std::uint8_t { Start, Middle, End };

/// How a line of text looks; lengths in pixels.
struct TextStyle {
  double capHeight = 10;  ///< height of a capital letter
  double weight = 1.3;    ///< width of the pen
  Rgb color{38, 42, 48};
  TextAnchor anchor = TextAnchor::Start;  ///< what of the line stands at the given position
  bool upwards = false;                   ///< reads from bottom to top
};

/// Length of the line in pixels.
[[nodiscard]] double textLength(std::string_view text, double capHeight);

/// Writes one line of UTF-8 text with its baseline at (x, y), in the library's own font of pen
/// strokes. Characters beyond ASCII show as a question mark.
void drawText(Image& image, double x, double y, std::string_view text, const TextStyle& style = {});

}  // namespace cutwater
