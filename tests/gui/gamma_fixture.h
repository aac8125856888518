// SPDX-License-Identifier: Apache-2.0
// Provides the window with the small body open, and helpers that operate the panel of Γ.
#pragma once

#include <QMenu>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include "tests/gui/window_fixture.h"
#include "widgets/form/range_box.h"
#include "widgets/gamma/gamma_slider.h"
#include "widgets/gamma/stage_strip.h"

namespace sline::test {

inline constexpr int minute = 60'000;

/// Provides the window with the small body open, and helpers that operate the panel.
struct GammaPanelFixture : WindowFixture {
  QTemporaryDir body;

  GammaPanelFixture() {
    writeBody(body.path());
    if (!drop(body.path()) || !settled())
      qFatal("the body does not open");
  }
  model::NodeId named(const char* name) { return session.scene().named(name).front(); }
  float gammaOf(const char* name) { return session.scene().resolve(named(name)).gamma.value(); }
  int steps() { return session.history().count(); }
  widgets::GammaSlider& slider() { return control<widgets::GammaSlider>("gammaSlider"); }
  widgets::RangeBox& number() { return control<widgets::RangeBox>("gammaNumber"); }
  widgets::StageButton& stage(int gamma) {
    return control<widgets::StageButton>(qPrintable(QStringLiteral("stage%1").arg(gamma)));
  }
  void click(QWidget& widget) {
    QTest::mouseClick(&widget, Qt::LeftButton, {}, widget.rect().center());
  }
  void unfold() {
    click(control<QToolButton>("more"));
    QCoreApplication::processEvents();
  }
  /// Returns the entry of the menu below "My presets" with that text or object name.
  QAction& presetEntry(const QString& which) {
    auto& menu = control<QMenu>("presetMenu");
    emit menu.aboutToShow();
    for (QAction* action : menu.actions())
      if (action->text() == which || action->objectName() == which)
        return *action;
    qFatal("no entry %s", qPrintable(which));
  }
  bool pictured() {
    return QTest::qWaitFor(
        [this] {
          for (int gamma = 0; gamma <= 5; ++gamma)
            if (stage(gamma).picture().isNull())
              return false;
          return true;
        },
        minute);
  }
};

}  // namespace sline::test
