// SPDX-License-Identifier: Apache-2.0
// Tests that sub-commands write no scene that could not be opened: a text or number at its limit
// is kept, one beyond it is refused, and the file is as it was.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "model/scene/scene_limits.h"
#include "model/scene_file/scene_file.h"
#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {
namespace {

QByteArray bytesOf(const QString& name) {
  QFile file(name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class LimitsCommandTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void texts_data();
  void texts();
  void namesOfFiles();
  void aFaultyFileStaysAsItIs();

 private:
  QString at(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
  QTemporaryDir m_folder;
};

void LimitsCommandTest::initTestCase() {
  const Finished made =
      runSline({"import", writeSample(at("meshes")), "-o", at("sample.sline"), "--smooth", "off"});
  QVERIFY2(made.code == 0, made.err.constData());
  const Finished view = runSline({"view", at("sample.sline"), "--add", "Front"});
  QVERIFY2(view.code == 0, view.err.constData());
}

void LimitsCommandTest::texts_data() {
  QTest::addColumn<QStringList>("command");  // its last argument gets the text added
  QTest::addColumn<int>("most");
  const auto row = [](const char* name, const QStringList& command, std::size_t most) {
    QTest::newRow(name) << command << int(most);
  };
  row("name of a view", {"view", "--add", ""}, model::longestSceneName);
  row("new name of a view", {"view", "--rename", "Front="}, model::longestSceneName);
  for (const char* flag : {"--title", "--text", "--notes", "--alt"}) {
    row(flag, {"view", "--tell", "Front", flag, ""}, model::longestSceneText);
    row((std::string(flag) + " in German").c_str(), {"view", "--tell", "Front", flag, "de="},
        model::longestSceneText);
  }
  row("label", {"annotate", "--on", "kidney", "--label", ""}, model::longestSceneText);
  row("label in Latin", {"annotate", "--on", "kidney", "--label", "x", "--text", "la="},
      model::longestSceneText);
  for (const char* flag : {"--authors", "--source", "--licence"})
    row(flag, {"credit", flag, ""}, model::longestCredit);
}

void LimitsCommandTest::texts() {
  QFETCH(QStringList, command);
  QFETCH(int, most);
  const QString file = at("edited.sline");
  const QString ending = command.takeLast();
  const QStringList start = QStringList{command.takeFirst(), file} + command;
  const auto fresh = [&] {
    QFile::remove(file);
    QVERIFY(QFile::copy(at("sample.sline"), file));
  };
  fresh();
  const QString longest = QString(most / 2, QChar(0xe4));  // of two bytes
  const Finished kept = runSline(start + QStringList{ending + longest});
  QVERIFY2(kept.code == 0, kept.err.constData());
  const auto opened = model::readSceneFile(file.toStdString());
  QVERIFY(opened.ok() && opened->leftOut.empty());

  fresh();
  const QByteArray before = bytesOf(file);
  const Finished tooLong = runSline(start + QStringList{ending + longest + "n"});
  QVERIFY(tooLong.code != 0);
  QVERIFY2(tooLong.err.contains("longer than " + QByteArray::number(most) + " bytes"),
           tooLong.err.constData());
  QCOMPARE(bytesOf(file), before);
  // Bytes that are no text come from other systems' file names.
  const Finished noText = runSlineLed("\"" + ending + "$(printf 'a\\377\\376')\"", start);
  if (noText.code != 0) {
    QVERIFY2(noText.err.contains("UTF-8"), noText.err.constData());
    QCOMPARE(bytesOf(file), before);
  } else {
    const auto cleaned = model::readSceneFile(file.toStdString());
    QVERIFY(cleaned.ok() && cleaned->leftOut.empty());
  }
}

void LimitsCommandTest::namesOfFiles() {
  // Names of groups in a file may be of any length, and of bytes that are no text.
  QByteArray obj("v 0 0 0\nv 50 0 0\nv 0 50 0\nv 50 50 9\n# CC BY\n");
  obj += "g " + QByteArray(5000, 'n') + "\nf 1 2 3\ng b\xff\xfe\nf 2 3 4\n";
  writeFile(at("names.obj"), obj);
  const Finished made =
      runSline({"import", at("names.obj"), "-o", at("names.sline"), "--keep-file-names"});
  QVERIFY2(made.code == 0, made.err.constData());
  QVERIFY2(made.err.contains("longer than 1000 bytes; it was cut there"), made.err.constData());
  QVERIFY2(made.err.contains("no letters in UTF-8"), made.err.constData());
  const Finished info = runSline({"info", at("names.sline"), "--json"});
  QVERIFY2(info.code == 0, info.err.constData());
}

/// Sub-commands work with what can be read, say what cannot, and write elsewhere alone.
void LimitsCommandTest::aFaultyFileStaysAsItIs() {
  const QString file = at("faulty.sline");
  const auto document = model::readSceneFile(at("sample.sline").toStdString());
  QVERIFY(document.ok());
  const std::string bytes = bytesOf(at("sample.sline")).toStdString();
  const auto zip = model::ZipReader::open(bytes);
  QVERIFY(zip.ok());
  std::vector<model::ZipMember> members;
  for (const auto& entry : zip->entries())
    members.push_back({entry.name, *zip->read(entry)});
  std::vector<const model::ZipMember*> all;
  for (model::ZipMember& member : members) {
    if (member.name == "scene.json") {
      const std::size_t at = member.bytes.find("\"frame_reason\": \"");
      QVERIFY(at != std::string::npos);
      member.bytes.insert(member.bytes.find(':', at) + 1, " 7, \"was\":");
    }
    all.push_back(&member);
  }
  writeFile(file, QByteArray::fromStdString(*model::zipped(all)));
  const QByteArray before = bytesOf(file);
  const Finished listed = runSline({"view", file, "--list"});
  QCOMPARE(listed.code, 0);
  QVERIFY2(listed.err.contains("frame_reason") && listed.err.contains("a text is expected here"),
           listed.err.constData());
  const Finished inPlace = runSline({"view", file, "--add", "Side"});
  QVERIFY(inPlace.code != 0);
  QVERIFY2(inPlace.err.contains("Save under another name"), inPlace.err.constData());
  const Finished imported = runSline({"import", file, "-o", file});
  QVERIFY(imported.code != 0);
  QCOMPARE(bytesOf(file), before);
  const Finished elsewhere = runSline({"view", file, "--add", "Side", "-o", at("other.sline")});
  QVERIFY2(elsewhere.code == 0, elsewhere.err.constData());
  const auto other = model::readSceneFile(at("other.sline").toStdString());
  QVERIFY(other.ok() && !other->isForReading());
  QCOMPARE(other->scene.views().size(), document->scene.views().size() + 1);
}

SLINE_TEST_WITH_EVENTS(LimitsCommandTest)

}  // namespace sline::test

#include "limits_command_test.moc"
