// SPDX-License-Identifier: Apache-2.0
// Compares pictures of which the surfaces are coarse, as while the camera moves, with those at
// rest.
#include <QtTest>
#include <cmath>

#include "tests/render/picture/section_scenes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Image;
using render::PictureSettings;

namespace {

constexpr PictureSettings still{.width = 480, .height = 360};

PictureSettings moving(int step, render::PictureContent parts = {}) {
  PictureSettings settings = still;
  settings.surfaceStep = step;
  settings.parts = parts;
  return settings;
}

/// Returns the blackness of the whole picture, in pixels.
double totalInk(const Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      sum += double(inkAt(image, x, y));
  return sum;
}

/// Returns the mean squared difference between neighbours, which falls where lines blur.
double sharpness(const Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x + 1 < image.width; ++x) {
      const double d = double(inkAt(image, x + 1, y) - inkAt(image, x, y));
      sum += d * d;
    }
  return sum / double(image.width * image.height);
}

/// Returns the darkest of the pixels at most `reach` away.
float darkestAround(const Image& image, int x, int y, int reach) {
  float darkest = 0.0f;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx)
      if (x + dx >= 0 && x + dx < image.width && y + dy >= 0 && y + dy < image.height)
        darkest = std::max(darkest, inkAt(image, x + dx, y + dy));
  return darkest;
}

/// Returns balls of many colours and sizes in and before each other.
model::Scene balls(float gamma) {
  model::Scene scene;
  for (int i = 0; i < 18; ++i) {
    const float a = 0.9f * float(i);
    const glm::vec3 at(52.0f * std::cos(a), 12.0f * std::sin(3.0f * a), 36.0f * std::sin(1.7f * a));
    add(scene, moved(*sphere(8.0f + float(i % 5), 4), 1.0f, at),
        styled(gamma, Colour{std::uint8_t(40 + 12 * i), std::uint8_t(200 - 9 * i), 120}));
  }
  return scene;
}

}  // namespace

class MovingPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    m_studio = openStudio();
    if (!m_studio.absent.empty())
      QSKIP(m_studio.absent.c_str());
    QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
  }

  void linesStaySharp_data() {
    QTest::addColumn<int>("step");
    QTest::addColumn<float>("gamma");
    for (const int step : {2, 3, 4})
      for (const float gamma : {1.0f, 2.0f, 3.0f})
        QTest::addRow("1/%d, gamma %g", step, double(gamma)) << step << gamma;
  }
  void linesStaySharp() {
    QFETCH(int, step);
    QFETCH(float, gamma);
    model::Scene scene = crowd(gamma);
    const render::PictureContent lines{.fills = false};
    const Image fine = picture(scene, moving(1, lines));
    const Image coarse = picture(scene, moving(step, lines));
    const double ink = totalInk(fine);
    QVERIFY(ink > 500.0);
    QVERIFY2(std::abs(totalInk(coarse) / ink - 1.0) < 0.02,
             qPrintable(QString("%1 of %2").arg(totalInk(coarse)).arg(ink)));
    QVERIFY2(sharpness(coarse) > 0.98 * sharpness(fine),
             qPrintable(QString("%1 of %2").arg(sharpness(coarse)).arg(sharpness(fine))));
    QVERIFY2(difference(fine, coarse).share < 0.01,
             qPrintable(QString::number(difference(fine, coarse).share)));
  }

  void nothingLeaks_data() {
    QTest::addColumn<int>("step");
    for (const int step : {2, 3, 4})
      QTest::addRow("1/%d", step) << step;
  }
  /// In one structure, a ball stands before a ring and hides most of it.
  void nothingLeaks() {
    QFETCH(int, step);
    const model::MeshPtr ring = moved(*torus(20.0f, 5.0f, 120, 48), 1.0f, {0.0f, 60.0f, 0.0f});
    model::Scene scene;
    add(scene, together(*sphere(40.0f, 5), *ring), gammaStyle(2.0f));
    const Image image = picture(scene, moving(step));
    const float radius = 40.0f / 110.0f * 360.0f;
    for (int y = 0; y < still.height; ++y)
      for (int x = 0; x < still.width; ++x)
        if (std::hypot(float(x) - 239.5f, float(y) - 179.5f) < radius - 4.0f)
          QVERIFY2(inkAt(image, x, y) < 0.02f, qPrintable(QString("(%1, %2)").arg(x).arg(y)));
    QVERIFY(inkAt(image, 240 + int(radius), 180) > 0.5f);
  }

  void fillsEndAtTheirOutlines_data() { nothingLeaks_data(); }
  void fillsEndAtTheirOutlines() {
    QFETCH(int, step);
    const model::Scene scene = balls(3.7f);
    const Image fine = picture(scene, moving(1));
    const Image coarse = picture(scene, moving(step));
    const auto lightestAround = [&](int x, int y) {
      float lightest = 1.0f;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          lightest = std::min(lightest, inkAt(fine, x + dx, y + dy));
      return lightest;
    };
    for (int y = 1; y + 1 < still.height; ++y)
      for (int x = 1; x + 1 < still.width; ++x) {
        const QString at = QString("(%1, %2)").arg(x).arg(y);
        if (darkestAround(fine, x, y, 1 + step / 2) == 0.0f)
          QVERIFY2(inkAt(coarse, x, y) == 0.0f, qPrintable("colour outside at " + at));
        if (lightestAround(x, y) > 0.15f)
          QVERIFY2(inkAt(coarse, x, y) > 0.05f, qPrintable("a gap at " + at));
      }
    QVERIFY2(difference(fine, coarse).mean < 0.6 * step,
             qPrintable(QString::number(difference(fine, coarse).mean)));
  }

  void fillsReachOutlinesWithin_data() { nothingLeaks_data(); }
  /// A ball of the structure stands before another one: there two surfaces are in one fill.
  void fillsReachOutlinesWithin() {
    QFETCH(int, step);
    constexpr float ball = 20.0f;
    const model::MeshPtr behind = moved(*sphere(45.0f, 5), 1.0f, {9.0f, 70.0f, 0.0f});
    model::Scene scene;
    add(scene, together(*sphere(ball, 5), *behind), gammaStyle(3.6f));
    const Image fine = picture(scene, moving(1));
    const Image coarse = picture(scene, moving(step));
    double apart = 0.0;
    int count = 0;
    const float radius = ball / 110.0f * 360.0f;
    for (int y = 0; y < still.height; ++y)
      for (int x = 0; x < still.width; ++x)
        if (std::abs(std::hypot(float(x) - 239.5f, float(y) - 179.5f) - radius) <
            1.0f + float(step)) {
          apart += double(std::abs(inkAt(fine, x, y) - inkAt(coarse, x, y)));
          ++count;
        }
    QVERIFY2(apart / count < 0.006 * step, qPrintable(QString::number(apart / count)));
  }

  /// What lies beside a layer in the atlas must not show in it.
  void layersKeepToThemselves() {
    const model::Scene scene = balls(5.0f);
    const Image coarse = picture(scene, moving(3));
    const Image fine = picture(scene, moving(1));
    QVERIFY(difference(fine, coarse).share < 0.12);
    for (int y = 0; y < still.height; ++y)
      for (int x = 0; x < still.width; ++x)
        if (darkestAround(fine, x, y, 2) == 0.0f)
          QCOMPARE(inkAt(coarse, x, y), 0.0f);
  }

  void cutFacesStaySharp() {
    model::Scene scene = crowd(4.0f);
    cut(scene, model::AnatomicalView::anterior, 0.0f);
    const Image fine = picture(scene, moving(1));
    const Image coarse = picture(scene, moving(3));
    const auto inFace = [](const Pixel& p) { return reddish(p); };
    const Spot a = spot(fine, inFace);
    const Spot b = spot(coarse, inFace);
    QVERIFY(a.count > 1000);
    QVERIFY2(std::abs(a.count - b.count) < a.count / 100,
             qPrintable(QString("%1 and %2").arg(a.count).arg(b.count)));
    QVERIFY2(difference(fine, coarse).share < 0.02,
             qPrintable(QString::number(difference(fine, coarse).share)));
  }

  void restIsAsEver() {
    const model::Scene scene = crowd(2.8f);
    const Image before = picture(scene, moving(1));
    for (const int step : {3, 2, 4})
      picture(scene, moving(step));
    QCOMPARE(difference(before, picture(scene, moving(1))).largest, 0);
    // And where the first picture was a coarse one.
    auto fresh = render::Picture::create();
    QVERIFY(fresh.ok());
    QVERIFY((*fresh)->render(scene, frontal(110.0f), moving(3)).ok());
    const auto after = (*fresh)->render(scene, frontal(110.0f), moving(1));
    QVERIFY(after.ok());
    QCOMPARE(difference(before, *after).largest, 0);
  }

  /// In a hurry no scale of a surface is made for its lines; at rest it is.
  void whatAHurryLeavesOutComesAtRest() {
    const model::MeshPtr ball = sphere(15.0f, 6);
    std::vector<glm::vec3> positions(ball->positions().begin(), ball->positions().end());
    for (glm::vec3& p : positions)
      p *= 1.0f + 0.01f * std::sin(2.5f * p.x) * std::sin(2.5f * p.z);
    model::Scene scene;
    add(scene,
        std::make_shared<const model::Mesh>(
            *model::Mesh::create(positions, {ball->triangles().begin(), ball->triangles().end()})),
        gammaStyle(2.0f));
    PictureSettings hurried = still;
    hurried.hurried = true;
    const Image rough = picture(scene, hurried);
    QVERIFY(m_studio.picture->timings().makeshift);
    const Image rest = picture(scene, still);
    QVERIFY(!m_studio.picture->timings().makeshift);
    QVERIFY(difference(rough, rest).share > 0.001);
    // What was made for it serves the next move.
    QCOMPARE(difference(rest, picture(scene, hurried)).largest, 0);
    QVERIFY(!m_studio.picture->timings().makeshift);
    auto fresh = render::Picture::create();
    QVERIFY(fresh.ok());
    const auto other = (*fresh)->render(scene, frontal(110.0f), still);
    QVERIFY(other.ok());
    QCOMPARE(difference(rest, *other).largest, 0);
  }

  void keepsCoarseLayers() {
    std::vector<model::Node> nodes = balls(3.5f).nodes();
    const auto drawn = [&](int step) {
      model::Scene scene;
      scene.setNodes(nodes);
      picture(scene, moving(step));
      return m_studio.picture->timings().layersDrawn;
    };
    QCOMPARE(drawn(3), 18);
    QCOMPARE(drawn(3), 0);
    nodes[3].style.gamma = Gamma::clamped(3.0f);
    QCOMPARE(drawn(3), 1);
    QCOMPARE(drawn(2), 18);
    QCOMPARE(drawn(1), 18);
  }

  /// Noise is found pixel by pixel, so its surfaces are fine.
  void noiseIsAsEver() {
    model::Scene scene;
    model::Style style = gammaStyle(3.0f);
    style.technique = model::Technique::noiseLic;
    add(scene, torus(30.0f, 12.0f, 120, 48), style);
    const Image fine = picture(scene, moving(1));
    QVERIFY(totalInk(fine) > 100.0);
    QCOMPARE(difference(fine, picture(scene, moving(3))).largest, 0);
  }

 private:
  Image picture(const model::Scene& scene, const PictureSettings& settings) {
    auto image = m_studio.picture->render(scene, frontal(110.0f), settings);
    if (!image)
      qFatal("%s", image.error().text().c_str());
    return std::move(*image);
  }

  Studio m_studio;
};

SLINE_TEST(MovingPictureTest)
#include "moving_picture_test.moc"
