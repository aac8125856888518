// SPDX-License-Identifier: Apache-2.0
// Tests saving, closing and opening again by hand: nothing that is unsaved goes without a question.
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QtTest>

#include "model/edit/emphasis.h"
#include "model/scene_file/scene_file.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/shell/message_bar.h"
#include "widgets/window/file_actions.h"

namespace sline::test {

namespace fs = std::filesystem;

class FilesTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

  /// Writes a scene file of its own for each test.
  QString sceneFile(const WindowFixture& f, const char* name = "body.sline") const {
    Session reader;
    reader.openPaths({m_body.path().toStdString()});
    if (!QTest::qWaitFor([&] { return !reader.busy(); }))
      qFatal("the body cannot be read");
    const QString path = f.folder.filePath(QLatin1String(name));
    if (!model::writeSceneFile(path.toStdString(), {.scene = reader.scene()}).ok())
      qFatal("no scene file");
    return path;
  }
  using Session = widgets::Session;

  static std::string bytesOf(const model::Scene& scene) {
    return *model::sceneFileBytes({.scene = scene});
  }
  static model::Scene onDisk(const QString& path) {
    const auto read = model::readSceneFile(path.toStdString());
    return read.ok() ? read->scene : model::Scene();
  }
  static void edit(WindowFixture& f) {
    f.pullGamma(f.session.scene().named("left kidney").front(), 4.0f);
    f.letGoOfGamma();
  }
  static bool press(WindowFixture& f, Qt::Key key,
                    Qt::KeyboardModifiers with = Qt::ControlModifier) {
    QTest::keyClick(&f.window, key, with);
    return true;
  }
  /// Types a name into the dialog that asks for one.
  static void typeName(WindowFixture& f, const QString& name) {
    auto& dialog = f.control<QFileDialog>("saveDialog");
    auto& edit = *dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    // While the dialog has no focus, its list of files would interfere.
    QApplication::setActiveWindow(&dialog);
    edit.setFocus();
    edit.setText(name);  // typed letter by letter, completion would interfere
    QTest::keyClick(&edit, Qt::Key_Return);
    QApplication::setActiveWindow(&f.window);
  }
  static void answer(WindowFixture& f, QMessageBox::StandardButton button) {
    auto& box = f.control<QMessageBox>("unsavedDialog");
    QTest::mouseClick(box.button(button), Qt::LeftButton);
  }
  template <class T>
  static bool gone(WindowFixture& f, const char* name) {
    return QTest::qWaitFor([&] { return !f.window.findChild<T*>(QLatin1String(name)); });
  }
  static bool startVisible(WindowFixture& f) { return f.control<QWidget>("startPage").isVisible(); }

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  /// The folder is dropped, edited, saved, closed, and opened again as it was.
  void asItWas() {
    WindowFixture f;
    QVERIFY(startVisible(f));
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    QVERIFY(!startVisible(f));
    QVERIFY(!f.window.isWindowModified());
    edit(f);
    QVERIFY(f.window.isWindowModified());
    // Turning the scene is no edit, but the camera comes back, too.
    dragMouse(f.viewport(), {400, 300}, {460, 330});
    QVERIFY(press(f, Qt::Key_S));  // it has no name yet
    const QString path = f.folder.filePath(QStringLiteral("mine.sline"));
    typeName(f, f.folder.filePath(QStringLiteral("mine")));
    QTRY_VERIFY(!f.window.isWindowModified());
    QVERIFY(f.window.windowTitle().startsWith(QStringLiteral("mine.sline")));
    const std::string saved = bytesOf(f.session.scene());
    const model::Camera camera = f.viewport().camera();
    QVERIFY(bytesOf(onDisk(path)) == saved);
    const auto document = model::readSceneFile(path.toStdString());
    const QImage thumbnail = QImage::fromData(QByteArray::fromStdString(document->thumbnail));
    QVERIFY(!thumbnail.isNull() && thumbnail.width() <= 320);

    QVERIFY(press(f, Qt::Key_W));
    QVERIFY(startVisible(f));
    QVERIFY(f.session.scene().nodes().empty());
    QVERIFY(!model::FileLock::held(path.toStdString()));
    QTest::mouseClick(&f.control<QWidget>("startRecent-0"), Qt::LeftButton);
    QVERIFY(f.settled());
    QVERIFY(bytesOf(f.session.scene()) == saved);
    QVERIFY(f.viewport().camera() == camera);
    QVERIFY(!f.window.isWindowModified());
    QVERIFY(model::FileLock::held(path.toStdString()));
  }

