#include <Cutwater/Render/Detail/StrokeFont.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace cutwater {

namespace {

// The font: pen strokes for the characters ' ' to '~'. A stroke is a character for its kind
// followed by points, each with two digits (0-9, A-Z) for x and y. The baseline is y = 4;
// lower-case letters reach up to y = C, capitals to y = G, descenders down to y = 0.
//   '-' straight lines from point to point
//   '~' a smooth curve from the first point to the last: a quadratic B-spline
//   'o' the same, closed
constexpr std::array<std::string_view, 95> kGlyphs{
    "",                                   // space
    "-0G08 -0404",                        // !
    "-0G0D -3G3D",                        // "
    "-142G -646G -0787 -0D8D",            // #
    "~8E8G0G0A8A840406 -424I",            // $
    "-048G o0C3C3G0G o54848858",          // %
    "~841D1G6G6C0904448A",                // &
    "-0G0D",                              // '
    "~3I0D0733",                          // (
    "~0I3D3703",                          // )
    "-3G3A -0E6C -0C6E",                  // *
    "-0969 -363C",                        // +
    "-1401",                              // ,
    "-0949",                              // -
    "-14241525",                          // . (large enough for small text)
    "-026H",                              // /
    "o04747G0G",                          // 0
    "-1D4G44",                            // 1
    "~0D0G7G7B04 -0474",                  // 2
    "~0E0G7G7A3A ~3A7A740406",            // 3
    "-545G0777",                          // 4
    "-7G1G0A ~0A7D740406",                // 5
    "o04747B0B ~6G1F08",                  // 6
    "-0G7G24",                            // 7
    "o1A6A6G1G o04747A0A",                // 8
    "o0G7G7909 ~14657C",                  // 9
    "-0505 -0B0B",                        // :
    "-1401 -1B1B",                        // ;
    "-6D0965",                            // <
    "-0767 -0B6B",                        // =
    "-0D6905",                            // >
    "~0E0G6G6B3B38 -3434",                // ?
    "~8404040G8GAGA87877 o37777D3D",      // @
    "-044G84 -1777",                      // A
    "-040G ~0G4G7G7A3A0A ~0A4A8A844404",  // B
    "~8D8G0G048487",                      // C
    "-040G ~0G4G8G844404",                // D
    "-7G0G0474 -0A6A",                    // E
    "-7G0G04 -0A6A",                      // F
    "~8D8G0G04848A -8A5A",                // G
    "-040G -848G -0A8A",                  // H
    "-040G",                              // I
    "~6G68640407",                        // J
    "-040G -7G09 -3C84",                  // K
    "-0G0474",                            // L
    "-040G58AGA4",                        // M
    "-040G848G",                          // N
    "o04848G0G",                          // O
    "-040G ~0G4G8G894909",                // P
    "o04848G0G -5893",                    // Q
    "-040G ~0G4G8G894909 -4984",          // R
    "~8E8G0G0A8A840406",                  // S
    "-0G8G -444G",                        // T
    "~0G090484898G",                      // U
    "-0G448G",                            // V
    "-0G346G94CG",                        // W
    "-048G -0G84",                        // X
    "-0G4A8G -4A44",                      // Y
    "-0G8G0484",                          // Z
    "-3I0I0232",                          // [
    "-0H62",                              // backslash
    "-0I3I3202",                          // ]
    "-0C3G6C",                            // ^
    "-0373",                              // _
    "-0G2D",                              // `
    "o04646C0C -6C64",                    // a
    "o04646C0C -040G",                    // b
    "~6A6C0C046466",                      // c
    "o04646C0C -646G",                    // d
    "-0868 ~686C0C045465",                // e
    "~5G2G2D24 -0C4C",                    // f
    "o04646C0C ~6C64600002",              // g
    "-040G ~080C6C6864",                  // h
    "-040C -0F0G",                        // i
    "~2C232000 -2F2G",                    // j
    "-040G -6C07 -2964",                  // k
    "-040G",                              // l
    "-040C ~080C5C5854 ~585CACA8A4",      // m
    "-040C ~080C6C6864",                  // n
    "o04646C0C",                          // o
    "o04646C0C -000C",                    // p
    "o04646C0C -606C",                    // q
    "-040C ~080C3C4C",                    // r
    "~5A5C0C0858540406",                  // s
    "~2F272454 -0C5C",                    // t
    "~0C08046468 -6C64",                  // u
    "-0C346C",                            // v
    "-0C245B84AC",                        // w
    "-046C -0C64",                        // x
    "-0C34 -6C10",                        // y
    "-0C6C0464",                          // z
    "~4I2I2A0A ~0A2A2242",                // {
    "-0I01",                              // |
    "~0I2I2A4A ~4A2A2202",                // }
    "~082D456A",                          // ~
};

// Latin-1 from U+00C0 on: a letter and the mark on it, or a second letter; or two spaces.
constexpr std::string_view kLetters =
    "A`A'A^A~A\"A*AEC,E`E'E^E\"I`I'I^I\"  N~O`O'O^O~O\"    U`U'U^U\"Y'    "
    "a`a'a^a~a\"a*aec,e`e'e^e\"i`i'i^i\"  n~o`o'o^o~o\"    u`u'u^u\"y'  y\"";
// As they stand on small letters.
constexpr std::array<std::pair<char, std::string_view>, 7> kMarks{{{'`', "-0G3E"},
                                                                   {'\'', "-0E3G"},
                                                                   {'^', "-0E2G4E"},
                                                                   {'~', "~0E1G4E5G"},
                                                                   {'"', "-0F0F -3F3F"},
                                                                   {'*', "o0E0H3H3E"},
                                                                   {',', "~243311"}}};
// Others of Latin-1, which are not letters with marks.
constexpr std::array<std::pair<int, std::string_view>, 16> kOthers{
    {{0xA0, ""},                               // space
     {0xB0, "o0C0G4G4C"},                      // degrees
     {0xB1, "-0A6A -3D37 -0464"},              // plus or minus
     {0xB2, "~0F0H4H4E0A -0A4A"},              // square
     {0xB3, "~0G0H4H4E1E ~1E5E4A0A0B"},        // cube
     {0xB5, "~0C08046468 -6C64 -000C"},        // micro
     {0xB7, "-0A0A"},                          // dot
     {0xD0, "-040G ~0G4G8G844404 -0A4A"},      // Eth
     {0xD7, "-066C -0C66"},                    // times
     {0xD8, "o04848G0G -038H"},                // O with stroke
     {0xDE, "-040G ~0D4D8D864606"},            // Thorn
     {0xDF, "-040D ~0D0G5G5B2B ~2B7B747424"},  // sharp s
     {0xF0, "o04646C0C ~2G6E66 -1D5G"},        // eth
     {0xF7, "-0969 -3D3D -3535"},              // divided by
     {0xF8, "o04646C0C -036D"},                // o with stroke
     {0xFE, "o04646C0C -000G"}}};              // thorn
constexpr double kBaseline = 4;
constexpr double kCapUnits = 12;  // from the baseline to the top of a capital
constexpr double kGap = 3;        // between two characters
constexpr double kSpace = 2;      // width of ' '
constexpr int kPieces = 6;        // straight pieces per arc of a curve

struct Point {
  double x, y;
};

Point between(const Point& a, const Point& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

struct Glyph {
  std::vector<Stroke> strokes;  // in font units
  double width = kSpace;
};

void addLines(Glyph& glyph, const std::vector<Point>& points) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    glyph.strokes.push_back({points[i].x, points[i].y, points[i + 1].x, points[i + 1].y});
  }
}

