// SPDX-License-Identifier: Apache-2.0
// Tests that the window asks which side is which where it can only guess, and follows the answer.
#include <QAction>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/edit/sides.h"
#include "model/edit/tree.h"
#include "model/scene/known_frame.h"
#include "tests/gui/window_fixture.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

namespace sline::test {

class SidesBarTest : public QObject {
  Q_OBJECT

 private slots:
  void asksAndFollows_data() {
    QTest::addColumn<QString>("button");
    QTest::addColumn<glm::vec3>("place");
    QTest::newRow("right") << "sidesRightButton" << glm::vec3(30, -10, -20);
    QTest::newRow("mirror") << "sidesMirrorButton" << glm::vec3(-30, -10, -20);
    QTest::newRow("turn") << "sidesTurnButton" << glm::vec3(-30, 10, -20);
  }
  void asksAndFollows() {
    QFETCH(QString, button);
    QFETCH(glm::vec3, place);
    const QTemporaryDir folder;
    const QString file = folder.filePath("growth.ply");
    writeMesh(file, *octahedron({30, -10, -20}, 10));
    WindowFixture f;
    auto& bar = f.control<QFrame>("sidesBar");
    QVERIFY(!bar.isVisible());
    QVERIFY(f.drop(file));
    QVERIFY(f.settled());
    const auto letters = [&f] {
      return f.control<QLabel>("letterLeft").text() + f.control<QLabel>("letterRight").text();
    };
    const auto centre = [&f] { return f.session.scene().nodes().back().mesh->bounds().centre(); };
    f.viewport().showFrom(model::AnatomicalView::anterior);
    QVERIFY(f.settled());
    QVERIFY(bar.isVisible());
    QVERIFY(f.control<QLabel>("sidesQuestion").text().contains("LPS"));
    QCOMPARE(letters(), QString("R?L?"));
    f.control<QPushButton>(qPrintable(button)).click();
    QVERIFY(f.settled());
    QVERIFY(!bar.isVisible());
    QVERIFY(glm::length(centre() - place) < 1e-4f);
    QVERIFY(!model::knownSides(f.session.scene()).inDoubt());
    QCOMPARE(letters(), QString("RL"));
    f.session.undo();
    QVERIFY(f.settled());
    QVERIFY(bar.isVisible());
    QVERIFY(glm::length(centre() - glm::vec3(30, -10, -20)) < 1e-4f);
    QCOMPARE(letters(), QString("R?L?"));
  }

  /// Names tell the sides of a pair, and not where its front is.
  void asksForTheFrontAlone() {
    const QTemporaryDir folder;
    writeMesh(folder.filePath("left_kidney.ply"), *octahedron({50, 40, -40}, 10));
    writeMesh(folder.filePath("right_kidney.ply"), *octahedron({-50, 40, -40}, 10));
    WindowFixture f;
    QVERIFY(f.drop(folder.path()));
    QVERIFY(f.settled());
    QVERIFY(f.control<QFrame>("sidesBar").isVisible());
    QVERIFY(f.control<QLabel>("sidesQuestion").text().startsWith("Front and back are not certain"));
    QVERIFY(!f.control<QPushButton>("sidesTurnButton").isVisible());
    f.control<QPushButton>("sidesMirrorButton").click();
    QVERIFY(f.settled());
    QVERIFY(!f.control<QFrame>("sidesBar").isVisible());
    const glm::vec3 last = f.session.scene().nodes().back().mesh->bounds().centre();
    QVERIFY(std::abs(last.y + 40.0f) < 1e-4f);
    QVERIFY(!model::knownSides(f.session.scene()).inDoubt());
  }

  /// Sides may be certain, and a name for the other one wrong.
  void tellsNamesOfTheOtherSide() {
    const QTemporaryDir folder;
    writeMesh(folder.filePath("left_kidney.ply"), *octahedron({-50, 40, -40}, 10),
              model::Frame::lps);
    writeMesh(folder.filePath("spleen.ply"), *octahedron({80, 20, 15}, 10), model::Frame::lps);
    writeMesh(folder.filePath("liver.ply"), *octahedron({-70, -30, 10}, 10), model::Frame::lps);
    writeMesh(folder.filePath("spine.ply"), *octahedron({0, 60, -5}, 10), model::Frame::lps);
    WindowFixture f;
    QVERIFY(f.drop(folder.path()));
    QVERIFY(f.settled());
    auto& bar = f.control<QFrame>("sidesBar");
    QTRY_VERIFY(bar.isVisible());  // names are compared beside the window
    const QStringList says = f.control<QLabel>("sidesQuestion").text().split('\n');
    QCOMPARE(says.front(), QString("\"left kidney\" lies on the other side than its name says."));
    QVERIFY2(says.back().contains("question mark"), qPrintable(says.back()));
    QVERIFY(!f.control<QPushButton>("sidesMirrorButton").isVisible());
    // Whoever knows better says so.
    auto& right = f.control<QPushButton>("sidesRightButton");
    QCOMPARE(right.text(), QString("Names are right"));
    right.click();
    QTRY_VERIFY(!bar.isVisible());
    QVERIFY(!model::hasDoubtedNames(f.session.scene()));
    f.session.undo();
    QTRY_VERIFY(bar.isVisible());
    // The bar goes with what it tells, and comes back with it.
    const model::NodeId kidney = f.session.scene().named("left kidney").front();
    QVERIFY(f.session.apply("Rename", model::renamed(f.session.scene(), kidney, "right kidney")));
    QTRY_VERIFY(!bar.isVisible());
    f.session.undo();
    QTRY_VERIFY(bar.isVisible());
    f.control<QToolButton>("closeSidesBar").click();
    QVERIFY(!bar.isVisible());
  }

  /// What is certain asks nothing; closed by hand, the bar comes back with the next scene.
  void asksNoMoreThanNeeded() {
    const QTemporaryDir folder;
    writeMesh(folder.filePath("known.ply"), *octahedron({30, -10, -20}, 10), model::Frame::lps);
    writeMesh(folder.filePath("growth.ply"), *octahedron({30, -10, -20}, 10));
    WindowFixture f;
    auto& bar = f.control<QFrame>("sidesBar");
    QVERIFY(f.drop(folder.filePath("known.ply")));
    QVERIFY(f.settled());
    QVERIFY(!bar.isVisible());
    QVERIFY(!f.control<QAction>("sidesRight").isEnabled());
    QVERIFY(f.control<QAction>("sidesMirror").isEnabled());
    f.session.openPaths({folder.filePath("growth.ply").toStdString()});
    QVERIFY(f.settled());
    QVERIFY(bar.isVisible());
    f.control<QToolButton>("closeSidesBar").click();
    QVERIFY(!bar.isVisible());
    QVERIFY(f.control<QAction>("sidesRight").isEnabled());
    f.session.openPaths({folder.filePath("growth.ply").toStdString()});
    QVERIFY(f.settled());
    QVERIFY(bar.isVisible());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::SidesBarTest)
#include "sides_bar_test.moc"
