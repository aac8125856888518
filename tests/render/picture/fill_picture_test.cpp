// SPDX-License-Identifier: Apache-2.0
// Tests fills: Phong that enters with Γ, paper and tint, opacity, transparency (METHOD §7).
#include <QtTest>
#include <cmath>

#include "tests/render/picture/scenes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Background;
using render::Image;

class FillPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void opacityGrowsWithGamma();
  void completeAtFive();
  void fillModes_data();
  void fillModes();
  void veilsAddUp();
  void opacityOfTheStyle();
  void seenFromWithin();
  void lightFallsFromTheEye();
  void keyLightFallsFromTheUpperLeft();
  void keyLightTurnsWithTheCamera();
  void entersAsShadeOrAsLight();
  void closesWithoutTurningBack_data();
  void closesWithoutTurningBack();

 private:
  Image picture(const model::Scene& scene, const model::Camera& camera, Background background,
                bool keyLight = false);
  Studio m_studio;
};

void FillPictureTest::initTestCase() {
  m_studio = openStudio();
  if (!m_studio.absent.empty())
    QSKIP(m_studio.absent.c_str());
  QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
}

Image FillPictureTest::picture(const model::Scene& scene, const model::Camera& camera,
                               Background background, bool keyLight) {
  auto image =
      m_studio.picture->render(scene, camera,
                               {.width = 400,
                                .height = 300,
                                .environment = {.background = background, .keyLight = keyLight}});
  if (!image)
    qFatal("%s", image.error().text().c_str());
  return std::move(*image);
}

void FillPictureTest::opacityGrowsWithGamma() {
  const model::MeshPtr shape = torus(50.0f, 20.0f, 120, 48);
  model::Camera camera = frontal(180.0f);
  camera.eye = {0.0f, -800.0f, 600.0f};
  Image last;
  for (const float gamma : {3.0f, 3.1f, 3.3f, 3.5f, 3.8f, 3.99f, 4.0f, 4.2f, 4.6f, 5.0f}) {
    model::Scene scene;
    model::Style style = gammaStyle(gamma);
    style.penWeight = 0.0f;  // without lines, alpha is the fill's own
    add(scene, shape, style);
    const Image image = picture(scene, camera, Background::transparent);
    if (!last.rgba.empty())
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
          QVERIFY2(pixelAt(image, x, y).alpha >= pixelAt(last, x, y).alpha - 1,
                   qPrintable(QString("gamma %1 at (%2, %3)").arg(gamma).arg(x).arg(y)));
    last = image;
  }
}

void FillPictureTest::completeAtFive() {
  model::Scene scene;
  add(scene, sphere(50.0f, 5), gammaStyle(5.0f));
  const Image image = picture(scene, frontal(150.0f), Background::transparent);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x) {
      const float radius = std::hypot(float(x) - 199.5f, float(y) - 149.5f);
      if (radius < 98.0f)
        QCOMPARE(pixelAt(image, x, y).alpha, 255);
      if (radius > 102.0f)
        QCOMPARE(pixelAt(image, x, y).alpha, 0);
    }
}

void FillPictureTest::fillModes_data() {
  QTest::addColumn<int>("fill");
  QTest::addColumn<int>("background");
  QTest::addColumn<QList<int>>("expected");
  // A sphere of Γ = 1 stands before an opaque box of grey 0.
  QTest::newRow("none") << int(model::Fill::none) << int(Background::white) << QList<int>{};
  QTest::newRow("paper on white") << int(model::Fill::paper) << int(Background::white)
                                  << QList<int>{255, 255, 255, 255};
  QTest::newRow("paper on dark") << int(model::Fill::paper) << int(Background::dark)
                                 << QList<int>{28, 30, 34, 255};
  QTest::newRow("paper on nothing")
      << int(model::Fill::paper) << int(Background::transparent) << QList<int>{255, 255, 255, 255};
}

