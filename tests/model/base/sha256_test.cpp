// SPDX-License-Identifier: Apache-2.0
// Tests SHA-256 against Qt's.
#include "model/base/sha256.h"

#include <QCryptographicHash>
#include <QtTest>

#include "tests/support/suite.h"

using namespace sline;

class Sha256Test : public QObject {
  Q_OBJECT
 private slots:
  void asOthersComputeIt() {
    for (int length = 0; length < 300; ++length) {
      QByteArray bytes;
      for (int i = 0; i < length; ++i)
        bytes += char(i * 37 + length);
      QCOMPARE(QByteArray::fromStdString(hexDigits(sha256(bytes.toStdString()))),
               QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
    }
  }
  void beginnings() {
    QCOMPARE(hexDigits(sha256("abc"), 4), std::string("ba7816bf"));
    QCOMPARE(hexDigits(sha256(""), 99).size(), std::size_t(64));
  }
};

SLINE_TEST(Sha256Test)
#include "sha256_test.moc"
