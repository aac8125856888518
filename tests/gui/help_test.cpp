// SPDX-License-Identifier: Apache-2.0
// Tests F1 in each panel, the pages, their links, and that no link leads outside without a
// question.
#include <QAction>
#include <QDialog>
#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QtTest>

#include "model/edit/visibility.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/help/help_browser.h"
#include "widgets/help/help_pages.h"
#include "widgets/help/help_window.h"

namespace sline::test {

class HelpTest : public QObject {
  Q_OBJECT

  static widgets::HelpBrowser* pageOf(WindowFixture& f) {
    return f.window.findChild<widgets::HelpBrowser*>(QStringLiteral("helpPage"));
  }
  /// Returns the targets of links and pictures of a page.
  static QStringList targets(QString text) {
    static const QRegularExpression code(QStringLiteral("`[^`]*`"));  // shows what links look like
    static const QRegularExpression link(QStringLiteral("\\]\\(([^)]+)\\)"));
    text.remove(code);
    QStringList found;
    for (auto match = link.globalMatch(text); match.hasNext();)
      found << match.next().captured(1);
    return found;
  }

 private slots:
  void keyOpensThePage_data() {
    QTest::addColumn<QString>("widget");
    QTest::addColumn<QString>("page");
    QTest::newRow("list") << "structureTree"
                          << "tree";
    QTest::newRow("filter") << "structureFilter"
                            << "tree";
    QTest::newRow("slider") << "gammaSlider"
                            << "gamma";
    QTest::newRow("picture") << "viewport"
                             << "picture";
  }
  void keyOpensThePage() {
    QFETCH(QString, widget);
    QFETCH(QString, page);
    const QTemporaryDir body;
    writeBody(body.path());
    WindowFixture f;
    QVERIFY(f.drop(body.path()) && f.settled());
    f.session.select({f.session.scene().named("bladder").front()});
    auto* focused = f.window.findChild<QWidget*>(widget);
    QVERIFY(focused);
    focused->setFocus();
    QTRY_COMPARE(QApplication::focusWidget(), focused);
    QTest::keyClick(focused, Qt::Key_F1);
    QVERIFY(pageOf(f));
    QCOMPARE(pageOf(f)->page(), page);
    QVERIFY(pageOf(f)->window()->isVisible());
    QVERIFY(pageOf(f)->toPlainText().size() > 200);
    // A second F1 does not open a second window.
    QTest::keyClick(focused, Qt::Key_F1);
    QCOMPARE(f.window.findChildren<widgets::HelpWindow*>().size(), 1);
  }

  void keyWorksInDialogs() {
    WindowFixture f;
    f.control<QAction>("controls").trigger();
    auto* dialog = f.window.findChild<QDialog*>(QStringLiteral("controlsDialog"));
    QVERIFY(dialog);
    QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_F1);
    auto* help = dialog->findChild<widgets::HelpWindow*>();
    QVERIFY(help && help->isVisible());
    QCOMPARE(help->findChild<widgets::HelpBrowser*>()->page(), QStringLiteral("keys"));
    dialog->close();
  }

  void pagesAreWhole() {
    const std::vector<QString> ids = widgets::helpPageIds();
    for (const char* language : {"en", "de"})
      for (const QString& id : ids) {
        const QString text = widgets::helpText(id, QLocale(QLatin1String(language)));
        QVERIFY2(text.startsWith(QStringLiteral("# ")), qPrintable(id));
        QVERIFY(!widgets::helpTitle(id, QLocale(QLatin1String(language))).isEmpty());
        for (const QString& target : targets(text)) {
          if (target.startsWith(QStringLiteral("http")))
            continue;
          const bool page = target.endsWith(QStringLiteral(".md"));
          QVERIFY2(page ? !widgets::helpText(target.chopped(3), QLocale()).isEmpty()
                        : QFile::exists(QStringLiteral(":/help/") + target),
                   qPrintable(id + ": " + target));
        }
      }
    QVERIFY(widgets::helpText(QStringLiteral("../secret"), QLocale()).isEmpty());
  }