/// Quadratic B-spline with these control points: a parabola for each inner control point, from the
/// middle of one edge to the middle of the next; an open curve begins and ends at its end points.
std::vector<Point> curve(const std::vector<Point>& control, bool closed) {
  std::vector<Point> points;
  const auto n = control.size();
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < n; ++i) {
    const auto& before = control[(i + n - 1) % n];
    const auto& after = control[(i + 1) % n];
    const auto start = !closed && i == 1 ? before : between(before, control[i], 0.5);
    const auto end = !closed && i + 2 == n ? after : between(control[i], after, 0.5);
    for (int piece = 0; piece <= kPieces; ++piece) {
      const double t = static_cast<double>(piece) / kPieces;
      points.push_back(between(between(start, control[i], t), between(control[i], end, t), t));
    }
  }
  return points;
}

double digit(char c) {
  return c <= '9' ? c - '0' : c - 'A' + 10;
}

Glyph parsed(std::string_view definition) {
  Glyph glyph;
  if (!definition.empty()) glyph.width = 0;
  while (!definition.empty()) {
    const auto stroke = definition.substr(0, definition.find(' '));
    definition.remove_prefix(std::min(stroke.size() + 1, definition.size()));
    std::vector<Point> points;
    for (std::size_t i = 1; i + 1 < stroke.size(); i += 2) {
      points.push_back({digit(stroke[i]), digit(stroke[i + 1]) - kBaseline});
      glyph.width = std::max(glyph.width, points.back().x);
    }
    addLines(glyph, stroke[0] == '-' ? points : curve(points, stroke[0] == 'o'));
  }
  return glyph;
}

