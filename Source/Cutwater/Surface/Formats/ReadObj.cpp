#include <Cutwater/Surface/Formats/Readers.hpp>

#include <algorithm>
#include <array>

namespace cutwater::formats {

namespace {

template <std::size_t count>
using Words = std::array<std::string_view, count>;

constexpr Words<6> kRead = {"v", "f", "fo", "g", "o", "usemtl"};
// Geometry other than polygons: skipped, with a report.
constexpr Words<12> kSkipped = {"p",   "l",   "curv", "curv2", "surf", "call",
                                "csh", "bzp", "bsp",  "cdc",   "cdp",  "res"};
// Statements for materials, textures and normals, or for the skipped curves and surfaces.
constexpr Words<27> kIgnored = {
    "vt",       "vn",   "vp",    "s",     "mg",         "mtllib",    "maplib", "usemap", "bevel",
    "c_interp", "lod",  "ctech", "stech", "shadow_obj", "trace_obj", "cstype", "deg",    "bmat",
    "d_interp", "step", "parm",  "trim",  "hole",       "scrv",      "sp",     "end",    "con"};

template <std::size_t count>
bool contains(const Words<count>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader {
 public:
  ObjReader(const Content& content, SoupBuilder& builder)
      : text_(content, {.comments = TextCursor::Comments::AtWords, .continuation = true}),
        builder_(builder) {
    builder_.countPointsFrom(1);
  }

  SurfaceFile read() {
    while (text_.nextLine()) {
      const auto statement = text_.word();
      if (!statement.empty()) readStatement(statement);
    }
    if (skipped_ > 0) {
      builder_.note(std::to_string(skipped_) + " statements (p, l, curv, ...) are not read.");
    }
    if (materialsHidden_) {
      builder_.note("Materials (usemtl) are not kept: groups or objects name the patches.");
    }
    return std::move(builder_).finish(text_);
  }

 private:
  void readStatement(std::string_view statement) {
    if (statement == "v") {
      readPoint();
    } else if (statement == "f" || statement == "fo") {
      readFace();
    } else if (statement == "g") {
      group_ = text_.rest();
      namePatch();
    } else if (statement == "o") {
      object_ = text_.rest();
      group_ = {};
      namePatch();
    } else if (statement == "usemtl") {
      material_ = text_.rest();
      materialsHidden_ = materialsHidden_ || !group_.empty() || !object_.empty();
      namePatch();
    } else if (contains(kSkipped, statement)) {
      ++skipped_;
      text_.skipLine();
    } else if (contains(kIgnored, statement)) {
      text_.skipLine();
    } else {
      text_.fail("unknown statement " + inQuotes(statement));
    }
  }

  void readPoint() {
    const double x = text_.number();
    const double y = text_.number();
    const double z = text_.number();
    builder_.addPoint({x, y, z}, text_);
    text_.skipNumbers();  // a weight, or a colour
  }

  void readFace() {
    for (auto corner = text_.word(); !corner.empty(); corner = text_.word()) {
      builder_.addCorner(indexOf(corner), text_);
    }
    builder_.endPolygon(text_);
  }

  // The first number of "7", "7/2", "7//3" or "7/2/3": counted from 1 or, if negative, back from
  // the last point.
  [[nodiscard]] std::int64_t indexOf(std::string_view corner) const {
    const auto slash = std::min(corner.find('/'), corner.size());
    const auto others = corner.substr(slash);
    if (others.find_first_not_of("/-0123456789") != std::string_view::npos) {
      text_.fail("expected a corner such as 7/2/3, found " + inQuotes(corner));
    }
    const std::int64_t index = text_.toInteger(corner.substr(0, slash));
    const auto points = static_cast<std::int64_t>(builder_.pointCount());
    if (index == 0 || index < -points) {
      text_.fail("index " + std::to_string(index) + " is out of range (" + std::to_string(points) +
                 " points so far)");
    }
    return index > 0 ? index - 1 : points + index;
  }

  // The patch is named after the current group; without one, after the object; else, the material.
  void namePatch() {
    builder_.setPatch(!group_.empty() ? group_ : !object_.empty() ? object_ : material_);
  }

  TextCursor text_;
  SoupBuilder& builder_;
  std::string_view group_;
  std::string_view object_;
  std::string_view material_;
  bool materialsHidden_ = false;
  std::uint64_t skipped_ = 0;
};

}  // namespace

bool isObjStatement(std::string_view word) {
  return contains(kRead, word) || contains(kSkipped, word) || contains(kIgnored, word);
}

SurfaceFile readObj(const Content& content, SoupBuilder& builder) {
  return ObjReader(content, builder).read();
}

}  // namespace cutwater::formats
