// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/h5p_package.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "render/export/encoding/xml_text.h"
#include "render/export/packages/package_parts.h"
#include "render/export/packages/package_words.h"

namespace sline::render {

namespace {

using Json = nlohmann::json;

struct Library {
  const char* name;
  int major;
  int minor;
  const char* title;

  std::string versioned() const {
    return std::string(name) + ' ' + std::to_string(major) + '.' + std::to_string(minor);
  }
};

constexpr Library column{"H5P.Column", 1, 16, "Column"};
constexpr Library questionSet{"H5P.QuestionSet", 1, 20, "Question Set"};
constexpr Library hotspot{"H5P.ImageHotspotQuestion", 1, 8, "Find the Hotspot"};
constexpr Library multiChoice{"H5P.MultiChoice", 1, 16, "Multiple Choice"};
constexpr Library blanks{"H5P.Blanks", 1, 14, "Fill in the Blanks"};
constexpr Library image{"H5P.Image", 1, 1, "Image"};

/// The longest text of a field of h5p.json, bytes.
constexpr std::size_t longestField = 255;

/// Returns text for a field that is shown as HTML.
std::string html(std::string_view text) {
  return xmlText(plainLine(text));
}

/// Returns the text cut where a character ends.
std::string shortened(std::string text) {
  if (text.size() <= longestField)
    return text;
  std::size_t end = longestField;
  while (end > 0 && (std::uint8_t(text[end]) & 0xC0) == 0x80)
    --end;
  return text.substr(0, end);
}

Json imageFile(const QuestionPicture& picture) {
  return {{"path", "images/" + picture.name},
          {"mime", "image/png"},
          {"width", picture.size.x},
          {"height", picture.size.y},
          {"copyright", {{"license", "U"}}}};
}

class Content {
 public:
  Content(const QuestionBook& book, const QuestionKinds& kinds)
      : m_book(book), m_kinds(kinds), m_words(packageWords(book.language)) {}

  std::vector<model::ZipMember> members() {
    for (const QuestionSheet& sheet : m_book.sheets)
      for (const SheetThing& thing : sheet.things)
        addThing(sheet, thing);
    const Json content = assembled();
    std::vector<model::ZipMember> all{{"h5p.json", dumped(manifest())},
                                      {"content/content.json", dumped(content)}};
    all.insert(all.end(), m_pictures.begin(), m_pictures.end());
    return all;
  }

