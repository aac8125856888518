// SPDX-License-Identifier: Apache-2.0
// Tests section planes by hand: the list and the handles in the picture.
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QToolButton>
#include <QTreeView>
#include <QtTest>

#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/sections/section_handles.h"
#include "widgets/sections/section_position.h"

namespace sline::test {

class ViewportSectionsTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

  static const model::Section& only(WindowFixture& f) {
    return f.session.scene().sections().front();
  }
  static widgets::SectionHandles handles(WindowFixture& f) {
    const QSizeF size = f.viewport().size();
    const auto found = widgets::sectionHandles(
        widgets::sectionFrame(only(f).plane, f.session.scene().visibleBounds(only(f).scope)),
        f.viewport().camera(), {float(size.width()), float(size.height())});
    if (!found)
      qFatal("no handles");
    return *found;
  }
  static QPoint point(const glm::vec2& p) { return {int(p.x), int(p.y)}; }
  /// Chooses an entry of the list's Add button.
  static void add(WindowFixture& f, int entry) {
    QMenu& menu = *f.control<QToolButton>("sectionAdd").menu();
    emit menu.aboutToShow();
    menu.actions().at(entry)->trigger();
  }
  static void press(WindowFixture& f, const char* button) {
    QTest::mouseClick(&f.control<QToolButton>(button), Qt::LeftButton);
  }

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void aDragOfTheArrowIsOneStep() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    QTest::keyClick(&f.window, Qt::Key_A);
    QVERIFY(f.settled());
    auto& mark = f.control<QWidget>("sectionMark");
    QVERIFY(!mark.isVisible());
    QTest::keyClick(&f.window, Qt::Key_1, Qt::ControlModifier);
    QVERIFY(f.settled());
    QVERIFY(mark.isVisible());
    QCOMPARE(mark.geometry(), f.viewport().rect());
    const QImage shown = f.viewport().grab().toImage();
    QCOMPARE(shown.pixelColor(point(handles(f).slide)), QColor(18, 92, 156));
    const int steps = f.session.history().count();
    const model::Plane before = only(f).plane;
    const QImage picture = f.picture();
    const QPoint grip = point(handles(f).slide);
    const QPoint to = grip + QPoint(-60, 0);

    sendMouse(f.viewport(), QEvent::MouseButtonPress, grip);
    for (int i = 1; i <= 6; ++i)
      sendMouse(f.viewport(), QEvent::MouseMove, grip - QPoint(10 * i, 0));
    QVERIFY(f.session.previewing());
    QCOMPARE(f.session.history().count(), steps);
    QTRY_VERIFY((point(handles(f).slide) - to).manhattanLength() < 5);
    sendMouse(f.viewport(), QEvent::MouseButtonRelease, to);
    QCOMPARE(f.session.history().count(), steps + 1);
    QVERIFY(only(f).plane.offset != before.offset);
    QVERIFY(only(f).plane.normal == before.normal);
    QVERIFY(f.session.selection().empty());  // the press was no click
    QVERIFY(f.settled());
    QVERIFY(!difference(picture, f.picture()).isEmpty());
    f.session.undo();
    QVERIFY(only(f).plane == before);
    QVERIFY(f.settled());
    QCOMPARE(difference(picture, f.picture()), QRect());

    // Escape comes in the middle of a drag.
    sendMouse(f.viewport(), QEvent::MouseButtonPress, grip);
    sendMouse(f.viewport(), QEvent::MouseMove, to);
    QVERIFY(!(only(f).plane == before));
    QTest::keyClick(&f.viewport(), Qt::Key_Escape);
    QVERIFY(only(f).plane == before);
    sendMouse(f.viewport(), QEvent::MouseButtonRelease, to);
    QVERIFY(only(f).plane == before);
    QVERIFY(!f.session.previewing());

