// SPDX-License-Identifier: Apache-2.0
// Tests the questions of a students' page: what is asked, which answers are right and that wrong
// ones are none of them.
#include <algorithm>
#include <array>
#include <set>

#include "model/edit/views.h"
#include "render/export/order/test_options.h"
#include "render/export/students/answer_hash.h"
#include "tests/render/export/slides/lesson.h"
#include "tests/render/export/students/page_parts.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

using nlohmann::json;

/// Returns balls with names and, except for those without, labels that say the same.
render::ExportOrder named(const std::vector<std::string>& names, bool labels = true) {
  render::ExportOrder order = lessonOf(names);
  if (!labels)
    order.scene.setAnnotations({});
  return order;
}

/// Returns the questions of that kind as they come.
std::vector<json> questionsOnPage(const render::ExportOrder& order, const std::string& kind,
                                  const render::StudentsOptions& own = {.title = "Lesson"}) {
  std::vector<json> all;
  const json facts = factsOf(pageOf(order, own).html);
  for (const json& question : facts["quiz"]["questions"])
    if (question["kind"] == kind)
      all.push_back(question);
  return all;
}

/// Returns the questions of that kind in the order in which the scene has what they ask for.
std::vector<json> questionsOf(const render::ExportOrder& order, const std::string& kind,
                              const render::StudentsOptions& own = {.title = "Lesson"}) {
  std::vector<json> all = questionsOnPage(order, kind, own);
  std::stable_sort(all.begin(), all.end(),
                   [](const json& a, const json& b) { return a["structures"] < b["structures"]; });
  return all;
}

/// Returns a group of tubes along x, named so; each is shorter and thinner by a share.
render::ExportOrder tubes(const std::vector<std::string>& names, float step = 40.0f) {
  render::ExportOrder order;
  model::Node group;
  group.name = "Arteries";
  const model::NodeId parent = order.scene.append(group);
  for (std::size_t i = 0; i < names.size(); ++i) {
    model::Node node;
    node.name = names[i];
    node.parent = parent;
    node.mesh = moved(*cylinder(5.0f - float(i), 40.0f, 24, 20), 1.0f, {0, 0, step * float(i)});
    order.scene.append(std::move(node));
  }
  fitCamera(order);
  return order;
}

}  // namespace

class PageQuizTest : public QObject {
  Q_OBJECT

 private slots:
  /// What may be on the other side than its name says is listed with a mark, and never asked for.
  void doubtedNames() {
    for (const bool labels : {true, false}) {
      render::ExportOrder order =
          named({"left kidney", "spleen", "stomach", "pancreas", "duodenum"}, labels);
      std::vector<model::Node> nodes = order.scene.nodes();
      nodes[0].provenance.nameEvidence = model::Evidence::conflict;
      order.scene.setNodes(nodes);
      const json facts = factsOf(pageOf(order, {.title = "Lesson"}).html);
      QVERIFY(!facts["quiz"]["questions"].empty());
      for (const json& question : facts["quiz"]["questions"])
        for (const json& structure : question["structures"])
          QVERIFY(structure != json(nodes[0].id.value));
      for (const json& node : facts["nodes"])
        QCOMPARE(node["names"]["en"].get<std::string>().ends_with("(?)"),
                 node["id"] == json(nodes[0].id.value));
    }
  }
  void kinds() {
    const std::vector<std::string> names{"liver", "spleen", "stomach", "pancreas", "duodenum"};
    const render::ExportOrder order = named(names);
    for (const char* kind : {"find", "name", "choose"}) {
      const std::vector<json> asked = questionsOf(order, kind);
      QCOMPARE(asked.size(), names.size());
      QCOMPARE(asked[0]["structures"], json({order.scene.nodes()[0].id.value}));
      QCOMPARE(asked[0]["labels"], json({order.scene.annotations()[0].id.value}));
      QCOMPARE(asked[0]["words"]["de"], json("Leber"));
    }
    QVERIFY(questionsOf(order, "find")[0]["answers"].empty());
    const std::vector<json> dragged = questionsOf(order, "drag");
    QCOMPARE(dragged.size(), std::size_t(1));
    QCOMPARE(dragged[0]["structures"].size(), names.size());
    QCOMPARE(dragged[0]["labels"].size(), names.size());
    const auto spleen = std::find(dragged[0]["labels"].begin(), dragged[0]["labels"].end(),
                                  json(order.scene.annotations()[1].id.value));
    QCOMPARE(dragged[0]["choices"][std::size_t(spleen - dragged[0]["labels"].begin())]["en"],
             json("spleen"));
    QVERIFY(questionsOf(order, "order").empty());
    std::set<std::string> ids;
    const json facts = factsOf(pageOf(order).html);
    for (const json& question : facts["quiz"]["questions"])
      QVERIFY(ids.insert(question["id"].get<std::string>()).second);
  }

