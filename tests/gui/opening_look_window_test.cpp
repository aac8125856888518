// SPDX-License-Identifier: Apache-2.0
// Tests that a folder dropped on the window becomes a plate, as one step that can be taken back.
#include <QtTest>

#include "model/edit/look.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/focus/focus_context.h"

namespace sline::test {

class OpeningLookWindowTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

  static bool wait(WindowFixture& f) {
    return QTest::qWaitFor([&f] { return !f.session.busy() && !f.window.focus().busy(); }, 60000) &&
           f.settled();
  }
  static float gammaOf(WindowFixture& f, const char* name) {
    return f.session.scene().resolve(f.session.scene().named(name).front()).gamma.value();
  }
  static void trigger(WindowFixture& f, const char* action) {
    f.control<QAction>(action).trigger();
  }

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void aFolderBecomesAPlate() {
    WindowFixture f;
    f.window.preferences().set("picture/openingLook", "auto");
    QVERIFY(f.drop(m_body.path()) && wait(f));
    QVERIFY(gammaOf(f, "left kidney") > 4.0f);
    QCOMPARE(f.session.history().undoText(), QString("Opening look"));
    QVERIFY2(!f.session.modified(), "what was chosen is no unsaved work");
    QVERIFY(f.window.focus().state().analysis);
    f.session.undo();
    QCOMPARE(gammaOf(f, "left kidney"), 2.0f);
    f.session.redo();
    QVERIFY(gammaOf(f, "left kidney") > 4.0f);
  }
  void plainWhereWished() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()) && wait(f));
    QCOMPARE(gammaOf(f, "left kidney"), 2.0f);
    trigger(f, "plate");
    QVERIFY(wait(f));
    QVERIFY(gammaOf(f, "left kidney") > 4.0f);
    QVERIFY(f.session.modified());
  }
  void anotherSubject() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()) && wait(f));
    trigger(f, "plate");
    QVERIFY(wait(f));
    const model::Scene first = f.session.scene();
    trigger(f, "anotherSubject");
    QVERIFY(wait(f));
    QVERIFY(!(f.session.scene() == first));
    const auto subjects = model::subjectsOf(first).size();
    for (std::size_t i = 1; i < subjects; ++i) {
      trigger(f, "anotherSubject");
      QVERIFY(wait(f));
    }
    QCOMPARE(f.session.scene(), first);
  }
  void whatIsChangedMeanwhileCounts() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()) && wait(f));
    trigger(f, "plate");
    const model::NodeId kidney = f.session.scene().named("left kidney").front();
    f.session.apply("by hand", model::withLook(f.session.scene(), {&kidney, 1},
                                               {.gamma = Gamma::clamped(1.0f)}));
    QVERIFY(wait(f));
    QCOMPARE(gammaOf(f, "left kidney"), 1.0f);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::OpeningLookWindowTest)
#include "opening_look_window_test.moc"
