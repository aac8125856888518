// SPDX-License-Identifier: Apache-2.0
// Tests `sline view`.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "model/edit/look.h"
#include "model/edit/views.h"
#include "model/look/opening_look.h"
#include "model/scene_file/scene_file.h"
#include "tests/cli/sline_process.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/suite.h"

namespace sline::test {
namespace {

QByteArray contentOf(const QString& name) {
  QFile file(name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class ViewCommandTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void addedAndListed();
  void whatTheFlagsSay();
  void theSceneStaysAsItLooks();
  void labels();
  void labelsOfViewsWithoutAList();
  void updated();
  void sceneKeepsItsLook();
  void words();
  void renamed_data();
  void renamed();
  void movedAndRemoved();
  void anotherFileIsWritten();
  void wrongUse_data();
  void wrongUse();
  void absentOnesAreTold();
  void newerFilesAreTold();
  void picturesOfViews();

 private:
  Finished view(const QStringList& more) const {
    return runSline(QStringList{"view", m_scene} + more);
  }
  QJsonArray listed() const {
    return QJsonDocument::fromJson(view({"--list", "--json"}).out).object()["views"].toArray();
  }
  QString names() const {
    QStringList all;
    for (const QJsonValue& each : listed())
      all << each["name"].toString();
    return all.join('|');
  }
  model::Scene scene() const { return model::readSceneFile(m_scene.toStdString())->scene; }
  void write(const model::Scene& scene) const {
    auto document = model::readSceneFile(m_scene.toStdString());
    document->scene = scene;
    QVERIFY(model::writeSceneFile(m_scene.toStdString(), *document).ok());
  }
  QString at(const QString& name) const { return m_folder->filePath(name); }

  std::unique_ptr<QTemporaryDir> m_folder;
  QString m_scene;
};

void ViewCommandTest::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  m_scene = at("sample.sline");
  const Finished made =
      runSline({"import", writeSample(at("meshes")), "-o", m_scene, "--smooth", "off"});
  QVERIFY2(made.code == 0, made.err.constData());
}

void ViewCommandTest::addedAndListed() {
  QCOMPARE(view({"--list"}).out, QByteArray("the scene has no saved views\n"));
  const Finished front = view({"--add", "Front"});
  QVERIFY2(front.code == 0, front.err.constData());
  QCOMPARE(view({"--add", "  \xC3\x84hnlich <b>", "--from", "left"}).code, 0);
  QCOMPARE(names(), QString("Front|\u00C4hnlich <b>"));
  QCOMPARE(view({"--list"}).out, QByteArray("1  Front\n2  \xC3\x84hnlich <b>\n"));
  const QJsonObject second = listed()[1].toObject();
  QVERIFY(second["camera"]["eye_mm"][0].toDouble() > 50.0);  // from the patient's left
  QCOMPARE(second["looks"].toInt(), int(scene().nodes().size()));
  QCOMPARE(second["absent"].toInt(), 0);
}

void ViewCommandTest::whatTheFlagsSay() {
  const Finished made =
      view({"--add", "V", "--from", "superior", "--gamma", "1", "--gamma", "kidney=4.5", "--only",
            "kidney", "--color", "kidney=#102030", "--section", "axial=3"});
  QVERIFY2(made.code == 0, made.err.constData());
  const model::Scene now = scene();
  const model::View& saved = now.views().front();
  QVERIFY(saved.camera.eye.z > 50.0f);
  QCOMPARE(saved.sections->size(), std::size_t(1));
  const model::Scene seen = model::withViewApplied(now, saved).scene;
  const model::ResolvedStyle kidney = seen.resolve(now.named("kidney").front());
  QCOMPARE(kidney.gamma.value(), 4.5f);
  QCOMPARE(kidney.colour, (Colour{16, 32, 48}));
  QVERIFY(kidney.visible);
  const model::ResolvedStyle vein = seen.resolve(now.named("renal vein").front());
  QCOMPARE(vein.gamma.value(), 1.0f);
  QVERIFY(!vein.visible);
}

void ViewCommandTest::theSceneStaysAsItLooks() {
  const model::Scene before = model::dressed(scene());
  QCOMPARE(view({"--add", "V", "--gamma", "5", "--only", "kidney", "--section", "axial"}).code, 0);
  const model::Scene after = scene();
  QCOMPARE(after.views().size(), std::size_t(1));
  QVERIFY(after.sections().empty());
  QCOMPARE(after.nodes().size(), before.nodes().size());
  for (const model::Node& node : before.nodes())
    QVERIFY(after.find(node.id)->style == node.style);
}

void ViewCommandTest::labels() {
  model::Scene with = scene();
  for (const float x : {1.0f, 2.0f, 3.0f})
    with.appendAnnotation({.kind = model::AnnotationKind::pin,
                           .anchors = {model::Anchor(glm::vec3(x, 0, 0))},
                           .text = "pin",
                           .visible = x < 2.5f});
  write(with);
  using Ids = QList<quint64>;
  const std::pair<QStringList, Ids> rows[] = {{{}, {1, 2}},
                                              {{"--labels", "all"}, {1, 2, 3}},
                                              {{"--labels", "none"}, {}},
                                              {{"--labels", "3,1"}, {3, 1}}};
  for (const auto& [flags, ids] : rows) {
    QCOMPARE(view(QStringList{"--add", "V"} + flags).code, 0);
    Ids saved;
    const model::Scene now = scene();
    for (const model::AnnotationId id : *now.views().back().annotations)
      saved << id.value;
    QCOMPARE(saved, ids);
    QCOMPARE(view({"--remove", "V"}).code, 0);
  }
  const Finished wrong = view({"--add", "V", "--labels", "1,9"});
  QCOMPARE(wrong.code, 2);
  QVERIFY2(wrong.err.contains("\"9\""), wrong.err.constData());
}

/// Scenes of other programs bring views that do not choose among the labels.
void ViewCommandTest::labelsOfViewsWithoutAList() {
  model::Scene with = scene();
  for (const float x : {1.0f, 2.0f})
    with.appendAnnotation({.kind = model::AnnotationKind::pin,
                           .anchors = {model::Anchor(glm::vec3(x, 0, 0))},
                           .text = "pin"});
  with.setViews({{.name = "Read"}});
  write(with);
  const Finished added = view({"--add", "Front"});
  QVERIFY2(added.code == 0 && !added.err.contains("no labels"), added.err.constData());
  QCOMPARE(scene().views().back().annotations->size(), std::size_t(2));
  const Finished next = view({"--add", "Back", "--from", "posterior"});
  QVERIFY2(next.code == 0 && next.err.contains("no labels"), next.err.constData());
  QVERIFY(scene().views().back().annotations->empty());
}

void ViewCommandTest::updated() {
  QCOMPARE(view({"--add", "A"}).code, 0);
  QCOMPARE(view({"--add", "B"}).code, 0);
  QCOMPARE(view({"--update", "a", "--from", "right", "--gamma", "0"}).code, 0);
  QCOMPARE(names(), QString("A|B"));
  QVERIFY(scene().views().front().camera.eye.x < -50.0f);
  QCOMPARE(view({"--update", "none"}).code, 2);
  // What is not said stays: camera, focus, sections and labels.
  QCOMPARE(view({"--update", "a", "--section", "axial", "--gamma", "kidney=4"}).code, 0);
  const model::View before = scene().views().front();
  QVERIFY(before.camera.eye.x < -50.0f && before.sections && before.sections->size() == 1);
  QCOMPARE(view({"--update", "a", "--labels", "none"}).code, 0);
  model::View after = scene().views().front();
  QVERIFY(after.annotations && after.annotations->empty());
  QVERIFY(after.camera == before.camera && after.sections == before.sections &&
          after.looks == before.looks && after.focus == before.focus);
  QCOMPARE(view({"--update", "a", "--from", "superior"}).code, 0);
  after = scene().views().front();
  QVERIFY(!(after.camera == before.camera) && after.sections == before.sections);
}

/// A scene that nobody has styled looks the same after a view was added, and so does the view.
void ViewCommandTest::sceneKeepsItsLook() {
  const model::Scene plain = scene();
  QVERIFY(model::hasNoLook(plain));
  QCOMPARE(view({"--add", "V", "--from", "left"}).code, 0);
  const model::Scene with = scene();
  const model::Scene dressed = model::dressed(plain);
  for (const model::Node& node : with.nodes()) {
    const model::ResolvedStyle now = with.resolve(node.id);
    const model::ResolvedStyle then = dressed.resolve(node.id);
    QVERIFY(std::abs(now.gamma.value() - then.gamma.value()) < 1e-3f);
    QVERIFY(now.fill == then.fill && now.colour == then.colour && now.visible == then.visible);
  }
  QVERIFY(
      model::withViewApplied(with, with.views().front()).scene.resolve(with.nodes().back().id) ==
      with.resolve(with.nodes().back().id));
}

/// Words come with a view or later, language by language; what is said again stands, what is said
/// without words goes, and updating the view leaves all of them.
void ViewCommandTest::words() {
  QCOMPARE(view({"--add", "Front", "--title", "The pelvis", "--text", "Seen *from the front*",
                 "--text", "de=Von *vorn*", "--notes", "a=b is no language", "--seconds", "7.5"})
               .code,
           0);
  QCOMPARE(view({"--tell", "Front", "--title", "la=Pelvis", "--text", "de=Von **vorn**"}).code, 0);
  QCOMPARE(view({"--update", "Front", "--from", "left"}).code, 0);
  model::ViewWords words = scene().views().front().words;
  QCOMPARE(words.title.in("en"), std::string("The pelvis"));
  QCOMPARE(words.title.in("la"), std::string("Pelvis"));
  QCOMPARE(words.text.in("de"), std::string("Von **vorn**"));
  QCOMPARE(words.text.in("nl"), std::string("Seen *from the front*"));
  QCOMPARE(words.notes.text, std::string("a=b is no language"));
  QCOMPARE(words.seconds, std::optional(7.5f));
  const QJsonObject told = listed().first().toObject();
  QCOMPARE(told["title"][""].toString(), QString("The pelvis"));
  QCOMPARE(told["text"]["de"].toString(), QString("Von **vorn**"));
  QCOMPARE(told["seconds"].toDouble(), 7.5);
  QCOMPARE(view({"--tell", "Front", "--title", "", "--title", "la=", "--seconds", "0"}).code, 0);
  words = scene().views().front().words;
  QVERIFY(words.title.empty() && !words.seconds && !words.text.empty());
  QCOMPARE(model::titleIn(scene().views().front(), "la"), std::string("Front"));
}

void ViewCommandTest::renamed_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<int>("code");
  QTest::addColumn<QString>("after");
  QTest::newRow("plain") << "one=uno" << 0 << "uno|two=2";
  QTest::newRow("case alone") << "one=ONE" << 0 << "ONE|two=2";
  QTest::newRow("with a sign in it") << "two=2=three" << 0 << "one|three";
  QTest::newRow("with a sign in the new one") << "one=1=1" << 0 << "1=1|two=2";
  QTest::newRow("taken") << "one=TWO=2" << 2 << "one|two=2";
  QTest::newRow("nothing") << "one=" << 2 << "one|two=2";
  QTest::newRow("no sign") << "one" << 2 << "one|two=2";
  QTest::newRow("unknown") << "oone=x" << 2 << "one|two=2";
}

void ViewCommandTest::renamed() {
  QFETCH(QString, text);
  QFETCH(int, code);
  QFETCH(QString, after);
  QCOMPARE(view({"--add", "one"}).code, 0);
  QCOMPARE(view({"--add", "two=2"}).code, 0);
  const Finished finished = view({"--rename", text});
  QVERIFY2(finished.code == code, finished.err.constData());
  QCOMPARE(names(), after);
}

void ViewCommandTest::movedAndRemoved() {
  for (const char* name : {"a", "b", "c"})
    QCOMPARE(view({"--add", name}).code, 0);
  QCOMPARE(view({"--move", "c=1"}).code, 0);
  QCOMPARE(names(), QString("c|a|b"));
  QCOMPARE(view({"--move", "c=3"}).code, 0);
  QCOMPARE(names(), QString("a|b|c"));
  QCOMPARE(view({"--move", "c=4"}).code, 2);
  QCOMPARE(view({"--move", "c=0"}).code, 2);
  QCOMPARE(view({"--move", "c"}).code, 2);
  QCOMPARE(view({"--remove", "B"}).code, 0);
  QCOMPARE(names(), QString("a|c"));
}

void ViewCommandTest::anotherFileIsWritten() {
  const QByteArray before = contentOf(m_scene);
  QCOMPARE(view({"--add", "V", "-o", at("other.sline")}).code, 0);
  QCOMPARE(contentOf(m_scene), before);
  m_scene = at("other.sline");
  QCOMPARE(names(), QString("V"));
}

void ViewCommandTest::wrongUse_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<int>("code");
  QTest::newRow("nothing to do") << QStringList{} << 2;
  QTest::newRow("two things") << QStringList{"--add", "x", "--remove", "V"} << 2;
  QTest::newRow("no name") << QStringList{"--add", "  "} << 2;
  QTest::newRow("taken") << QStringList{"--add", "v"} << 2;
  QTest::newRow("unknown side") << QStringList{"--add", "x", "--from", "front"} << 2;
  QTest::newRow("unknown structure") << QStringList{"--add", "x", "--gamma", "kidny=2"} << 2;
  QTest::newRow("both cameras") << QStringList{"--add", "x", "--from", "left", "--camera", "c.json"}
                                << 2;
  QTest::newRow("no such camera") << QStringList{"--add", "x", "--camera", "none.json"} << 2;
  QTest::newRow("json of nothing") << QStringList{"--remove", "V", "--json"} << 2;
  QTest::newRow("words in vain") << QStringList{"--remove", "V", "--title", "x"} << 2;
  QTest::newRow("words twice") << QStringList{"--tell", "V", "--text", "de=a", "--text", "de=b"}
                               << 2;
  QTest::newRow("no time") << QStringList{"--tell", "V", "--seconds", "-1"} << 2;
  QTest::newRow("tells nobody") << QStringList{"--tell", "none", "--title", "x"} << 2;
  QTest::newRow("list into a file") << QStringList{"--list", "-o", "x.sline"} << 2;
  QTest::newRow("into a mesh") << QStringList{"--remove", "V", "-o", "x.ply"} << 2;
  QTest::newRow("no folder") << QStringList{"--remove", "V", "-o", "/nowhere/x.sline"} << 1;
}

