// SPDX-License-Identifier: Apache-2.0
// Tests what labels ask for, and that a quiz counts right.
#include <QtTest>
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

class QuizTest : public QObject {
  Q_OBJECT

 private slots:
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
    QVERIFY(asked[0] == (Question{"ureter", {a.balls[0], a.balls[1]}}));
    QVERIFY(asked[1] == (Question{"bladder", {a.balls[2]}}));
    QCOMPARE(questionsOf(a.scene, "de")[1].words, std::string("Harnblase"));
    annotations[0].visible = false;
    a.scene.setAnnotations(annotations);
    QVERIFY(questionsOf(a.scene, "")[0] == (Question{"ureter", {a.balls[1]}}));
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
