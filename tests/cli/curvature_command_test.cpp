// SPDX-License-Identifier: Apache-2.0
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

class CurvatureCommandTest : public QObject {
  Q_OBJECT

 private slots:
  void sphere_data();
  void sphere();
};

void CurvatureCommandTest::sphere_data() {
  QTest::addColumn<QString>("frame");
  QTest::addColumn<float>("sign");  // of x and y
  QTest::newRow("file") << "file" << 1.0f;
  QTest::newRow("LPS") << "LPS" << 1.0f;
  QTest::newRow("RAS") << "RAS" << -1.0f;
}

void CurvatureCommandTest::sphere() {
  QFETCH(QString, frame);
  QFETCH(float, sign);
  const QTemporaryDir folder;
  const model::MeshPtr ball = test::sphere(20.0f, 4);
  writeObj(folder.filePath("ball.obj"), *ball);
  const Finished finished = runSline({"curvature", folder.filePath("ball.obj"), "-o",
                                      folder.filePath("out.csv"), "--frame", frame});
  QVERIFY2(finished.code == 0, finished.err.constData());
  QVERIFY(finished.out.isEmpty() && finished.err.isEmpty());
  QFile file(folder.filePath("out.csv"));
  QVERIFY(file.open(QIODevice::ReadOnly));
  QList<QByteArray> rows = file.readAll().split('\n');
  QCOMPARE(rows.takeFirst(),
           QByteArray("x,y,z,nx,ny,nz,k1,k2,e1x,e1y,e1z,e2x,e2y,e2z,dcurv0,dcurv1,dcurv2,dcurv3"));
  QCOMPARE(rows.takeLast(), QByteArray());
  QCOMPARE(rows.size(), qsizetype(ball->vertexCount()));
  for (qsizetype i = 0; i < rows.size(); ++i) {
    QList<double> v;
    for (const QByteArray& cell : rows[i].split(','))
      v << cell.toDouble();
    QCOMPARE(v.size(), 18);
    const glm::vec3& p =
        ball->positions()[std::size_t(i)];  // in the file's order, to the last digit
    QCOMPARE(float(v[0]), sign * p.x);
    QCOMPARE(float(v[1]), sign * p.y);
    QCOMPARE(float(v[2]), p.z);
    for (int c = 0; c < 3; ++c)
      QVERIFY(std::abs(v[3 + c] - v[c] / 20.0) < 1e-3);  // outward
    QVERIFY(std::abs(v[6] - 0.05) < 0.002 && std::abs(v[7] - 0.05) < 0.002);
    QVERIFY(std::abs(std::hypot(v[8], v[9], v[10]) - 1.0) < 1e-4);
    QVERIFY(std::abs(std::hypot(v[11], v[12], v[13]) - 1.0) < 1e-4);
    QVERIFY(std::abs(v[8] * v[11] + v[9] * v[12] + v[10] * v[13]) < 1e-4);
  }
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::CurvatureCommandTest)
#include "curvature_command_test.moc"
