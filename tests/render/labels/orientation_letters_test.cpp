// SPDX-License-Identifier: Apache-2.0
#include <QTest>
#include <glm/gtc/matrix_transform.hpp>

#include "model/camera/camera.h"
#include "render/labels/orientation_letters.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

class OrientationLettersTest : public QObject {
  Q_OBJECT
 private slots:
  void views_data() {
    QTest::addColumn<int>("view");
    QTest::addColumn<float>("turn");
    QTest::addColumn<QString>("letters");  // left right top bottom
    const auto row = [](const char* name, model::AnatomicalView view, float turn,
                        const char* letters) {
      QTest::newRow(name) << int(view) << turn << letters;
    };
    using enum model::AnatomicalView;
    row("anterior", anterior, 0.0f, "R L S I");
    row("posterior", posterior, 0.0f, "L R S I");
    row("left", left, 0.0f, "A P S I");
    row("right", right, 0.0f, "P A S I");
    row("superior", superior, 0.0f, "L R A P");
    row("inferior", inferior, 0.0f, "R L A P");
    // The eye goes to the patient's right, so that more of it comes into sight.
    row("oblique", anterior, 40.0f, "RP LA S I");
    row("hardly oblique", anterior, 10.0f, "R L S I");
  }
  void views() {
    QFETCH(int, view);
    QFETCH(float, turn);
    QFETCH(QString, letters);
    model::Camera camera = model::anatomicalCamera(model::AnatomicalView(view), {}, 1.0f);
    camera.eye =
        glm::vec3(glm::rotate(glm::mat4(1.0f), glm::radians(-turn), glm::vec3(0.0f, 0.0f, 1.0f)) *
                  glm::vec4(camera.eye, 1.0f));
    const EdgeLetters found = edgeLetters(camera, {});
    QCOMPARE(QString::fromStdString(found.left + " " + found.right + " " + found.top + " " +
                                    found.bottom),
             letters);
  }

  /// What nobody is sure of has a question mark, in oblique views too.
  void doubt() {
    model::Camera camera = model::anatomicalCamera(model::AnatomicalView::anterior, {}, 1.0f);
    const auto letters = [&camera](const model::SideEvidence& evidence) {
      const EdgeLetters found = edgeLetters(camera, {.any = true, .evidence = evidence});
      return found.left + " " + found.right + " " + found.top + " " + found.bottom;
    };
    using enum model::Evidence;
    for (const model::Evidence sure : {known, settled, voted})
      QCOMPARE(letters({sure, sure}), std::string("R L S I"));
    for (const model::Evidence unsure : {assumed, conflict})
      QCOMPARE(letters({unsure, known}), std::string("R? L? S I"));
    QCOMPARE(letters({known, assumed}), std::string("R L S I"));
    camera.eye = {-600.0f, -800.0f, 0.0f};
    QCOMPARE(letters({assumed, assumed}), std::string("R?P? L?A? S I"));
    QCOMPARE(letters({assumed, known}), std::string("R?P L?A S I"));
  }
};

SLINE_TEST(OrientationLettersTest)
#include "orientation_letters_test.moc"