  void theMarkFollowsUndo() {
    WindowFixture f;
    QVERIFY(f.drop(sceneFile(f)) && f.settled());
    QVERIFY(!f.window.isWindowModified());
    const QAction& save = f.control<QAction>("save");
    QVERIFY(!save.isEnabled());
    f.pullGamma(f.session.scene().named("left kidney").front(), 4.0f);
    QVERIFY(f.window.isWindowModified());  // even while it is dragged
    f.letGoOfGamma();
    QVERIFY(save.isEnabled());
    QVERIFY(press(f, Qt::Key_Z));
    QVERIFY(!f.window.isWindowModified() && !save.isEnabled());
    QTest::keySequence(&f.window, f.control<QAction>("redo").shortcut());
    QVERIFY(f.window.isWindowModified());
    QVERIFY(press(f, Qt::Key_S));
    QTRY_VERIFY(!f.window.isWindowModified());
    QVERIFY(press(f, Qt::Key_Z));
    QVERIFY(f.window.isWindowModified());
    f.control<QAction>("revert").trigger();
    QTest::mouseClick(&f.control<QWidget>("revertFile"), Qt::LeftButton);
    QTRY_VERIFY(!f.window.isWindowModified());
  }

  void closingAsks_data() {
    QTest::addColumn<int>("button");
    QTest::addColumn<bool>("closes");
    QTest::addColumn<bool>("saves");
    QTest::newRow("save") << int(QMessageBox::Save) << true << true;
    QTest::newRow("discard") << int(QMessageBox::Discard) << true << false;
    QTest::newRow("cancel") << int(QMessageBox::Cancel) << false << false;
  }
  void closingAsks() {
    QFETCH(int, button);
    QFETCH(bool, closes);
    QFETCH(bool, saves);
    WindowFixture f;
    const QString path = sceneFile(f);
    QVERIFY(f.drop(path) && f.settled());
    edit(f);
    const std::string edited = bytesOf(f.session.scene());
    QVERIFY(!f.window.close());
    QVERIFY(f.window.isVisible());
    answer(f, QMessageBox::StandardButton(button));
    QTRY_COMPARE(f.window.isVisible(), !closes);
    QVERIFY(gone<QMessageBox>(f, "unsavedDialog"));
    QCOMPARE(f.window.isVisible(), !closes);
    QCOMPARE(bytesOf(onDisk(path)) == edited, saves);
    if (!closes)
      QVERIFY(bytesOf(f.session.scene()) == edited && f.window.isWindowModified());
  }

  /// If saving on the way out fails, the window stays.
  void closingWaitsForTheDisk() {
    WindowFixture f;
    const QString folder = f.folder.filePath(QStringLiteral("sub"));
    QVERIFY(QDir().mkpath(folder));
    const QString path = folder + QStringLiteral("/body.sline");
    QVERIFY(QFile::rename(sceneFile(f), path));
    QVERIFY(f.drop(path) && f.settled());
    edit(f);
    QVERIFY(QDir(folder).removeRecursively());
    QVERIFY(!f.window.close());
    answer(f, QMessageBox::Save);
    auto& message = f.control<widgets::MessageBar>("messageBar");
    QTRY_VERIFY(message.isVisible());
    QVERIFY2(message.text().contains(QStringLiteral("body.sline")), qPrintable(message.text()));
    QVERIFY(f.window.isVisible() && f.window.isWindowModified());
    QVERIFY(press(f, Qt::Key_S));  // again, as it is still not saved
    QVERIFY(f.window.isWindowModified());
  }

