// SPDX-License-Identifier: Apache-2.0
// Provides a window with two balls in it, and helpers that operate its export dialog.
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDirIterator>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QToolButton>
#include <QtTest>

#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "widgets/export/export_dialog.h"
#include "widgets/export/export_preview.h"
#include "widgets/shell/message_bar.h"

namespace sline::test {

using widgets::ExportDialog;

inline model::Annotation labelOn(model::NodeId structure, const char* english, const char* german) {
  model::Annotation label;
  label.anchors = {model::SurfacePoint{.structure = structure, .triangle = 5}};
  label.found = true;
  label.text = english;
  label.texts["de"] = german;
  return label;
}

/// Provides a window with two balls, a label on each and two saved views, and helpers that operate
/// the dialog.
struct ExportDesk : WindowFixture {
  QTemporaryDir out;

  explicit ExportDesk(int fineness = 3) {
    // The page is landscape, whatever the window's shape is.
    settings.setValue(QStringLiteral("export/width"), 160);
    settings.setValue(QStringLiteral("export/height"), 90);
    // Films are short.
    settings.setValue(QStringLiteral("export/options/seconds"), 1);
    settings.setValue(QStringLiteral("export/options/framesPerSecond"), 5);
    settings.setValue(QStringLiteral("export/options/filmFormat"), QStringLiteral("page"));
    settings.setValue(QStringLiteral("export/options/filmHeight"), 90);
    open(fineness);
  }

  void open(int fineness) {
    session.openMade(QStringLiteral("Balls"), [fineness](const auto&, const auto&) {
      model::Scene scene;
      const model::MeshPtr ball = sphere(20, fineness);
      const auto left =
          scene.append({.name = "left ball", .mesh = moved(*ball, 1.0f, {30.0f, 0.0f, 0.0f})});
      const auto right =
          scene.append({.name = "right ball", .mesh = moved(*ball, 1.0f, {-30.0f, 0.0f, 0.0f})});
      scene.appendAnnotation(labelOn(left, "The left one", "Die linke"));
      scene.appendAnnotation(labelOn(right, "The right one", "Die rechte"));
      model::View front{.name = "Front/ \xE5\xBF\x83"};
      model::View back{.name = "front- \xE5\xBF\x83"};  // the same name if case does not count
      back.camera.eye = {0.0f, 1000.0f, 0.0f};
      scene.setViews({front, back});
      return Result<widgets::LoadedDocument>(
          widgets::LoadedDocument{.scene = std::move(scene), .title = QStringLiteral("Balls")});
    });
    if (!settled())
      qFatal("the scene does not come");
  }

  ExportDialog* dialog() { return window.findChild<ExportDialog*>(); }
  ExportDialog& show() {
    QTest::keyClick(&viewport(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    if (!QTest::qWaitFor([this] { return dialog() && dialog()->isVisible(); }))
      qFatal("no dialog");
    // There is no window manager to activate it.
    QApplication::setActiveWindow(dialog());
    return *dialog();
  }
  template <class T>
  T& part(const char* name) {
    T* found = dialog()->findChild<T*>(QLatin1String(name));
    if (!found)
      qFatal("the dialog has no %s", name);
    return *found;
  }
  /// Chooses the kind by arrow keys, from the top.
  void chooseKind(const QString& id) {
    auto& kinds = part<QListWidget>("exportKinds");
    kinds.setFocus();
    QTest::keyClick(&kinds, Qt::Key_Home);
    for (int i = 0; i < kinds.count() && kinds.currentItem()->data(Qt::UserRole) != id; ++i)
      QTest::keyClick(&kinds, Qt::Key_Down);
    QCOMPARE(kinds.currentItem()->data(Qt::UserRole).toString(), id);
  }
  void pick(const char* name, const QString& text) {
    auto& box = part<QComboBox>(name);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_Home);
    for (int i = 0; i < box.count() && box.currentText() != text; ++i)
      QTest::keyClick(&box, Qt::Key_Down);
    QCOMPARE(box.currentText(), text);
    // A click on the entry would emit this; arrow keys do so only while the list is open.
    emit box.activated(box.currentIndex());
  }
  void number(const char* name, double value) {
    auto& box = part<QDoubleSpinBox>(name);
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, QLocale().toString(value, 'f', box.decimals()));
    QTest::keyClick(&box, Qt::Key_Tab);
  }
  void target(const QString& path) {
    auto& line = part<QLineEdit>("exportTarget");
    line.setFocus();
    line.selectAll();
    QTest::keyClick(&line, Qt::Key_Delete);
    // Not every character has a key.
    line.setText(path);
  }
  void click(const char* button) {
    auto& pressed = part<QAbstractButton>(button);
    // The click goes to the button's box, since a line is longer than its text.
    QTest::mouseClick(&pressed, Qt::LeftButton, {}, {8, pressed.height() / 2});
  }
  /// Sets a small page, so that every kind is quick.
  void small() {
    number("exportWidth", 60);
    number("exportHeight", 45);
  }
  QString message() { return control<widgets::MessageBar>("messageBar").text(); }
  bool exporting() { return window.findChild<QToolButton*>(QStringLiteral("exportCancel")); }
  bool finished() {
    return QTest::qWaitFor([this] { return !exporting(); }, 120'000);
  }
  bool previewed() {
    return QTest::qWaitFor([this] { return dialog()->preview().upToDate(); }, 60'000);
  }
  /// Returns all files below the folder that exports went to.
  QStringList written() {
    QStringList names;
    for (QDirIterator each(out.path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
         each.hasNext();)
      names << QDir(out.path()).relativeFilePath(each.next());
    names.sort();
    return names;
  }
};

}  // namespace sline::test
