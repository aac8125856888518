// SPDX-License-Identifier: Apache-2.0
// Tests pointing at structures in the picture: clicks, steps deeper, names, the menu.
#include <QClipboard>
#include <QLabel>
#include <QMenu>
#include <QtTest>
#include <algorithm>
#include <cstdlib>

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
    /// Returns the largest difference of a channel between the two pictures within the area.
    static int largest(const QImage& a, const QImage& b, const QRect& area) {
      int most = 0;
      for (int y = area.top(); y <= area.bottom(); ++y)
        for (int x = area.left(); x <= area.right(); ++x) {
          const QRgb one = a.pixel(x, y);
          const QRgb other = b.pixel(x, y);
          most = std::max({most, std::abs(qRed(one) - qRed(other)),
                           std::abs(qGreen(one) - qGreen(other)),
                           std::abs(qBlue(one) - qBlue(other))});
        }
      return most;
    }
    QImage shown() {
      if (!f.settled())
        qFatal("no picture");
      return f.picture();
    }
    QImage with(const widgets::NodeIds& selection) {
      f.session.select(selection);
      return shown();
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

  /// What is selected has a line around it, whose picture draws no layer anew: strong where the
  /// structure is seen, weak where another one hides it.
  void theSelectedIsOutlined() {
    Bench b;
    const QImage without = b.shown();
    b.click(b.middle);
    QVERIFY(b.selected({b.organ}));
    const QImage organ = b.shown();
    QCOMPARE(b.f.viewport().lastLayersDrawn(), 0);
    const QRect around = b.f.areaOf(b.organ);
    const QRect line = difference(without, organ);
    QVERIFY(around.adjusted(-8, -8, 8, 8).contains(line));
    QVERIFY(line.width() > around.width() - 12 && line.height() > around.height() - 12);
    // It is a line: nothing changes inside.
    const QRect inside = around.adjusted(around.width() / 4, around.height() / 4,
                                         -around.width() / 4, -around.height() / 4);
    QCOMPARE(Bench::largest(without, organ, inside), 0);
    const int strong = Bench::largest(without, organ, line);
    QVERIFY(strong > 90);
    // An outline alone has one, too; the tumour lies behind the organ.
    const QImage skin = b.with({b.skin});
    QVERIFY(b.f.areaOf(b.skin).adjusted(-8, -8, 8, 8).contains(difference(without, skin)));
    QVERIFY(difference(without, skin).width() > line.width());
    const QImage tumour = b.with({b.tumour});
    const QRect behind = difference(without, tumour);
    QVERIFY(b.f.areaOf(b.tumour).adjusted(-8, -8, 8, 8).contains(behind));
    const int weak = Bench::largest(without, tumour, behind);
    QVERIFY2(weak > 20 && 3 * weak < 2 * strong, qPrintable(QString::number(weak)));
    // And all is as it was.
    QVERIFY(difference(without, b.with({})).isNull());
  }

  void exportsHaveNoOutline() {
    Bench b;
    b.f.control<QAction>("copyPicture").trigger();
    const auto copied = [] { return QGuiApplication::clipboard()->image(); };
    QTRY_VERIFY(!copied().isNull());
    const QImage before = copied();
    QGuiApplication::clipboard()->clear();
    b.with({b.organ});
    b.f.control<QAction>("copyPicture").trigger();
    QTRY_VERIFY(!copied().isNull());
    QVERIFY(difference(before.convertToFormat(QImage::Format_RGB32),
                       copied().convertToFormat(QImage::Format_RGB32))
                .isNull());
  }

  /// The structure under the mouse has a fainter line, which stays while the mouse moves on it and
  /// goes with it.
  void whatIsPointedAtIsOutlined() {
    Bench b;
    const QImage without = b.shown();
    const QImage selected = b.with({b.organ});
    b.with({});
    QLabel& name = b.f.control<QLabel>("nameUnderMouse");
    b.hover(b.middle);
    QTRY_VERIFY(name.isVisible());
    const QImage pointed = b.shown();
    QCOMPARE(b.f.viewport().lastLayersDrawn(), 0);
    const QRect line = difference(without, pointed);
    QVERIFY(b.f.areaOf(b.organ).adjusted(-8, -8, 8, 8).contains(line));
    const int faint = Bench::largest(without, pointed, line);
    QVERIFY(faint > 30 && faint < Bench::largest(without, selected, line));
    sendMouse(b.f.viewport(), QEvent::MouseMove, b.middle + QPoint(9, 3), Qt::NoButton);
    QVERIFY(!name.isVisible());
    QVERIFY(difference(pointed, b.shown()).isNull());
    b.hover({5, 5});
    QTRY_VERIFY(difference(without, b.shown()).isNull());
  }

  /// The middle button and the Page keys do without Alt, which window managers take.
  void stepsDeeperWithoutAlt() {
    Bench b;
    for (const model::NodeId id : {b.skin, b.organ, b.tumour, b.skin}) {
      QTest::mouseClick(&b.f.viewport(), Qt::MiddleButton, {}, b.middle);
      QVERIFY(b.selected({id}));
    }
    b.f.viewport().setFocus();
    b.hover(b.middle);
    QTest::keyClick(&b.f.viewport(), Qt::Key_PageDown);
    QVERIFY(b.selected({b.organ}));
    QTest::keyClick(&b.f.viewport(), Qt::Key_PageUp);
    QVERIFY(b.selected({b.skin}));
    QTest::keyClick(&b.f.viewport(), Qt::Key_PageUp);
    QVERIFY(b.selected({b.tumour}));
    // A drag of the middle button moves the picture, as before.
    dragMouse(b.f.viewport(), b.middle, b.middle + QPoint(40, 0), Qt::MiddleButton);
    QVERIFY(b.f.settled());
    QVERIFY(b.f.session.selection() == widgets::NodeIds{b.tumour});
  }

  void menuListsAllThatIsThere() {
    Bench b;
    QTest::mouseClick(&b.f.viewport(), Qt::RightButton, {}, b.middle);
    QMenu* menu = nullptr;
    QTRY_VERIFY((menu = b.f.window.findChild<QMenu*>("pictureMenu")) && menu->isVisible());
    QMenu* here = menu->findChild<QMenu*>("selectHere");
    QVERIFY(here);
    const QImage before = b.shown();
    menu->setActiveAction(here->menuAction());
    QTRY_VERIFY(here->isVisible());
    const QList<QAction*> entries = here->actions();
    QCOMPARE(entries.size(), 3);
    QCOMPARE(entries[0]->text(), QStringLiteral("skin && fat"));
    QCOMPARE(entries[2]->text(), QStringLiteral("tumour"));
    const Colour colour = b.f.session.scene().resolve(b.tumour).colour;
    QCOMPARE(entries[2]->icon().pixmap(16).toImage().pixelColor(8, 8),
             QColor(colour.red, colour.green, colour.blue));
    // Passed over, it shows in the picture.
    for (const QPoint& beside : {QPoint(0, 0), QPoint(2, 1)})
      sendMouse(*here, QEvent::MouseMove, here->actionGeometry(entries[2]).center() + beside,
                Qt::NoButton);
    QTRY_COMPARE(here->activeAction(), entries[2]);
    const QRect lit = difference(before, b.shown());
    QVERIFY(!lit.isNull() && b.f.areaOf(b.tumour).adjusted(-8, -8, 8, 8).contains(lit));
    QTest::mouseClick(here, Qt::LeftButton, {}, here->actionGeometry(entries[2]).center());
    QVERIFY(b.selected({b.tumour}));
    QTRY_VERIFY(!b.f.window.findChild<QMenu*>("pictureMenu"));
    const QImage chosen = b.shown();
    QVERIFY(difference(chosen, b.with({b.tumour})).isNull());
  }

  void boxesSelectWhatIsSeen() {
    Bench b;
    const model::Camera camera = b.f.viewport().camera();
    const QRect all = b.f.areaOf(b.skin).adjusted(-12, -12, 12, 12);
    const QRect organ = b.f.areaOf(b.organ).adjusted(-6, -6, 6, 6);
    const auto drag = [&b](const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys) {
      dragMouse(b.f.viewport(), from, to, Qt::LeftButton, keys);
    };
    // To the right: what lies within. The tumour is hidden by the organ.
    drag(all.topLeft(), all.bottomRight(), Qt::ControlModifier);
    QVERIFY(b.selected({b.skin, b.organ}));
    b.f.session.select({});
    drag(organ.topLeft(), organ.bottomRight(), Qt::ControlModifier);
    QVERIFY(b.selected({b.organ}));
    // In addition to what is selected, to the left: what is touched.
    b.f.session.select({b.tumour});
    drag(b.middle + QPoint(10, 10), b.middle - QPoint(10, 10), Qt::ControlModifier);
    QVERIFY(b.selected({b.skin, b.organ, b.tumour}));
    // With the key, in place of what is selected; Escape leaves it.
    QTest::keyClick(&b.f.window, Qt::Key_B);
    drag(organ.topLeft(), organ.bottomRight(), {});
    QVERIFY(b.selected({b.organ}));
    QTest::keyClick(&b.f.window, Qt::Key_B);
    b.f.viewport().setFocus();
    QTest::keyClick(&b.f.viewport(), Qt::Key_Escape);
    QVERIFY(b.f.viewport().camera() == camera);
    drag(b.middle, b.middle + QPoint(60, 0), {});
    QVERIFY(!(b.f.viewport().camera() == camera));
    QVERIFY(b.f.session.selection() == widgets::NodeIds{b.organ});
  }

  /// By keys, in the picture as in the list, and without a step of undo.
  void keysSelect() {
    WindowFixture f;
    const QTemporaryDir body;
    writeBody(body.path());
    QVERIFY(f.drop(body.path()));
    QVERIFY(f.settled());
    const int steps = f.session.history().count();
    const auto selected = [&f] {
      QStringList names;
      for (const model::NodeId id : f.session.selection())
        names << QString::fromStdString(f.session.scene().find(id)->name);
      names.sort();
      return names.join(QLatin1Char(','));
    };
    f.session.select(f.session.scene().named("left kidney"));
    QTest::keyClick(&f.viewport(), Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(selected(), QStringLiteral("right kidney"));
    QTest::keyClick(&f.viewport(), Qt::Key_G, Qt::ShiftModifier);
    QCOMPARE(selected(), QStringLiteral("left kidney,right kidney"));
    f.tree().setFocus();
    QTest::keyClick(&f.tree(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(selected(), QStringLiteral("aorta,bladder,left renal vein"));
    QTest::keyClick(&f.tree(), Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(f.session.selection().size(), std::size_t(5));
    QCOMPARE(f.session.history().count(), steps);
    // A hidden and a locked structure are left alone.
    f.session.select(f.session.scene().named("aorta"));
    QTest::keyClick(&f.tree(), Qt::Key_Space);
    f.session.select(f.session.scene().named("bladder"));
    QTest::keyClick(&f.window, Qt::Key_L, Qt::ControlModifier);
    QTest::keyClick(&f.viewport(), Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(selected(), QStringLiteral("left kidney,left renal vein,right kidney"));
  }

  /// The menu over a structure has what selects others by it.
  void otherSideFromTheMenu() {
    WindowFixture f;
    const QTemporaryDir body;
    writeBody(body.path());
    QVERIFY(f.drop(body.path()));
    QVERIFY(f.settled());
    const widgets::NodeIds left = f.session.scene().named("left kidney");
    f.session.select({left.front(), f.session.scene().named("right kidney").front()});
    f.control<QAction>("hideOthers").trigger();
    f.session.select({});
    QVERIFY(f.settled());
    QTest::mouseClick(&f.viewport(), Qt::RightButton, {}, f.areaOf(left.front()).center());
    QMenu* menu = nullptr;
    QTRY_VERIFY((menu = f.window.findChild<QMenu*>("pictureMenu")) && menu->isVisible());
    QCOMPARE(f.session.selection(), left);
    auto& choices = f.control<QMenu>("selectMenu");
    QVERIFY(menu->actions().contains(choices.menuAction()));
    menu->setActiveAction(choices.menuAction());
    QTest::keyClick(menu, Qt::Key_Right);
    QTRY_VERIFY(choices.isVisible());
    QTest::mouseClick(&choices, Qt::LeftButton, {},
                      choices.actionGeometry(&f.control<QAction>("selectOtherSide")).center());
    QCOMPARE(f.session.selection(), f.session.scene().named("right kidney"));
    QTRY_VERIFY(!f.window.findChild<QMenu*>("pictureMenu"));
  }

  void menuOfAStructure() {
    Bench b;
    QTest::mouseClick(&b.f.viewport(), Qt::RightButton, {}, b.middle);
    QMenu* menu = nullptr;
    QTRY_VERIFY((menu = b.f.window.findChild<QMenu*>("pictureMenu")) && menu->isVisible());
    QVERIFY(b.selected({b.organ}));
    QVERIFY(menu->actions().contains(&b.f.control<QAction>("focus")));
    QVERIFY(menu->actions().contains(&b.f.control<QAction>("zoomTo")));
    QVERIFY(menu->actions().contains(&b.f.control<QAction>("labelSelected")));
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
