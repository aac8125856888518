// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/readers/refusals.h"

#include <QTest>
#include <algorithm>

namespace sline::test {

QByteArray edited(const char* kind, const QByteArray& from, const QByteArray& to) {
  QByteArray bytes = cubeFile(kind);
  const qsizetype at = bytes.indexOf(from);
  if (at < 0)
    qFatal("%s does not contain %s", kind, from.constData());
  return bytes.replace(at, from.size(), to);
}

QByteArray cut(const char* kind, double part) {
  const QByteArray bytes = cubeFile(kind);
  return bytes.left(qsizetype(part * double(bytes.size())));
}

QByteArray patched(const char* kind, qsizetype at, const QByteArray& with) {
  QByteArray bytes = cubeFile(kind);
  return bytes.replace(at < 0 ? bytes.size() + at : at, with.size(), with);
}

void addRefusalColumns() {
  QTest::addColumn<QString>("extension");
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("fragment");
}

void addRefusal(const QString& what, const char* extension, const QByteArray& bytes,
                const char* fragment) {
  if (*fragment == '\0')
    qFatal("a row without a message to look for: %s", qPrintable(what));
  QTest::newRow(qPrintable(what)) << QString(extension) << bytes << QString(fragment);
}

void checkRefusal() {
  QFETCH(QString, extension);
  QFETCH(QByteArray, bytes);
  QFETCH(QString, fragment);
  QTemporaryDir folder;
  const Result<model::RawMeshes> read = readBytes(folder, "broken" + extension, bytes);
  QVERIFY2(!read, "was read without an error");
  const Error& error = read.error();
  const QString message =
      QString::fromStdString(error.where + ": " + error.reason + ". " + error.remedy);
  const QStringList fragments = fragment.split('|');
  QVERIFY2(std::any_of(fragments.begin(), fragments.end(),
                       [&](const QString& one) { return message.contains(one); }),
           qPrintable(message));
  QVERIFY(error.file.ends_with(("broken" + extension).toStdString()));
  QVERIFY(!error.reason.empty());
  QVERIFY(!error.remedy.empty());
}

}  // namespace sline::test
