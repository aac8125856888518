// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/qti_package.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "render/export/packages/package_parts.h"
#include "render/export/packages/package_words.h"

namespace sline::render {

namespace {

constexpr const char* qtiSpace =
    "xmlns=\"http://www.imsglobal.org/xsd/imsqti_v2p1\" "
    "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
    "xsi:schemaLocation=\"http://www.imsglobal.org/xsd/imsqti_v2p1 "
    "http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd\"";
constexpr const char* templates = "http://www.imsglobal.org/question/qti_v2p1/rptemplates/";

std::string outcome() {
  return "  <outcomeDeclaration identifier=\"SCORE\" cardinality=\"single\" baseType=\"float\">"
         "<defaultValue><value>0</value></defaultValue></outcomeDeclaration>\n"
         "  <outcomeDeclaration identifier=\"MAXSCORE\" cardinality=\"single\" baseType=\"float\">"
         "<defaultValue><value>1</value></defaultValue></outcomeDeclaration>\n";
}

std::string oneRight(const std::string& right) {
  return "  <responseDeclaration identifier=\"RESPONSE\" cardinality=\"single\" "
         "baseType=\"identifier\"><correctResponse><value>" +
         right + "</value></correctResponse></responseDeclaration>\n";
}

/// Returns a polygon in whole pixels, as HTML's maps have it.
std::string coordinates(const QuestionZone& zone, const glm::ivec2& size) {
  std::string list;
  for (const glm::ivec2& pixel : pixelOutline(zone, size))
    list += (list.empty() ? "" : ",") + std::to_string(pixel.x) + ',' + std::to_string(pixel.y);
  return list;
}

/// What an item asks, and how that is judged.
struct ItemParts {
  std::string declared;
  std::string body;
  const char* processing;
};

struct Item {
  std::string id;  ///< also the file's name
  std::string xml;
  std::vector<std::string> pictures;
};

class Package {
 public:
  Package(const QuestionBook& book, const QuestionKinds& kinds)
      : m_book(book), m_kinds(kinds), m_words(packageWords(book.language)) {}

  std::vector<model::ZipMember> members() {
    for (const QuestionSheet& sheet : m_book.sheets) {
      m_sections.emplace_back();
      for (const SheetThing& thing : sheet.things)
        addThing(sheet, thing);
    }
    std::vector<model::ZipMember> all{{"imsmanifest.xml", manifest()}, {"test.xml", test()}};
    for (const std::vector<Item>& section : m_sections)
      for (const Item& item : section)
        all.push_back({"items/" + item.id + ".xml", item.xml});
    all.insert(all.end(), m_pictures.begin(), m_pictures.end());
    return all;
  }

 private:
  void addThing(const QuestionSheet& sheet, const SheetThing& thing) {
    if (m_kinds.find && isFoundByPlace(thing))
      addHotspot(sheet, thing);
    else if (m_kinds.find && hasNumberChoice(thing))
      addNumberChoice(sheet, thing);
    if (m_kinds.name)
      addTextEntry(sheet, thing);
    if (m_kinds.choose && hasChoice(thing))
      addChoice(sheet, thing);
  }

  void addPicture(const QuestionPicture& picture) {
    if (m_names.insert(picture.name).second)
      m_pictures.push_back({"images/" + picture.name, picture.png});
  }

  /// Adds an item; its title names nothing, as students see it.
  void addItem(const std::string& kind, const SheetThing& thing, const QuestionPicture& picture,
               const ItemParts& parts) {
    addPicture(picture);
    Item item{.id = "q-" + thing.id + '-' + kind, .xml = {}, .pictures = {picture.name}};
    item.xml =
        std::string(xmlHead) + "<assessmentItem " + qtiSpace + xmlAttribute("identifier", item.id) +
        xmlAttribute("title", std::to_string(++m_number)) +
        xmlAttribute("xml:lang", m_book.language) +
        " adaptive=\"false\" timeDependent=\"false\" toolName=\"Sline\">\n" + parts.declared +
        outcome() + "  <itemBody>\n" + parts.body + "  </itemBody>\n  <responseProcessing" +
        " template=\"" + templates + parts.processing + "\"/>\n</assessmentItem>\n";
    m_sections.back().push_back(std::move(item));
  }

