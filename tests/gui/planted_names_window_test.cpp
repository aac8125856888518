// SPDX-License-Identifier: Apache-2.0
// Tests that the window offers no name that stands in a folder's or file's name, or in a file, for
// what is saved or exported, and has none in its titles.
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QtTest>

#include "tests/gui/window_fixture.h"
#include "tests/model/import/planted/planted_names.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// Returns what the dialogs and the window say in their titles and offer in their fields.
QStringList offeredBy(const QWidget& top) {
  QStringList texts{top.windowTitle()};
  for (const QWidget* child : top.findChildren<QWidget*>())
    if (child->isVisible() && !child->windowTitle().isEmpty())
      texts << child->windowTitle();
  for (const QLineEdit* field : top.findChildren<QLineEdit*>())
    texts << QFileInfo(field->text()).fileName();
  if (const auto* files = qobject_cast<const QFileDialog*>(&top))
    for (const QString& file : files->selectedFiles())
      texts << QFileInfo(file).fileName();
  return texts;
}

}  // namespace

class PlantedNamesWindowTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_top;
  std::unique_ptr<Planting> m_planting;
  int m_texts = 0;
  QStringList m_dialogs;

  void verifyClean(const QString& where, const QStringList& texts) {
    for (const QString& text : texts) {
      m_texts += text.isEmpty() ? 0 : 1;
      for (const auto& [name, place] : m_planting->places())
        QVERIFY2(!text.contains(name, Qt::CaseInsensitive),
                 qPrintable(where + " offers \"" + text + "\", which is of " + place));
    }
  }

  /// Opens every dialog that a menu names with three dots, and closes it again.
  void verifyDialogs(WindowFixture& f) {
    for (QAction* action : f.window.findChildren<QAction*>()) {
      if (!action->isEnabled() || action->menu() || !action->text().endsWith(QChar(0x2026)))
        continue;
      action->trigger();
      QTest::qWait(50);
      for (QWidget* top : QApplication::topLevelWidgets()) {
        auto* dialog = qobject_cast<QDialog*>(top);
        if (!dialog || !dialog->isVisible())
          continue;
        m_dialogs << action->objectName();
        // Who looks for a file to read is shown the folders of this machine.
        const auto* files = qobject_cast<QFileDialog*>(dialog);
        if (!files || files->acceptMode() == QFileDialog::AcceptSave)
          verifyClean(action->text(), offeredBy(*dialog));
        dialog->reject();
      }
      QTest::qWait(10);
    }
  }

 private slots:
  void initTestCase() { m_planting = std::make_unique<Planting>(m_top.path()); }

  void cleanupTestCase() {
    qInfo("%d places of names against %d titles and fields of %d dialogs: %s",
          int(m_planting->places().size()), m_texts, int(m_dialogs.size()),
          qPrintable(m_dialogs.join(", ")));
  }

  void opened_data() {
    QTest::addColumn<QString>("input");
    QTest::newRow("a folder") << m_planting->folder();
    for (const QString& input : m_planting->inputs().mid(1))
      QTest::newRow(qPrintable("a file " + QFileInfo(input).completeSuffix())) << input;
  }
  void opened() {
    QFETCH(QString, input);
    WindowFixture f;
    QVERIFY(f.drop(input));
    QVERIFY(f.settled());
    QVERIFY(f.session.document().opening != 0);
    verifyClean("the window", offeredBy(f.window));
    f.control<QAction>("copyPicture").trigger();
    QTRY_VERIFY(QApplication::clipboard()->mimeData()->hasImage());
    for (const QString& format : QApplication::clipboard()->mimeData()->formats())
      if (format.startsWith("text/"))
        verifyClean(format,
                    {QString::fromUtf8(QApplication::clipboard()->mimeData()->data(format))});
    if (QTest::currentDataTag() == QByteArray("a folder"))
      verifyDialogs(f);
  }

  void importDialog() {
    WindowFixture f;
    QVERIFY(f.drop(m_planting->folder(), Qt::ShiftModifier));
    QDialog* dialog = nullptr;
    QVERIFY(QTest::qWaitFor([&] {
      dialog = f.window.findChild<QDialog*>(QStringLiteral("importDialog"));
      return dialog && dialog->isVisible();
    }));
    verifyClean("the import dialog", {dialog->windowTitle()});
    dialog->reject();
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::PlantedNamesWindowTest)
#include "planted_names_window_test.moc"
