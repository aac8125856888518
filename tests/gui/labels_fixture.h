// SPDX-License-Identifier: Apache-2.0
// Provides a window with a liver and a bladder in it, and helpers that label them.
#pragma once

#include <QAction>
#include <QPlainTextEdit>
#include <QtTest>

#include "model/edit/annotations.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"

namespace sline::test {

struct Labels : WindowFixture {
  model::NodeId liver;
  model::NodeId bladder;

  explicit Labels(const std::vector<model::View>& views = {}) {
    session.openMade(QStringLiteral("Organs"), [this, views](const auto&, const auto&) {
      model::Scene scene;
      const auto ball = [&scene](const char* name, float x) {
        model::Style style;
        style.fill = model::Fill::paper;
        return scene.append(
            {.name = name, .style = style, .mesh = moved(*sphere(20, 3), 1.0f, {x, 0.0f, 0.0f})});
      };
      liver = ball("liver", -30.0f);
      bladder = ball("bladder", 30.0f);
      scene.setViews(views);
      return Result<widgets::LoadedDocument>(
          widgets::LoadedDocument{.scene = std::move(scene), .title = QStringLiteral("Organs")});
    });
    if (!settled())
      qFatal("the scene does not come");
    QTest::keyClick(&viewport(), Qt::Key_A);
    if (!settled())
      qFatal("no picture from the front");
  }

  const std::vector<model::Annotation>& annotations() { return session.scene().annotations(); }
  const model::Annotation& only() {
    if (annotations().size() != 1)
      qFatal("%zu annotations", annotations().size());
    return annotations().front();
  }
  widgets::PictureLabels& labels() { return viewport().labels(); }
  const widgets::LabelSheet& sheet() {
    if (!settled() || !labels().layer().sheet())
      qFatal("no labels in the picture");
    return *labels().layer().sheet();
  }
  QPoint middleOf(model::NodeId id) { return areaOf(id).center(); }
  QPoint textAt(model::AnnotationId id) { return widgets::boxOf(sheet(), id).center().toPoint(); }
  QPoint placeAt(model::AnnotationId id, std::size_t which = 0) {
    for (const render::ShownLabel& label : sheet().plate.labels)
      if (label.item.id == id) {
        const glm::vec2 p = sheet().wish.pixelsPerMm * label.item.places[which];
        return {qRound(p.x), qRound(p.y)};
      }
    qFatal("the label is not in the picture");
  }
  /// Returns the lines of each label in the picture.
  QStringList shownLines() {
    QStringList all;
    const widgets::LabelSheet& now = sheet();
    for (std::size_t i = 0; i < now.plate.labels.size(); ++i)
      if (now.plate.layout.find(now.plate.labels[i].item.id))
        all << render::plainText(now.plate.texts[i].lines, QChar('/'));
    return all;
  }
  model::NodeId structureOf(const model::Annotation& annotation, std::size_t place = 0) {
    return std::get<model::SurfacePoint>(annotation.anchors.at(place)).structure;
  }

  void key(Qt::Key which, Qt::KeyboardModifiers keys = {}) {
    QTest::keyClick(&viewport(), which, keys);
  }
  void click(const QPoint& at) { QTest::mouseClick(&viewport(), Qt::LeftButton, {}, at); }
  widgets::LabelEditor& editor() { return labels().editor(); }
  bool typing() {
    return QTest::qWaitFor([this] { return editor().isOpen() && editor().hasFocus(); });
  }
  /// Makes a label of that kind by hand.
  void make(model::NodeId on, const QString& text, Qt::Key key = Qt::Key_T,
            Qt::KeyboardModifiers keys = {}) {
    this->key(key, keys);
    click(middleOf(on));
    if (!typing())
      qFatal("no words can be typed");
    if (!text.isNull())
      QTest::keyClicks(&editor(), text);
    QTest::keyClick(&editor(), Qt::Key_Return);
    this->key(Qt::Key_Escape);
    if (!settled())
      qFatal("no picture with the label");
  }
  void undo() { key(Qt::Key_Z, Qt::ControlModifier); }
  void redo() { session.redo(); }
  int steps() { return session.history().index(); }
  QString step() { return session.history().undoText(); }
  void change(const std::function<void(model::Annotation&)>& how) {
    model::Annotation annotation = only();
    how(annotation);
    session.apply(QStringLiteral("change"),
                  model::withAnnotationChanged(session.scene(), annotation.id, annotation));
  }
  QImage whole() { return viewport().grab().toImage().convertToFormat(QImage::Format_RGB32); }
};

}  // namespace sline::test
