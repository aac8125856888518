// SPDX-License-Identifier: Apache-2.0
// Tests the main job by hand: a folder is dropped, one slider moved, the scene turned, steps
// undone.
#include <QAccessible>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTabBar>
#include <QtTest>

#include "model/edit/visibility.h"
#include "tests/gui/window_fixture.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/gamma/gamma_slider.h"
#include "widgets/shell/message_bar.h"
#include "widgets/structure_tree/structure_tree.h"
#include "widgets/structure_tree/structure_tree_model.h"
#include "widgets/structure_tree/structure_tree_view.h"
#include "widgets/theme/theme.h"

namespace sline::test {

using widgets::StructureTreeModel;

class WindowTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

  /// Returns the only structure of that name.
  static model::NodeId structure(WindowFixture& f, const QString& name) {
    const std::vector<model::NodeId> found = f.session.scene().named(name.toStdString());
    if (found.size() != 1)
      qFatal("%zu structures are named %s", found.size(), qPrintable(name));
    return found.front();
  }
  bool openBody(WindowFixture& f) { return f.drop(m_body.path()) && f.settled(); }

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void oneSliderChangesOneStructure_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<int>("structures");
    QTest::addColumn<QString>("name");
    QTest::addColumn<float>("gamma");
    const QString pelvis = QStringLiteral(SLINE_TEST_DATA "/pelvis/bodyparts3d");
    QTest::newRow("written meshes") << m_body.path() << 5 << "left kidney" << 5.0f;
    QTest::newRow("down to the silhouette") << m_body.path() << 5 << "aorta" << 0.0f;
    QTest::newRow("pelvis") << pelvis << 40 << "left femur" << 4.0f;
    QTest::newRow("behind others") << pelvis << 40 << "sacrum" << 5.0f;
  }
  void oneSliderChangesOneStructure() {
    QFETCH(QString, folder);
    QFETCH(int, structures);
    QFETCH(QString, name);
    QFETCH(float, gamma);
    if (!QFileInfo::exists(folder))
      SLINE_ABSENT("no real anatomy here");
    WindowFixture f;
    QVERIFY(f.drop(folder));
    QVERIFY(f.settled());
    QCOMPARE(int(f.session.scene().structuresBelow(model::rootId).size()), structures);

    const model::NodeId id = structure(f, name);
    const QImage before = f.picture();
    const model::Scene sceneBefore = f.session.scene();
    f.pullGamma(id, gamma);
    QVERIFY2(f.session.previewing(), "what is dragged shows at once");
    QCOMPARE(f.session.history().count(), 0);
    f.letGoOfGamma();
    QCOMPARE(f.session.history().count(), 1);
    QCOMPARE(f.session.scene().resolve(id).gamma.value(), gamma);
    QVERIFY(f.settled());
    const QImage after = f.picture();

    const QRect changed = difference(before, after);
    const QRect area = f.areaOf(id);
    QVERIFY2(!changed.isEmpty(), "the picture is as before");
    QVERIFY2(area.contains(changed),
             qPrintable(QStringLiteral("pixels changed in %1,%2 %3×%4, the structure is in %5,%6 "
                                       "%7×%8")
                            .arg(changed.x())
                            .arg(changed.y())
                            .arg(changed.width())
                            .arg(changed.height())
                            .arg(area.x())
                            .arg(area.y())
                            .arg(area.width())
                            .arg(area.height())));
    QVERIFY2(area.width() < before.width() && area.height() < before.height(),
             "a structure all over the picture shows nothing");

    f.window.findChild<QAction*>(QStringLiteral("undo"))->trigger();
    QVERIFY(f.session.scene() == sceneBefore);
    QVERIFY(f.settled());
    QCOMPARE(difference(before, f.picture()), QRect());
  }

  void escapeGivesUpADrag() {
    WindowFixture f;
    QVERIFY(openBody(f));
    const model::Scene before = f.session.scene();
    f.pullGamma(structure(f, QStringLiteral("bladder")), 4.0f);
    QVERIFY(!(f.session.scene() == before));
    QTest::keyClick(&f.tree(), Qt::Key_Escape);
    QVERIFY(f.session.scene() == before);
    f.letGoOfGamma();
    QVERIFY(f.session.scene() == before);
    QCOMPARE(f.session.history().count(), 0);
  }

  void mouseMovesTheCamera_data() {
    QTest::addColumn<int>("button");
    QTest::addColumn<int>("keys");
    QTest::addColumn<bool>("turns");
    QTest::newRow("orbit") << int(Qt::LeftButton) << int(Qt::NoModifier) << true;
    QTest::newRow("pan") << int(Qt::MiddleButton) << int(Qt::NoModifier) << false;
    QTest::newRow("pan with Shift") << int(Qt::LeftButton) << int(Qt::ShiftModifier) << false;
  }
  void mouseMovesTheCamera() {
    QFETCH(int, button);
    QFETCH(int, keys);
    QFETCH(bool, turns);
    WindowFixture f;
    QVERIFY(openBody(f));
    const model::Camera before = f.viewport().camera();
    const QImage pictureBefore = f.picture();
    const QPoint middle = f.viewport().rect().center();
    dragMouse(f.viewport(), middle, middle + QPoint(90, 40), Qt::MouseButton(button),
              Qt::KeyboardModifiers(keys));
    const model::Camera after = f.viewport().camera();
    QVERIFY(!(after == before));
    const glm::vec3 back = model::cameraFrame(before).back;
    QCOMPARE(glm::dot(back, model::cameraFrame(after).back) < 0.999f, turns);
    QVERIFY(std::abs(model::cameraFrame(after).right.z) < 1e-3f);
    QCOMPARE(f.session.history().count(), 0);
    QVERIFY(f.settled());
    QVERIFY(!difference(pictureBefore, f.picture()).isEmpty());
  }

  void wheelZoomsToTheMouse() {
    WindowFixture f;
    QVERIFY(openBody(f));
    const float before = glm::length(f.viewport().camera().eye);
    const QPointF at = f.viewport().rect().center();
    QWheelEvent wheel(at, f.viewport().mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&f.viewport(), &wheel);
    QVERIFY(glm::length(f.viewport().camera().eye) < 0.9f * before);
    QTest::keyClick(&f.window, Qt::Key_A);
    QVERIFY(std::abs(glm::length(f.viewport().camera().eye) - before) < 1.0f);
  }

  void clickSelects() {
    WindowFixture f;
    QVERIFY(openBody(f));
    const model::NodeId id = structure(f, QStringLiteral("left kidney"));
    QTest::mouseClick(&f.viewport(), Qt::LeftButton, {}, f.areaOf(id).center());
    QTRY_COMPARE(f.session.selection(), widgets::NodeIds{id});
    QCOMPARE(f.control<QLabel>("gammaTitle").text(), QStringLiteral("left kidney"));
    QCOMPARE(f.tree().selectionModel()->selectedRows().size(), 1);
    QTest::mouseClick(&f.viewport(), Qt::LeftButton, {}, QPoint(3, 3));
    QTRY_VERIFY(f.session.selection().empty());
  }

  void panelActsOnAllSelected() {
    WindowFixture f;
    QVERIFY(openBody(f));
    const widgets::NodeIds ids{structure(f, QStringLiteral("left kidney")),
                               structure(f, QStringLiteral("right kidney"))};
    f.session.select(ids);
    auto& slider = f.control<widgets::GammaSlider>("gammaSlider");
    dragMouse(slider, slider.pointOf(Gamma::clamped(2.0f)).toPoint(),
              slider.pointOf(Gamma::clamped(4.0f)).toPoint());
    for (const model::NodeId id : ids)
      QVERIFY(std::abs(f.session.scene().resolve(id).gamma.value() - 4.0f) < 0.05f);
    QCOMPARE(f.session.history().count(), 1);
    const float start = f.session.scene().resolve(ids.front()).gamma.value();
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_Up);
    QCOMPARE(f.session.scene().resolve(ids.front()).gamma.value(), start + 0.05f);
    QTest::keyClick(&slider, Qt::Key_PageDown);
    QCOMPARE(f.session.scene().resolve(ids.back()).gamma.value(), start - 0.95f);
    QCOMPARE(f.session.history().count(), 2);
  }

  void spaceAndEyeToggle() {
    WindowFixture f;
    QVERIFY(openBody(f));
    const model::NodeId id = structure(f, QStringLiteral("bladder"));
    f.session.select({id});
    QTest::keyClick(&f.tree(), Qt::Key_Space);
    QVERIFY(!f.session.scene().resolve(id).visible);
    const QRect eye = f.tree().cellOf(id, StructureTreeModel::eye);
    QTest::mouseClick(f.tree().viewport(), Qt::LeftButton, {}, eye.center());
    QVERIFY(f.session.scene().resolve(id).visible);
    const model::NodeId group = f.session.scene().find(id)->parent;
    QTest::mouseClick(f.tree().viewport(), Qt::LeftButton, {}, eye.center());
    QCOMPARE(model::visibilityOf(f.session.scene(), group), model::Visibility::some);
  }

  void filterFinds() {
    WindowFixture f;
    QVERIFY(openBody(f));
    const widgets::NodeIds selected{structure(f, QStringLiteral("aorta"))};
    f.session.select(selected);
    f.window.findChild<QAction*>(QStringLiteral("find"))->trigger();
    QTest::keyClicks(&f.control<QLineEdit>("structureFilter"), QStringLiteral("kid"));
    QVERIFY(!f.tree().cellOf(structure(f, QStringLiteral("left kidney")), 0).isEmpty());
    QVERIFY(f.tree().cellOf(structure(f, QStringLiteral("aorta")), 0).isEmpty());
    QCOMPARE(f.session.selection(), selected);
    QTest::keyClick(&f.control<QLineEdit>("structureFilter"), Qt::Key_Escape);
    QCOMPARE(f.session.selection(), selected);
    QCOMPARE(f.tree().selectionModel()->selectedRows().size(), 1);
  }

  /// What the filter hides is not selected any more, even if Ctrl was down in the tree before.
  void downFromTheFilterSelectsOneRow() {
    WindowFixture f;
    QVERIFY(openBody(f));
    f.session.select({structure(f, QStringLiteral("aorta"))});
    f.tree().setFocus();
    QTest::keyPress(&f.tree(), Qt::Key_Control, Qt::ControlModifier);
    f.window.findChild<QAction*>(QStringLiteral("find"))->trigger();
    auto& filter = f.control<QLineEdit>("structureFilter");
    QTest::keyClicks(&filter, QStringLiteral("left kid"));
    QTest::keyClick(&filter, Qt::Key_Down);
    QCOMPARE(f.session.selection(), widgets::NodeIds{structure(f, QStringLiteral("left kidney"))});
  }

  /// A filter for one scene hides nothing of the next.
  void filterGoesWithItsDocument() {
    WindowFixture f;
    QVERIFY(openBody(f));
    auto& filter = f.control<QLineEdit>("structureFilter");
    QTest::keyClicks(&filter, QStringLiteral("kid"));
    QVERIFY(f.drop(m_body.path() + QStringLiteral("/Vessels")));
    QVERIFY(f.settled());
    QCOMPARE(filter.text(), QString());
    QTest::keyClicks(&filter, QStringLiteral("aor"));
    f.session.select({structure(f, QStringLiteral("aorta"))});
    QTest::keyClick(&f.viewport(), Qt::Key_H);
    QCOMPARE(filter.text(), QStringLiteral("aor"));
    f.session.undo();
    f.session.undo();
    QCOMPARE(filter.text(), QString());
  }

  /// The first time, behind the start page and in the program's style, panels have the widths they
  /// are made for, and names their room; afterwards they have the widths that the user gave them.
  void panelsHaveRoom() {
    WindowFixture f;
    QSettings settings(f.folder.filePath(QStringLiteral("first.ini")), QSettings::IniFormat);
    const auto widthOf = [](const widgets::MainWindow& window, const char* panel) {
      return window.findChild<QDockWidget*>(QLatin1String(panel))->width();
    };
    const auto show = [](widgets::MainWindow& window) {
      window.show();
      const bool shown = QTest::qWaitForWindowExposed(&window);
      window.resize(1600, 1000);
      QCoreApplication::processEvents();
      return shown;
    };
    {
      widgets::Session session;
      widgets::MainWindow first(session, settings);
      const widgets::ThemeFollower dressed(*qApp, first.preferences());
      QVERIFY(show(first));
      QVERIFY(first.findChild<QWidget*>(QStringLiteral("startPage"))->isVisible());
      QVERIFY2(std::abs(widthOf(first, "structuresPanel") - 400) <= 4,
               qPrintable(QString::number(widthOf(first, "structuresPanel"))));
      QVERIFY(std::abs(widthOf(first, "gammaPanel") - 304) <= 4);
      const auto nameWidth = [&first] {
        return first.tree().view().columnWidth(widgets::StructureTreeModel::name);
      };
      QVERIFY2(nameWidth() > 120, qPrintable(QString::number(nameWidth())));
      // Names are not cut to nothing by hand either.
      auto* structures = first.findChild<QDockWidget*>(QStringLiteral("structuresPanel"));
      first.resizeDocks({structures}, {60}, Qt::Horizontal);
      QCoreApplication::processEvents();
      QVERIFY2(nameWidth() > 80, qPrintable(QString::number(nameWidth())));
      first.resizeDocks({structures}, {440}, Qt::Horizontal);
      QCoreApplication::processEvents();
      first.close();
    }
    widgets::Session session;
    widgets::MainWindow again(session, settings);
    QVERIFY(show(again));
    QVERIFY(std::abs(widthOf(again, "structuresPanel") - 440) <= 4);
  }

  void summarySaysWhatIsRefined() {
    WindowFixture f;
    const auto& summary = f.control<QLabel>("summary");
    for (const int steps : {0, 1}) {
      f.session.openMade(QStringLiteral("Ball"), [steps](const auto&, const auto&) {
        model::Scene scene;
        scene.append(
            {.name = "ball", .mesh = sphere(20, 2), .provenance = {.refinementSteps = steps}});
        return Result<widgets::LoadedDocument>(
            widgets::LoadedDocument{.scene = std::move(scene), .title = QStringLiteral("Ball")});
      });
      QVERIFY(f.settled());
      QVERIFY2(summary.text().endsWith("(refined)") == (steps > 0), qPrintable(summary.text()));
    }
  }

  /// Enter in the preferences leaves them as they are.
  void enterKeepsPreferences() {
    WindowFixture f;
    f.window.preferences().set("labels/points", 17);
    f.window.findChild<QAction*>(QStringLiteral("preferences"))->trigger();
    auto* dialog = f.window.findChild<QDialog*>(QStringLiteral("preferencesDialog"));
    QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog));
    for (const QPushButton* button : dialog->findChildren<QPushButton*>())
      QCOMPARE(button->isDefault(), button->objectName() != QStringLiteral("restoreStandards"));
    QTest::keyClick(dialog, Qt::Key_Return);
    QTRY_VERIFY(!f.window.findChild<QDialog*>(QStringLiteral("preferencesDialog")));
    QCOMPARE(f.window.preferences().number("labels/points"), 17);
  }

  void focusIsOneStep() {
    WindowFixture f;
    QVERIFY(openBody(f));
    const model::NodeId id = structure(f, QStringLiteral("aorta"));
    f.session.select({id});
    QTest::mouseClick(&f.control<QWidget>("focusButton"), Qt::LeftButton);
    QVERIFY(f.settled());
    const auto gammaOf = [&f](model::NodeId each) {
      return f.session.scene().resolve(each).gamma.value();
    };
    QVERIFY(gammaOf(id) > 4.0f);
    QVERIFY(gammaOf(structure(f, QStringLiteral("bladder"))) < 3.0f);
    QCOMPARE(f.session.history().count(), 1);
  }

  void aBadDropChangesNothing_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("cut short") << "short.ply"
                               << QByteArray(
                                      "ply\nformat ascii 1.0\nelement vertex 40\n"
                                      "property float x\nproperty float y\n"
                                      "property float z\nend_header\n0 0 0\n");
    QTest::newRow("not a mesh") << "letter.obj" << QByteArray("Dear Sir or Madam,\n");
    QTest::newRow("unknown kind") << "picture.jpg" << QByteArray("\xff\xd8\xff");
    QTest::newRow("gone") << "gone.stl" << QByteArray();
  }
  void aBadDropChangesNothing() {
    QFETCH(QString, file);
    QFETCH(QByteArray, text);
    WindowFixture f;
    QVERIFY(openBody(f));
    const widgets::Document before = f.session.document();
    const QImage pictureBefore = f.picture();
    const QSize size = f.viewport().size();
    const QString path = f.folder.filePath(file);
    if (!text.isEmpty())
      writeText(path, text);
    QVERIFY(f.drop(path));
    auto& message = f.control<widgets::MessageBar>("messageBar");
    QTRY_VERIFY(message.isVisible());
    QVERIFY2(message.text().contains(file), qPrintable(message.text()));
    QVERIFY(f.session.document() == before);
    QCOMPARE(f.session.history().count(), 0);
    // The message covers nothing of the picture, which gives way and comes back.
    const auto placeOf = [&f](const QWidget& widget) {
      return QRect(widget.mapTo(&f.window, QPoint()), widget.size());
    };
    QTRY_VERIFY(!placeOf(f.viewport()).intersects(placeOf(message)));
    QVERIFY(f.settled());
    QVERIFY(message.isVisible() && placeOf(f.viewport()).top() > placeOf(message).bottom());
    QTest::mouseClick(&f.control<QWidget>("messageClose"), Qt::LeftButton);
    QVERIFY(!message.isVisible());
    QTRY_COMPARE(f.viewport().size(), size);
    QVERIFY(f.settled());
    QCOMPARE(difference(pictureBefore, f.picture()), QRect());
  }

  void anotherDropCanBeUndone() {
    WindowFixture f;
    QVERIFY(openBody(f));
    const widgets::Document before = f.session.document();
    QVERIFY(f.drop(m_body.path() + QStringLiteral("/Vessels")));
    QVERIFY(f.settled());
    QCOMPARE(int(f.session.scene().structuresBelow(model::rootId).size()), 2);
    QVERIFY(f.window.windowTitle().startsWith(QStringLiteral("Vessels")));
    f.session.undo();
    QVERIFY(f.session.document() == before);
  }

  void settingsAreKept() {
    WindowFixture f;
    f.window.findChild<QAction*>(QStringLiteral("background-dark"))->trigger();
    f.window.close();
    widgets::Session session;
    widgets::MainWindow again(session, f.settings);
    QCOMPARE(again.viewport().background(), render::Background::dark);
  }

  void controlsHaveNames() {
    WindowFixture f;
    for (const QWidget* widget : f.window.findChildren<QWidget*>()) {
      if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisible() ||
          widget->objectName().startsWith(QStringLiteral("qt_")))
        continue;
      // This is Qt's own bar of panels that share a place, which names itself by its tabs.
      if (qobject_cast<const QTabBar*>(widget) && widget->parentWidget() == &f.window)
        continue;
      const QAccessibleInterface* seen =
          QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
      QVERIFY2(!widget->objectName().isEmpty(), widget->metaObject()->className());
      QVERIFY2(seen && !seen->text(QAccessible::Name).isEmpty(), qPrintable(widget->objectName()));
    }
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::WindowTest)
#include "window_test.moc"