    // A click on the head keeps the other side.
    QTest::mouseClick(&f.viewport(), Qt::LeftButton, {}, point(handles(f).tip));
    QVERIFY(only(f).plane.normal == -before.normal);
    QVERIFY(f.settled());
  }

  void aRingTilts() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    QTest::keyClick(&f.window, Qt::Key_L);
    QTest::keyClick(&f.window, Qt::Key_2, Qt::ControlModifier);
    QVERIFY(f.settled());
    const model::Plane before = only(f).plane;
    const QPoint ring = point(*handles(f).turnAboutU);
    dragMouse(f.viewport(), ring, ring + QPoint(50, 0));
    QVERIFY(!(only(f).plane.normal == before.normal));
    QVERIFY(std::abs(only(f).plane.normal.x) < 1e-4f);  // about the axis across the picture
    QVERIFY(f.settled());
    f.session.undo();
    QVERIFY(only(f).plane == before);
  }

  void theListSaysAllOfASection() {
    WindowFixture f;
    f.window.resize(1300, 950);
    f.control<QDockWidget>("sectionsPanel").raise();
    QVERIFY(!f.control<QToolButton>("sectionAdd").isEnabled());
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    auto& list = f.control<QTreeView>("sectionList");
    QVERIFY(list.isVisible());
    QCOMPARE(list.model()->rowCount(), 0);
    add(f, 0);
    add(f, 2);
    QCOMPARE(list.model()->rowCount(), 2);
    QCOMPARE(f.session.history().count(), 2);
    QCOMPARE(list.currentIndex().row(), 1);  // the newest is the active one
    QVERIFY(f.settled());

    // The position is changed by a key held down, in one step.
    auto& position = f.control<QDoubleSpinBox>("sectionPosition");
    position.setFocus();
    const double from = position.value();
    for (int i = 0; i < 5; ++i)
      QTest::keyClick(&position, Qt::Key_Up);
    QCOMPARE(position.value(), from + 5.0);
    QCOMPARE(model::positionOf(f.session.scene().sections()[1].plane), from + 5.0);
    QCOMPARE(f.session.history().count(), 3);
    QVERIFY(list.model()->index(1, 1).data().toString().contains("mm"));

    // A section with its tick off stays in the list but cuts nothing.
    const QModelIndex name = list.model()->index(1, 0);
    QVERIFY(list.model()->setData(name, Qt::Unchecked, Qt::CheckStateRole));
    QVERIFY(!f.session.scene().sections()[1].enabled);
    QVERIFY(f.session.scene().sectionsOf(f.session.scene().nodes().back().id).size() == 1);
    QVERIFY(list.model()->setData(name, Qt::Checked, Qt::CheckStateRole));
    QVERIFY(list.model()->setData(name, "Through L3", Qt::EditRole));
    QCOMPARE(f.session.scene().sections()[1].name, std::string("Through L3"));
    QVERIFY(!list.model()->setData(name, "  ", Qt::EditRole));

    f.control<QCheckBox>("sectionHatched").click();
    QVERIFY(f.session.scene().sections()[1].hatched);
    auto& faces = f.control<QComboBox>("sectionFaces");
    QCOMPARE(faces.currentIndex(), int(model::CutFaces::tissue));
    const int steps = f.session.history().count();
    QTest::keyClick(&faces, Qt::Key_Up);
    QCOMPARE(f.session.scene().sections()[1].faces, model::CutFaces::tint);
    QCOMPARE(f.session.scene().sections()[0].faces, model::CutFaces::tissue);
    QCOMPARE(f.session.history().count(), steps + 1);
    f.session.undo();
    QCOMPARE(f.session.scene().sections()[1].faces, model::CutFaces::tissue);
    QCOMPARE(faces.currentIndex(), int(model::CutFaces::tissue));
    const glm::vec3 normal = f.session.scene().sections()[1].plane.normal;
    press(f, "sectionFlipOne");
    QVERIFY(f.session.scene().sections()[1].plane.normal == -normal);
    QVERIFY(f.settled());
  }

  /// A click on another row chooses its section; Del in the list removes it and no structure.
  void theListDeletes() {
    WindowFixture f;
    f.window.resize(1300, 950);
    f.control<QDockWidget>("sectionsPanel").raise();
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    auto& list = f.control<QTreeView>("sectionList");
    add(f, 0);
    add(f, 2);
    const std::size_t nodes = f.session.scene().nodes().size();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                      list.visualRect(list.model()->index(0, 1)).center());
    QVERIFY(f.session.activeSection() == f.session.scene().sections()[0].id);
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Delete);
    QCOMPARE(f.session.scene().sections().size(), std::size_t(1));
    QCOMPARE(f.session.scene().nodes().size(), nodes);
    QVERIFY(f.session.activeSection() == f.session.scene().sections()[0].id);
    press(f, "sectionDelete");
    QVERIFY(f.session.scene().sections().empty());
    QVERIFY(!f.control<QToolButton>("sectionDelete").isEnabled());
    QVERIFY(!f.control<QDoubleSpinBox>("sectionPosition").isVisible());
    f.session.undo();
    QCOMPARE(list.model()->rowCount(), 1);
    QVERIFY(f.settled());
  }

  void ofAGroupAlone() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const model::NodeId organs = f.session.scene().named("Organs").front();
    const model::NodeId aorta = f.session.scene().named("aorta").front();
    add(f, 0);
    QVERIFY(only(f).scope == model::rootId);
    f.session.select({organs});
    f.control<QDockWidget>("sectionsPanel").raise();
    auto& scope = f.control<QComboBox>("sectionScope");
    QCOMPARE(scope.count(), 2);
    QTest::keyClick(&scope, Qt::Key_Down);
    QVERIFY(only(f).scope == organs);
    QVERIFY(f.session.scene().sectionsOf(aorta).empty());
    QVERIFY(f.settled());
    f.session.undo();
    // The menu adds such a section at once.
    add(f, 5);
    QCOMPARE(f.session.scene().sections().size(), std::size_t(2));
    QVERIFY(f.session.scene().sections()[1].scope == organs);
    QVERIFY(f.settled());
  }

  /// More sections than a structure can have are refused with a message, and change nothing.
  void tooManyAreRefused() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    for (std::size_t i = 0; i < model::maximumSections; ++i)
      add(f, 3);
    QCOMPARE(f.session.scene().sections().size(), model::maximumSections);
    const widgets::Document before = f.session.document();
    QVERIFY(!f.control<QWidget>("messageBar").isVisible());
    add(f, 3);
    QVERIFY(f.session.document() == before);
    QVERIFY(f.control<QWidget>("messageBar").isVisible());
    QVERIFY(f.settled());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ViewportSectionsTest)
#include "viewport_sections_test.moc"
