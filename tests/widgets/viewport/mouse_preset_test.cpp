// SPDX-License-Identifier: Apache-2.0
#include <QTest>
#include <set>

#include "tests/support/suite.h"
#include "widgets/viewport/tools/camera_tool.h"

using namespace sline;
using namespace sline::widgets;

namespace {

struct FixedView : ViewControl {
  model::Camera now = model::anatomicalCamera(model::AnatomicalView::anterior, {}, 1.0f);
  const model::Camera& camera() const override { return now; }
  glm::vec3 pivot() const override { return {5.0f, 6.0f, 7.0f}; }
  void move(const model::Camera& camera) override { now = camera; }
};

}  // namespace

class MousePresetTest : public QObject {
  Q_OBJECT
 private slots:
  void drags_data() {
    QTest::addColumn<int>("preset");
    QTest::addColumn<int>("button");
    QTest::addColumn<int>("keys");
    QTest::addColumn<int>("kind");  // -1: nothing
    using enum model::CameraDrag::Kind;
    const auto row = [](const char* name, MousePreset preset, Qt::MouseButton button, int keys,
                        int kind) {
      QTest::newRow(name) << int(preset) << int(button) << keys << kind;
    };
    const int shift = Qt::ShiftModifier;
    const int control = Qt::ControlModifier;
    const int alt = Qt::AltModifier;
    const MousePreset sline = MousePreset::sline;
    const MousePreset slicer = MousePreset::slicer;
    const MousePreset blender = MousePreset::blender;
    row("left", sline, Qt::LeftButton, 0, int(orbit));
    row("middle", sline, Qt::MiddleButton, 0, int(pan));
    row("shift left", sline, Qt::LeftButton, shift, int(pan));
    row("right", sline, Qt::RightButton, 0, int(zoom));
    row("control shift left", sline, Qt::LeftButton, control | shift, int(roll));
    row("control left", sline, Qt::LeftButton, control, -1);
    row("keypad left", sline, Qt::LeftButton, Qt::KeypadModifier, int(orbit));
    row("slicer left", slicer, Qt::LeftButton, 0, int(orbit));
    row("slicer shift left", slicer, Qt::LeftButton, shift, int(pan));
    row("slicer right", slicer, Qt::RightButton, 0, int(zoom));
    row("slicer control left", slicer, Qt::LeftButton, control, int(roll));
    row("blender left", blender, Qt::LeftButton, 0, -1);
    row("blender middle", blender, Qt::MiddleButton, 0, int(orbit));
    row("blender shift middle", blender, Qt::MiddleButton, shift, int(pan));
    row("blender control middle", blender, Qt::MiddleButton, control, int(zoom));
    row("blender alt left", blender, Qt::LeftButton, alt, int(orbit));
    row("blender right", blender, Qt::RightButton, 0, -1);
  }
  void drags() {
    QFETCH(int, preset);
    QFETCH(int, button);
    QFETCH(int, keys);
    QFETCH(int, kind);
    const auto found =
        dragOf(MousePreset(preset), Qt::MouseButton(button), Qt::KeyboardModifiers::fromInt(keys));
    QCOMPARE(found ? int(*found) : -1, kind);

    FixedView view;
    const model::Camera before = view.now;
    CameraTool tool(view);
    tool.setPreset(MousePreset(preset));
    const Pointer at{.pixel = {300, 200},
                     .size = {800, 600},
                     .button = Qt::MouseButton(button),
                     .keys = Qt::KeyboardModifiers::fromInt(keys)};
    QCOMPARE(tool.press(at), kind >= 0);
    tool.move({.pixel = {340, 260}, .size = {800, 600}});
    QCOMPARE(view.now == before, kind < 0);
    tool.cancel();
    QVERIFY(view.now == before);
    tool.move({.pixel = {400, 300}, .size = {800, 600}});
    QVERIFY(view.now == before);  // the drag is over
  }

  /// No two rows of a table use the same buttons and keys, and help has a line for each way to
  /// move.
  void tablesAreSound() {
    for (const MousePresetName& name : mousePresetNames()) {
      QCOMPARE(mousePresetNamed(QLatin1String(name.id)), name.preset);
      std::set<std::pair<int, int>> hands;
      std::set<model::CameraDrag::Kind> kinds;
      for (const MouseRow& row : presetRows(name.preset)) {
        QVERIFY(hands.insert({int(row.button), int(row.keys)}).second);
        kinds.insert(row.kind);
      }
      QCOMPARE(kinds.size(), std::size_t(4));
      for (const ControlRow& row : controlRows(name.preset))
        QVERIFY(!row.control.isEmpty() && !row.meaning.isEmpty());
    }
    QCOMPARE(mousePresetNamed(QStringLiteral("no such")), MousePreset::sline);
    QVERIFY(controlRows(MousePreset::blender).front().control.startsWith("Middle drag"));
    QVERIFY(controlRows(MousePreset::sline)[1].control.contains("Shift+Left drag"));
  }
};

SLINE_TEST(MousePresetTest)
#include "mouse_preset_test.moc"