  /// Questions come as one reads the labels' numbers, whatever was labelled first; those of one
  /// view after those of another.
  void inTheOrderOfNumbers() {
    render::ExportOrder order = named({"liver", "spleen", "stomach", "pancreas"});
    const auto namesOf = [](const std::vector<json>& questions) {
      QStringList names;
      for (const json& question : questions)
        names << QString::fromStdString(question["words"]["en"].get<std::string>());
      return names;
    };
    const QStringList read = namesOf(questionsOnPage(order, "name"));
    // Two columns of two.
    QCOMPARE(read, QStringList({"liver", "stomach", "spleen", "pancreas"}));
    std::vector<model::Annotation> annotations = order.scene.annotations();
    std::reverse(annotations.begin(), annotations.end());
    order.scene.setAnnotations(annotations);
    for (const char* kind : {"find", "name", "choose"})
      QCOMPARE(namesOf(questionsOnPage(order, kind)), read);
    std::vector<model::View> views;
    addView(order, views, "First").annotations = {{annotations[0].id, annotations[3].id}};
    addView(order, views, "All");
    order.scene.setViews(views);
    QCOMPARE(namesOf(questionsOnPage(order, "name")),
             QStringList({"liver", "pancreas", "stomach", "spleen"}));
  }

  void choicesOfTheTeacher() {
    const render::ExportOrder order = named({"liver", "spleen", "stomach"});
    const auto quiz = [&order](const render::StudentsOptions& own) {
      return factsOf(pageOf(order, own).html)["quiz"];
    };
    QVERIFY(quiz({.quiz = render::QuizMode::off})["questions"].empty());
    QCOMPARE(quiz({.quiz = render::QuizMode::off})["mode"], json("off"));
    const json few = quiz({.find = false,
                           .name = false,
                           .drag = false,
                           .counts = false,
                           .lockCamera = true,
                           .lockLook = true});
    QCOMPARE(few["questions"].size(), std::size_t(3));
    QCOMPARE(few["questions"][0]["kind"], json("choose"));
    QCOMPARE(few["counts"], json(false));
    QCOMPARE(few["lockCamera"], json(true));
    QCOMPARE(few["lockLook"], json(true));
    render::ExportOrder some = order;
    some.of<render::TestOptions>().names = "spleen";
    QCOMPARE(questionsOf(some, "find").size(), std::size_t(1));
  }

  /// Each name of the structure in any of the languages is right, and hashed.
  void answers() {
    const render::ExportOrder order = named({"left kidney", "my own thing"});
    const json quiz = factsOf(pageOf(order).html)["quiz"];
    const std::string salt = quiz["salt"];
    QCOMPARE(salt.size(), std::size_t(16));
    const std::vector<json> asked = questionsOf(order, "name");
    const auto accepts = [&salt](const json& question, const char* name) {
      const json& answers = question["answers"];
      return std::find(answers.begin(), answers.end(), render::answerHash(salt, name)) !=
             answers.end();
    };
    for (const char* name :
         {"left kidney", "Left Kidney ", "linke Niere", "ren sinister", "venstre nyre"})
      QVERIFY2(accepts(asked[0], name), name);
    for (const char* name : {"kidney", "right kidney", "my own thing", ""})
      QVERIFY2(!accepts(asked[0], name), name);
    QVERIFY(accepts(asked[1], "My own thing"));
  }

