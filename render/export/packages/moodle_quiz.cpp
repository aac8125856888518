// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/moodle_quiz.h"

#include <set>
#include <string_view>
#include <utility>

#include "render/export/encoding/xml_text.h"
#include "render/export/packages/package_parts.h"
#include "render/export/packages/package_words.h"
#include "render/export/students/answer_hash.h"

namespace sline::render {

namespace {

/// Returns text for a field that Moodle takes for HTML, within XML.
std::string asHtml(std::string_view text) {
  return xmlText(xmlText(plainLine(text)));
}

std::string htmlField(const char* tag, const std::string& html, const std::string& files = {}) {
  return std::string("    <") + tag + " format=\"html\">\n      <text>" + html + "</text>\n" +
         files + "    </" + tag + ">\n";
}

std::string fileElement(const QuestionPicture& picture, const char* path) {
  return "      <file name=\"" + picture.name + '"' + path + " encoding=\"base64\">" +
         base64(picture.png) + "</file>\n";
}

/// Returns a question's text with the picture below it.
std::string pictured(const std::string& words, const QuestionPicture& picture,
                     const std::string& shows) {
  const std::string html = "<p>" + xmlText(plainLine(words)) + "</p><p><img src=\"@@PLUGINFILE@@/" +
                           picture.name + "\" alt=\"" + xmlText(plainLine(shows)) + "\" width=\"" +
                           std::to_string(picture.size.x) + "\" height=\"" +
                           std::to_string(picture.size.y) +
                           "\" style=\"max-width:100%;height:auto\"></p>";
  return htmlField("questiontext", xmlText(html), fileElement(picture, " path=\"/\""));
}

/// Returns the name as a short answer's pattern: a star stands for itself.
std::string pattern(const std::string& name) {
  std::string text;
  for (const char c : name)
    text += c == '*' ? std::string("\\*") : std::string(1, c);
  return xmlText(text);
}

/// Returns a polygon in whole pixels, as markers have it.
std::string polygonOf(const QuestionZone& zone, const glm::ivec2& size) {
  std::string text;
  for (const glm::ivec2& pixel : pixelOutline(zone, size))
    text += (text.empty() ? "" : ";") + std::to_string(pixel.x) + ',' + std::to_string(pixel.y);
  return text;
}

class Quiz {
 public:
  Quiz(const QuestionBook& book, const QuestionKinds& kinds)
      : m_book(book), m_kinds(kinds), m_words(packageWords(book.language)) {}

  std::string xml() {
    m_xml = std::string(xmlHead) + "<quiz>\n";
    for (const QuestionSheet& sheet : m_book.sheets) {
      addCategory(sheet);
      for (const SheetThing& thing : sheet.things)
        addThing(sheet, thing);
    }
    return std::move(m_xml) + "</quiz>\n";
  }

 private:
  /// Returns a category's name; a slash would part it from one in it.
  static std::string categoryName(const std::string& title) {
    std::string name;
    for (const char c : plainLine(title))
      name += c == '/' ? std::string("//") : std::string(1, c);
    return xmlText(name);
  }

  void addCategory(const QuestionSheet& sheet) {
    const std::string book = categoryName(m_book.title);
    const std::string title = categoryName(sheet.title);
    m_xml += "  <question type=\"category\">\n    <category><text>$course$/top/" + book +
             (title == book || title.empty() ? std::string() : '/' + title) +
             "</text></category>\n";
    const std::string credit = m_book.credit.line();
    if (!credit.empty())
      m_xml += htmlField("info", asHtml(credit));
    m_xml += "  </question>\n";
  }

  void addThing(const QuestionSheet& sheet, const SheetThing& thing) {
    if (m_kinds.find && isFoundByPlace(thing))
      addMarker(sheet, thing);
    else if (m_kinds.find && hasNumberChoice(thing))
      addNumberChoice(sheet, thing);
    if (m_kinds.name)
      addShortAnswer(sheet, thing);
    if (m_kinds.choose && hasChoice(thing))
      addChoice(sheet, thing);
  }

