// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/stroke_maker.h"

#include <QTest>

#include "tests/support/suite.h"

namespace sline::render {

class StrokeMakerTest : public QObject {
  Q_OBJECT

 private slots:
  /// The curve of an outline may lie half a λ outside the surface. The pen's outer edge runs along
  /// it; its inner edge, in print, reaches a quarter of a λ within the line itself, so that a fill
  /// begins where it ends. On the screen, where half a λ is half a pixel, and in drawings of lines
  /// alone the pen stays as it is.
  void outlinesReachTheirFill_data() {
    QTest::addColumn<int>("height");
    QTest::addColumn<float>("tones");
    QTest::addColumn<float>("inner");  ///< px outside the line
    QTest::newRow("screen") << 720 << 1.0f << 0.0f;
    QTest::newRow("print") << 7200 << 1.0f << -3.0f;
    QTest::newRow("large print") << 14400 << 1.0f << -5.5f;
    QTest::newRow("print, tones half entered") << 7200 << 0.5f << 0.75f;
    QTest::newRow("print of lines alone") << 7200 << 0.0f << 4.5f;
  }
  void outlinesReachTheirFill() {
    QFETCH(int, height);
    QFETCH(float, tones);
    QFETCH(float, inner);
    const float mm = 100.0f;
    const model::Camera camera{.projection = model::Projection::orthographic,
                               .eye = {0, -200, 0},
                               .target = {0, 0, 0},
                               .up = {0, 0, 1},
                               .heightMm = mm};
    model::Box bounds;
    bounds.add(glm::vec3(-60.0f));
    bounds.add(glm::vec3(60.0f));
    const PictureView view(camera, bounds, height, height);
    const model::Surface surface{};
    StrokeMaker maker(surface, view, view.whole());
    maker.setTones(tones);
    const float unit = view.outputUnit();
    const float beyond = 0.5f * unit;  // px
    const glm::vec3 move(0.0f, 0.0f, beyond * mm / float(height));
    const float width = 2.0f * unit;
    maker.contour({.a = {-5, 0, 0},
                   .b = {5, 0, 0},
                   .normalA = {0, 0, 1},
                   .normalB = {0, 0, 1},
                   .moveA = move,
                   .moveB = move},
                  width, 1.0f, 1.0f);
    const std::vector<Stroke> strokes = maker.take();
    QCOMPARE(strokes.size(), std::size_t(1));
    const Stroke& s = strokes.front();
    // As the pen is laid: half a pixel of it within its line.
    const float middle = s.moveA.y + s.halfWidthA - 0.5f;
    QVERIFY(std::abs(middle + s.halfWidthA - (beyond + width - 0.5f)) < 0.01f * unit);
    QVERIFY(std::abs(middle - s.halfWidthA - inner) < 0.01f * unit);
  }
};

}  // namespace sline::render

SLINE_TEST(sline::render::StrokeMakerTest)
#include "stroke_maker_test.moc"
