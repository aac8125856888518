// SPDX-License-Identifier: Apache-2.0
// Tests every control of the window and its dialogs, in every language: its text has room, it says
// what it is to users who do not see it, and the keyboard gets there.
#include <QAccessible>
#include <QAction>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>
#include <QtTest>

#include "tests/gui/keyboard.h"
#include "tests/gui/text_fit.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/language/language_switch.h"
#include "widgets/language/languages.h"
#include "widgets/shell/message_bar.h"

namespace sline::test {

namespace {

/// Provides a window with a scene, a structure selected, all panels shown and all folds open.
struct Open : WindowFixture {
  widgets::LanguageSwitch language;

  explicit Open(const QString& speaks, const QString& body) {
    language.follow(window.preferences());
    window.resize(1280, 800);
    if (!drop(body) || !settled())
      qFatal("the scene does not open");
    session.select({session.scene().named("left renal vein").front()});
    language.use(speaks);
    QCoreApplication::sendPostedEvents();
    // The scene is in English, and its names must be as long in any language.
    window.preferences().set(QStringLiteral("language/structures"), QStringLiteral("interface"));
    for (QDockWidget* dock : docks())
      dock->show();
    unfold(window);
    QCoreApplication::processEvents();
  }
  ~Open() { language.use(QStringLiteral("en")); }

  QList<QDockWidget*> docks() { return window.findChildren<QDockWidget*>(); }
  /// Opens what checkable tool buttons fold away.
  static void unfold(QWidget& root) {
    for (QToolButton* button : root.findChildren<QToolButton*>())
      if (button->isCheckable() && !button->isChecked() && !button->defaultAction() &&
          button->arrowType() != Qt::NoArrow)
        button->click();
  }
};

/// Saves a picture to look at: SLINE_SCREENSHOTS names a folder that takes the pictures.
void keep(QWidget& widget, const QString& name) {
  const QString folder = qEnvironmentVariable("SLINE_SCREENSHOTS");
  if (!folder.isEmpty())
    QVERIFY(QDir().mkpath(folder) && widget.grab().save(folder + '/' + name + ".png"));
}

QString nameOf(QWidget* widget) {
  const QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(widget);
  return seen ? seen->text(QAccessible::Name) : QString();
}

QSet<QAction*> actionsInMenus(QMainWindow& window) {
  QSet<QAction*> all;
  QList<QMenu*> open;
  for (QAction* action : window.menuBar()->actions())
    open << action->menu();
  while (!open.isEmpty())
    for (QAction* action : open.takeLast()->actions()) {
      all << action;
      if (action->menu())
        open << action->menu();
    }
  return all;
}

}  // namespace

class EveryControlTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

  static void languages() {
    QTest::addColumn<QString>("language");
    for (const widgets::InterfaceLanguage& language : widgets::interfaceLanguages())
      QTest::newRow(qPrintable(language.id)) << language.id;
  }

  /// Returns the dialogs that actions open, by the action's id.
  static QStringList dialogActions() {
    return {QStringLiteral("preferences"), QStringLiteral("controls"), QStringLiteral("about"),
            QStringLiteral("export"), QStringLiteral("help")};
  }
  static QWidget* opened(Open& f, const QString& action) {
    const QList<QWidget*> before = QApplication::topLevelWidgets();
    f.control<QAction>(qPrintable(action)).trigger();
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (!before.contains(widget) && widget->isVisible() && !qobject_cast<QMenu*>(widget))
        return widget;
    return nullptr;
  }

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void textsHaveRoom_data() { languages(); }
  void textsHaveRoom() {
    QFETCH(QString, language);
    Open f(language, m_body.path());
    QStringList clipped;
    // Panels that share a place are seen one after the other.
    for (QDockWidget* dock : f.docks()) {
      dock->raise();
      QCoreApplication::processEvents();
      clipped << clippedTexts(f.window);
    }
    keep(f.window, QStringLiteral("window-") + language);
    f.control<widgets::MessageBar>("messageBar")
        .showRemarks({QStringLiteral("one"), QStringLiteral("two")});
    QCoreApplication::processEvents();
    clipped << clippedTexts(f.window);
    clipped.removeDuplicates();
    QCOMPARE(f.window.size(), QSize(1280, 800));
    QVERIFY2(clipped.isEmpty(), qPrintable('\n' + clipped.join('\n')));
  }

