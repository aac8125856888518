// SPDX-License-Identifier: Apache-2.0
// Tests those parts of a scene that are not structures: saved views, the key light, the files it
// came from.
#include <QDirIterator>
#include <QMenu>
#include <QToolButton>
#include <QtTest>

#include "model/edit/look.h"
#include "model/edit/settled_units.h"
#include "model/edit/views.h"
#include "tests/gui/gated_painter.h"
#include "tests/gui/window_fixture.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

class WindowSceneTest : public QObject {
  Q_OBJECT

 private slots:
  void changedFilesAreReadAgain() {
    const QTemporaryDir body;
    writeBody(body.path());
    WindowFixture f;
    QAction& reload = f.control<QAction>("reload");
    QVERIFY(!reload.isEnabled());
    QVERIFY(f.drop(body.path()));
    QVERIFY(f.settled());
    QVERIFY(reload.isEnabled());
    const model::NodeId bladder = f.session.scene().named("bladder").front();
    const model::Node before = *f.session.scene().find(bladder);
    QVERIFY(f.session.apply(
        "Γ", model::withLook(f.session.scene(), {&bladder, 1}, {.gamma = Gamma::clamped(4.5f)})));
    const int steps = f.session.history().count();

    reload.trigger();  // nothing has changed
    QVERIFY(f.settled());
    QCOMPARE(f.session.history().count(), steps);

    const QString file = body.path() + "/" + fileOf(body.path(), before.provenance.file);
    writeMesh(file, *sphere(7.0f, 2));
    reload.trigger();
    // An edit made meanwhile stays.
    const model::NodeId other = f.session.scene().named("left kidney").front();
    QVERIFY(f.session.apply("Hide",
                            model::withLook(f.session.scene(), {&other, 1}, {.visible = false})));
    QVERIFY(f.settled());
    QCOMPARE(f.session.history().count(), steps + 2);
    const model::Node* after = f.session.scene().find(bladder);
    QVERIFY(after->mesh != before.mesh);
    QVERIFY(std::abs(after->mesh->bounds().size().x - 14.0f) < 0.2f);
    QVERIFY(after->style != before.style);  // in focus, as before
    QVERIFY(!f.session.scene().resolve(other).visible);
    f.session.undo();
    QVERIFY(f.session.scene().find(bladder)->mesh == before.mesh);
    f.session.redo();
    QVERIFY(f.session.scene().find(bladder)->mesh != before.mesh);
  }

  void savedViewShowsWhatItSays() {
    const QTemporaryDir body;
    writeBody(body.path());
    WindowFixture f;
    QVERIFY(f.drop(body.path()));
    QVERIFY(f.settled());
    const model::NodeId kidney = f.session.scene().named("left kidney").front();
    model::View view{.name = "Without", .camera = f.viewport().camera()};
    view.camera.eye += glm::vec3(0, -50, 0);
    view.looks = {{.node = kidney, .style = {.visible = false}}};
    model::Scene scene = f.session.scene();
    scene.setViews({view});
    QVERIFY(f.session.apply("views", {scene, true}));
    QMenu& menu = f.control<QMenu>("savedViews");
    QVERIFY(menu.isEnabled());
    QCOMPARE(menu.actions().size(), 1);
    QVERIFY(!f.areaOf(kidney).isEmpty());
    menu.actions().front()->trigger();
    QVERIFY(f.settled());
    QVERIFY(!f.session.scene().resolve(kidney).visible);
    QVERIFY(f.viewport().camera() == view.camera);
    f.session.undo();
    QVERIFY(f.session.scene().resolve(kidney).visible);
  }

  /// Its picture, its marks and what was said of it go at once, however long the next picture
  /// takes.
  void nothingOfTheSceneBeforeStays() {
    const QTemporaryDir body;
    writeBody(body.path());
    const auto gate = std::make_shared<Gate>();
    WindowFixture f(gated(gate));
    const auto plain = [&f] {
      const QImage picture = f.picture();
      QImage paper = picture;
      paper.fill(picture.pixel(0, 0));
      return picture == paper;
    };
    for (int i = 0; i < 2; ++i) {
      QVERIFY(f.drop(body.path()));
      QVERIFY(f.settled());
    }
    QVERIFY(!plain() && f.control<QWidget>("scaleBar").isVisible());
    emit f.session.failed({.reason = "it cannot be done", .remedy = "Do something else"});
    QVERIFY(f.control<QWidget>("messageText").isVisible());
    gate->open = false;
    f.session.undo();
    QVERIFY(plain() && f.viewport().isBlank());
    QVERIFY(!f.control<QWidget>("scaleBar").isVisible());
    QVERIFY(!f.control<QWidget>("messageText").isVisible());
    QTRY_VERIFY(gate->begun > gate->done);
    QTest::qWait(100);
    QVERIFY(plain());
    gate->open = true;
    gate->pass.release(1000);
    QVERIFY(f.settled());
    QVERIFY(!plain() && f.control<QWidget>("scaleBar").isVisible());
  }

