// SPDX-License-Identifier: Apache-2.0
// Tests section planes and the key light by hand: keys, menu and toolbar.
#include <QAction>
#include <QToolBar>
#include <QtTest>

#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

class WindowSectionsTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

  static QAction& action(WindowFixture& f, const QString& id) {
    auto* found = f.window.findChild<QAction*>(id);
    if (!found)
      qFatal("no action %s", qPrintable(id));
    return *found;
  }
  static void pressTool(WindowFixture& f, const QString& id) {
    QWidget* button = f.control<QToolBar>("tools").widgetForAction(&action(f, id));
    QTest::mouseClick(button, Qt::LeftButton);
  }

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void aSectionIsOneStep_data() {
    QTest::addColumn<int>("view");
    QTest::addColumn<int>("key");
    QTest::addColumn<QString>("action");
    QTest::addColumn<int>("axis");
    QTest::addColumn<float>("normal");
    // The side towards the eye is taken away.
    QTest::newRow("sagittal, from the left")
        << int(Qt::Key_L) << int(Qt::Key_1) << "sectionSagittal" << 0 << 1.0f;
    QTest::newRow("sagittal, from the right")
        << int(Qt::Key_R) << int(Qt::Key_1) << "sectionSagittal" << 0 << -1.0f;
    QTest::newRow("coronal, from the front")
        << int(Qt::Key_A) << int(Qt::Key_2) << "sectionCoronal" << 1 << -1.0f;
    QTest::newRow("axial, from above")
        << int(Qt::Key_S) << int(Qt::Key_3) << "sectionAxial" << 2 << 1.0f;
  }
  void aSectionIsOneStep() {
    QFETCH(int, view);
    QFETCH(int, key);
    QFETCH(QString, action);
    QFETCH(int, axis);
    QFETCH(float, normal);
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    QTest::keyClick(&f.window, Qt::Key(view));
    QVERIFY(f.settled());
    const QImage whole = f.picture();
    const model::Box bounds = f.session.scene().visibleBounds();

    QTest::keyClick(&f.window, Qt::Key(key), Qt::ControlModifier);
    QCOMPARE(f.session.scene().sections().size(), std::size_t(1));
    const model::Plane plane = f.session.scene().sections().front().plane;
    QCOMPARE(plane.normal[axis], normal);
    QVERIFY(std::abs(plane.distance(bounds.centre())) < 1e-3);
    QVERIFY(this->action(f, action).isChecked());
    QVERIFY(f.settled());
    QVERIFY(!difference(whole, f.picture()).isEmpty());
    QCOMPARE(f.session.history().count(), 1);

    QTest::keyClick(&f.window, Qt::Key_X);
    QCOMPARE(f.session.scene().sections().front().plane.normal[axis], -normal);
    QCOMPARE(f.session.history().count(), 2);
    QTest::keyClick(&f.window, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(&f.window, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(f.session.scene().sections().empty());
    QVERIFY(!this->action(f, action).isChecked());
    QVERIFY(f.settled());
    QCOMPARE(difference(whole, f.picture()), QRect());
  }

  void toolsToggle() {
    WindowFixture f;
    QVERIFY(!action(f, QStringLiteral("sectionAxial")).isEnabled());
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    f.window.resize(1500, 800);
    QVERIFY(!action(f, QStringLiteral("sectionFlip")).isEnabled());
    pressTool(f, QStringLiteral("sectionAxial"));
    pressTool(f, QStringLiteral("sectionSagittal"));
    QCOMPARE(f.session.scene().sections().size(), std::size_t(2));
    QVERIFY(action(f, QStringLiteral("sectionFlip")).isEnabled());
    pressTool(f, QStringLiteral("sectionAxial"));
    QCOMPARE(f.session.scene().sections().size(), std::size_t(1));
    QVERIFY(!action(f, QStringLiteral("sectionAxial")).isChecked());
    QTest::keyClick(&f.window, Qt::Key_0, Qt::ControlModifier);
    QVERIFY(f.session.scene().sections().empty());
    QCOMPARE(f.session.history().count(), 4);
  }

  void whatIsCutAwayCannotBePicked() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const model::NodeId kidney = f.session.scene().named("left kidney").front();
    QTest::keyClick(&f.window, Qt::Key_L);
    QTest::keyClick(&f.window, Qt::Key_1, Qt::ControlModifier);  // keeps the right
    const QPoint place = f.areaOf(kidney).center();
    QTest::mouseClick(&f.viewport(), Qt::LeftButton, {}, place);
    QTRY_VERIFY(!f.session.selection().empty());
    QVERIFY(f.session.selection().front() != kidney);
  }

  void keyLightLightsAndIsKept() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    f.session.select({f.session.scene().named("bladder").front()});
    QTest::keyClick(&f.window, Qt::Key_E, Qt::ControlModifier);
    QVERIFY(f.settled());
    const QImage plain = f.picture();
    QTest::keyClick(&f.window, Qt::Key_K);
    QVERIFY(f.viewport().keyLight());
    QVERIFY(f.settled());
    QVERIFY(!difference(plain, f.picture()).isEmpty());
    f.window.close();
    widgets::Session session;
    widgets::MainWindow again(session, f.settings);
    QVERIFY(again.viewport().keyLight());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::WindowSectionsTest)
#include "window_sections_test.moc"