  void openingAsks() {
    WindowFixture f;
    const QString first = sceneFile(f, "first.sline");
    const QString second = sceneFile(f, "second.sline");
    QVERIFY(f.drop(first) && f.settled());
    edit(f);
    const widgets::Document before = f.session.document();
    QVERIFY(f.drop(second));
    answer(f, QMessageBox::Cancel);
    QVERIFY(gone<QMessageBox>(f, "unsavedDialog"));
    QVERIFY(f.session.document() == before && !f.session.busy());
    QVERIFY(f.drop(second));
    answer(f, QMessageBox::Discard);
    QVERIFY(f.settled());
    QCOMPARE(f.session.title(), QStringLiteral("second.sline"));
    QVERIFY(!f.window.isWindowModified());
    QVERIFY(press(f, Qt::Key_Z));  // opening is a step
    QVERIFY(f.session.document() == before && f.window.isWindowModified());
    QVERIFY(f.window.windowTitle().startsWith(QStringLiteral("first.sline")));
    QVERIFY(press(f, Qt::Key_N));
    answer(f, QMessageBox::Save);
    QTRY_COMPARE(f.session.title(), QStringLiteral("Untitled"));
    QVERIFY(bytesOf(onDisk(first)) == bytesOf(before.scene));
  }

  void anotherWindowHasIt() {
    WindowFixture f;
    const QString path = sceneFile(f);
    Session other;
    other.openPaths({path.toStdString()});
    QVERIFY(QTest::qWaitFor([&] { return !other.busy(); }));
    QVERIFY(f.drop(path) && f.settled());
    auto& message = f.control<widgets::MessageBar>("messageBar");
    QVERIFY(message.isVisible());
    QVERIFY2(message.text().contains(QStringLiteral("read-only")), qPrintable(message.text()));
    QVERIFY(f.window.windowTitle().contains(QStringLiteral("read-only")));
    edit(f);
    const std::string before = bytesOf(onDisk(path));
    QTest::mouseClick(&f.control<QWidget>("messageRemedy"), Qt::LeftButton);
    typeName(f, f.folder.filePath(QStringLiteral("own.sline")));
    QTRY_VERIFY(!f.window.isWindowModified());
    QVERIFY(!message.isVisible());
    QVERIFY(!f.window.windowTitle().contains(QStringLiteral("read-only")));
    QVERIFY(bytesOf(onDisk(path)) == before);
    QVERIFY(bytesOf(onDisk(f.folder.filePath(QStringLiteral("own.sline")))) ==
            bytesOf(f.session.scene()));
  }

  void aCopyChangesNoName() {
    WindowFixture f;
    QVERIFY(f.drop(sceneFile(f)) && f.settled());
    edit(f);
    f.control<QAction>("saveCopy").trigger();
    const QString copy = f.folder.filePath(QStringLiteral("copy.v2"));
    typeName(f, copy);
    QTRY_VERIFY(QFile::exists(copy + QStringLiteral(".sline")));
    QTRY_VERIFY(bytesOf(onDisk(copy + QStringLiteral(".sline"))) == bytesOf(f.session.scene()));
    QCOMPARE(f.session.title(), QStringLiteral("body.sline"));
    QVERIFY(f.window.isWindowModified());
    // The whole name exists now, so a question comes.
    f.control<QAction>("saveCopy").trigger();
    typeName(f, copy);
    QTRY_VERIFY(f.window.findChild<QMessageBox*>(QStringLiteral("overwriteDialog")));
    QTest::mouseClick(&f.control<QWidget>("replaceFile"), Qt::LeftButton);
    QVERIFY(gone<QMessageBox>(f, "overwriteDialog"));
  }

  void recentFiles() {
    WindowFixture f;
    const QString first = sceneFile(f, "first & last.sline");
    const QString second = sceneFile(f, "second.sline");
    QVERIFY(f.drop(first) && f.settled());
    QVERIFY(f.drop(second) && f.settled());
    auto& menu = f.control<QMenu>("recentMenu");
    QVERIFY(menu.isEnabled());
    emit menu.aboutToShow();
    f.control<QAction>("recent-1").trigger();
    QVERIFY(f.settled());
    QCOMPARE(f.session.title(), QStringLiteral("first & last.sline"));
    QVERIFY(QFile::remove(second));
    emit menu.aboutToShow();
    f.control<QAction>("recent-1").trigger();
    auto& message = f.control<widgets::MessageBar>("messageBar");
    QVERIFY(message.isVisible() && message.text().contains(QStringLiteral("second.sline")));
    QCOMPARE(f.window.files().recent().paths(), QStringList{first});
    emit menu.aboutToShow();
    f.control<QAction>("clearRecent").trigger();
    QVERIFY(!menu.isEnabled());
  }

