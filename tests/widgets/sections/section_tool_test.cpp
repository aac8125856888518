// SPDX-License-Identifier: Apache-2.0
// Tests a section's handles by hand, without a window: each drag is one undo step.
#include <QSignalSpy>
#include <QTest>
#include <glm/geometric.hpp>

#include "model/camera/camera_moves.h"
#include "model/edit/sections.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/sections/section_tool.h"

using namespace sline;
using namespace sline::widgets;

namespace {

constexpr glm::vec2 size(900.0f, 700.0f);

struct FixedView : ViewControl {
  model::Camera now;
  const model::Camera& camera() const override { return now; }
  glm::vec3 pivot() const override { return {}; }
  void move(const model::Camera& camera) override { now = camera; }
};

Pointer at(const glm::vec2& pixel, Qt::KeyboardModifiers keys = {}) {
  return {.pixel = pixel, .size = size, .button = Qt::LeftButton, .keys = keys};
}

}  // namespace

class SectionToolTest : public QObject {
  Q_OBJECT

  /// Holds a ball, cut in two and seen obliquely.
  struct Bench {
    Session session;
    FixedView view;
    SectionTool tool{session, view};

    Bench() {
      model::Scene scene;
      scene.append({.name = "ball", .mesh = test::sphere(50.0f, 3)});
      session.apply("ball", {scene, true});
      model::Section section;
      section.plane = {.normal = {1, 0, 0}, .offset = 0.0f};
      session.apply("cut", model::withSection(session.scene(), section));
      view.now = orbited(model::anatomicalCamera(model::AnatomicalView::anterior,
                                                 session.scene().visibleBounds(), size.x / size.y),
                         {}, -40.0f, 10.0f);
    }
    void activate() { session.activateSection(session.scene().sections().front().id); }
    model::Plane plane() const { return session.scene().sections().front().plane; }
    int steps() { return session.history().count(); }
  };

 private slots:
  void nothingToHoldWithoutAnActiveSection() {
    Bench b;
    QVERIFY(!b.tool.handles(size));
    QVERIFY(!b.tool.press(at({450, 350})));
    b.activate();
    QVERIFY(b.tool.handles(size));
    // A section that is switched off has no handles.
    model::Section off = b.session.scene().sections().front();
    off.enabled = false;
    b.session.apply("off", model::withSectionChanged(b.session.scene(), off.id, off));
    QVERIFY(!b.tool.handles(size));
    b.session.undo();
    QVERIFY(b.tool.handles(size));
    b.session.undo();  // the section is gone
    QVERIFY(!b.session.activeSection());
    b.session.redo();
    QVERIFY(b.session.activeSection());
  }

  void dragIsOneStep() {
    Bench b;
    b.activate();
    const int before = b.steps();
    const glm::vec2 grip = b.tool.handles(size)->slide;
    QVERIFY(!b.tool.press(at(grip + glm::vec2(100, 60))));
    QVERIFY(b.tool.press(at(grip)));
    for (int i = 1; i <= 5; ++i) {
      b.tool.move(at(grip + glm::vec2(8.0f * float(i), 0.0f)));
      QCOMPARE(b.steps(), before);
      QVERIFY(b.session.previewing());
    }
    QVERIFY(b.plane().offset > 3.0f);
    QVERIFY2(b.tool.readout().startsWith("L"), qPrintable(b.tool.readout()));
    // The handle stands where the mouse is.
    QVERIFY(std::abs(b.tool.handles(size)->slide.x - (grip.x + 40.0f)) < 3.0f);
    b.tool.release(at(grip + glm::vec2(40, 0)));
    QCOMPARE(b.steps(), before + 1);
    QVERIFY(!b.session.previewing() && b.tool.readout().isEmpty());
    b.session.undo();
    QCOMPARE(b.plane().offset, 0.0f);
  }

  void escapeRestores() {
    Bench b;
    b.activate();
    const Document document = b.session.document();
    const int before = b.steps();
    const glm::vec2 ring = *b.tool.handles(size)->turnAboutU;
    QVERIFY(b.tool.press(at(ring)));
    b.tool.move(at(ring + glm::vec2(30, 10)));
    QVERIFY(b.plane().normal != glm::vec3(1, 0, 0));
    QVERIFY(b.tool.readout().endsWith(QString::fromUtf8("°")));
    b.tool.cancel();
    QVERIFY(b.session.document() == document);
    b.tool.move(at(ring + glm::vec2(60, 10)));
    b.tool.release(at(ring));
    QCOMPARE(b.steps(), before);
    QVERIFY(b.session.document() == document);
  }

  void headFlips() {
    Bench b;
    b.activate();
    const int before = b.steps();
    const glm::vec2 tip = b.tool.handles(size)->tip;
    QVERIFY(b.tool.press(at(tip)));
    b.tool.move(at(tip + glm::vec2(1, 1)));  // a hand that shakes
    b.tool.release(at(tip + glm::vec2(1, 1)));
    QVERIFY(b.plane().normal == glm::vec3(-1, 0, 0));
    QCOMPARE(b.steps(), before + 1);
    b.session.undo();
    // A dragged tip takes the arrow along.
    QVERIFY(b.tool.press(at(tip)));
    b.tool.move(at(tip + glm::vec2(30, 0)));
    b.tool.release(at(tip + glm::vec2(30, 0)));
    QVERIFY(b.plane().normal == glm::vec3(1, 0, 0));
    QVERIFY(b.plane().offset > 2.0f);
  }

  void controlSnaps() {
    Bench b;
    b.activate();
    const glm::vec2 grip = b.tool.handles(size)->slide;
    QVERIFY(b.tool.press(at(grip, Qt::ControlModifier)));
    b.tool.move(at(grip + glm::vec2(37, 0), Qt::ControlModifier));
    const float offset = b.plane().offset;
    QVERIFY(offset != 0.0f && offset == std::round(offset));
    b.tool.release(at(grip));
  }
};

SLINE_TEST_WITH_EVENTS(SectionToolTest)
#include "section_tool_test.moc"
