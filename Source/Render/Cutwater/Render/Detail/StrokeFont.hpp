#pragma once

#include <Cutwater/Render/Image.hpp>

#include <string_view>
#include <vector>

namespace cutwater {

/// The point of a text that lies at its position.
enum class TextAnchor : std::uint8_t { Start, Middle, End };

/// The appearance of a line of text; lengths in pixels.
struct TextStyle {
  double capHeight = 10;  ///< height of a capital letter
  double weight = 1.3;    ///< width of the pen
  Rgb color{38, 42, 48};
  TextAnchor anchor = TextAnchor::Start;  ///< the point of the line at the given position
  bool upwards = false;                   ///< reads from bottom to top
};

namespace detail {

/// Whether a byte of UTF-8 belongs to the character of the one before it.
[[nodiscard]] constexpr bool continuesCharacter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

}  // namespace detail

/// Length of the line in pixels.
[[nodiscard]] double textLength(std::string_view text, double capHeight);

/// Draws one line of UTF-8 text with its baseline at (x, y), in the library's own stroke font.
/// It has ASCII and the letters and units of Latin-1; other characters appear as question marks.
void drawText(Image& image, double x, double y, std::string_view text, const TextStyle& style = {});

}  // namespace cutwater
