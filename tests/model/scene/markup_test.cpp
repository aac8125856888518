// SPDX-License-Identifier: Apache-2.0
#include "model/scene/markup.h"

#include <QtTest>

#include "tests/support/mutator.h"
#include "tests/support/suite.h"

using namespace sline::model;

namespace {

/// Returns the runs with <b>, <i> and <bi> around what is not plain, {…=name} around links to
/// structures, {…@name} around those to views, and "• " before items.
QString spelt(const std::vector<MarkedLine>& lines) {
  QStringList all;
  for (const MarkedLine& line : lines) {
    QString one = line.bullet ? QStringLiteral("• ") : QString();
    for (const MarkedRun& run : line.runs) {
      const QString tag =
          QLatin1String(run.style.bold ? "b" : "") + QLatin1String(run.style.italic ? "i" : "");
      QString text = QString::fromStdString(run.text);
      if (run.link)
        text = QStringLiteral("{%1%2%3}")
                   .arg(text, run.link->to == MarkupLink::To::view ? "@" : "=",
                        QString::fromStdString(run.link->name));
      one += tag.isEmpty() ? text : QStringLiteral("<%1>%2</>").arg(tag, text);
    }
    all << one;
  }
  return all.join('|');
}

/// Tells whether every byte of every span is one of the text's, in order.
bool spansAreSound(std::string_view text) {
  std::size_t last = 0;
  for (const MarkupLine& line : parsedMarkup(text)) {
    if (line.begin < last || line.end > text.size() || line.content < line.begin)
      return false;
    last = line.content;
    for (const MarkupSpan& span : line.spans) {
      if (span.begin < last || span.end <= span.begin || span.end > line.end ||
          (span.link && *span.link >= line.links.size()))
        return false;
      last = span.end;
    }
  }
  return true;
}

}  // namespace

