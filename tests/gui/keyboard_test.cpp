// SPDX-License-Identifier: Apache-2.0
// Tests that the window can be worked with the keyboard alone: every control is reached and shows
// that it has the keyboard, from the start page on and in another language.
#include "tests/gui/keyboard.h"

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QtTest>

#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/help/help_browser.h"
#include "widgets/language/language_switch.h"

namespace sline::test {

namespace {

QString told(const QWidget& widget) {
  return QLatin1String(widget.metaObject()->className()) + QStringLiteral(" “") +
         widget.objectName() + QStringLiteral("” ") + widget.accessibleName();
}

/// Returns the part of the window around the widget.
QImage around(QWidget& widget) {
  constexpr int margin = 4;
  QWidget* window = widget.window();
  const QRect place(widget.mapTo(window, QPoint()), widget.size());
  return window->grab(place.adjusted(-margin, -margin, margin, margin)).toImage();
}

/// Returns those of the widgets that look the same with the keyboard and without it.
QStringList withoutRing(QWidget& window, const QSet<QWidget*>& widgets) {
  QStringList same;
  for (QWidget* widget : widgets) {
    window.setFocus();
    if (QWidget* at = QApplication::focusWidget())
      at->clearFocus();
    QCoreApplication::processEvents();
    const QImage before = around(*widget);
    widget->setFocus(Qt::TabFocusReason);
    QCoreApplication::processEvents();
    if (widget->hasFocus() && around(*widget) == before)
      same << told(*widget);
  }
  same.sort();
  return same;
}

}  // namespace

class KeyboardTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void startPage() {
    WindowFixture f;
    auto& page = f.control<QWidget>("startPage");
    QVERIFY(page.isVisible() && QApplication::focusWidget());
    const QSet<QWidget*> reached = reachedByTab(f.window);
    QStringList lost;
    for (QWidget* widget : actingWidgets(page))
      if (!reached.contains(widget) && !besideReached(widget, reached))
        lost << told(*widget);
    QVERIFY2(lost.isEmpty(), qPrintable('\n' + lost.join('\n')));
    QSet<QWidget*> onPage;
    for (QWidget* widget : reached)
      if (page.isAncestorOf(widget))
        onPage << widget;
    QVERIFY(onPage.size() > 3);
    const QStringList same = withoutRing(f.window, onPage);
    QVERIFY2(same.isEmpty(), qPrintable('\n' + same.join('\n')));
  }
  void f1OnTheStartPage() {
    WindowFixture f;
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
    auto* page = f.window.findChild<widgets::HelpBrowser*>();
    QVERIFY(page && page->isVisible());
    QCOMPARE(page->page(), QStringLiteral("start"));
  }
  void focusIsSeen() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()) && f.settled());
    f.session.select({f.session.scene().named("left renal vein").front()});
    QStringList same;
    for (QDockWidget* dock : f.window.findChildren<QDockWidget*>()) {
      dock->show();
      dock->raise();
      QCoreApplication::processEvents();
      f.control<QWidget>("structureFilter").setFocus();
      QSet<QWidget*> inPanel;
      for (QWidget* widget : reachedByTab(f.window))
        if (dock->isAncestorOf(widget) && !widget->visibleRegion().isEmpty())
          inPanel << widget;
      same << withoutRing(f.window, inPanel);
    }
    QVERIFY2(same.isEmpty(), qPrintable('\n' + same.join('\n')));
  }
  void keysLiveAfterTheLanguageChanged() {
    WindowFixture f;
    widgets::LanguageSwitch language;
    language.follow(f.window.preferences());
    QVERIFY(f.drop(m_body.path()) && f.settled());
    // What has the keyboard goes with the language, and need not have a name.
    f.control<QDockWidget>("gammaPanel").findChild<QAbstractButton*>()->setFocus();
    language.use(QStringLiteral("de"));
    QCoreApplication::sendPostedEvents();
    QVERIFY(QApplication::focusWidget());
    const glm::vec3 before = f.viewport().camera().eye;
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_P);
    QTRY_VERIFY(glm::length(f.viewport().camera().eye - before) > 1.0f);
    language.use(QStringLiteral("en"));
  }
  void allPanelsHideWithOneKey() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()) && f.settled());
    const auto shown = [&f] {
      QStringList names;
      for (const QDockWidget* dock : f.window.findChildren<QDockWidget*>())
        if (!dock->isHidden())
          names << dock->objectName();
      return names;
    };
    const QStringList before = shown();
    QVERIFY(before.size() > 3);
    QTest::keyClick(&f.viewport(), Qt::Key_F12);
    QVERIFY(shown().isEmpty());
    QTest::keyClick(&f.viewport(), Qt::Key_F12);
    QCOMPARE(shown(), before);
    // One that was fetched meanwhile is hidden with the others, and those come back together.
    QTest::keyClick(&f.viewport(), Qt::Key_F12);
    f.control<QDockWidget>("historyPanel").show();
    QTest::keyClick(&f.viewport(), Qt::Key_F12);
    QVERIFY(shown().isEmpty());
    QTest::keyClick(&f.viewport(), Qt::Key_F12);
    QCOMPARE(shown(), QStringList{QStringLiteral("historyPanel")});
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::KeyboardTest)
#include "keyboard_test.moc"
