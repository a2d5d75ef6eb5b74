#include "common/text/xml.h"

#include <gtest/gtest.h>

#include "test/error_of.h"

namespace twinbus::test {
namespace {

std::string refusal(const std::string& text) {
  return error_of([&] { (void)parse_xml(text, "f.xml"); });
}

TEST(Xml, WhatIsNotWellFormedIsRefusedWithItsLine) {
  for (const char* bad : {"<a b='0&45'/>",
                          "<a b='3&00'/>",
                          "<a b='1' b='2'/>",
                          "<a b=1/>",
                          "<a b/>",
                          "<a><b></a></b>",
                          "<a>",
                          "<a/><b/>",
                          "<a/>text",
                          "text",
                          "<a b='<'/>",
                          "<a><!-- -- --></a>",
                          "<a>]]></a>",
                          "<a>&none;</a>",
                          "<a>\x01</a>",
                          "<a>&#1;</a>",
                          "<a>\xff</a>",
                          "<1/>",
                          "<a b='x'c='y'/>",
                          "< a/>",
                          "<a><?xml version='1.0'?></a>"}) {
    const std::string error = refusal(bad);
    EXPECT_EQ(error.find("f.xml:1: not well-formed XML: "), 0U) << bad << ": " << error;
    EXPECT_NE(error.find("; "), std::string::npos) << error;
  }
  EXPECT_EQ(refusal("<a>\n<b c='0&1'/>\n</a>").find("f.xml:2: "), 0U);
  EXPECT_NE(refusal(" \n ").find("XML"), std::string::npos);
}

TEST(Xml, DeclarationsThatChangeWhatAFileSaysAreRefused) {
  for (const char* bad :
       {"<!DOCTYPE a [<!ENTITY x '1'>]><a b='&x;'/>", "<!DOCTYPE a [<!ATTLIST a b CDATA '1'>]><a/>",
        "<!DOCTYPE a SYSTEM 'other'><a b='&x;'/>"}) {
    EXPECT_NE(refusal(bad).find("remove <!DOCTYPE"), std::string::npos)
        << bad << ": " << refusal(bad);
  }
  EXPECT_EQ(refusal("<!DOCTYPE a><a/>"), "");
}

TEST(Xml, TheTreeIsWhatTheFileSays) {
  const XmlElement root = parse_xml(
      "<?xml version='1.0' encoding='ISO-8859-1'?>\n<a x='1 &lt;2' y=\"'\">  text &amp; more "
      "\n<b/>late</a>",
      "f");
  EXPECT_EQ(root.name, "a");
  EXPECT_EQ(root.line, 2);
  EXPECT_EQ(*root.attribute("x"), "1 <2");
  EXPECT_EQ(*root.attribute("y"), "'");
  EXPECT_EQ(root.text, "text & more");
  ASSERT_EQ(root.children.size(), 1U);
  EXPECT_EQ(root.children[0].line, 3);
}

TEST(Xml, WrittenAgainItReadsTheSame) {
  const std::string text =
      "<a x='&lt;&amp;&quot;&#10;&#9;' y='\xc3\xa4'>&lt;b&gt;<c z=''/><d>1</d></a>";
  std::string once, twice;
  append_xml(parse_xml(text, "f"), once);
  append_xml(parse_xml(once, "f"), twice);
  EXPECT_EQ(once, twice);
  EXPECT_EQ(*parse_xml(once, "f").attribute("x"), "<&\"\n\t");
}

}  // namespace
}  // namespace twinbus::test