void ViewCommandTest::wrongUse() {
  QFETCH(QStringList, arguments);
  QFETCH(int, code);
  QCOMPARE(view({"--add", "V"}).code, 0);
  const QByteArray before = contentOf(m_scene);
  const Finished finished = view(arguments);
  QVERIFY2(finished.code == code, finished.err.constData());
  QVERIFY(!finished.err.isEmpty());
  QCOMPARE(contentOf(m_scene), before);
}

void ViewCommandTest::absentOnesAreTold() {
  QCOMPARE(view({"--add", "V"}).code, 0);
  model::Scene with = scene();
  std::vector<model::View> views = with.views();
  views.front().looks->push_back({.node = {991}});
  views.front().looks->push_back({.node = {992}});
  with.setViews(views);
  write(with);
  QCOMPARE(view({"--list"}).out,
           QByteArray("1  V  (2 of what it shows are no longer in the scene)\n"));
  QCOMPARE(listed().at(0).toObject()["absent"].toInt(), 2);
  const QStringList drawn{"render", m_scene, "-o", at("x.png"), "--size", "64x64", "--view", "V"};
  QVERIFY(runSline(drawn).err.contains("shows, 2 structures or groups are no longer"));
  views.front().looks->pop_back();
  with.setViews(views);
  write(with);
  QVERIFY(runSline(drawn).err.contains("shows, 1 structure or group is no longer"));
}

