// SPDX-License-Identifier: Apache-2.0
// Tests pointing at structures in the picture: clicks, steps deeper, names, the menu.
#include <QLabel>
#include <QMenu>
#include <QtTest>

#include "model/edit/look.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// Returns three balls one behind the other, seen from the front: a skin of lines, an organ, a
/// tumour.
Result<widgets::LoadedDocument> balls(const model::ImportProgress&, const std::stop_token&) {
  model::Scene scene;
  const auto ball = [&scene](const char* name, float radius, float y, float gamma,
                             model::Fill fill) {
    model::Style style;
    style.gamma = Gamma::clamped(gamma);
    style.fill = fill;
    scene.append(
        {.name = name, .style = style, .mesh = moved(*sphere(radius, 4), 1.0f, {0.0f, y, 0.0f})});
  };
  ball("skin & fat", 60.0f, 0.0f, 1.0f, model::Fill::none);
  ball("<b>organ</b>", 40.0f, 120.0f, 3.0f, model::Fill::paper);
  ball("tumour", 30.0f, 220.0f, 3.0f, model::Fill::paper);
  return widgets::LoadedDocument{.scene = std::move(scene), .title = QStringLiteral("Balls")};
}

}  // namespace

class ViewportPickTest : public QObject {
  Q_OBJECT

  struct Bench {
    WindowFixture f;
    model::NodeId skin, organ, tumour;
    QPoint middle;

    Bench() {
      f.session.openMade(QStringLiteral("Balls"), balls);
      if (!f.settled())
        qFatal("no picture");
      skin = f.session.scene().nodes()[0].id;
      organ = f.session.scene().nodes()[1].id;
      tumour = f.session.scene().nodes()[2].id;
      middle = f.areaOf(tumour).center();
    }
    void click(const QPoint& at, Qt::KeyboardModifiers keys = {}) {
      QTest::mouseClick(&f.viewport(), Qt::LeftButton, keys, at);
    }
    bool selected(widgets::NodeIds ids) {
      return QTest::qWaitFor([&] { return f.session.selection() == ids; });
    }
    void hover(const QPoint& at) {
      sendMouse(f.viewport(), QEvent::MouseMove, at + QPoint(2, 2), Qt::NoButton);
      QTest::mouseMove(&f.viewport(), at);
    }
  };

 private slots:
  void clicksSelectWhatIsSeen() {
    Bench b;
    b.click(b.middle);
    QVERIFY(b.selected({b.organ}));
    // One click is on the drawn line of the skin, one within it.
    const QRect area = b.f.areaOf(b.skin);
    b.click({area.left() + 4, area.center().y()});
    QVERIFY(b.selected({b.skin}));
    b.click({5, 5});
    QVERIFY(b.selected({}));
    b.click(b.middle);
    QVERIFY(b.selected({b.organ}));
    b.click({area.left() + 4, area.center().y()}, Qt::ControlModifier);
    QVERIFY(b.selected({b.skin, b.organ}));
    b.click(b.middle, Qt::ControlModifier);
    QVERIFY(b.selected({b.skin}));
  }

  /// A locked structure lets the click through to the one behind, until it is unlocked.
  void clicksPassWhatIsLocked() {
    Bench b;
    b.click(b.middle);
    QVERIFY(b.selected({b.organ}));
    QTest::keyClick(&b.f.window, Qt::Key_L, Qt::ControlModifier);
    QVERIFY(b.f.session.scene().isLocked(b.organ));
    b.click(b.middle);
    QVERIFY(b.selected({b.tumour}));
    b.f.session.undo();
    QVERIFY(!b.f.session.scene().isLocked(b.organ));
    b.click(b.middle);
    QVERIFY(b.selected({b.organ}));
  }