  /// All of the start page can be reached and used without a mouse; its messages are visible.
  void startPageByKeyboard() {
    WindowFixture f;
    const QString there = sceneFile(f, "there.sline");
    f.window.files().recent().add(f.folder.filePath(QStringLiteral("gone.sline")));
    f.window.files().recent().add(there);
    QStringList order;
    f.control<QWidget>("startFiles").setFocus();
    do {
      order << QApplication::focusWidget()->objectName();
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    } while (!order.contains(QApplication::focusWidget()->objectName()) && order.size() < 20);
    QCOMPARE(order, QStringList({"startFiles", "startFolder", "startRecent-0", "startRecent-1",
                                 "startDemo-pelvis-female", "startDemo-pelvis-male",
                                 "startDemo-abdomen-female", "startDemo-abdomen-male",
                                 "startDemo-kidney-female", "startDrawing-auto"}));
    QTest::keyClick(&f.control<QWidget>("startRecent-1"), Qt::Key_Return);
    auto& message = f.control<widgets::MessageBar>("messageBar");
    QVERIFY(message.isVisible());
    QVERIFY(f.control<QWidget>("startPage").isAncestorOf(&message));
    QTest::keyClick(&f.control<QWidget>("startRecent-0"), Qt::Key_Space);
    QVERIFY(f.settled());
    QCOMPARE(f.session.title(), QStringLiteral("there.sline"));
    QVERIFY(!startVisible(f));
  }

  void whatACrashLeftIsOffered_data() {
    QTest::addColumn<bool>("recover");
    QTest::newRow("recover") << true;
    QTest::newRow("delete") << false;
  }
  void whatACrashLeftIsOffered() {
    QFETCH(bool, recover);
    const QTemporaryDir state;
    const fs::path journals =
        (state.path() + QStringLiteral("/state/sline/journals")).toStdString();
    const fs::path file = state.filePath(QStringLiteral("lost.sline")).toStdString();
    model::Scene scene;
    scene.append({.name = "<b>group</b>", .style = {.fill = model::Fill::paper}});
    {
      const auto journal = model::Journal::reserve(journals);
      QVERIFY(journal.ok());
      const auto kept = std::make_shared<const model::Scene>(scene);
      QVERIFY((*journal)->start({"lost.sline", file}, {}, {.scene = kept}).ok());
    }
    Session session;
    QSettings settings(sealed(state.path()), QSettings::IniFormat);
    widgets::MainWindow window(session, settings);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QApplication::setActiveWindow(&window);
    QTRY_VERIFY(window.findChild<QWidget*>(QStringLiteral("recover-0")));
    const auto click = [&window](const char* name) {
      QTest::mouseClick(window.findChild<QWidget*>(QLatin1String(name)), Qt::LeftButton);
    };
    QVERIFY(window.findChild<QWidget*>(QStringLiteral("recoveryPanel"))->isVisible());
    if (!recover) {
      click("forget-0");
      click("forgetCopy");
      QTRY_VERIFY(model::recoverableIn(journals).empty());
      QVERIFY(!window.findChild<QWidget*>(QStringLiteral("recoveryPanel"))->isVisible());
      return;
    }
    click("recover-0");
    QTRY_VERIFY(!session.busy());
    QVERIFY(bytesOf(session.scene()) == bytesOf(scene));
    QVERIFY(window.isWindowModified());
    QVERIFY(window.windowTitle().startsWith(QStringLiteral("lost.sline")));
    QTest::keyClick(&window, Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(!window.isWindowModified());
    QVERIFY(bytesOf(onDisk(QString::fromStdString(file.string()))) == bytesOf(scene));
    QTRY_VERIFY(model::recoverableIn(journals).empty());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::FilesTest)
#include "files_test.moc"