  /// What is said of an edit, of a step that was taken back, or of what has gone is said no longer.
  void untrueMessagesGo() {
    const QTemporaryDir body;
    writeBody(body.path());
    WindowFixture f;
    QVERIFY(f.drop(body.path()));
    QVERIFY(f.settled());
    const auto said = [&f] { return f.control<QWidget>("messageText").isVisible(); };
    const model::NodeId bladder = f.session.scene().named("bladder").front();
    const auto edit = [&f, bladder](float gamma) {
      const model::Style look{.gamma = Gamma::clamped(gamma)};
      return f.session.apply("Γ", model::withLook(f.session.scene(), {&bladder, 1}, look));
    };
    // An edit that was refused.
    for (std::size_t i = 0; i <= model::maximumSections; ++i)
      f.control<QAction>("sectionFacing").trigger();
    QVERIFY(said());
    QVERIFY(f.settled());
    QVERIFY(edit(4.0f));
    QVERIFY(!said());
    // What failed on the disk stays until it is closed.
    emit f.session.failed({.file = "a.obj", .reason = "it cannot be read", .remedy = "Try"});
    QVERIFY(edit(3.0f) && said());
    f.control<QToolButton>("messageClose").click();
    // A step that was taken back.
    const std::string file = f.session.scene().find(bladder)->provenance.file;
    writeMesh(body.path() + "/" + fileOf(body.path(), file), *sphere(7.0f, 2));
    f.control<QAction>("reload").trigger();
    QVERIFY(f.settled());
    QVERIFY(said());
    QVERIFY(edit(2.5f) && said());
    f.session.undo();
    QVERIFY(said());
    f.session.undo();
    QVERIFY(!said());
  }

  /// The question for the unit goes with what was doubted.
  void theDoubtOfTheUnitGoes() {
    const QTemporaryDir folder;
    writeMesh(folder.filePath("liver.ply"), *octahedron({0, 0, 0}, 5), model::Frame::lps);
    WindowFixture f;
    f.session.openPaths({folder.filePath("liver.ply").toStdString()});
    QVERIFY(f.settled());
    QVERIFY(model::hasDoubtedUnits(f.session.scene()));
    QVERIFY(f.control<QWidget>("messageText").isVisible());
    f.session.select({f.session.scene().nodes().back().id});
    f.control<QAction>("remove").trigger();
    QVERIFY(!model::hasDoubtedUnits(f.session.scene()));
    QVERIFY(!f.control<QWidget>("messageText").isVisible());
  }

  void keyLightIsOfTheScene() {
    const QTemporaryDir body;
    writeBody(body.path());
    WindowFixture f;
    QVERIFY(f.drop(body.path()));
    QVERIFY(f.settled());
    QAction& key = f.control<QAction>("keyLight");
    QVERIFY(!f.session.scene().keyLight());
    QTest::keyClick(&f.window, Qt::Key_K);
    QVERIFY(f.session.scene().keyLight() && f.session.scene().keyLight()->shades);
    QVERIFY(key.isChecked());
    QTest::keyClick(&f.window, Qt::Key_K);
    QVERIFY(!f.session.scene().keyLight()->shades && !key.isChecked());
    f.session.undo();
    QVERIFY(f.viewport().keyLight() && key.isChecked());
    // The scene's own light overrides what was chosen last.
    model::KeyLight light{.towards = {0, 0, 1}, .shades = false};
    QVERIFY(f.session.apply("light", model::withKeyLight(f.session.scene(), light)));
    QVERIFY(!f.viewport().keyLight() && !key.isChecked());
  }

 private:
  /// Returns where below the folder the file of that name is.
  static QString fileOf(const QString& folder, const std::string& name) {
    QDirIterator files(folder, {QString::fromStdString(name)}, QDir::Files,
                       QDirIterator::Subdirectories);
    return files.hasNext() ? QDir(folder).relativeFilePath(files.next()) : QString();
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::WindowSceneTest)
#include "window_scene_test.moc"