void FillPictureTest::fillModes() {
  QFETCH(int, fill);
  QFETCH(int, background);
  QFETCH(QList<int>, expected);
  model::Style behindStyle = gammaStyle(5.0f);
  behindStyle.colour = Colour{220, 40, 40};
  const model::MeshPtr behind = moved(*sphere(50.0f, 4), 1.0f, {0.0f, 200.0f, 0.0f});
  model::Scene alone;
  add(alone, behind, behindStyle);
  model::Scene covered = alone;
  model::Style style = gammaStyle(1.0f);
  style.fill = model::Fill(fill);
  add(covered, sphere(50.0f, 4), style);
  const Image image = picture(covered, frontal(150.0f), Background(background));
  const Pixel p = pixelAt(image, 200, 150);
  if (expected.isEmpty()) {
    const Pixel q = pixelAt(picture(alone, frontal(150.0f), Background(background)), 200, 150);
    QCOMPARE(p.red, q.red);
    QCOMPARE(p.green, q.green);
  } else {
    QCOMPARE((QList<int>{p.red, p.green, p.blue, p.alpha}), expected);
  }
}

void FillPictureTest::veilsAddUp() {
  // 0, 1 and 2 veiled spheres before an opaque one: each leaves two fifths of the contrast.
  const model::MeshPtr ball = sphere(50.0f, 4);
  model::Scene scene;
  model::Style behind = gammaStyle(5.0f);
  behind.colour = Colour{10, 10, 10};
  add(scene, moved(*ball, 1.0f, {0.0f, 200.0f, 0.0f}), behind);
  model::Style veil = gammaStyle(1.0f);
  veil.fill = model::Fill::veil;
  QList<int> contrast;
  for (int veils = 0; veils <= 2; ++veils) {
    contrast << 255 - pixelAt(picture(scene, frontal(150.0f), Background::white), 200, 150).red;
    add(scene, moved(*ball, 1.0f, {0.0f, -120.0f * float(veils), 0.0f}), veil);
  }
  QVERIFY(std::abs(contrast[1] - int(0.4f * float(contrast[0]))) <= 2);
  QVERIFY(std::abs(contrast[2] - int(0.4f * float(contrast[1]))) <= 2);
}

void FillPictureTest::opacityOfTheStyle() {
  model::Scene scene;
  model::Style style = gammaStyle(5.0f);
  style.opacity = Opacity::clamped(0.5f);
  add(scene, sphere(50.0f, 4), style);
  const Pixel p = pixelAt(picture(scene, frontal(150.0f), Background::transparent), 200, 150);
  QVERIFY(std::abs(p.alpha - 128) <= 1);
  model::Scene tinted;
  model::Style wash = gammaStyle(1.0f);
  wash.fill = model::Fill::tint;
  wash.colour = Colour{200, 100, 50};
  add(tinted, sphere(50.0f, 4), wash);
  const Pixel t = pixelAt(picture(tinted, frontal(150.0f), Background::transparent), 200, 150);
  QVERIFY(t.alpha > 25 && t.alpha < 80);
  // Alpha is straight: the colour is the structure's own.
  QVERIFY(std::abs(t.red - 200) <= 3 && std::abs(t.green - 100) <= 3);
}

void FillPictureTest::seenFromWithin() {
  // The tube is open and seen from the side of its mouth: its inner wall is lit like an outer one.
  model::Scene scene;
  add(scene, cylinder(40.0f, 100.0f, 96, 48), gammaStyle(5.0f));
  model::Camera camera = frontal(150.0f);
  camera.eye = {0.0f, -500.0f, 866.0f};
  camera.up = {0.0f, 1.0f, 0.0f};
  const Image image = picture(scene, camera, Background::white);
  int dark = 0;
  int painted = 0;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x) {
      painted += pixelAt(image, x, y).grey() < 250;
      dark += pixelAt(image, x, y).grey() < 40;
    }
  QVERIFY(painted > 5000);
  QVERIFY(dark < painted / 20);
}

void FillPictureTest::lightFallsFromTheEye() {
  model::Scene scene;
  add(scene, sphere(50.0f, 5), gammaStyle(5.0f));
  const Image image = picture(scene, frontal(150.0f), Background::white);
  int last = 256;
  for (int x = 200; x < 296; x += 8) {
    const int grey = pixelAt(image, x, 150).grey();
    QVERIFY2(grey <= last, qPrintable(QString("x %1: %2").arg(x).arg(grey)));
    last = grey;
  }
  QVERIFY(pixelAt(image, 200, 150).grey() > 1.4 * last);
}

