#include <Cutwater/Io/Detail/XmlReader.hpp>
#include <Cutwater/Text/TextCursor.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <memory>
#include <new>

#ifdef CUTWATER_HAS_EXPAT
#include <expat.h>
#endif

namespace cutwater::detail {

const std::string* XmlElement::attribute(std::string_view key) const {
  const auto found =
      std::ranges::find_if(attributes, [&](const auto& pair) { return pair.first == key; });
  return found == attributes.end() ? nullptr : &found->second;
}

const XmlElement* XmlElement::child(std::string_view key) const {
  const auto found = std::ranges::find(children, key, &XmlElement::name);
  return found == children.end() ? nullptr : &*found;
}

std::size_t XmlElement::count(std::string_view key) const {
  return static_cast<std::size_t>(std::ranges::count(children, key, &XmlElement::name));
}

void failAtLine(const text::Content& content, std::uint64_t line, const std::string& message) {
  const text::TextCursor cursor(content);
  cursor.failAt({text::Place::Unit::Line, line}, message);
}

#ifdef CUTWATER_HAS_EXPAT

namespace {

class XmlParsing {
 public:
  XmlParsing(const text::Content& content, std::string_view last)
      : content_(content), last_(last), parser_(XML_ParserCreate(nullptr)) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), onStart, onEnd);
    XML_SetStartDoctypeDeclHandler(parser_.get(), onDoctype);
  }

  XmlElement run() && {
    constexpr std::size_t kPiece = std::size_t{1} << 24U;  // expat counts in int
    for (std::size_t at = 0; !isDone_; at += kPiece) {
      const auto piece = content_.bytes.substr(at, kPiece);
      const bool isEnd = at + piece.size() == content_.bytes.size();
      const auto status = XML_Parse(parser_.get(), piece.data(), static_cast<int>(piece.size()),
                                    static_cast<int>(isEnd));
      if (failure_) std::rethrow_exception(failure_);
      if (isDone_) break;
      if (status != XML_STATUS_OK) failToParse(XML_GetErrorCode(parser_.get()));
      if (isEnd) break;
    }
    return std::move(document_.children.front());
  }

 private:
  static constexpr std::size_t kMostElements = 4096;
  static constexpr std::size_t kMostDepth = 32;

  struct Free {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };

  // Exceptions must not pass through expat.
  template <typename Action>
  static void guarded(void* self, const Action& action) {
    auto& parsing = *static_cast<XmlParsing*>(self);
    if (parsing.failure_ || parsing.isDone_) return;
    try {
      action(parsing);
    } catch (...) {
      parsing.failure_ = std::current_exception();
    }
    if (parsing.failure_ || parsing.isDone_) XML_StopParser(parsing.parser_.get(), XML_FALSE);
  }
  static void XMLCALL onStart(void* self, const XML_Char* name, const XML_Char** attributes) {
    guarded(self, [&](XmlParsing& parsing) { parsing.start(name, attributes); });
  }
  static void XMLCALL onEnd(void* self, const XML_Char*) {
    guarded(self, [](XmlParsing& parsing) { parsing.end(); });
  }
  static void XMLCALL onDoctype(void* self, const XML_Char*, const XML_Char*, const XML_Char*,
                                int) {
    guarded(self, [](XmlParsing& parsing) { parsing.fail("a document type is not read"); });
  }

  void start(const XML_Char* name, const XML_Char** attributes) {
    if (++elements_ > kMostElements)
      fail("more than " + std::to_string(kMostElements) + " elements");
    if (open_.size() > kMostDepth) fail("elements within each other too deep");
    auto& element = open_.back()->children.emplace_back();
    const auto tag = static_cast<std::uint64_t>(XML_GetCurrentByteIndex(parser_.get()));
    element.name = content_.bytes.substr(tag + 1, std::string_view(name).size());
    for (; *attributes != nullptr; attributes += 2) {
      element.attributes.emplace_back(attributes[0], attributes[1]);
    }
    element.line = line();
    open_.push_back(&element);
    beginText();
    if (name != last_) return;
    element.text = content_.bytes.substr(textBegin_);
    isDone_ = true;
  }

  void end() {
    const auto at = static_cast<std::uint64_t>(XML_GetCurrentByteIndex(parser_.get()));
    open_.back()->text = content_.bytes.substr(textBegin_, at - textBegin_);
    open_.pop_back();
    beginText();
  }

  /// Behind the present tag.
  void beginText() {
    const auto tag = static_cast<std::uint64_t>(XML_GetCurrentByteIndex(parser_.get()));
    const auto size = static_cast<std::uint64_t>(XML_GetCurrentByteCount(parser_.get()));
    textBegin_ = tag + size;
    const auto text = content_.bytes.substr(tag, size);
    open_.back()->textLine = line() + static_cast<std::uint64_t>(std::ranges::count(text, '\n'));
  }

  [[noreturn]] void failToParse(XML_Error error) const {
    constexpr std::array kEndsTooEarly{XML_ERROR_NO_ELEMENTS, XML_ERROR_UNCLOSED_TOKEN,
                                       XML_ERROR_PARTIAL_CHAR, XML_ERROR_UNCLOSED_CDATA_SECTION};
    if (std::ranges::find(kEndsTooEarly, error) == kEndsTooEarly.end()) {
      fail(XML_ErrorString(error));
    }
    if (document_.children.empty()) fail("the file ends before its first element");
    fail("the file ends too early: it should end with </" +
         std::string(document_.children.front().name) + '>');
  }

  [[nodiscard]] std::uint64_t line() const { return XML_GetCurrentLineNumber(parser_.get()); }
  [[noreturn]] void fail(const std::string& message) const {
    failAtLine(content_, line(), message);
  }

  const text::Content& content_;
  std::string_view last_;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, Free> parser_;
  XmlElement document_;
  // The document, and the elements whose end has not come yet. A list of children grows only while
  // none of them is open, so these stay where they are.
  std::vector<XmlElement*> open_{&document_};
  std::size_t elements_ = 0;
  std::uint64_t textBegin_ = 0;
  bool isDone_ = false;
  std::exception_ptr failure_;
};

}  // namespace

XmlElement readXml(const text::Content& content, std::string_view last) {
  return XmlParsing(content, last).run();
}

#else

XmlElement readXml(const text::Content& content, std::string_view) {
  failAtLine(content, 1, "an XML file, and this Cutwater was built without expat");
}

#endif

}  // namespace cutwater::detail