  static std::string image(const QuestionPicture& picture, const std::string& shows) {
    return "    <p><img src=\"../images/" + picture.name + '"' + xmlAttribute("alt", shows) +
           xmlAttribute("width", std::to_string(picture.size.x)) +
           xmlAttribute("height", std::to_string(picture.size.y)) + "/></p>\n";
  }

  void addHotspot(const QuestionSheet& sheet, const SheetThing& thing) {
    const QuestionPicture& ground = sheet.ground;
    std::string body =
        "    <hotspotInteraction responseIdentifier=\"RESPONSE\" maxChoices=\"1\">\n      "
        "<prompt>" +
        lineElementText(withName(m_words.find, thing.words)) +
        "</prompt>\n      <object type=\"image/png\"" +
        xmlAttribute("data", "../images/" + ground.name) +
        xmlAttribute("width", std::to_string(ground.size.x)) +
        xmlAttribute("height", std::to_string(ground.size.y)) + '>' + lineElementText(sheet.shows) +
        "</object>\n";
    std::string right;
    for (std::size_t i = 0; i < sheet.things.size(); ++i) {
      const SheetThing& each = sheet.things[i];
      if (each.zone.outline.empty())
        continue;
      const std::string id = "H" + std::to_string(i + 1);
      if (&each == &thing)
        right = id;
      body += "      <hotspotChoice identifier=\"" + id + "\" shape=\"poly\" coords=\"" +
              coordinates(each.zone, ground.size) + "\"/>\n";
    }
    body += "    </hotspotInteraction>\n";
    addItem("find", thing, ground, {oneRight(right), body, "match_correct"});
  }

  std::string choices(const std::string& prompt, bool shuffled,
                      const std::vector<std::string>& texts) const {
    std::string body = std::string(
                           "    <choiceInteraction responseIdentifier=\"RESPONSE\" "
                           "shuffle=\"") +
                       (shuffled ? "true" : "false") + "\" maxChoices=\"1\">\n      <prompt>" +
                       lineElementText(prompt) + "</prompt>\n";
    for (std::size_t i = 0; i < texts.size(); ++i)
      body += "      <simpleChoice identifier=\"C" + std::to_string(i + 1) + "\">" +
              lineElementText(texts[i]) + "</simpleChoice>\n";
    return body + "    </choiceInteraction>\n";
  }

  void addNumberChoice(const QuestionSheet& sheet, const SheetThing& thing) {
    std::set<std::vector<int>> sorted{thing.numbers};
    for (const std::size_t other : thing.others)
      sorted.insert(sheet.things[other].numbers);
    std::vector<std::string> texts;
    std::string right;
    for (const std::vector<int>& numbers : sorted) {
      SheetThing shown;
      shown.numbers = numbers;
      if (numbers.empty())
        continue;
      texts.push_back(numberText(shown));
      if (numbers == thing.numbers)
        right = "C" + std::to_string(texts.size());
    }
    addItem("number", thing, sheet.numbered,
            {oneRight(right),
             image(sheet.numbered, sheet.shows) +
                 choices(withName(m_words.whichNumber, thing.words), false, texts),
             "match_correct"});
  }

  void addTextEntry(const QuestionSheet& sheet, const SheetThing& thing) {
    std::string declared =
        "  <responseDeclaration identifier=\"RESPONSE\" cardinality=\"single\" "
        "baseType=\"string\"><correctResponse><value>" +
        lineElementText(thing.accepted.front()) +
        "</value></correctResponse><mapping lowerBound=\"0\" upperBound=\"1\" "
        "defaultValue=\"0\">";
    std::size_t longest = 20;
    for (const std::string& name : thing.accepted) {
      declared += "<mapEntry" + xmlAttribute("mapKey", name) +
                  " mappedValue=\"1\" caseSensitive=\"false\"/>";
      longest = std::max(longest, name.size());
    }
    addItem("name", thing, thing.marked,
            {declared + "</mapping></responseDeclaration>\n",
             image(thing.marked, sheet.shows) + "    <p>" + lineElementText(m_words.nameIt) +
                 " <textEntryInteraction responseIdentifier=\"RESPONSE\" expectedLength=\"" +
                 std::to_string(longest) + "\"/></p>\n",
             "map_response"});
  }