void FillPictureTest::keyLightFallsFromTheUpperLeft() {
  model::Scene scene;
  add(scene, sphere(50.0f, 5), gammaStyle(5.0f));
  const auto corner = [](const Image& image, int right, int down) {
    return pixelAt(image, 200 + 50 * right, 150 + 50 * down).grey();
  };
  const Image head = picture(scene, frontal(150.0f), Background::white);
  const Image key = picture(scene, frontal(150.0f), Background::white, true);
  QVERIFY(std::abs(corner(head, -1, -1) - corner(head, 1, 1)) <= 2);
  QVERIFY2(corner(key, -1, -1) > 1.4 * corner(key, 1, 1),
           qPrintable(QString("%1, %2").arg(corner(key, -1, -1)).arg(corner(key, 1, 1))));
  QVERIFY(corner(key, 1, -1) > corner(key, 1, 1) && corner(key, 1, -1) < corner(key, -1, -1));
  // Structures that were drawn are drawn anew for another light.
  QCOMPARE(difference(picture(scene, frontal(150.0f), Background::white), head).largest, 0);
}

void FillPictureTest::keyLightTurnsWithTheCamera() {
  model::Scene scene;
  add(scene, sphere(50.0f, 5), gammaStyle(5.0f));
  const Image front = picture(scene, frontal(150.0f), Background::white, true);
  model::Camera above = frontal(150.0f);
  above.eye = {300.0f, 500.0f, 800.0f};
  above.up = {1.0f, 0.3f, 0.0f};
  const Difference d = difference(front, picture(scene, above, Background::white, true));
  QVERIFY2(d.mean < 0.5, qPrintable(QString::number(d.mean)));
}

void FillPictureTest::entersAsShadeOrAsLight() {
  model::Style style = gammaStyle(3.4f);
  style.penWeight = 0.0f;
  style.colour = Colour{230, 120, 60};
  model::Scene scene;
  add(scene, sphere(50.0f, 5), style);
  // The places are the sphere's middle and one 5 of its 100 pixels from the rim.
  const auto change = [&](Background background, int x) {
    const Image image = picture(scene, frontal(150.0f), background);
    return pixelAt(image, x, 150).grey() - pixelAt(image, 2, 2).grey();
  };
  QVERIFY(change(Background::white, 295) < -20);
  QVERIFY(std::abs(change(Background::white, 200)) <= 2);
  QVERIFY(change(Background::dark, 200) > 20);
  QVERIFY(std::abs(change(Background::dark, 295)) <= 2);
}

void FillPictureTest::closesWithoutTurningBack_data() {
  QTest::addColumn<int>("background");
  QTest::addColumn<bool>("keyLight");
  QTest::newRow("white") << int(Background::white) << false;
  QTest::newRow("white, key light") << int(Background::white) << true;
  QTest::newRow("dark") << int(Background::dark) << false;
  QTest::newRow("dark, key light") << int(Background::dark) << true;
}

void FillPictureTest::closesWithoutTurningBack() {
  QFETCH(int, background);
  QFETCH(bool, keyLight);
  // Each pixel goes from the ground's colour to the surface's, and turns back by at most 2 %
  // (METHOD §7).
  std::vector<Image> images;
  for (const float gamma : {3.0f, 3.3f, 3.6f, 3.9f, 4.0f, 4.4f, 4.8f, 4.95f, 4.999f}) {
    model::Style style = gammaStyle(gamma);
    style.penWeight = 0.0f;
    style.colour = Colour{230, 120, 60};
    model::Scene scene;
    add(scene, sphere(50.0f, 5), style);
    images.push_back(picture(scene, frontal(150.0f), Background(background), keyLight));
  }
  const Image& last = images.back();
  int turned = 0;
  for (std::size_t i = 1; i < images.size(); ++i)
    for (std::size_t k = 0; k < last.rgba.size(); ++k) {
      const auto [low, high] = std::minmax(images[i - 1].rgba[k], last.rgba[k]);
      const int now = images[i].rgba[k];
      turned = std::max({turned, low - now, now - high});
    }
  QVERIFY2(turned <= 5, qPrintable(QString("by %1 of 255").arg(turned)));
}

SLINE_TEST_WITH_EVENTS(FillPictureTest)
#include "fill_picture_test.moc"