class MarkupTest : public QObject {
  Q_OBJECT
 private slots:
  void texts_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("shown");
    const auto row = [](const char* name, const char* text, const char* shown) {
      QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(shown);
    };
    row("plain", "Arteria renalis", "Arteria renalis");
    row("bold", "the **renal** artery", "the <b>renal</> artery");
    row("italic", "the *arteria renalis*", "the <i>arteria renalis</>");
    row("within a word", "in**ter**lobar", "in<b>ter</>lobar");
    row("all of it", "***both***", "<bi>both</>");
    row("italic in bold", "**a *b* c**", "<b>a </><bi>b</><b> c</>");
    row("bold in italic", "*a **b** c*", "<i>a </><bi>b</><i> c</>");
    row("italic ends with bold", "**a *b***", "<b>a </><bi>b</>");
    row("bold ends with italic", "*a **b***", "<i>a </><bi>b</>");
    row("bold lasts longer", "***a* b**", "<bi>a</><b> b</>");
    row("italic lasts longer", "***a** b*", "<bi>a</><i> b</>");
    row("one after the other", "**a***b*", "<b>a</><i>b</>");
    row("bold to bold", "**a****b**", "<b>ab</>");
    row("both to italic", "***a****b*", "<bi>a</><i>b</>");
    row("umlauts", "**Öffnung** *für* ÿ", "<b>Öffnung</> <i>für</> ÿ");
    // These marks have no partner.
    row("lone asterisk", "L5*", "L5*");
    row("footnotes", "p* and q*", "p* and q*");
    row("product", "5 * 3 * 2", "5 * 3 * 2");
    row("bold not ended", "**a", "**a");
    row("bold not begun", "a**", "a**");
    row("italic not ended in bold", "**a *b**", "<b>a *b</>");
    row("bold not ended in italic", "*a **b*", "<i>a **b</>");
    row("too few at the end", "**a*", "**a*");
    row("too many at the end", "**Note***", "<b>Note</>*");
    row("too many at the beginning", "***a**", "*<b>a</>");
    row("the nearer beginning", "2*x or *italic*", "2*x or <i>italic</>");
    row("not over lines", "**a\nb**", "**a|b**");
    row("blank within", "** a **", "** a **");
    row("nothing within", "****", "****");
    row("seven in a row", "*******a*******", "*******a*******");
    // These are lists.
    row("list", "Parts:\n- one\n- *two*", "Parts:|• one|• <i>two</>");
    row("indented item", "  -   one", "• one");
    row("no item", "-one\n–\n-", "-one|–|-");
    row("markers do not span items", "- *a\n- b*", "• *a|• b*");
    row("asterisk as bullet is none", "* a\n* b", "* a|* b");
    // These are escapes.
    row("escaped", "\\*a\\*", "*a*");
    row("escaped in bold", "**\\*a\\***", "<b>*a*</>");
    row("escaped item", "\\- a", "- a");
    row("escaped escape", "\\\\*a*", "\\<i>a</>");
    row("other escapes stay", "C:\\new \\_ \\", "C:\\new \\_ \\");
    // These are links.
    row("structure", "the [ureter](#structure=left-ureter) ends", "the {ureter=left-ureter} ends");
    row("view", "go [there](#view=2).", "go {there@2}.");
    row("view by name", "[x](#view=from behind)", "{x@from behind}");
    row("one by one", "[a](#view=1)[b](#structure=b)", "{a@1}{b=b}");
    row("link in a list", "- [a](#view=1)", "• {a@1}");
    row("bold link", "**[a](#view=1)** b", "<b>{a@1}</> b");
    row("bold in a link", "[a **b**](#view=1) c", "{a @1}<b>{b@1}</> c");
    row("bold over a link", "*a [b](#view=1) c*", "<i>a </><i>{b@1}</><i> c</>");
    row("bold beside a link", "**a**[**b**](#view=1)**c**", "<b>a</><b>{b@1}</><b>c</>");
    row("marker from within", "[a **b](#view=1) c**", "{a @1}<b>{b@1}</><b> c</>");
    row("name with asterisks", "*a [b](#structure=*b*) c*", "<i>a </><i>{b=*b*}</><i> c</>");
    row("name with brackets", "[a](#structure=a (left)) b", "{a=a (left)} b");
    row("name without end", "[a](#structure=a (left) b", "[a](#structure=a (left) b");
    row("the inner bracket", "[[a](#view=1)]", "[{a@1}]");
    row("no name", "[a](#view=) b", "{a@} b");
    row("elsewhere", "[a](https://example.org)", "[a](https://example.org)");
    row("script", "[a](javascript:alert(1))", "[a](javascript:alert(1))");
    row("brackets", "a [b] (c) [d](e)", "a [b] (c) [d](e)");
    row("no words", "[](#view=1) [ ](#view=1)", "[](#view=1) [ ](#view=1)");
    row("not ended", "[a](#view=1", "[a](#view=1");
    row("over lines", "[a\nb](#view=1)", "[a|b](#view=1)");
    row("escaped link", "\\[a](#view=1)", "[a](#view=1)");
    row("escape in a link", "[\\[a](#view=1)", "{[a@1}");
    // HTML is not interpreted.
    row("tags", "<b>a</b> &amp; *c*", "<b>a</b> &amp; <i>c</>");
    row("blank lines", "\n \na\n\nb\r\n \n", "a||b");
    row("nothing", "", "");
  }
  void texts() {
    QFETCH(QString, text);
    QFETCH(QString, shown);
    QCOMPARE(spelt(markedLines(text.toStdString())), shown);
    QVERIFY(spansAreSound(text.toStdString()));
  }

  void plainTexts() {
    const std::string text = "**Ureter**\n- *a*\n- b\\*\n[c](#view=1)";
    QCOMPARE(plainText(AnnotationKind::callout, text), std::string("Ureter\n• a\n• b*\nc"));
    for (const AnnotationKind kind :
         {AnnotationKind::label, AnnotationKind::pin, AnnotationKind::distance})
      QCOMPARE(plainText(kind, text), text);
    Annotation annotation{.kind = AnnotationKind::callout, .text = "**a**"};
    annotation.texts["de"] = "*b*";
    QCOMPARE(plainTextIn(annotation, ""), std::string("a"));
    QCOMPARE(plainTextIn(annotation, "de"), std::string("b"));
    QCOMPARE(plainTextIn(annotation, "la"), std::string("a"));
  }

  /// A plain text has links and nothing else.
  void plainTextsWithLinks_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("shown");
    const auto row = [](const char* text, const char* shown) {
      QTest::newRow(text) << QString(text) << QString(shown);
    };
    row("", "");
    row("plain\n", "plain\n");
    row("- **a** [b](#view=1)\n[c](#structure=d)e\n", "- **a** {b@1}\n{c=d}e\n");
    row("\\[b](#view=1) [c](d)", "\\{b@1} [c](d)");
    row("[a\nb](#view=1)", "[a\nb](#view=1)");
  }
  void plainTextsWithLinks() {
    QFETCH(QString, text);
    QFETCH(QString, shown);
    const std::vector<MarkedRun> runs = linkedRuns(text.toStdString());
    QCOMPARE(spelt({{.runs = runs}}), shown);
    QString words = shown;
    QCOMPARE(QString::fromStdString(withoutLinks(text.toStdString())),
             words.remove(QRegularExpression(QStringLiteral("[{}]|[@=][^}]*(?=})"))));
    std::string again;
    for (const MarkedRun& run : runs)
      again += run.link ? "[" + run.text + "]" + writtenTarget(*run.link) : run.text;
    QCOMPARE(QString::fromStdString(again), text);
  }

  /// A parser that looked back for each marker would not come to an end.
  void longTextsComeToAnEnd_data() {
    QTest::addColumn<QByteArray>("piece");
    for (const char* piece :
         {"*",          "**",           "*a",    "**a", "a*",         "*a ",          "**a *b ",
          "*a**b",      "***a ",        "a**b*", "\\",  "\\*",        "- ",           "- *\n",
          "\n",         "****a",        "[",     "[a]", "[a](#view=", "[a](#view=1)", "[a](#view=(",
          "](#view=1)", "[a](#view=(1)"})
      QTest::newRow(piece) << QByteArray(piece);
  }
  void longTextsComeToAnEnd() {
    QFETCH(QByteArray, piece);
    const std::string text = piece.repeated(1'000'000 / piece.size()).toStdString();
    QVERIFY(spansAreSound(text));
    QVERIFY(plainText(AnnotationKind::callout, text).size() <= 3 * text.size());
  }

  void spoiltTextsAreParsed() {
    sline::test::Mutator spoil(11,
                               {[](sline::test::Mutator& random, QByteArray& bytes, qsizetype at) {
                                 bytes.insert(at, "**** \\\n- *[]()"[random.below(14)]);
                               }});
    QByteArray text("**Ureter** *dexter*\n- the **upper *third***\n- a\\*b, 5 * 3\n");
    text += "[**ren**](#structure=x)";
    for (int i = 0; i < 20'000; ++i) {
      const QByteArray spoilt = spoil(text);
      const std::string bytes(spoilt.constData(), std::size_t(spoilt.size()));
      QVERIFY2(spansAreSound(bytes), spoilt.toHex());
      const auto count = [](const std::string& in) {
        return std::size_t(std::count(in.begin(), in.end(), 'e'));
      };
      std::size_t letters = 0;
      for (const MarkupLine& line : parsedMarkup(bytes))
        for (const MarkupLink& link : line.links)
          letters += count(writtenTarget(link));
      for (const MarkedLine& line : markedLines(bytes))
        for (const MarkedRun& run : line.runs)
          letters += count(run.text);
      QCOMPARE(letters, std::size_t(spoilt.count('e')));
    }
  }
};

SLINE_TEST(MarkupTest)
#include "markup_test.moc"