  /// Anatomists abbreviate the kind and leave it out; a side is never left out, nor the kind where
  /// another structure is called so, too.
  void abbreviations_data() {
    QTest::addColumn<int>("asked");
    QTest::addColumn<QStringList>("right");
    QTest::addColumn<QStringList>("wrong");
    QTest::newRow("artery beside its vein")
        << 0 << QStringList{"left common iliac artery",   "A. iliaca communis sinistra",
                            "a iliaca communis sinistra", "Arteria iliaca communis sinistra",
                            "left common iliac a.",       "A. iliaca comm. sin.",
                            "A. iliaca communis sin.",    "linke A. iliaca communis",
                            "li. A. iliaca communis",     "l. common iliac artery"}
        << QStringList{
               "left common iliac",   "iliaca communis sinistra",    "A. iliaca communis",
               "common iliac artery", "V. iliaca communis sinistra", "A. iliaca communis dextra",
               "A. iliaca comm.",     "A. iliaca comm. dext.",       "rechte A. iliaca communis",
               "A. iliaca ext. sin."};
    QTest::newRow("vein") << 1 << QStringList{"V. iliaca communis sinistra", "left common iliac v."}
                          << QStringList{"A. iliaca communis sinistra", "V. iliaca communis"};
    QTest::newRow("nerve alone") << 2
                                 << QStringList{"left femoral nerve", "N. femoralis sinister",
                                                "left femoral n.", "left femoral"}
                                 << QStringList{"femoral", "N. femoralis", "left", "n."};
    QTest::newRow("muscle") << 3
                            << QStringList{"M. psoas major sinister", "left psoas major",
                                           "psoas major sinister", "left psoas major muscle"}
                            << QStringList{"psoas major", "M. psoas major dexter"};
    QTest::newRow("label that abbreviates") << 4
                                            << QStringList{"V. cava inferior", "vena cava inferior",
                                                           "inferior vena cava", "V. cava inf."}
                                            << QStringList{"cava superior", "V. cava"};
  }
  void abbreviations() {
    QFETCH(int, asked);
    QFETCH(QStringList, right);
    QFETCH(QStringList, wrong);
    const render::ExportOrder order =
        named({"left common iliac artery", "left common iliac vein", "left femoral nerve",
               "left psoas major muscle", "V. cava inferior"});
    const json quiz = factsOf(pageOf(order).html)["quiz"];
    const json answers = questionsOf(order, "name")[std::size_t(asked)]["answers"];
    const auto accepts = [&](const QString& name) {
      const std::string hash = render::answerHash(quiz["salt"], name.toStdString());
      return std::find(answers.begin(), answers.end(), hash) != answers.end();
    };
    for (const QString& name : right)
      QVERIFY2(accepts(name), qPrintable(name));
    for (const QString& name : wrong)
      QVERIFY2(!accepts(name), qPrintable(name));
  }

