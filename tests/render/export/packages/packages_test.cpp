// SPDX-License-Identifier: Apache-2.0
// Tests what learning systems are given: each question can be answered, has one right answer, and
// its picture names nothing.
#include <QByteArray>
#include <QImage>
#include <QtTest>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>

#include "model/camera/camera.h"
#include "render/export/packages/accepted_names.h"
#include "render/export/packages/h5p_package.h"
#include "render/export/packages/moodle_quiz.h"
#include "render/export/packages/page_package.h"
#include "render/export/packages/qti_package.h"
#include "render/export/students/accepted_answers.h"
#include "render/export/students/students_options.h"
#include "tests/render/export/packages/asked_scene.h"
#include "tests/support/suite.h"

using namespace sline;
using nlohmann::json;

namespace {

using Members = std::map<std::string, std::string>;

Members byName(const std::vector<model::ZipMember>& members) {
  Members all;
  for (const model::ZipMember& member : members)
    all[member.name] = member.bytes;
  return all;
}

QImage imageFrom(const std::string& png) {
  return QImage::fromData(QByteArray::fromStdString(png));
}

/// Returns what a browser would show of an HTML fragment, and how many elements it has.
std::pair<QString, int> shownHtml(const std::string& html) {
  pugi::xml_document parsed;
  QString closed = QString::fromStdString("<r>" + html + "</r>");
  closed.replace(QRegularExpression("(<img [^<>]*[^/])>"), "\\1/>");
  if (!parsed.load_string(closed.toUtf8().constData()))
    return {"no HTML: " + closed, -1};
  QString text;
  for (const auto& node : parsed.select_nodes("//text()"))
    text += QString::fromUtf8(node.node().value());
  return {text, int(parsed.select_nodes("//r//*").size())};
}

std::vector<glm::vec2> polygonIn(QString text) {
  const QStringList numbers = text.replace(';', ',').split(',');
  std::vector<glm::vec2> corners;
  for (qsizetype i = 0; i + 1 < numbers.size(); i += 2)
    corners.emplace_back(numbers[i].toFloat(), numbers[i + 1].toFloat());
  return corners;
}

}  // namespace

class PackagesTest : public QObject {
  Q_OBJECT

  render::QuestionBook m_book;

  const render::QuestionSheet& sheet() const { return m_book.sheets.front(); }
  const render::SheetThing& thing(const char* words) const {
    for (const render::SheetThing& each : sheet().things)
      if (each.words == words)
        return each;
    qFatal("nothing is called %s", words);
  }

 private slots:
  void initTestCase() {
    render::ExportOrder order = test::askedOrder();
    order.credit = {"Jane <b>Doe", "CC BY & 4.0"};
    const auto book = render::pictureQuestions(order, {});
    QVERIFY2(book.ok(), book.ok() ? "" : book.error().text().c_str());
    m_book = *book;
    QCOMPARE(m_book.sheets.size(), std::size_t(1));
  }

  void asksForWhatIsSeen() {
    QStringList asked;
    std::vector<int> numbers;
    for (const render::SheetThing& each : sheet().things) {
      asked << QString::fromStdString(each.words);
      numbers.insert(numbers.end(), each.numbers.begin(), each.numbers.end());
    }
    // In the order of their numbers, as one reads them from the left.
    QCOMPARE(numbers, (std::vector<int>{1, 2, 3}));
    QCOMPARE(asked.front(), QString("liver"));
    asked.sort();
    QCOMPARE(asked, QStringList({test::hostileLabel, "left kidney", "liver"}));
    for (const render::SheetThing& each : sheet().things) {
      QVERIFY(each.zone.canBeHit());
      QCOMPARE(each.others.size(), std::size_t(2));
      // The spleen is there, though nobody sees it.
      QCOMPARE(each.wrong.size(), std::size_t(3));
      QVERIFY(std::find(each.wrong.begin(), each.wrong.end(), each.words) == each.wrong.end());
      for (const std::size_t other : each.others)
        QVERIFY(&sheet().things[other] != &each);
    }
    QVERIFY(!QString::fromStdString(sheet().shows).contains("liver"));
  }

