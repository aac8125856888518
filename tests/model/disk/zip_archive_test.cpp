// SPDX-License-Identifier: Apache-2.0
#include "model/disk/zip_archive.h"

#include <QtTest>

#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {
std::string archive(const std::vector<ZipMember>& members) {
  std::vector<const ZipMember*> all;
  for (const ZipMember& member : members)
    all.push_back(&member);
  auto bytes = zipped(all);
  return bytes.ok() ? std::move(*bytes) : std::string();
}

const std::vector<ZipMember> two{{"scene.json", "{}"}, {"meshes/1.mesh", std::string(5000, 'm')}};

/// Returns the bytes with every `from` replaced by `to`, which has the same length.
std::string replaced(std::string bytes, const std::string& from, const std::string& to) {
  for (std::size_t at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + 1))
    bytes.replace(at, from.size(), to);
  return bytes;
}

/// Sets two bytes at an offset into the first central header (APPNOTE 4.3.12).
std::string withCentral(std::string bytes, std::size_t offset, unsigned value) {
  const std::size_t header = bytes.find("PK\1\2");
  bytes[header + offset] = char(value & 0xffu);
  bytes[header + offset + 1] = char(value >> 8);
  return bytes;
}
}  // namespace

class ZipArchiveTest : public QObject {
  Q_OBJECT
 private slots:
  void roundTrip();
  void sameMembersGiveSameBytes();
  void whatWouldExceedTheRatioIsStored();
  void refuses_data();
  void refuses();
  void limits();
  void names_data();
  void names();
  void damageIsFound();
};

void ZipArchiveTest::roundTrip() {
  std::vector<ZipMember> members = two;
  members.push_back({"empty", ""});
  members.push_back({"Leber/größe", "ü"});
  const std::string bytes = archive(members);
  const auto zip = ZipReader::open(bytes);
  QVERIFY(zip.ok());
  QCOMPARE(zip->entries().size(), members.size());
  for (const ZipMember& member : members) {
    const ZipReader::Entry* entry = zip->find(member.name);
    QVERIFY(entry);
    const auto unpacked = zip->read(*entry);
    QVERIFY(unpacked.ok());
    QCOMPARE(*unpacked, member.bytes);
  }
  QVERIFY(!zip->find("nothing"));
}

void ZipArchiveTest::sameMembersGiveSameBytes() {
  const std::string bytes = archive(two);
  QTest::qSleep(2100);  // the time in a ZIP file counts in steps of two seconds
  QCOMPARE(archive(two), bytes);
}

void ZipArchiveTest::whatWouldExceedTheRatioIsStored() {
  const std::vector<ZipMember> flat{{"flat", std::string(10 << 20, '\0')}};
  const std::string bytes = archive(flat);
  QVERIFY(bytes.size() > flat[0].bytes.size());
  QVERIFY(ZipReader::open(bytes).ok());
}

void ZipArchiveTest::refuses_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("reason");
  const auto row = [](const char* name, const std::string& bytes, const char* reason) {
    QTest::newRow(name) << QByteArray::fromStdString(bytes) << QString(reason);
  };
  const std::string good = archive(two);
  const std::string long13 = "meshes/1.mesh";
  row("nothing", "", "it is empty");
  row("a text", std::string(1000, 'a'), "no whole ZIP file");
  row("its first half", good.substr(0, good.size() / 2), "no whole ZIP file");
  row("..", replaced(good, long13, "meshes/../1.m"), "\"..\"");
  row(".. first", replaced(good, long13, "../meshes/1.m"), "\"..\"");
  row(".. last", replaced(good, long13, "meshes/1.m/.."), "\"..\"");
  row("absolute", replaced(good, long13, "/meshes/1.mes"), "absolute");
  row("a drive", replaced(good, long13, "C:meshes/1.me"), "character");
  row("backslashes", replaced(good, long13, "meshes\\1.mesh"), "character");
  row("twice", replaced(archive({{"a", "1"}, {"b", "2"}}), "b", "a"), "two members");
  row("another method", withCentral(good, 10, 12), "method other than deflate");
  row("encrypted", withCentral(good, 8, 1), "encrypted");
  row("a link", withCentral(withCentral(good, 4, 3 << 8 | 20), 40, 0120777), "link");
}

void ZipArchiveTest::refuses() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, reason);
  const std::string kept = bytes.toStdString();
  const auto zip = ZipReader::open(kept);
  QVERIFY(!zip.ok());
  QVERIFY2(QString::fromStdString(zip.error().reason).contains(reason), zip.error().reason.c_str());
}

void ZipArchiveTest::limits() {
  const std::string bytes = archive(two);
  QVERIFY(ZipReader::open(bytes, {.members = 2}).ok());
  QVERIFY(!ZipReader::open(bytes, {.members = 1}).ok());
  QVERIFY(ZipReader::open(bytes, {.unpackedBytes = 5002}).ok());
  QVERIFY(!ZipReader::open(bytes, {.unpackedBytes = 5001}).ok());
  QVERIFY(!ZipReader::open(bytes, {.nameBytes = 12}).ok());
  const std::string grows = archive({{"a", std::string(10 << 20, 'a') + std::string(200'000, 'b')},
                                     {"b", std::string(1 << 18, '\x3')}});
  QVERIFY(ZipReader::open(grows, {.ratio = 1}).ok());  // stored, so it does not grow at all
  std::string half;
  for (int i = 0; i < 600'000; ++i)
    half += char('a' + (i * 7 + i / 13) % 23);
  const std::string packed = archive({{"a", half + half + half + half}});
  QVERIFY(packed.size() < 1'300'000);
  QVERIFY(!ZipReader::open(packed, {.ratio = 0}).ok());
  QVERIFY(ZipReader::open(packed).ok());
}

void ZipArchiveTest::names_data() {
  QTest::addColumn<QByteArray>("name");
  QTest::addColumn<bool>("good");
  QTest::newRow("plain") << QByteArray("meshes/1.mesh") << true;
  QTest::newRow("dots") << QByteArray("a..b/...") << true;
  QTest::newRow("empty") << QByteArray("") << false;
  QTest::newRow("up") << QByteArray("..") << false;
  QTest::newRow("line break") << QByteArray("a\nb") << false;
  QTest::newRow("long") << QByteArray(2000, 'a') << false;
}

void ZipArchiveTest::names() {
  QFETCH(QByteArray, name);
  QFETCH(bool, good);
  QCOMPARE(zipNameFault(name.toStdString()).empty(), good);
}

void ZipArchiveTest::damageIsFound() {
  std::string text;
  for (int i = 0; i < 3000; ++i)
    text += std::to_string(i * i);
  const std::string bytes = archive({{"a", text}});
  const std::size_t start = bytes.find('a') + 1;
  const std::size_t end = bytes.find("PK\1\2");
  for (std::size_t at = start; at < end; at += 37) {
    std::string changed = bytes;
    changed[at] = char(changed[at] ^ 4);
    const auto zip = ZipReader::open(changed);
    QVERIFY(!zip.ok() || !zip->read(zip->entries()[0]).ok());
  }
}

SLINE_TEST(ZipArchiveTest)
#include "zip_archive_test.moc"
