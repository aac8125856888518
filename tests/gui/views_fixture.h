// SPDX-License-Identifier: Apache-2.0
// Provides a window with two balls in it, and helpers that operate its panel of views.
#pragma once

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QtTest>
#include <array>

#include "model/edit/look.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "widgets/views/view_list.h"
#include "widgets/views/view_pictures.h"
#include "widgets/views/view_row.h"
#include "widgets/views/views_panel.h"

namespace sline::test {

struct Views : WindowFixture {
  model::NodeId left;
  model::NodeId right;

  explicit Views(const std::vector<model::View>& views = {}) {
    session.openMade(QStringLiteral("Balls"), [this, views](const auto&, const auto&) {
      model::Scene scene;
      left = scene.append(
          {.name = "left ball", .mesh = moved(*sphere(20, 3), 1.0f, {30.0f, 0.0f, 0.0f})});
      right = scene.append(
          {.name = "right ball", .mesh = moved(*sphere(20, 3), 1.0f, {-30.0f, 0.0f, 0.0f})});
      scene.setViews(views);
      return Result<widgets::LoadedDocument>(
          widgets::LoadedDocument{.scene = std::move(scene), .title = QStringLiteral("Balls")});
    });
    if (!settled())
      qFatal("the scene does not come");
  }

  const model::Scene& scene() const { return session.scene(); }
  QString names() const {
    QStringList all;
    for (const model::View& view : scene().views())
      all << QString::fromStdString(view.name);
    return all.join(QLatin1Char('|'));
  }
  QDockWidget& dock() { return control<QDockWidget>("viewsPanel"); }
  widgets::ViewRow& row() { return control<widgets::ViewRow>("viewRow"); }
  QRect card(int index) { return row().visualRect(row().model()->index(index, 0)); }
  void clickCard(int index) {
    QTest::mouseClick(row().viewport(), Qt::LeftButton, {}, card(index).center());
  }
  /// Goes to the view of the card and presents from there on; returns the scene before that.
  model::Scene presentedFrom(int index) {
    clickCard(index);
    if (!settled())
      qFatal("no picture");
    const model::Scene before = scene();
    QTest::keyClick(&viewport(), Qt::Key_F5, Qt::ShiftModifier);
    if (!settled())
      qFatal("no presentation");
    return before;
  }
  void press(const char* button) {
    QTest::mouseClick(&control<QToolButton>(button), Qt::LeftButton);
  }
  void add(const char* key) {
    QTest::keyClick(&viewport(), Qt::Key(key[0]));
    QTest::keyClick(&viewport(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
  }
  /// Adds two views that differ in camera and Γ; the second is the one on screen.
  bool addFrontAndBack() {
    add("A");
    setGamma(left, 5.0f);
    add("P");
    return settled();
  }
  /// Adds front, back and left.
  void addThree() {
    for (const char* key : {"A", "P", "L"})
      add(key);
    QVERIFY(settled());
  }
  /// Has all views show all labels; a new one takes those alone that are no other's.
  void showAllLabels() {
    model::Scene all = scene();
    std::vector<model::Annotation> annotations = all.annotations();
    for (model::Annotation& annotation : annotations)
      annotation.visible = true;
    all.setAnnotations(std::move(annotations));
    std::vector<model::View> views = all.views();
    for (model::View& view : views)
      view.annotations.reset();
    all.setViews(std::move(views));
    session.apply(QStringLiteral("labels"), {std::move(all), true});
  }
  void setGamma(model::NodeId id, float gamma) {
    session.apply(QStringLiteral("Γ"),
                  model::withLook(scene(), std::array{id}, {.gamma = Gamma::clamped(gamma)}));
  }
  void type(const QString& name) {
    auto* editor = row().findChild<QLineEdit*>(QStringLiteral("viewName"));
    if (!editor)
      qFatal("no name is being typed");
    editor->selectAll();
    QTest::keyClicks(editor, name);
    QTest::keyClick(editor, Qt::Key_Return);
    typed();
  }
  /// Waits for the event loop to take over what was typed.
  void typed() {
    if (!QTest::qWaitFor(
            [this] { return !row().findChild<QLineEdit*>(QStringLiteral("viewName")); }))
      qFatal("the name is still being typed");
  }
  int steps() { return session.history().index(); }
  void undo() { QTest::keyClick(&viewport(), Qt::Key_Z, Qt::ControlModifier); }
  void fly() {
    settings.setValue(QStringLiteral("navigation/flights"), true);
    viewport().setFlights(true);
  }
  QString presented() {
    const auto& label = control<QLabel>("presentedView");
    return label.isVisible() ? label.text() : QString();
  }
  const widgets::ViewPictures& pictures() {
    return window.findChild<widgets::ViewsPanel*>(QStringLiteral("views"))->pictures();
  }
  QImage cardPicture(int index) {
    return row().model()->index(index, 0).data(Qt::DecorationRole).value<QImage>();
  }
  bool pictured(int count) {
    constexpr int minute = 60'000;
    return QTest::qWaitFor(
        [&] {
          for (int i = 0; i < count; ++i)
            if (cardPicture(i).isNull())
              return false;
          return true;
        },
        minute);
  }
};

}  // namespace sline::test
