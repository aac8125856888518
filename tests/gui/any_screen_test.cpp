// SPDX-License-Identifier: Apache-2.0
// Tests that the window and its dialogs fit small screens, with letters of twice the usual size
// too.
#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QMenu>
#include <QScreen>
#include <QTabWidget>
#include <QtTest>

#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

QString told(const QWidget& widget, const QSize& least) {
  return QStringLiteral("%1 “%2” needs %3 × %4")
      .arg(QLatin1String(widget.metaObject()->className()), widget.objectName())
      .arg(least.width())
      .arg(least.height());
}

/// Tells whether the window lies on its screen as a whole.
bool isOnScreen(const QWidget& window) {
  return window.screen()->availableGeometry().contains(window.frameGeometry());
}

/// Says which widgets a wide or tall one consists of: those that are as large.
void explain(const QWidget& root, QStringList& lines, int depth = 0) {
  for (const QWidget* child : root.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    const QSize least = child->minimumSizeHint().expandedTo(child->minimumSize());
    if (depth < 5 && (least.width() > 500 || least.height() > 400) && !child->isWindow()) {
      lines << QString(2 * depth + 2, ' ') + told(*child, least);
      explain(*child, lines, depth + 1);
    }
  }
}

}  // namespace

class AnyScreenTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;
  QFont m_letters;

  static QWidget* opened(WindowFixture& f, const char* action) {
    const QList<QWidget*> before = QApplication::topLevelWidgets();
    f.control<QAction>(action).trigger();
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (!before.contains(widget) && widget->isVisible() && !qobject_cast<QMenu*>(widget))
        return widget;
    return nullptr;
  }

 private slots:
  void initTestCase() {
    writeBody(m_body.path());
    m_letters = QApplication::font();
  }
  void cleanup() { QApplication::setFont(m_letters); }

  void everythingFits_data() {
    QTest::addColumn<double>("letters");
    QTest::newRow("usual letters") << 1.0;
    QTest::newRow("letters at 200 %") << 2.0;
  }
  void everythingFits() {
    QFETCH(double, letters);
    QFont font = m_letters;
    font.setPointSizeF(m_letters.pointSizeF() * letters);
    QApplication::setFont(font);
    WindowFixture f;
    QCOMPARE(f.window.screen()->size(), QSize(1024, 640));
    QVERIFY(isOnScreen(f.window));
    QVERIFY(f.drop(m_body.path()) && f.settled());
    f.session.select({f.session.scene().named("left renal vein").front()});
    QStringList large;
    const auto measure = [&large](const QWidget& widget) {
      const QSize least = widget.minimumSizeHint().expandedTo(widget.minimumSize());
      const QSize screen = widget.screen()->availableGeometry().size();
      if (least.width() > screen.width() || least.height() > screen.height() ||
          !isOnScreen(widget)) {
        large << told(widget, least);
        explain(widget, large);
      }
    };
    for (QDockWidget* dock : f.window.findChildren<QDockWidget*>())
      dock->show();
    QCoreApplication::processEvents();
    measure(f.window);
    for (const char* action : {"preferences", "controls", "about", "export", "help", "properties",
                               "printProof", "compareTechniques", "composeFigure"}) {
      QWidget* dialog = opened(f, action);
      QVERIFY2(dialog, action);
      QVERIFY(QTest::qWaitForWindowExposed(dialog));
      measure(*dialog);
      dialog->close();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QVERIFY2(large.isEmpty(), qPrintable('\n' + large.join('\n')));
  }

  /// What lies beyond the edge comes in, and wishes grow with the letters.
  void windowsComeIn() {
    WindowFixture f;
    QDialog dialog(&f.window);
    dialog.resize(5000, 200);
    dialog.move(900, 600);
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    QTRY_VERIFY(isOnScreen(dialog));
    QCOMPARE(dialog.height(), 200);
    QFont font = m_letters;
    font.setPointSizeF(m_letters.pointSizeF() * 2.0);
    QDialog large(&f.window);
    large.setFont(font);
    large.resize(300, 200);
    large.show();
    QVERIFY(QTest::qWaitForWindowExposed(&large));
    QVERIFY(large.width() > 450 && large.height() > 300 && isOnScreen(large));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::AnyScreenTest)
#include "any_screen_test.moc"