  /// A view is asked for what one sees in it alone: not for what another structure hides, nor for a
  /// sliver of what stands behind one.
  void viewsAreAskedForWhatTheyShow_data() {
    QTest::addColumn<float>("aside");
    QTest::addColumn<bool>("asked");
    QTest::newRow("behind") << 0.0f << false;
    QTest::newRow("a sliver") << 6.2f << false;
    QTest::newRow("half") << 14.0f << true;
  }
  void viewsAreAskedForWhatTheyShow() {
    QFETCH(float, aside);
    QFETCH(bool, asked);
    for (const bool labels : {true, false}) {
      render::ExportOrder order;
      addBall(order.scene, {0.0f, 0.0f, 0.0f}, 16.0f, "liver");
      addBall(order.scene, {aside, 60.0f, 0.0f}, 10.0f, "spleen");
      addBall(order.scene, {60.0f, 0.0f, 0.0f}, 16.0f, "stomach");
      std::vector<model::Node> nodes = order.scene.nodes();
      const std::array<glm::vec3, 3> places{
          glm::vec3(0.0f), {aside, 60.0f, 0.0f}, {60.0f, 0.0f, 0.0f}};
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        nodes[i].style.gamma = Gamma::clamped(5.0f);
        nodes[i].mesh = moved(*sphere(i == 1 ? 10.0f : 16.0f, 4), 1.0f, places[i]);
      }
      order.scene.setNodes(nodes);
      fitCamera(order);
      order.camera.projection = model::Projection::orthographic;
      order.labels.mode = labels ? render::LabelMode::on : render::LabelMode::off;
      if (!labels)
        order.scene.setAnnotations({});
      std::vector<model::View> views;
      addView(order, views, "Front");
      order.scene.setViews(views);
      std::set<std::string> names;
      for (const json& question : questionsOf(order, "name")) {
        names.insert(question["words"]["en"].get<std::string>());
        QCOMPARE(question["view"], json(1));
      }
      const std::set<std::string> wanted = asked
                                               ? std::set<std::string>{"liver", "spleen", "stomach"}
                                               : std::set<std::string>{"liver", "stomach"};
      QVERIFY2(names == wanted, qPrintable(QString::number(int(names.size()))));
    }
  }

  /// Whatever is called, no wrong choice is another name of the right one.
  void distractorsAreNeverRight() {
    const std::vector<std::string> names{
        "left kidney",    "kidney", "right kidney", "Niere",        "liver",
        "hepar",          "liver",  "spleen",       "ren sinister", "left renal artery",
        "urinary bladder"};
    render::ExportOrder order = named(names);
    const json facts = factsOf(pageOf(order).html);
    const std::string salt = facts["quiz"]["salt"];
    std::map<json, json> answers;  // by what is asked for
    for (const json& question : questionsOf(order, "name"))
      answers[question["labels"]] = question["answers"];
    const std::vector<json> asked = questionsOf(order, "choose");
    QVERIFY(asked.size() >= 6);
    for (const json& question : asked) {
      const auto right = question["right"].get<std::size_t>();
      QCOMPARE(question["choices"][right], question["words"]);
      QVERIFY(question["choices"].size() >= 2 && question["choices"].size() <= 4);
      std::set<std::string> said;
      for (std::size_t i = 0; i < question["choices"].size(); ++i)
        for (const auto& [tag, name] : question["choices"][i].items()) {
          const std::string hash = render::answerHash(salt, name.get<std::string>());
          const json& accepted = answers[question["labels"]];
          const bool known = std::find(accepted.begin(), accepted.end(), hash) != accepted.end();
          QVERIFY2(i == right || !known, name.get<std::string>().c_str());
          if (tag == "en")
            QVERIFY2(said.insert(name).second, name.get<std::string>().c_str());
        }
      // A kidney without a side may be the left one.
      if (question["words"]["en"] == "kidney")
        for (const json& choice : question["choices"])
          QVERIFY2(choice["en"] == "kidney" ||
                       choice["en"].get<std::string>().find("kidney") == std::string::npos,
                   choice.dump().c_str());
    }
  }

  /// How a name is written tells nothing: labels are a teacher's, other names come from files.
  void choicesAreWrittenAlike() {
    render::ExportOrder order = named({"Spleen", "left_kidney", "pancreas", "duodenum"});
    std::vector<model::Annotation> labels = order.scene.annotations();
    labels.resize(1);
    order.scene.setAnnotations(labels);
    const std::vector<json> questions = questionsOf(order, "choose");
    QCOMPARE(questions.size(), std::size_t(1));
    std::set<std::string> said;
    for (const json& choice : questions.front()["choices"])
      said.insert(choice["en"].get<std::string>());
    QVERIFY(said == std::set<std::string>({"Spleen", "Left kidney", "Pancreas", "Duodenum"}));
  }

  void neighboursAndKinFirst() {
    // In a grid of two columns the first two are neighbours; the artery is far off.
    render::ExportOrder order = named({"liver", "spleen", "stomach", "pancreas", "aorta"});
    std::vector<model::Node> nodes = order.scene.nodes();
    nodes[4].mesh = moved(*sphere(10.0f, 1), 1.0f, {900.0f, 0.0f, 0.0f});
    order.scene.setNodes(nodes);
    for (const json& question : questionsOf(order, "choose"))
      if (question["words"]["en"] != "aorta")
        for (const json& choice : question["choices"])
          QVERIFY2(choice["en"] != "aorta", question.dump().c_str());
  }

  void labelsOfViews() {
    render::ExportOrder order = named({"liver", "spleen"});
    std::vector<model::Annotation> annotations = order.scene.annotations();
    std::vector<model::View> views;
    addView(order, views, "Both");
    annotations[1].visible = false;
    order.scene.setAnnotations(annotations);
    order.scene.setViews(views);
    const std::vector<json> asked = questionsOf(order, "find");
    QCOMPARE(asked.size(), std::size_t(2));
    QCOMPARE(asked[0]["view"], json(1));
    QCOMPARE(asked[1]["view"], json(1));
  }

  /// Where there is no label, those structures get one that are seen.
  void unlabelled() {
    const render::ExportOrder order = named({"liver", "spleen", "stomach"}, false);
    const json facts = factsOf(pageOf(order).html);
    QCOMPARE(facts["labels"].size(), std::size_t(3));
    QCOMPARE(questionsOf(order, "name").size(), std::size_t(3));
    render::ExportOrder without = order;
    without.labels.mode = render::LabelMode::off;
    QCOMPARE(factsOf(pageOf(without).html)["labels"].size(), std::size_t(0));
    QCOMPARE(questionsOf(without, "find").size(), std::size_t(3));
  }

  void chains_data() {
    QTest::addColumn<QStringList>("names");
    QTest::addColumn<float>("step");
    QTest::addColumn<QStringList>("order");
    const QStringList arteries{"abdominal aorta", "left common iliac artery",
                               "left external iliac artery", "left femoral artery"};
    QTest::newRow("arteries") << arteries << 40.0f << arteries;
    const QStringList veins{"inferior vena cava", "left common iliac vein",
                            "left external iliac vein"};
    QTest::newRow("veins flow back") << veins << 40.0f << QStringList{veins[2], veins[1], veins[0]};
    QTest::newRow("apart") << arteries << 60.0f << QStringList();
    QTest::newRow("beside each other") << arteries << 1.0f << QStringList();
    QTest::newRow("too few") << arteries.mid(0, 2) << 40.0f << QStringList();
    QTest::newRow("organs") << QStringList{"liver", "spleen", "stomach"} << 40.0f << QStringList();
  }
  void chains() {
    QFETCH(QStringList, names);
    QFETCH(float, step);
    QFETCH(QStringList, order);
    std::vector<std::string> all;
    for (const QString& name : names)
      all.push_back(name.toStdString());
    const std::vector<json> asked = questionsOf(tubes(all, step), "order");
    QStringList found;
    for (const json& question : asked)
      for (const json& choice : question["choices"])
        found << QString::fromStdString(choice["en"]);
    QCOMPARE(found, order);
    if (!asked.empty()) {
      QCOMPARE(asked[0]["words"]["de"], json("Arterien"));
      QCOMPARE(asked[0]["structures"].size(), std::size_t(order.size()));
    }
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::PageQuizTest)
#include "page_quiz_test.moc"
