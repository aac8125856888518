// SPDX-License-Identifier: Apache-2.0
#include "model/base/number_codes.h"

#include <QtTest>

#include "tests/support/suite.h"

using namespace sline;

class NumberCodesTest : public QObject {
  Q_OBJECT

 private slots:
  void smallDifferencesAreSmall() {
    QCOMPARE(zigzag(0u), 0u);
    QCOMPARE(zigzag(std::uint32_t(-1)), 1u);
    QCOMPARE(zigzag(1u), 2u);
    QCOMPARE(zigzag(std::uint32_t(-2)), 3u);
    QCOMPARE(zigzag(0x80000000u), 0xffffffffu);
    QCOMPARE(zigzag(std::uint16_t(-1)), std::uint16_t(1));
    QCOMPARE(zigzag(std::uint16_t(0x8000u)), std::uint16_t(0xffffu));
  }

  void theyComeBack() {
    for (unsigned number = 0; number <= 0xffffu; ++number) {
      QCOMPARE(unzigzag(zigzag(std::uint16_t(number))), std::uint16_t(number));
      const std::uint32_t wide = number * 65'537u;
      QCOMPARE(unzigzag(zigzag(wide)), wide);
    }
  }

  void wordsAreLowestFirst() {
    std::string bytes(6, 'x');
    putWord(bytes.data() + 1, 0xfe030201u);
    QCOMPARE(bytes, std::string("x\x01\x02\x03\xfex"));
    QCOMPARE(wordAt(bytes, 1), 0xfe030201u);
  }
};

SLINE_TEST(NumberCodesTest)
#include "number_codes_test.moc"