  void linksAndSearchLeadOn() {
    WindowFixture f;
    widgets::HelpWindow help;
    help.showPage(QStringLiteral("start"));
    help.show();
    QVERIFY(QTest::qWaitForWindowExposed(&help));
    auto* page = help.findChild<widgets::HelpBrowser*>();
    auto* contents = help.findChild<QListWidget*>(QStringLiteral("helpContents"));
    QCOMPARE(contents->count(), int(widgets::helpPageIds().size()));
    emit page->anchorClicked(QUrl(QStringLiteral("gamma.md")));
    QCOMPARE(page->page(), QStringLiteral("gamma"));
    QCOMPARE(contents->currentRow(), 2);
    QTest::mouseClick(help.findChild<QWidget*>(QStringLiteral("helpBack")), Qt::LeftButton);
    QCOMPARE(page->page(), QStringLiteral("start"));
    QTest::mouseClick(help.findChild<QWidget*>(QStringLiteral("helpForward")), Qt::LeftButton);
    QCOMPARE(page->page(), QStringLiteral("gamma"));
    auto* search = help.findChild<QLineEdit*>(QStringLiteral("helpSearch"));
    QTest::keyClicks(search, QStringLiteral("tracing paper"));
    QCOMPARE(contents->count(), 1);
    search->clear();
    QTest::keyClicks(search, QStringLiteral("mmCIF"));
    QVERIFY(contents->count() >= 1);
    QTest::keyClick(search, Qt::Key_Return);
    QVERIFY(page->toPlainText().contains(QStringLiteral("mmCIF"), Qt::CaseInsensitive));
    QVERIFY(page->textCursor().hasSelection());
    search->clear();
    QTest::keyClicks(search, QStringLiteral("nothing like zebras anywhere"));
    QCOMPARE(contents->count(), 0);
  }

  /// What is typed there is taken back in the line, and nothing of the scene, even where the line
  /// has nothing left to take back.
  void searchTakesBackItsOwn() {
    const QTemporaryDir body;
    writeBody(body.path());
    WindowFixture f;
    QVERIFY(f.drop(body.path()) && f.settled());
    const model::NodeId bladder[] = {f.session.scene().named("bladder").front()};
    QVERIFY(f.session.apply(QStringLiteral("Hide"), model::withHidden(f.session.scene(), bladder)));
    const model::Scene before = f.session.scene();
    widgets::HelpWindow help;
    help.show();
    QVERIFY(QTest::qWaitForWindowExposed(&help));
    QApplication::setActiveWindow(&help);  // there is no window manager to do it
    auto* search = help.findChild<QLineEdit*>(QStringLiteral("helpSearch"));
    search->setFocus();
    QTest::keyClicks(search, QStringLiteral("zebras"));
    for (int i = 0; i < 3; ++i)
      QTest::keyClick(search, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(search->text().isEmpty());
    QVERIFY(f.session.scene() == before);
    QTest::keyClick(search, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(search->text(), QStringLiteral("zebras"));
  }

  void nothingLeadsOutsideUnasked() {
    widgets::HelpWindow help;
    help.showPage(QStringLiteral("start"));
    help.show();
    auto* page = help.findChild<widgets::HelpBrowser*>();
    emit page->anchorClicked(QUrl(QStringLiteral("https://example.org/a")));
    auto* box = help.findChild<QMessageBox*>(QStringLiteral("outsideDialog"));
    QVERIFY(box && box->text().contains(QStringLiteral("https://example.org/a")));
    QCOMPARE(page->page(), QStringLiteral("start"));
    box->reject();
    // Pictures are not fetched from elsewhere, and files are not read.
    for (const char* address :
         {"https://example.org/a.png", "file:///etc/passwd", "../../etc/passwd"})
      for (const int type : {int(QTextDocument::ImageResource), int(QTextDocument::HtmlResource)}) {
        const QVariant loaded = page->loadResource(type, QUrl(QLatin1String(address)));
        QVERIFY(!loaded.isValid() || loaded.value<QImage>().isNull());
      }
  }

  void picturesFitThePage() {
    widgets::HelpWindow help;
    help.resize(700, 500);
    help.showPage(QStringLiteral("gamma"));
    help.show();
    QVERIFY(QTest::qWaitForWindowExposed(&help));
    auto* page = help.findChild<widgets::HelpBrowser*>();
    for (const int width : {700, 560, 1200}) {
      help.resize(width, 500);
      QTRY_COMPARE(help.width(), width);
      QTRY_VERIFY(page->document()->size().width() <= page->viewport()->width() + 1);
    }
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::HelpTest)
#include "help_test.moc"
