// SPDX-License-Identifier: Apache-2.0
// Tests what labels ask for, and that a quiz counts right.
#include <QtTest>
#include <algorithm>
#include <random>
#include <set>

#include "model/scene/quiz.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace model;

namespace {

struct Asked {
  Scene scene;
  std::vector<NodeId> balls;
  explicit Asked(int count) {
    for (int i = 0; i < count; ++i)
      balls.push_back(scene.append({.name = "ball", .mesh = sphere(5.0f, 1)}));
  }
  void name(int ball, const std::string& text, AnnotationKind kind = AnnotationKind::label) {
    Annotation label{.kind = kind, .text = text};
    label.anchors.assign(anchorCount(kind),
                         SurfacePoint{balls[std::size_t(ball)], 0, {0.3f, 0.3f}});
    scene.appendAnnotation(label);
  }
};

}  // namespace

}  // namespace sline::test

Q_DECLARE_METATYPE(sline::model::QuestionChoice)

namespace sline::test {

class QuizTest : public QObject {
  Q_OBJECT

 private slots:
  /// Import counts what several files call the same; whoever answers cannot know the number.
  void countedNamesAreOneThing() {
    Asked a(3);
    std::vector<Node> nodes = a.scene.nodes();
    nodes[0].name = "portal vein";
    nodes[1].name = "portal vein 2";
    nodes[2].name = "lesion 2";
    a.scene.setNodes(nodes);
    a.name(0, "portal vein");
    a.name(1, "portal vein 2");
    a.name(2, "lesion 2");
    const std::vector<Question> questions = questionsOf(a.scene, "");
    QCOMPARE(questions.size(), std::size_t(2));
    QCOMPARE(questions[0].words, std::string("portal vein"));
    QCOMPARE(questions[0].structures.size(), std::size_t(2));
    QCOMPARE(questions[1].words, std::string("lesion 2"));
  }

  void questions() {
    Asked a(4);
    a.name(0, "ureter");
    a.name(1, "ureter");
    a.name(2, "bladder", AnnotationKind::pin);
    a.name(2, "explains", AnnotationKind::callout);
    a.name(2, "far", AnnotationKind::distance);
    a.name(2, "  ");
    a.name(3, "hidden");
    std::vector<Node> nodes = a.scene.nodes();
    nodes[3].style.visible = false;
    a.scene.setNodes(std::move(nodes));
    Annotation free{.anchors = {glm::vec3(1.0f)}, .text = "in space"};
    a.scene.appendAnnotation(free);
    std::vector<Annotation> annotations = a.scene.annotations();
    annotations[2].texts["de"] = "Harnblase";
    a.scene.setAnnotations(annotations);
    const std::vector<Question> asked = questionsOf(a.scene, "");
    QCOMPARE(asked.size(), std::size_t(2));
    const auto& labels = a.scene.annotations();
    QVERIFY(asked[0] ==
            (Question{"ureter", {a.balls[0], a.balls[1]}, {labels[0].id, labels[1].id}}));
    QVERIFY(asked[1] == (Question{"bladder", {a.balls[2]}, {labels[2].id}}));
    QCOMPARE(questionsOf(a.scene, "de")[1].words, std::string("Harnblase"));
    annotations[0].visible = false;
    a.scene.setAnnotations(annotations);
    QVERIFY(questionsOf(a.scene, "")[0] == (Question{"ureter", {a.balls[1]}, {annotations[1].id}}));
  }

  /// Nobody is asked for what may be on the other side than its name says.
  void doubtedNames() {
    Asked a(2);
    a.name(0, "left kidney");
    a.name(1, "right kidney");
    std::vector<Node> nodes = a.scene.nodes();
    nodes[0].provenance.nameEvidence = Evidence::conflict;
    a.scene.setNodes(nodes);
    a.name(0, "**left** kidney", AnnotationKind::callout);
    const std::vector<Question> asked = questionsOf(a.scene, "", {.callouts = true});
    QCOMPARE(asked.size(), std::size_t(1));
    QCOMPARE(asked[0].words, std::string("right kidney"));
    nodes[0].provenance.nameEvidence = Evidence::settled;
    a.scene.setNodes(nodes);
    QCOMPARE(questionsOf(a.scene, "").size(), std::size_t(2));
  }