  void dialogsHaveRoom_data() { languages(); }
  void dialogsHaveRoom() {
    QFETCH(QString, language);
    Open f(language, m_body.path());
    QStringList clipped;
    for (const QString& action : dialogActions()) {
      QWidget* dialog = opened(f, action);
      QVERIFY2(dialog, qPrintable(action));
      QVERIFY(QTest::qWaitForWindowExposed(dialog));
      auto* pages = dialog->findChild<QTabWidget*>();
      for (int page = 0; page < (pages ? pages->count() : 1); ++page) {
        if (pages)
          pages->setCurrentIndex(page);
        QCoreApplication::processEvents();
        clipped << clippedTexts(*dialog);
        keep(*dialog, QStringLiteral("%1%2-%3").arg(action).arg(page).arg(language));
      }
      dialog->close();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    clipped.removeDuplicates();
    QVERIFY2(clipped.isEmpty(), qPrintable('\n' + clipped.join('\n')));
  }

  void menusHaveNoKeyTwice_data() { languages(); }
  void menusHaveNoKeyTwice() {
    QFETCH(QString, language);
    Open f(language, m_body.path());
    QStringList twice;
    QList<QList<QAction*>> menus{f.window.menuBar()->actions()};
    for (QMenu* menu : f.window.findChildren<QMenu*>())
      menus << menu->actions();
    for (const QList<QAction*>& menu : menus) {
      QMap<QString, QString> letters;
      for (const QAction* action : menu) {
        const QString key = QKeySequence::mnemonic(action->text()).toString();
        if (key.isEmpty())
          continue;
        if (letters.contains(key))
          twice << key + ": " + letters[key] + ", " + action->text();
        letters[key] = action->text();
      }
    }
    QVERIFY2(twice.isEmpty(), qPrintable('\n' + twice.join('\n')));
  }

  void controlsSayWhatTheyAre_data() { languages(); }
  void controlsSayWhatTheyAre() {
    QFETCH(QString, language);
    Open f(language, m_body.path());
    QStringList silent;
    QList<QWidget*> roots{&f.window};
    for (const QString& action : dialogActions())
      roots << opened(f, action);
    for (QWidget* root : roots)
      for (QWidget* widget : actingWidgets(*root))
        if (nameOf(widget).trimmed().isEmpty())
          silent << QStringLiteral("%1 “%2” in %3 in %4")
                        .arg(QLatin1String(widget->metaObject()->className()), widget->objectName(),
                             widget->parentWidget()->objectName(), root->objectName());
    silent.removeDuplicates();
    QVERIFY2(silent.isEmpty(), qPrintable('\n' + silent.join('\n')));
  }

  void keyboardGetsEverywhere() {
    Open f(QStringLiteral("en"), m_body.path());
    const QSet<QAction*> inMenus = actionsInMenus(f.window);
    QStringList lost;
    for (QAction* action : f.window.findChildren<QAction*>())
      if (!action->objectName().isEmpty() && !inMenus.contains(action) &&
          action->shortcuts().isEmpty() && !action->isSeparator() &&
          f.window.actions().contains(action))
        lost << "action " + action->objectName();
    for (QDockWidget* dock : f.docks()) {
      dock->raise();
      QCoreApplication::processEvents();
      f.control<QWidget>("structureFilter").setFocus();
      const QSet<QWidget*> reached = reachedByTab(f.window);
      QVERIFY(reached.size() > 5);
      for (QWidget* widget : actingWidgets(*dock)) {
        if (!widget->isEnabled() || widget->visibleRegion().isEmpty())
          continue;
        const auto* button = qobject_cast<QToolButton*>(widget);
        const bool elsewhere =
            button && (inMenus.contains(button->defaultAction()) || !button->shortcut().isEmpty());
        if (!reached.contains(widget) && !elsewhere && !besideReached(widget, reached))
          lost << QLatin1String(widget->metaObject()->className()) + ' ' + widget->objectName();
      }
      QVERIFY(reached.contains(&f.viewport()));
    }
    for (const QToolButton* button : f.control<QToolBar>("tools").findChildren<QToolButton*>())
      if (button->defaultAction() && !inMenus.contains(button->defaultAction()))
        lost << "tool " + button->defaultAction()->objectName();
    lost.removeDuplicates();
    QVERIFY2(lost.isEmpty(), qPrintable('\n' + lost.join('\n')));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::EveryControlTest)
#include "every_control_test.moc"
