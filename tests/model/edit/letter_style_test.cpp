// SPDX-License-Identifier: Apache-2.0
#include "model/edit/letter_style.h"

#include <QtTest>

#include "tests/support/mutator.h"
#include "tests/support/suite.h"

using namespace sline::model;

namespace {

/// Holds a text and its selection, which brackets mark without being part of the text.
struct Chosen {
  std::string text;
  TextRange range;
};
Chosen chosen(const QString& marked) {
  std::string text = marked.toStdString();
  const std::size_t begin = text.find('[');
  text.erase(begin, 1);
  const std::size_t end = text.find(']');
  text.erase(end, 1);
  return {text, {begin, end}};
}
QString bracketed(const MarkedText& made) {
  std::string text = made.text;
  text.insert(made.selection.end, "]");
  text.insert(made.selection.begin, "[");
  return QString::fromStdString(text);
}

}  // namespace

class LetterStyleTest : public QObject {
  Q_OBJECT
 private slots:
  void marks_data() {
    QTest::addColumn<bool>("bold");
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("after");
    const auto row = [](bool bold, const char* before, const char* after) {
      QTest::newRow(QByteArray(before).replace('\n', '|'))
          << bold << QString::fromUtf8(before) << QString::fromUtf8(after);
    };
    row(true, "the [renal] artery", "the **[renal]** artery");
    row(false, "the [renal] artery", "the *[renal]* artery");
    row(true, "the **[renal]** artery", "the [renal] artery");
    row(true, "the [**renal**] artery", "the [renal] artery");
    row(false, "the *[renal]* artery", "the [renal] artery");
    row(false, "**[renal]**", "***[renal]***");
    row(true, "***[renal]***", "*[renal]*");
    row(false, "***[renal]***", "**[renal]**");
    row(true, "**[renal] artery**", "[renal] **artery**");
    row(true, "**renal [artery]**", "**renal** [artery]");
    row(true, "**a [b] c**", "**a** [b] **c**");
    row(true, "**renal** [artery]", "**renal [artery]**");
    row(true, "[**renal** artery]", "**[renal artery]**");
    row(false, "**renal [artery]** b", "**renal *[artery]*** b");
    row(false, "**a [b** c]", "**a *[b*** *c]*");
    row(true, "in[ter]lobar", "in**[ter]**lobar");
    row(true, "**in[ter]lobar**", "**in**[ter]**lobar**");
    row(true, "[ renal ]", " **[renal]** ");
    row(true, "[Kidney\n- one\n- two]", "**[Kidney**\n- **one**\n- **two]**");
    row(true, "**[Kidney**\n- **one**]", "[Kidney\n- one]");
    row(true, "a\nb [c]  \nd", "a\nb **[c]**  \nd");
    row(true, "5 * 3 [mm]", "5 * 3 **[mm]**");
    row(true, "[p*] q*", "**[p\\*]** q\\*");
    row(true, "[\\*a\\*]", "**\\[*a\\*]**");
    row(false, "[Öl]", "*[Öl]*");
    row(true, "[ ]", "[ ]");
    row(true, "a[] b", "a**[]** b");
    row(false, "a[] b", "a*[]* b");
    row(true, "a**[]** b", "a[] b");
    row(false, "*[]*", "[]");
  }
  void marks() {
    QFETCH(bool, bold);
    QFETCH(QString, before);
    QFETCH(QString, after);
    const Chosen was = chosen(before);
    const LetterMark mark = bold ? LetterMark::bold : LetterMark::italic;
    QCOMPARE(bracketed(withLetterStyle(was.text, was.range, mark)), after);
  }

  /// Links lead where they led, whatever of their words is marked.
  void linksStay_data() {
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("selected");
    QTest::addColumn<QString>("after");
    const auto row = [](const char* before, const char* selected, const char* after) {
      QTest::addRow("%s of %s", selected, before) << before << selected << after;
    };
    row("to [a b](#view=1) c", "a b", "to [**a b**](#view=1) c");
    row("to [a b](#view=1) c", "b", "to [a **b**](#view=1) c");
    row("to [a b](#view=1) c", "to [a b](#view=1) c", "**to** [**a b**](#view=1) **c**");
    row("**to** [**a b**](#view=1) **c**", "to** [**a b**](#view=1) **c", "to [a b](#view=1) c");
    row("[a](#view=1)[b](#structure=x (y))", "b", "[a](#view=1)[**b**](#structure=x (y))");
    row("a \\[b](#view=1)", "a", "**a** \\[b](#view=1)");
  }
  void linksStay() {
    QFETCH(QString, before);
    QFETCH(QString, selected);
    QFETCH(QString, after);
    const std::string text = before.toStdString();
    const std::size_t begin = text.rfind(selected.toStdString());
    const MarkedText made =
        withLetterStyle(text, {begin, begin + std::size_t(selected.size())}, LetterMark::bold);
    QCOMPARE(QString::fromStdString(made.text), after);
  }

  /// Whatever is selected in whatever text, the words stay, and afterwards the selection is all of
  /// one style; a second time reverts it.
  void wordsStay() {
    sline::test::Mutator spoil(7,
                               {[](sline::test::Mutator& random, QByteArray& bytes, qsizetype at) {
                                 bytes.insert(at, "***\\\n- a []"[random.below(11)]);
                               }});
    const auto words = [](const std::string& text) {
      return plainText(AnnotationKind::callout, text);
    };
    int changed = 0;
    for (int i = 0; i < 20'000; ++i) {
      const QByteArray bytes = spoil("**a *b*** c\n- d\\*e *f*\n[g **h**](#view=1) *i*");
      const std::string text(bytes.constData(), std::size_t(bytes.size()));
      TextRange range{spoil.below(text.size() + 1), 0};
      range.end = range.begin + spoil.below(text.size() + 1 - range.begin);
      if (range.begin == range.end)
        continue;
      const LetterMark mark = spoil.below(2) == 0 ? LetterMark::bold : LetterMark::italic;
      const MarkedText made = withLetterStyle(text, range, mark);
      QCOMPARE(words(made.text), words(text));
      if (made.text == text)
        continue;
      ++changed;
      const MarkedText again = withLetterStyle(made.text, made.selection, mark);
      QCOMPARE(words(again.text), words(text));
      QVERIFY2(again.text != made.text, bytes.toHex());
      const MarkedText third = withLetterStyle(again.text, again.selection, mark);
      QVERIFY2(markedLines(third.text) == markedLines(made.text), bytes.toHex());
    }
    QVERIFY(changed > 5'000);
  }
};

SLINE_TEST(LetterStyleTest)
#include "letter_style_test.moc"