  void altStepsDeeperAndRound() {
    Bench b;
    for (const model::NodeId id : {b.skin, b.organ, b.tumour, b.skin}) {
      b.click(b.middle, Qt::AltModifier);
      QVERIFY(b.selected({id}));
    }
    QVERIFY(b.f.session.apply(
        "hide", model::withLook(b.f.session.scene(), {&b.organ, 1}, {.visible = false})));
    b.click(b.middle, Qt::AltModifier);
    QVERIFY(b.selected({b.tumour}));
  }

  void lockedLetsThrough() {
    Bench b;
    model::Scene scene = b.f.session.scene();
    std::vector<model::Node> nodes = scene.nodes();
    nodes[1].locked = true;
    scene.setNodes(nodes);
    QVERIFY(b.f.session.apply("lock", {scene, true}));
    b.click(b.middle);
    QVERIFY(b.selected({b.tumour}));
  }

  /// The name appears as plain text after a rest, and is gone while dragging.
  void nameUnderTheMouse() {
    Bench b;
    QLabel& name = b.f.control<QLabel>("nameUnderMouse");
    QVERIFY(!name.isVisible());
    b.hover(b.middle);
    QTRY_VERIFY(name.isVisible());
    QCOMPARE(name.text(), QStringLiteral("<b>organ</b>"));
    QCOMPARE(name.textFormat(), Qt::PlainText);
    QVERIFY(b.f.viewport().rect().contains(name.geometry()));
    sendMouse(b.f.viewport(), QEvent::MouseButtonPress, b.middle);
    QVERIFY(!name.isVisible());
    sendMouse(b.f.viewport(), QEvent::MouseMove, b.middle + QPoint(30, 0));
    sendMouse(b.f.viewport(), QEvent::MouseButtonRelease, b.middle + QPoint(30, 0));
    QVERIFY(!name.isVisible());
    // Names are switched off.
    b.f.control<QAction>("showNames").trigger();
    QVERIFY(!b.f.window.preferences().isOn("picture/names"));
    b.hover(b.middle);
    QTest::qWait(400);
    QVERIFY(!name.isVisible());
  }

  void menuOfAStructure() {
    Bench b;
    QTest::mouseClick(&b.f.viewport(), Qt::RightButton, {}, b.middle);
    QMenu* menu = nullptr;
    QTRY_VERIFY((menu = b.f.window.findChild<QMenu*>("pictureMenu")) && menu->isVisible());
    QVERIFY(b.selected({b.organ}));
    QVERIFY(menu->actions().contains(&b.f.control<QAction>("focus")));
    QVERIFY(menu->actions().contains(&b.f.control<QAction>("zoomTo")));
    QVERIFY(!menu->actions().front()->isEnabled());  // the structure's name
    QMenu* here = menu->findChild<QMenu*>("sectionHereAlone");
    QVERIFY(here);
    here->actions().at(1)->trigger();  // coronal
    menu->close();
    const auto& sections = b.f.session.scene().sections();
    QCOMPARE(sections.size(), std::size_t(1));
    QVERIFY(sections[0].scope == b.organ);
    // The section passes through the place that was clicked, on the organ's near side.
    QVERIFY(std::abs(-sections[0].plane.offset - 80.0f) < 2.0f);
    QVERIFY(b.f.session.activeSection() == sections[0].id);
    QTRY_VERIFY(!b.f.window.findChild<QMenu*>("pictureMenu"));

    QTest::mouseClick(&b.f.viewport(), Qt::RightButton, {}, QPoint(6, 6));
    QTRY_VERIFY((menu = b.f.window.findChild<QMenu*>("pictureMenu")) && menu->isVisible());
    QVERIFY(menu->actions().contains(&b.f.control<QAction>("fit")));
    menu->close();
    // A drag of the right button zooms and opens no menu.
    QTRY_VERIFY(!b.f.window.findChild<QMenu*>("pictureMenu"));
    dragMouse(b.f.viewport(), b.middle, b.middle + QPoint(0, 60), Qt::RightButton);
    QVERIFY(b.f.settled());
    QVERIFY(!b.f.window.findChild<QMenu*>("pictureMenu"));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ViewportPickTest)
#include "viewport_pick_test.moc"
