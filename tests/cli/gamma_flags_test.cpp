// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/gamma_flags.h"

#include <QTest>

#include "app/cli/flags/picture_flags.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::cli {

using model::GammaScalar;

class GammaFlagsTest : public QObject {
  Q_OBJECT

 private slots:
  void understood_data();
  void understood();
  void refused_data();
  void refused();
  void targetsAreFound();
  void innermostNameWins();
};

void GammaFlagsTest::understood_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<int>("scalar");
  QTest::addColumn<QString>("target");
  QTest::addColumn<QString>("curve");  // empty: the usual one
  QTest::newRow("occlusion") << "occlusion" << int(GammaScalar::occlusion) << ""
                             << "";
  QTest::newRow("case") << "Curvature" << int(GammaScalar::curvature) << ""
                        << "";
  QTest::newRow("painted") << "painted@0:-2,1:+2" << int(GammaScalar::painted) << ""
                           << "0:-2,1:+2";
  QTest::newRow("none") << "none" << int(GammaScalar::none) << ""
                        << "";
  QTest::newRow("a curve") << "curvature@-2:+2,0:0" << int(GammaScalar::curvature) << ""
                           << "-2:+2,0:0";
  QTest::newRow("a distance") << "distance:tumour" << int(GammaScalar::distance) << "tumour"
                              << "";
  QTest::newRow("a name with signs")
      << "distance:Chain A: 2@x@0:3,9:0" << int(GammaScalar::distance) << "Chain A: 2@x"
      << "0:+3,9:0";
}

void GammaFlagsTest::understood() {
  QFETCH(QString, text);
  QFETCH(int, scalar);
  QFETCH(QString, target);
  QFETCH(QString, curve);
  const Result<GammaMapWish> wish = parseGammaMap(text.toStdString());
  QVERIFY2(wish.ok(), wish.ok() ? "" : wish.error().text().c_str());
  QCOMPARE(int(wish->map.scalar), scalar);
  QCOMPARE(QString::fromStdString(wish->target), target);
  if (curve.isEmpty())
    QVERIFY(wish->map.curve == model::usualCurve(GammaScalar(scalar)));
  else
    QCOMPARE(QString::fromStdString(model::curveText(wish->map.curve)), curve);
}

void GammaFlagsTest::refused_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("said");
  QTest::newRow("nothing") << ""
                           << "occlusion";
  QTest::newRow("another scalar") << "mood"
                                  << "\"mood\"";
  QTest::newRow("a distance from nothing") << "distance"
                                           << "from what";
  QTest::newRow("a distance from no name") << "distance:_@0:1,1:2"
                                           << "from what";
  QTest::newRow("occlusion from something") << "occlusion:liver"
                                            << "only a distance";
  QTest::newRow("a bad point") << "occlusion@0:0,half:3"
                               << "point 2 of the curve: \"half:3\"";
  QTest::newRow("one point") << "occlusion@0:0"
                             << "2 to 8";
  QTest::newRow("no curve") << "occlusion@"
                            << "point 1";
  QTest::newRow("too much") << "distance:liver@0:9,40:-1"
                            << "-5 to 5";
  QTest::newRow("a curve of nothing") << "none@0:0,1:1"
                                      << "follows nothing";
}

void GammaFlagsTest::refused() {
  QFETCH(QString, text);
  QFETCH(QString, said);
  const Result<GammaMapWish> wish = parseGammaMap(text.toStdString());
  QVERIFY(!wish.ok());
  QVERIFY(!wish.error().remedy.empty());
  QVERIFY2(wish.error().text().find(said.toStdString()) != std::string::npos,
           wish.error().text().c_str());
}

void GammaFlagsTest::targetsAreFound() {
  model::Scene scene;
  const model::NodeId group = scene.append({.name = "Vessels"});
  scene.append({.parent = group, .name = "vein", .mesh = test::sphere(1.0f, 1)});
  const Result<GammaMapWish> known = parseGammaMap("distance:vessels");
  const Result<model::GammaMap> map = gammaMapIn(scene, *known);
  QVERIFY(map.ok());
  QCOMPARE(map->targets, std::vector<model::NodeId>{group});
  const Result<GammaMapWish> unknown = parseGammaMap("distance:vien");
  const Result<model::GammaMap> none = gammaMapIn(scene, *unknown);
  QVERIFY(!none.ok());
  QVERIFY(none.error().text().find("vein") != std::string::npos);
}

void GammaFlagsTest::innermostNameWins() {
  model::Scene scene;
  const model::NodeId group = scene.append({.name = "Organs"});
  const model::NodeId liver =
      scene.append({.parent = group, .name = "liver", .mesh = test::sphere(1.0f, 1)});
  const model::NodeId spleen =
      scene.append({.parent = group, .name = "spleen", .mesh = test::sphere(1.0f, 1)});
  PictureFlags flags;
  flags.gammaMaps = {"liver=distance:spleen@0:2,5:-1", "organs=curvature"};
  const Result<PictureSpec> spec = parseFlagsWithoutOutput(flags);
  QVERIFY2(spec.ok(), spec.ok() ? "" : spec.error().text().c_str());
  const Result<model::Scene> drawn = styled(scene, *spec);
  QVERIFY(drawn.ok());
  QCOMPARE(drawn->resolve(liver).gammaMap.targets, std::vector<model::NodeId>{spleen});
  QCOMPARE(int(drawn->resolve(spleen).gammaMap.scalar), int(GammaScalar::curvature));
}

}  // namespace sline::cli

SLINE_TEST(sline::cli::GammaFlagsTest)
#include "gamma_flags_test.moc"