void add(Glyph& glyph, const Glyph& other, double right, double up) {
  for (const auto& s : other.strokes) {
    glyph.strokes.push_back({s.x0 + right, s.y0 + up, s.x1 + right, s.y1 + up});
  }
}

/// A letter and what follows it in kLetters.
Glyph composed(char letter, char second, const std::vector<Glyph>& ascii) {
  constexpr double kRise = 4;  // from small letters to capitals
  const auto known = [&](char c) { return ascii[static_cast<std::size_t>(c - ' ')]; };
  Glyph glyph = letter == 'i' ? parsed("-040C") : known(letter);  // without its dot
  const auto* const mark = std::ranges::find(kMarks, second, &decltype(kMarks)::value_type::first);
  if (mark == kMarks.end()) {
    add(glyph, known(second), glyph.width + kGap, 0);
    glyph.width += kGap + known(second).width;
    return glyph;
  }
  const auto above = parsed(mark->second);
  const double right = 0.5 * (glyph.width - above.width);  // less than 0 if wider than the letter
  Glyph whole{{}, std::max(glyph.width, above.width)};
  add(whole, glyph, std::max(-right, 0.0), 0);
  add(whole, above, std::max(right, 0.0), letter < 'a' && second != ',' ? kRise : 0);
  return whole;
}

/// ASCII from ' ' to '~', then Latin-1 from U+00A0 on.
const std::vector<Glyph>& font() {
  static const std::vector<Glyph> glyphs = [] {
    std::vector<Glyph> ascii;
    for (const auto definition : kGlyphs) ascii.push_back(parsed(definition));
    auto all = ascii;
    all.resize(kGlyphs.size() + 96, ascii['?' - ' ']);
    for (std::size_t i = 0; i < kLetters.size(); i += 2) {
      if (kLetters[i] == ' ') continue;
      all[kGlyphs.size() + 32 + i / 2] = composed(kLetters[i], kLetters[i + 1], ascii);
    }
    for (const auto& [code, definition] : kOthers) {
      all[kGlyphs.size() + static_cast<std::size_t>(code - 0xA0)] = parsed(definition);
    }
    return all;
  }();
  return glyphs;
}

/// The glyph of the first character of a text in UTF-8, which is then removed.
const Glyph& nextGlyph(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  std::size_t size = 1;
  while (size < text.size() && detail::continuesCharacter(text[size])) ++size;
  std::size_t index = '?' - ' ';
  if (' ' <= text[0] && text[0] <= '~') index = static_cast<std::size_t>(text[0] - ' ');
  if (size == 2 && (byte(0) == 0xC2 || byte(0) == 0xC3)) {
    const auto code = (byte(0) & 3U) << 6U | (byte(1) & 0x3FU);
    if (code >= 0xA0) index = kGlyphs.size() + code - 0xA0;
  }
  text.remove_prefix(size);
  return font()[index];
}

}  // namespace

double textLength(std::string_view text, double capHeight) {
  double units = 0;
  while (!text.empty()) units += nextGlyph(text).width + kGap;
  return std::max(units - kGap, 0.0) * capHeight / kCapUnits;
}

void drawText(Image& image, double x, double y, std::string_view text, const TextStyle& style) {
  const double unit = style.capHeight / kCapUnits;
  const double length = textLength(text, style.capHeight);
  double along = style.anchor == TextAnchor::Start    ? 0
                 : style.anchor == TextAnchor::Middle ? -0.5 * length
                                                      : -length;
  const auto place = [&](double right, double up) -> Point {
    const double a = along + right * unit;
    const double b = up * unit;
    return style.upwards ? Point{x - b, y - a} : Point{x + a, y - b};
  };
  std::vector<Stroke> strokes;
  while (!text.empty()) {
    const auto& glyph = nextGlyph(text);
    strokes.clear();
    for (const auto& s : glyph.strokes) {
      const auto from = place(s.x0, s.y0);
      const auto to = place(s.x1, s.y1);
      strokes.push_back({from.x, from.y, to.x, to.y});
    }
    image.drawStrokes(strokes, style.weight, style.color);
    along += (glyph.width + kGap) * unit;
  }
}

}  // namespace cutwater