void ViewCommandTest::newerFilesAreTold() {
  QFile file(m_scene);
  QVERIFY(file.open(QIODevice::ReadOnly));
  const std::string bytes = file.readAll().toStdString();
  QJsonObject root =
      QJsonDocument::fromJson(QByteArray::fromStdString(memberOf(bytes, "scene.json"))).object();
  QVERIFY(root["schema"].toInt() > 0);
  root["schema"] = 1000;
  writeFile(m_scene, QByteArray::fromStdString(withMember(
                         bytes, "scene.json", QJsonDocument(root).toJson().toStdString())));
  for (const char* command : {"view", "annotate"}) {
    const Finished told = runSline({command, m_scene, "--list"});
    QCOMPARE(told.code, 0);
    QVERIFY2(told.err.contains("newer version"), told.err.constData());
  }
}

void ViewCommandTest::picturesOfViews() {
  QCOMPARE(view({"--add", "Green", "--gamma", "5", "--color", "kidney=#00ff00"}).code, 0);
  const auto green = [this](const QString& name) {
    const Finished drawn =
        runSline({"render", m_scene, "-o", at("x.png"), "--size", "160x120", "--view", name});
    return drawn.code == 0 ? tinted(readPicture(at("x.png")), 1).count : -1;
  };
  QVERIFY(green("green") > 500);
  QCOMPARE(green("anterior"), 0);
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ViewCommandTest)
#include "view_command_test.moc"
