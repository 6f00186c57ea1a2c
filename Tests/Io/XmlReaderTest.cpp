#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/XmlReader.hpp>

#include <gtest/gtest.h>

#include "Support/Refusal.hpp"

namespace cutwater::test {
namespace {

using detail::readXml;
using detail::XmlElement;

XmlElement parsed(const std::string& text) {
  // The text outlives the elements, whose views refer to it.
  static std::string kept;
  kept = text;
  return readXml({"a.xml", kept}, "Last");
}

std::string refused(const std::string& text) {
  return refusal([&] { return parsed(text); });
}

TEST(XmlReaderTest, ReadsElementsWithTheirAttributesAndText) {
  const auto root = parsed(
      "<?xml version=\"1.0\"?>\n<!-- a comment -->\n<A x='1' y=\"&lt;&#65;\">\n<B>b</B>\n<C\n "
      "z='2'/>"
      "\n<B>c\n</B> tail</A>\n");
  EXPECT_EQ(root.name, "A");
  ASSERT_NE(root.attribute("y"), nullptr);
  EXPECT_EQ(*root.attribute("y"), "<A");
  EXPECT_EQ(root.attribute("z"), nullptr);
  EXPECT_EQ(root.line, 3U);
  EXPECT_EQ(root.count("B"), 2U);
  EXPECT_EQ(root.child("B")->text, "b");
  EXPECT_EQ(root.children[2].text, "c\n");
  EXPECT_EQ(root.children[1].text, "");
  EXPECT_EQ(*root.child("C")->attribute("z"), "2");
  EXPECT_EQ(root.child("C")->line, 5U);
  EXPECT_EQ(root.child("C")->textLine, 6U);
  EXPECT_EQ(root.child("D"), nullptr);
  EXPECT_EQ(root.text, " tail");
}

TEST(XmlReaderTest, TextBeginsBehindTheLastChild) {
  const auto root = parsed("<A><Key name='n'><Value>1</Value></Key>\n 1 2 3 </A>");
  EXPECT_EQ(root.text, "\n 1 2 3 ");
  EXPECT_EQ(root.textLine, 1U);
}

TEST(XmlReaderTest, StopsBehindTheLastElementsTag) {
  const auto root = parsed(std::string("<A><Last e='raw'>_\0\xff<&", 22));
  EXPECT_EQ(*root.child("Last")->attribute("e"), "raw");
  EXPECT_EQ(root.child("Last")->text, std::string_view("_\0\xff<&", 5));
}

TEST(XmlReaderTest, RefusesWhatIsNotWellFormedWithItsLine) {
  EXPECT_TRUE(refused("<A>\n<B>\n</A>").starts_with("a.xml: line 3: mismatched tag"));
  EXPECT_TRUE(
      refused("<A>\n<B a='1' a='2'/></A>").starts_with("a.xml: line 2: duplicate attribute"));
  EXPECT_TRUE(refused("<A/>\n<B/>").starts_with("a.xml: line 2: junk after document element"));
  EXPECT_TRUE(refused("<A>&unknown;</A>").starts_with("a.xml: line 1: undefined entity"));
  EXPECT_TRUE(refused("<A>\xff</A>").starts_with("a.xml: line 1: not well-formed"));
}

TEST(XmlReaderTest, SaysThatTheFileEndsTooEarly) {
  const std::string tooEarly = "the file ends too early: it should end with </A>";
  EXPECT_EQ(refused("<A>\n<B/>\n"), "a.xml: line 3: " + tooEarly);
  EXPECT_EQ(refused("<A>\n<B c='1"), "a.xml: line 2: " + tooEarly);
  EXPECT_EQ(refused("<A>\n</"), "a.xml: line 2: " + tooEarly);
  EXPECT_EQ(refused("<?xml"), "a.xml: line 1: the file ends before its first element");
}

TEST(XmlReaderTest, RefusesDocumentTypesAndTooManyElements) {
  EXPECT_EQ(refused("<?xml version='1.0'?>\n<!DOCTYPE A [<!ENTITY a 'b'>]>\n<A>&a;</A>"),
            "a.xml: line 2: a document type is not read");
  std::string wide = "<A>";
  for (int i = 0; i < 4095; ++i) wide += "<B/>";
  EXPECT_EQ(refused(wide + "</A>"), "");
  EXPECT_EQ(refused(wide + "<B/></A>"), "a.xml: line 1: more than 4096 elements");
  std::string deep;
  for (int i = 0; i < 33; ++i) deep += "<A>";
  EXPECT_EQ(refused(deep), "a.xml: line 1: elements within each other too deep");
}

}  // namespace
}  // namespace cutwater::test