  void addChoice(const QuestionSheet& sheet, const SheetThing& thing) {
    std::vector<std::string> texts{thing.words};
    texts.insert(texts.end(), thing.wrong.begin(), thing.wrong.end());
    addItem(
        "choose", thing, thing.marked,
        {oneRight("C1"), image(thing.marked, sheet.shows) + choices(m_words.chooseIt, true, texts),
         "match_correct"});
  }

  std::string test() const {
    std::string xml = std::string(xmlHead) + "<assessmentTest " + qtiSpace +
                      " identifier=\"test\"" + xmlAttribute("title", m_book.title) +
                      " toolName=\"Sline\">\n  <testPart identifier=\"part\" "
                      "navigationMode=\"nonlinear\" submissionMode=\"individual\">\n";
    for (std::size_t i = 0; i < m_sections.size(); ++i) {
      xml += "    <assessmentSection identifier=\"section-" + std::to_string(i + 1) + '"' +
             xmlAttribute("title", m_book.sheets[i].title) + " visible=\"true\">\n";
      for (const Item& item : m_sections[i])
        xml += "      <assessmentItemRef identifier=\"" + item.id + "\" href=\"items/" + item.id +
               ".xml\"/>\n";
      xml += "    </assessmentSection>\n";
    }
    return xml + "  </testPart>\n</assessmentTest>\n";
  }

  /// Returns what the manifest says of the whole, with the credit where there is one.
  std::string metadata() const {
    return "  <metadata>\n    <schema>QTIv2.1 Package</schema>\n"
           "    <schemaversion>1.0.0</schemaversion>\n    " +
           lomElement(m_book.title, m_book.language, m_book.credit) + "\n  </metadata>\n";
  }

  std::string manifest() const {
    std::string xml =
        std::string(xmlHead) +
        "<manifest xmlns=\"http://www.imsglobal.org/xsd/imscp_v1p1\" "
        "xmlns:lom=\"http://ltsc.ieee.org/xsd/LOM\" "
        "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
        "xsi:schemaLocation=\"http://www.imsglobal.org/xsd/imscp_v1p1 "
        "http://www.imsglobal.org/xsd/qti/qtiv2p1/qtiv2p1_imscpv1p2_v1p0.xsd "
        "http://ltsc.ieee.org/xsd/LOM http://www.imsglobal.org/xsd/imsmd_loose_v1p3p2.xsd\" "
        "identifier=\"manifest\">\n" +
        metadata() +
        "  <organizations/>\n  <resources>\n    <resource identifier=\"res-test\" "
        "type=\"imsqti_test_xmlv2p1\" href=\"test.xml\">\n"
        "      <file href=\"test.xml\"/>\n";
    for (const std::vector<Item>& section : m_sections)
      for (const Item& item : section)
        xml += "      <dependency identifierref=\"res-" + item.id + "\"/>\n";
    xml += "    </resource>\n";
    for (const std::vector<Item>& section : m_sections)
      for (const Item& item : section) {
        xml += "    <resource identifier=\"res-" + item.id +
               "\" type=\"imsqti_item_xmlv2p1\" href=\"items/" + item.id +
               ".xml\">\n      <file href=\"items/" + item.id + ".xml\"/>\n";
        for (const std::string& picture : item.pictures)
          xml += "      <file href=\"images/" + picture + "\"/>\n";
        xml += "    </resource>\n";
      }
    return xml + "  </resources>\n</manifest>\n";
  }

  const QuestionBook& m_book;
  const QuestionKinds& m_kinds;
  const PackageWords& m_words;
  std::vector<std::vector<Item>> m_sections;
  std::vector<model::ZipMember> m_pictures;
  std::set<std::string> m_names;
  int m_number = 0;
};

}  // namespace

std::vector<model::ZipMember> qtiPackage(const QuestionBook& book, const QuestionKinds& kinds) {
  return Package(book, kinds).members();
}

}  // namespace sline::render