  void zonesAreWhereTheThingsAre() {
    // The patient's left is at the right hand.
    const std::map<const char*, glm::vec2> places{{"left kidney", {0.75f, 0.5f}},
                                                  {test::hostileLabel, {0.5f, 0.5f}},
                                                  {"liver", {0.25f, 0.5f}}};
    for (const auto& [own, zone] : places)
      for (const auto& [other, place] : places) {
        const bool within = render::isWithin(thing(own).zone.outline, place);
        QVERIFY2(within == (own == other), own);
      }
  }

  void picturesNameNothing() {
    std::set<std::string> names;
    for (const render::QuestionPicture* picture :
         {&sheet().ground, &sheet().small, &sheet().numbered, &thing("liver").marked,
          &thing("left kidney").marked}) {
      QVERIFY(names.insert(picture->name).second);
      const QImage image = imageFrom(picture->png);
      QCOMPARE(image.size(), QSize(picture->size.x, picture->size.y));
      for (const QString& key : image.textKeys())
        for (const char* word : {"kidney", "liver", "onerror", "Lobus"})
          QVERIFY2(!image.text(key).contains(word), qPrintable(image.text(key)));
      QVERIFY(image.text("Author").contains("Jane"));
    }
    QVERIFY(sheet().small.size.x <= 600 && sheet().small.size.y <= 400);
  }

  void answersAreTolerant() {
    const std::vector<std::string>& names = thing("left kidney").accepted;
    // A side belongs to the answer wherever there are two, by whatever name.
    const std::vector<std::string> hip =
        render::ownAnswers({{"de", "linkes Hüftbein"}, {"en", "left hip bone"}}, {});
    const auto isRight = [&hip](const char* name) {
      return std::find(hip.begin(), hip.end(), name) != hip.end();
    };
    for (const char* sided : {"left hip bone", "left hip", "left pelvic bone", "linkes Hüftbein"})
      QVERIFY2(isRight(sided), sided);
    for (const char* bare : {"hip", "pelvic bone", "hip bone", "Hüftbein", "os coxae"})
      QVERIFY2(!isRight(bare), bare);
    QCOMPARE(names.front(), std::string("left kidney"));
    // No system tells capitals from small letters.
    for (const char* name : {"Ren sinister", "linke Niere", "venstre nyre"})
      QVERIFY2(std::any_of(names.begin(), names.end(),
                           [name](const std::string& each) {
                             return QString::fromStdString(each).toCaseFolded() ==
                                    QString(name).toCaseFolded();
                           }),
               name);
    std::set<QString> folded;
    for (const std::string& name : names)
      QVERIFY(folded.insert(QString::fromStdString(name).toCaseFolded()).second);
    QCOMPARE(render::withoutAccents("Übergang æ ß é"), std::string("Ubergang ae ss e"));
  }

  void moodleHasOneRightAnswer() {
    const std::string xml = render::moodleQuiz(m_book, {});
    pugi::xml_document quiz;
    QVERIFY(quiz.load_string(xml.c_str()));
    const auto count = [&](const char* type) {
      return quiz.select_nodes(("/quiz/question[@type='" + std::string(type) + "']").c_str())
          .size();
    };
    QCOMPARE(count("ddmarker"), std::size_t(3));
    QCOMPARE(count("shortanswer"), std::size_t(3));
    QCOMPARE(count("multichoice"), std::size_t(3));
    QCOMPARE(count("category"), std::size_t(1));
    // A slash would part categories.
    QCOMPARE(QString(quiz.select_node("/quiz/question/category/text").node().text().get()),
             QString("$course$/top/Lobus liver // front"));
    for (const auto& each : quiz.select_nodes("/quiz/question[@type='multichoice']")) {
      QCOMPARE(each.node().select_nodes("answer[@fraction='100']").size(), std::size_t(1));
      QCOMPARE(each.node().select_nodes("answer").size(), std::size_t(4));
    }
    for (const auto& each : quiz.select_nodes("/quiz/question[@type='shortanswer']/answer"))
      QCOMPARE(QString(each.node().attribute("fraction").value()), QString("100"));
    for (const auto& each : quiz.select_nodes("//file")) {
      const QByteArray png = QByteArray::fromBase64(each.node().text().get());
      QVERIFY(!QImage::fromData(png).isNull());
    }
  }

