// SPDX-License-Identifier: Apache-2.0
// Has Khronos's validator judge the files of glTF that are written.
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include "model/demo/pelvis/pelvis.h"
#include "model/import/plan/import.h"
#include "tests/render/export/gltf/gltf_sample.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

model::MeshPtr meshOf(std::vector<glm::vec3> positions, std::vector<model::Triangle> triangles) {
  return std::make_shared<const model::Mesh>(
      std::move(model::Mesh::create(std::move(positions), std::move(triangles))).value());
}

QByteArray readAll(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

}  // namespace

class GltfValidatorTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void validates_data();
  void validates();
  void validatesTheAbdomen();
  void validatorFindsFaults();

 private:
  /// Returns the report of Khronos's validator on the bytes; an empty object if it did not run.
  QJsonObject judged(const std::string& bytes);
  QString m_node;
  QString m_why;  ///< why there is no validator
  QTemporaryDir m_folder;
};

void GltfValidatorTest::initTestCase() {
  m_node = QStandardPaths::findExecutable("node");
  const QString npm = QStandardPaths::findExecutable("npm");
  if (m_node.isEmpty() || npm.isEmpty()) {
    m_why = "Node.js and npm are not installed: nobody asked Khronos's validator";
    return;
  }
  const QDir folder(SLINE_VALIDATOR_FOLDER);
  QVERIFY(folder.mkpath("."));
  bool same = folder.exists("node_modules/gltf-validator/package.json");
  for (const char* file : {"package.json", "package-lock.json"}) {
    const QString source = QString(SLINE_VALIDATOR_FILES) + "/" + file;
    same = same && readAll(folder.filePath(file)) == readAll(source);
    QFile::remove(folder.filePath(file));
    QVERIFY(QFile::copy(source, folder.filePath(file)));
  }
  if (same)
    return;
  QProcess install;
  install.setWorkingDirectory(folder.path());
  install.start(npm, {"ci", "--no-audit", "--no-fund", "--ignore-scripts"});
  if (!install.waitForFinished(120'000) || install.exitCode() != 0) {
    install.kill();
    install.waitForFinished();
    m_why = "npm cannot fetch Khronos's validator: " + install.readAllStandardError();
  }
}

QJsonObject GltfValidatorTest::judged(const std::string& bytes) {
  const QString file = m_folder.filePath("scene.glb");
  QFile out(file);
  if (!out.open(QIODevice::WriteOnly) || out.write(bytes.data(), qint64(bytes.size())) < 0)
    return {};
  out.close();
  QProcess validator;
  validator.setWorkingDirectory(SLINE_VALIDATOR_FOLDER);
  validator.start(m_node, {QString(SLINE_VALIDATOR_FILES) + "/validate.cjs", file});
  if (!validator.waitForFinished(120'000))
    return {};
  if (const QByteArray complaint = validator.readAllStandardError(); !complaint.isEmpty())
    qWarning("%s", complaint.constData());
  return QJsonDocument::fromJson(validator.readAllStandardOutput()).object();
}

void GltfValidatorTest::validates_data() {
  QTest::addColumn<model::Scene>("scene");
  QTest::addColumn<int>("triangles");
  QTest::newRow("all there is") << sample().scene << 4 * 80;
  QTest::newRow("empty") << model::Scene() << 0;
  model::Scene hidden;
  setStyle(hidden, add(hidden, "ball", model::rootId, test::sphere(10.0f, 1)), {.visible = false});
  QTest::newRow("all hidden") << hidden << 0;
  hidden.setViews({{.name = "A view of nothing", .camera = {}}});
  QTest::newRow("a view of nothing") << hidden << 0;
  model::Scene names;
  const auto group = add(names, "器官 / \"органы\"", model::rootId);
  add(names, "Ä\u0301\n\t\\ 🫀", group, test::sphere(1.0f, 0));
  add(names, std::string("no UTF-8: \xff\xc3"), group, test::sphere(2.0f, 0));
  add(names, "", group, test::sphere(3.0f, 0));
  QTest::newRow("names") << names << 60;
  model::Scene triangle;
  add(triangle, "triangle", model::rootId,
      meshOf({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}}, {{0, 1, 2}}));
  QTest::newRow("one triangle") << triangle << 1;
  model::Scene odd;
  add(odd, "a vertex of none, one without area", model::rootId,
      meshOf({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {5, 5, 5}, {6, 6, 6}}, {{0, 1, 2}, {3, 3, 3}}));
  add(odd, "no triangles", model::rootId, meshOf({{0, 0, 0}}, {}));
  QTest::newRow("odd meshes") << odd << 2;
  const model::Scene pelvis = model::pelvisDemo(model::Sex::female);
  int triangles = 0;
  for (const model::Node& node : pelvis.nodes())
    triangles += node.mesh ? int(node.mesh->triangleCount()) : 0;
  QVERIFY(triangles > 100'000);
  QTest::newRow("pelvis") << pelvis << triangles;
}

void GltfValidatorTest::validates() {
  if (!m_why.isEmpty())
    QSKIP(qPrintable(m_why));
  QFETCH(model::Scene, scene);
  const QJsonObject verdict = judged(bytesOf(scene));
  const QByteArray messages = QJsonDocument(verdict["messages"].toArray()).toJson();
  QVERIFY2(verdict["errors"].toInt(-1) == 0 && verdict["warnings"].toInt(-1) == 0,
           messages.constData());
  QTEST(verdict["triangles"].toInt(), "triangles");
}

void GltfValidatorTest::validatesTheAbdomen() {
  if (!m_why.isEmpty())
    QSKIP(qPrintable(m_why));
  const std::filesystem::path data = std::filesystem::path(SLINE_TEST_DATA) / "abdomen";
  if (!std::filesystem::exists(data))
    SLINE_ABSENT("no data of the abdomen");
  model::ImportOptions options;
  options.smoothing = {.mode = model::Smoothing::Mode::off};
  const std::array inputs{data};
  const auto imported = model::importInputs(inputs, options);
  QVERIFY(imported.ok());
  const QJsonObject verdict = judged(bytesOf(imported->scene));
  QCOMPARE(verdict["errors"].toInt(-1), 0);
  QCOMPARE(verdict["warnings"].toInt(-1), 0);
  QVERIFY(verdict["triangles"].toInt() > 1'000'000);
}

/// Without this the validator's silence would mean nothing.
void GltfValidatorTest::validatorFindsFaults() {
  if (!m_why.isEmpty())
    QSKIP(qPrintable(m_why));
  std::string bytes = bytesOf(sample().scene);
  const std::size_t at = bytes.find("\"NORMAL\"");
  QVERIFY(at != std::string::npos);
  bytes.replace(at, 8, "\"NORMAA\"");
  QVERIFY(judged(bytes)["errors"].toInt() > 0);
}

SLINE_TEST_WITH_EVENTS(GltfValidatorTest)
#include "gltf_validator_test.moc"