  void begin(const char* type, const char* asked, const SheetThing& thing) {
    m_xml += std::string("  <question type=\"") + type + "\">\n    <name><text>" +
             xmlText(plainLine(thing.words + " – " + asked)) + "</text></name>\n";
  }

  void grade(const SheetThing& thing) {
    m_xml += htmlField("generalfeedback", asHtml(thing.words)) +
             "    <defaultgrade>1</defaultgrade>\n    <penalty>0.3333333</penalty>\n"
             "    <hidden>0</hidden>\n";
  }

  void feedback() {
    m_xml += htmlField("correctfeedback", asHtml(m_words.right)) +
             htmlField("partiallycorrectfeedback", asHtml(m_words.wrong)) +
             htmlField("incorrectfeedback", asHtml(m_words.wrong));
  }

  void addMarker(const QuestionSheet& sheet, const SheetThing& thing) {
    begin("ddmarker", "find", thing);
    m_xml += htmlField("questiontext", asHtml(withName(m_words.putMarker, thing.words)));
    grade(thing);
    feedback();
    m_xml += fileElement(sheet.small, "") + "    <drag>\n      <no>1</no>\n      <text>" +
             asHtml(thing.words) + "</text>\n      <noofdrags>1</noofdrags>\n    </drag>\n" +
             "    <drop>\n      <no>1</no>\n      <shape>polygon</shape>\n      <coords>" +
             polygonOf(thing.zone, sheet.small.size) +
             "</coords>\n      <choice>1</choice>\n    </drop>\n  </question>\n";
  }

  void answer(const std::string& html, bool right) {
    m_xml += std::string("    <answer fraction=\"") + (right ? "100" : "0") +
             "\" format=\"html\">\n      <text>" + html +
             "</text>\n      <feedback format=\"html\"><text></text></feedback>\n    </answer>\n";
  }

  void beginChoices(bool shuffled) {
    m_xml += std::string("    <single>true</single>\n    <shuffleanswers>") +
             (shuffled ? "true" : "false") +
             "</shuffleanswers>\n    <answernumbering>none</answernumbering>\n"
             "    <showstandardinstruction>0</showstandardinstruction>\n";
    feedback();
  }

  void addNumberChoice(const QuestionSheet& sheet, const SheetThing& thing) {
    begin("multichoice", "number", thing);
    m_xml += pictured(withName(m_words.whichNumber, thing.words), sheet.numbered, sheet.shows);
    grade(thing);
    beginChoices(false);
    std::set<std::pair<std::vector<int>, bool>> choices{{thing.numbers, true}};
    for (const std::size_t other : thing.others)
      choices.insert({sheet.things[other].numbers, false});
    for (const auto& [numbers, right] : choices) {
      SheetThing shown;
      shown.numbers = numbers;
      if (!numbers.empty())
        answer(asHtml(numberText(shown)), right);
    }
    m_xml += "  </question>\n";
  }

  void addShortAnswer(const QuestionSheet& sheet, const SheetThing& thing) {
    begin("shortanswer", "name", thing);
    m_xml += pictured(m_words.nameIt, thing.marked, sheet.shows);
    grade(thing);
    m_xml += "    <usecase>0</usecase>\n";
    for (const std::string& name : thing.accepted)
      m_xml += "    <answer fraction=\"100\" format=\"moodle_auto_format\">\n      <text>" +
               pattern(name) +
               "</text>\n      <feedback format=\"html\"><text></text></feedback>\n    </answer>\n";
    m_xml += "  </question>\n";
  }

  void addChoice(const QuestionSheet& sheet, const SheetThing& thing) {
    begin("multichoice", "choose", thing);
    m_xml += pictured(m_words.chooseIt, thing.marked, sheet.shows);
    grade(thing);
    beginChoices(true);
    answer(asHtml(thing.words), true);
    for (const std::string& other : thing.wrong)
      answer(asHtml(other), false);
    m_xml += "  </question>\n";
  }

  const QuestionBook& m_book;
  const QuestionKinds& m_kinds;
  const PackageWords& m_words;
  std::string m_xml;
};

}  // namespace

std::string moodleQuiz(const QuestionBook& book, const QuestionKinds& kinds) {
  return Quiz(book, kinds).xml();
}

}  // namespace sline::render