  void choices_data() {
    QTest::addColumn<QuestionChoice>("choice");
    QTest::addColumn<QStringList>("words");
    QTest::newRow("all") << QuestionChoice() << QStringList{"ureter", "bladder", "sacrum"};
    QTest::newRow("in focus") << QuestionChoice{.focusAlone = true} << QStringList{"bladder"};
    QTest::newRow("a group") << QuestionChoice{.names = {"Organs"}}
                             << QStringList{"ureter", "bladder"};
    QTest::newRow("a structure, however it is written")
        << QuestionChoice{.names = {"BALL-2", "nothing"}} << QStringList{"sacrum"};
    QTest::newRow("nothing of that name") << QuestionChoice{.names = {"nothing"}} << QStringList{};
    QTest::newRow("focus and group")
        << QuestionChoice{.focusAlone = true, .names = {"ball 2"}} << QStringList{};
    QTest::newRow("sentences") << QuestionChoice{.callouts = true}
                               << QStringList{"ureter", "bladder", "sacrum", "It holds urine"};
    QTest::newRow("in space") << QuestionChoice{.inSpace = true}
                              << QStringList{"ureter", "bladder", "sacrum", "free"};
    QTest::newRow("nothing of a group is in space")
        << QuestionChoice{.names = {"Organs"}, .inSpace = true} << QStringList{"ureter", "bladder"};
  }
  void choices() {
    QFETCH(QuestionChoice, choice);
    QFETCH(QStringList, words);
    Asked a(3);
    std::vector<Node> nodes = a.scene.nodes();
    nodes[2].name = "ball 2";
    a.scene.setNodes(nodes);
    const NodeId group = a.scene.append({.name = "organs"});
    nodes = a.scene.nodes();
    std::rotate(nodes.begin(), nodes.end() - 1, nodes.end());
    nodes[1].parent = nodes[2].parent = group;
    a.scene.setNodes(nodes);
    a.scene.setFocus({.targets = {a.balls[1]}});
    a.name(0, "ureter");
    a.name(1, "bladder");
    a.name(2, "sacrum");
    a.name(1, "It **holds** urine", AnnotationKind::callout);
    a.scene.appendAnnotation({.anchors = {glm::vec3(1.0f)}, .text = "free"});
    QStringList asked;
    for (const Question& question : questionsOf(a.scene, "", choice))
      asked << QString::fromStdString(question.words);
    QCOMPARE(asked, words);
    // Only the labels of questions are left to be seen.
    const Scene alone = withQuestionsAlone(a.scene, questionsOf(a.scene, "", choice));
    QCOMPARE(std::count_if(alone.annotations().begin(), alone.annotations().end(),
                           [](const Annotation& each) { return each.visible; }),
             std::ptrdiff_t(words.size()));
  }

  /// Fifty runs with answers by chance: each thing is asked for once, and the score is the number
  /// of first answers that were right.
  void scores() {
    Asked a(9);
    for (int i = 0; i < 9; ++i)
      a.name(i, "structure " + std::to_string(i));
    std::set<std::string> orders;
    for (std::uint32_t run = 0; run < 50; ++run) {
      Quiz quiz(questionsOf(a.scene, ""), run);
      std::mt19937 chance(run);
      std::set<std::string> asked;
      std::string order;
      std::size_t right = 0;
      for (; !quiz.done(); quiz.next()) {
        QCOMPARE(quiz.at(), asked.size());
        asked.insert(quiz.question().words);
        order += quiz.question().words;
        if (chance() % 5 == 0)
          continue;  // passed over
        const NodeId wanted = quiz.question().structures.front();
        const NodeId said = a.balls[chance() % a.balls.size()];
        QCOMPARE(quiz.answer(said), said == wanted);
        right += said == wanted;
        QVERIFY(quiz.answered());
        quiz.answer(wanted);  // too late
      }
      QCOMPARE(asked.size(), std::size_t(9));
      QCOMPARE(quiz.right(), right);
      orders.insert(order);
    }
    QVERIFY(orders.size() > 40);
  }

  void nothingToAsk() {
    Quiz quiz({}, 1);
    QVERIFY(quiz.done());
    quiz.next();
    QVERIFY(quiz.done());
    QCOMPARE(quiz.right(), std::size_t(0));
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::QuizTest)
#include "quiz_test.moc"