  void moodleMarkersHaveTheirZones() {
    pugi::xml_document quiz;
    QVERIFY(quiz.load_string(render::moodleQuiz(m_book, {}).c_str()));
    const auto found = quiz.select_nodes("/quiz/question[@type='ddmarker']");
    // The balls, by what they are called; questions come in the order of the numbers.
    const std::map<std::string, float> balls{
        {"liver", 0.25f}, {test::hostileLabel, 0.5f}, {"left kidney", 0.75f}};
    QCOMPARE(std::size_t(found.size()), balls.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const pugi::xml_node question = found[i].node();
      const QImage image =
          QImage::fromData(QByteArray::fromBase64(question.child("file").text().get()));
      QVERIFY(image.width() <= 600 && image.height() <= 400);
      const auto corners = polygonIn(question.select_node("drop/coords").node().text().get());
      QVERIFY(corners.size() >= 3);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        QVERIFY(corners[k].x <= float(image.width()) && corners[k].y <= float(image.height()));
        QVERIFY(corners[k] != corners[(k + 1) % corners.size()]);
      }
      for (const auto& [words, at] : balls)
        QCOMPARE(
            render::isWithin(corners, {at * float(image.width()), 0.5f * float(image.height())}),
            words == sheet().things[i].words);
    }
  }

  void moodleTextsStayTexts() {
    pugi::xml_document quiz;
    QVERIFY(quiz.load_string(render::moodleQuiz(m_book, {}).c_str()));
    int seen = 0;
    for (const auto& each : quiz.select_nodes("//*[@format='html']/text | //drag/text")) {
      const auto [text, elements] = shownHtml(each.node().text().get());
      QVERIFY2(elements >= 0 && elements <= 3, qPrintable(text));
      seen += text.contains(test::hostileLabel);
    }
    QVERIFY(seen >= 6);
    // A star in a short answer stands for any text, unless it is escaped.
    for (const auto& each : quiz.select_nodes("//question[@type='shortanswer']/answer/text"))
      QVERIFY(!QString(each.node().text().get()).contains(QRegularExpression("(^|[^\\\\])\\*")));
  }

  void kindsOfQuestionsAreChosen() {
    const auto types = [&](const render::QuestionKinds& chosen) {
      pugi::xml_document quiz;
      std::set<std::string> all;
      if (quiz.load_string(render::moodleQuiz(m_book, chosen).c_str()))
        for (const auto& each : quiz.select_nodes("/quiz/question[@type!='category']"))
          all.insert(each.node().attribute("type").value());
      return all;
    };
    QCOMPARE(types({.name = false, .choose = false}), (std::set<std::string>{"ddmarker"}));
    QCOMPARE(types({.find = false, .choose = false}), (std::set<std::string>{"shortanswer"}));
    QCOMPARE(types({.find = false, .name = false}), (std::set<std::string>{"multichoice"}));
  }

  void whatCannotBeHitHasANumber() {
    render::QuestionBook thin = m_book;
    thin.sheets.front().things.front().zone.thickness = 0.001f;
    pugi::xml_document quiz;
    QVERIFY(quiz.load_string(render::moodleQuiz(thin, {.name = false, .choose = false}).c_str()));
    const pugi::xml_node question = quiz.select_node("/quiz/question[@type='multichoice']").node();
    const QString right = question.select_node("answer[@fraction='100']/text").node().text().get();
    QCOMPARE(right, QString::number(thin.sheets.front().things.front().numbers.front()));
    QCOMPARE(question.select_nodes("answer").size(), std::size_t(3));
  }

  void qtiIsComplete() {
    const Members members = byName(render::qtiPackage(m_book, {}));
    pugi::xml_document manifest;
    QVERIFY(manifest.load_string(members.at("imsmanifest.xml").c_str()));
    std::set<std::string> listed{"imsmanifest.xml"};
    for (const auto& each : manifest.select_nodes("//file/@href"))
      listed.insert(each.attribute().value());
    std::set<std::string> there;
    for (const auto& [name, bytes] : members)
      there.insert(name);
    QCOMPARE(listed, there);
    std::set<std::string> ids;
    for (const auto& each : manifest.select_nodes("//resource/@identifier"))
      QVERIFY(ids.insert(each.attribute().value()).second);
    for (const auto& each : manifest.select_nodes("//dependency/@identifierref"))
      QVERIFY(ids.contains(each.attribute().value()));
    QVERIFY(members.at("imsmanifest.xml").find("Jane &lt;b&gt;Doe") != std::string::npos);
    pugi::xml_document test;
    QVERIFY(test.load_string(members.at("test.xml").c_str()));
    QCOMPARE(test.select_nodes("//assessmentItemRef").size(), std::size_t(9));
    for (const auto& each : test.select_nodes("//assessmentItemRef/@href"))
      QVERIFY(members.contains(each.attribute().value()));
  }

  void qtiItemsCanBeAnswered() {
    std::map<std::string, int> interactions;
    for (const auto& [name, bytes] : byName(render::qtiPackage(m_book, {}))) {
      pugi::xml_document item;
      if (!name.starts_with("items/"))
        continue;
      QVERIFY(item.load_string(bytes.c_str()));
      const std::string right = item.select_node("//correctResponse/value").node().text().get();
      const pugi::xml_node asked = item.select_node("//*[@responseIdentifier='RESPONSE']").node();
      ++interactions[asked.name()];
      std::set<std::string> choices;
      for (const auto& each : asked.select_nodes("*[@identifier]"))
        QVERIFY(choices.insert(each.node().attribute("identifier").value()).second);
      if (std::string(asked.name()) != "textEntryInteraction")
        QVERIFY2(choices.size() >= 3 && choices.contains(right), name.c_str());
      std::set<std::string> mapped;
      for (const auto& each : item.select_nodes("//mapEntry"))
        QVERIFY(mapped.insert(each.node().attribute("mapKey").value()).second);
      QCOMPARE(mapped.contains(right), std::string(asked.name()) == "textEntryInteraction");
      // Neither the title nor a picture gives the answer away, and texts are texts.
      QVERIFY(QString(item.child("assessmentItem").attribute("title").value()).toInt() > 0);
      QCOMPARE(item.select_nodes("//*[@onerror] | //script").size(), std::size_t(0));
      for (const auto& each : item.select_nodes("//hotspotChoice[@coords]"))
        QVERIFY(polygonIn(each.node().attribute("coords").value()).size() >= 3);
    }
    QCOMPARE(interactions, (std::map<std::string, int>{{"choiceInteraction", 3},
                                                       {"hotspotInteraction", 3},
                                                       {"textEntryInteraction", 3}}));
  }

  void h5pIsContentAlone() {
    const Members members = byName(render::h5pPackage(m_book, {}));
    const json manifest = json::parse(members.at("h5p.json"));
    QCOMPARE(QString::fromStdString(manifest["mainLibrary"]), QString("H5P.Column"));
    QVERIFY(QRegularExpression("^[-a-zA-Z]{1,10}$")
                .match(QString::fromStdString(manifest["language"]))
                .hasMatch());
    QCOMPARE(manifest["authors"][0]["name"], json("Jane <b>Doe"));
    std::set<std::string> stated;
    for (const json& each : manifest["preloadedDependencies"])
      stated.insert(each["machineName"].get<std::string>() + ' ' +
                    std::to_string(each["majorVersion"].get<int>()) + '.' +
                    std::to_string(each["minorVersion"].get<int>()));
    const std::string content = members.at("content/content.json");
    std::set<std::string> used;
    const QRegularExpression library("\"library\":\"([^\"]+)\"");
    for (auto each = library.globalMatch(QString::fromStdString(content)); each.hasNext();)
      used.insert(each.next().captured(1).toStdString());
    used.insert("H5P.Column 1.16");
    QCOMPARE(used, stated);
    const QRegularExpression path("\"path\":\"([^\"]+)\"");
    for (auto each = path.globalMatch(QString::fromStdString(content)); each.hasNext();)
      QVERIFY(members.contains("content/" + each.next().captured(1).toStdString()));
    for (const auto& [name, bytes] : members)
      QVERIFY2(name == "h5p.json" || name.starts_with("content/"), name.c_str());
  }

  void h5pQuestionsCanBeAnswered() {
    const json content =
        json::parse(byName(render::h5pPackage(m_book, {})).at("content/content.json"));
    std::map<std::string, int> kinds;
    for (const json& part : content["content"]) {
      const json& params = part["content"]["params"];
      if (!params.contains("imageHotspotQuestion")) {
        for (const json& each : params["questions"])
          ++kinds[each["library"].get<std::string>()];
        continue;
      }
      ++kinds["hotspot"];
      const json& settings = params["imageHotspotQuestion"]["hotspotSettings"];
      int right = 0;
      for (const json& spot : settings["hotspot"]) {
        const json& place = spot["computedSettings"];
        right += int(spot["userSettings"]["correct"].get<bool>());
        QVERIFY(place["x"] >= 0.0 && place["y"] >= 0.0);
        QVERIFY(place["x"].get<double>() + place["width"].get<double>() <= 100.01);
        QVERIFY(place["y"].get<double>() + place["height"].get<double>() <= 100.01);
      }
      QVERIFY(right >= 1 && right < int(settings["hotspot"].size()));
      QVERIFY(shownHtml(settings["taskDescription"].get<std::string>()).second == 0);
    }
    // A blank cannot have the signs that part answers there.
    QCOMPARE(kinds, (std::map<std::string, int>{
                        {"H5P.Blanks 1.14", 2}, {"H5P.MultiChoice 1.16", 3}, {"hotspot", 3}}));
  }

  void pagesHaveManifests_data() {
    QTest::addColumn<int>("standard");
    QTest::addColumn<QString>("manifest");
    QTest::addColumn<QString>("start");
    QTest::addColumn<QString>("passing");
    const auto row = [](render::PageStandard standard, const char* file, const char* start,
                        const char* passing) {
      QTest::newRow(render::reportName(standard)) << int(standard) << file << start << passing;
    };
    row(render::PageStandard::scorm12, "imsmanifest.xml",
        "//resource[@adlcp:scormtype='sco']/@href", "//adlcp:masteryscore[.='65']");
    row(render::PageStandard::scorm2004, "imsmanifest.xml",
        "//resource[@adlcp:scormType='sco']/@href", "//imsss:minNormalizedMeasure[.='0.65']");
    row(render::PageStandard::cmi5, "cmi5.xml", "//au/url", "//au[@masteryScore='0.65']");
  }
  void pagesHaveManifests() {
    QFETCH(int, standard);
    QFETCH(QString, manifest);
    QFETCH(QString, start);
    QFETCH(QString, passing);
    const Members page{{"index.html", "<p>"}, {"page.js", ";"}, {"a & b.scene", "x"}};
    const render::PageAbout about{
        .title = test::hostileLabel, .language = "de", .credit = {"Jane", "CC"}, .passing = 0.65};
    const Members members =
        byName(render::pagePackage(render::PageStandard(standard), page, about));
    QCOMPARE(members.size(), page.size() + 1);
    pugi::xml_document parsed;
    QVERIFY(parsed.load_string(members.at(manifest.toStdString()).c_str()));
    const auto found = parsed.select_node(start.toUtf8().constData());
    QCOMPARE(QString(found.attribute() ? found.attribute().value() : found.node().text().get()),
             QString("index.html"));
    QVERIFY(parsed.select_node(passing.toUtf8().constData()));
    if (manifest == "imsmanifest.xml")
      for (const auto& [name, bytes] : page)
        QVERIFY2(parsed.select_node(("//file[@href='" + name + "']").c_str()), name.c_str());
    const std::string& xml = members.at(manifest.toStdString());
    QVERIFY(xml.find("&lt;img src=x") != std::string::npos);
    QVERIFY(xml.find("Jane") != std::string::npos);
    // The same page has the same identifier, another another.
    QCOMPARE(byName(render::pagePackage(render::PageStandard(standard), page, about)), members);
    Members other = page;
    other["page.js"] = "x";
    QVERIFY(byName(render::pagePackage(render::PageStandard(standard), other, about))
                .at(manifest.toStdString()) != xml);
  }

  void nothingToAskIsAnError() {
    render::ExportOrder bare = test::askedOrder();
    bare.scene.setAnnotations({});
    QVERIFY(!render::pictureQuestions(bare, {}).ok());
    render::ExportOrder none = test::askedOrder();
    auto& kinds = none.of<render::StudentsOptions>();
    kinds.find = kinds.name = kinds.choose = false;
    QVERIFY(!render::pictureQuestions(none, {}).ok());
  }
};

SLINE_TEST(PackagesTest)
#include "packages_test.moc"