 private:
  static std::string dumped(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  void addThing(const QuestionSheet& sheet, const SheetThing& thing) {
    if (m_kinds.find && isFoundByPlace(thing))
      m_hotspots.push_back(hotspotQuestion(sheet, thing));
    else if (m_kinds.find && hasNumberChoice(thing))
      m_questions.push_back(numberChoice(sheet, thing));
    if (const std::string answers = blankOf(thing); m_kinds.name && !answers.empty())
      m_questions.push_back(blank(sheet, thing, answers));
    if (m_kinds.choose && hasChoice(thing))
      m_questions.push_back(nameChoice(sheet, thing));
  }

  Json content(const Library& library, const std::string& id, Json params) {
    use(library);
    return {
        {"library", library.versioned()},
        {"params", std::move(params)},
        {"subContentId", uuidOf(id)},
        {"metadata", {{"contentType", library.title}, {"license", "U"}, {"title", library.title}}}};
  }

  void use(const Library& library) {
    if (std::find(m_used.begin(), m_used.end(), &library) == m_used.end())
      m_used.push_back(&library);
  }

  void addPicture(const QuestionPicture& picture) {
    if (m_names.insert(picture.name).second)
      m_pictures.push_back({"content/images/" + picture.name, picture.png});
  }

  /// Returns the picture as it stands above a question.
  Json media(const QuestionPicture& picture, const std::string& shows, const std::string& id) {
    addPicture(picture);
    return {{"type", content(image, id + "-image",
                             {{"contentName", "Image"},
                              {"file", imageFile(picture)},
                              {"alt", plainLine(shows)},
                              {"decorative", shows.empty()}})},
            {"disableImageZooming", false}};
  }

  static Json spot(const QuestionZone::Box& box, bool right, const char* feedback) {
    return {{"userSettings", {{"correct", right}, {"feedbackText", feedback}}},
            {"computedSettings",
             {{"x", 100.0 * double(box.low.x)},
              {"y", 100.0 * double(box.low.y)},
              {"width", 100.0 * double(box.high.x - box.low.x)},
              {"height", 100.0 * double(box.high.y - box.low.y)},
              {"figure", "rectangle"}}}};
  }

  Json hotspotQuestion(const QuestionSheet& sheet, const SheetThing& thing) {
    addPicture(sheet.ground);
    Json spots = Json::array();
    for (const SheetThing& each : sheet.things)
      for (const QuestionZone::Box& box : each.zone.boxes)
        spots.push_back(
            spot(box, &each == &thing, &each == &thing ? m_words.right : m_words.wrong));
    return content(hotspot, thing.id + "-find",
                   {{"imageHotspotQuestion",
                     {{"backgroundImageSettings", {{"backgroundImage", imageFile(sheet.ground)}}},
                      {"hotspotSettings",
                       {{"taskDescription", html(withName(m_words.find, thing.words))},
                        {"hotspot", spots},
                        {"noneSelectedFeedback", m_words.missed},
                        {"showFeedbackAsPopup", true},
                        {"l10n", {{"retryText", m_words.again}, {"closeText", "OK"}}}}}}}});
  }

  Json choice(const std::string& id, const std::string& prompt, const Json& above,
              const std::vector<std::pair<std::string, bool>>& texts) {
    Json answers = Json::array();
    for (const auto& [text, right] : texts)
      answers.push_back({{"text", "<div>" + html(text) + "</div>"}, {"correct", right}});
    return content(multiChoice, id,
                   {{"media", above},
                    {"question", "<p>" + html(prompt) + "</p>"},
                    {"answers", answers},
                    {"UI",
                     {{"checkAnswerButton", m_words.check},
                      {"showSolutionButton", m_words.solution},
                      {"tryAgainButton", m_words.again}}},
                    {"behaviour",
                     {{"enableRetry", true},
                      {"enableSolutionsButton", true},
                      {"type", "single"},
                      {"singlePoint", true},
                      {"randomAnswers", true}}}});
  }

  Json numberChoice(const QuestionSheet& sheet, const SheetThing& thing) {
    std::vector<std::pair<std::string, bool>> texts{{numberText(thing), true}};
    for (const std::size_t other : thing.others)
      if (!sheet.things[other].numbers.empty())
        texts.emplace_back(numberText(sheet.things[other]), false);
    const std::string id = thing.id + "-number";
    return choice(id, withName(m_words.whichNumber, thing.words),
                  media(sheet.numbered, sheet.shows, id), texts);
  }

  Json nameChoice(const QuestionSheet& sheet, const SheetThing& thing) {
    std::vector<std::pair<std::string, bool>> texts{{thing.words, true}};
    for (const std::string& other : thing.wrong)
      texts.emplace_back(other, false);
    const std::string id = thing.id + "-choose";
    return choice(id, m_words.chooseIt, media(thing.marked, sheet.shows, id), texts);
  }

  /// Returns the names as a blank has them; empty where the first cannot stand there.
  static std::string blankOf(const SheetThing& thing) {
    std::string names;
    for (const std::string& name : thing.accepted) {
      const bool clear = name.find_first_of("*/:\\") == std::string::npos;
      if (!clear && names.empty())
        return {};
      if (clear)
        names += (names.empty() ? "" : "/") + html(name);
    }
    return names;
  }

  Json blank(const QuestionSheet& sheet, const SheetThing& thing, const std::string& answers) {
    const std::string id = thing.id + "-name";
    return content(blanks, id,
                   {{"media", media(thing.marked, sheet.shows, id)},
                    {"text", "<p>" + html(m_words.nameIt) + "</p>"},
                    {"questions", Json::array({"<p>*" + answers + "*</p>"})},
                    {"checkAnswer", m_words.check},
                    {"showSolutions", m_words.solution},
                    {"tryAgain", m_words.again},
                    {"behaviour",
                     {{"enableRetry", true},
                      {"enableSolutionsButton", true},
                      {"caseSensitive", false},
                      {"acceptSpellingErrors", true},
                      {"showSolutionsRequiresInput", true},
                      {"separateLines", false},
                      {"autoCheck", false}}}});
  }

  /// Returns the content of the main library, which is then the first of those used.
  Json assembled() {
    Json set{{"introPage", {{"showIntroPage", false}}},
             {"progressType", "dots"},
             {"passPercentage", m_book.passing},
             {"questions", m_questions}};
    if (m_hotspots.empty()) {
      m_main = &questionSet;
      return set;
    }
    m_main = &column;
    if (!m_questions.empty())
      m_hotspots.push_back(content(questionSet, "set", set));
    Json parts = Json::array();
    for (const Json& each : m_hotspots)
      parts.push_back({{"content", each}, {"useSeparator", "auto"}});
    return {{"content", parts}};
  }

  Json manifest() {
    use(*m_main);
    Json dependencies = Json::array();
    for (const Library* library : m_used)
      dependencies.push_back({{"machineName", library->name},
                              {"majorVersion", library->major},
                              {"minorVersion", library->minor}});
    const std::string primary = m_book.language.substr(0, m_book.language.find_first_of("-_+"));
    std::string title = shortened(plainLine(m_book.title));
    if (title.empty())
      title = "Sline";
    Json json{{"title", title},
              {"language", primary.empty() ? "und" : primary.substr(0, 10)},
              {"mainLibrary", m_main->name},
              {"embedTypes", {"div"}},
              {"license", "U"},
              {"preloadedDependencies", dependencies}};
    const ExportCredit& credit = m_book.credit;
    if (!credit.author.empty())
      json["authors"] = {{{"name", shortened(credit.author)}, {"role", "Author"}}};
    if (!credit.copyright.empty())
      json["licenseExtras"] = credit.copyright;
    return json;
  }

  const QuestionBook& m_book;
  const QuestionKinds& m_kinds;
  const PackageWords& m_words;
  std::vector<Json> m_hotspots;
  std::vector<Json> m_questions;
  std::vector<const Library*> m_used;
  const Library* m_main = &column;
  std::vector<model::ZipMember> m_pictures;
  std::set<std::string> m_names;
};

}  // namespace

std::vector<model::ZipMember> h5pPackage(const QuestionBook& book, const QuestionKinds& kinds) {
  return Content(book, kinds).members();
}

std::vector<std::string> shortenedInH5p(const QuestionBook& book) {
  std::vector<std::string> texts;
  for (const std::string& text : {plainLine(book.title), book.credit.author})
    if (text.size() > longestField)
      texts.push_back(text);
  return texts;
}

}  // namespace sline::render
