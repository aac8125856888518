// SPDX-License-Identifier: Apache-2.0
// Tests texts of labels and callouts: their fonts, how wide their runs are, where their lines end.
#include <QFontInfo>
#include <QImage>
#include <QPainter>
#include <QRawFont>
#include <QtTest>
#include <set>

#include "render/lettering/hyphenation.h"
#include "render/lettering/label_painter.h"
#include "render/lettering/label_texts.h"
#include "render/lettering/typesetting.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;
using model::LetterStyle;

namespace {

constexpr LetterStyle plain{};
constexpr LetterStyle bold{.bold = true};
constexpr LetterStyle italic{.italic = true};
constexpr LetterStyle both{.bold = true, .italic = true};

ShownLabel shown(model::AnnotationKind kind, const QString& text) {
  ShownLabel label;
  label.item.id = {1};
  label.item.kind = kind;
  label.text = text.toStdString();
  return label;
}

LabelText callout(const QString& text, float widestMm = 60.0f) {
  return textOf(shown(model::AnnotationKind::callout, text), {.mode = LabelMode::on}, widestMm);
}

LabelText label(const QString& text, float widestMm, const WordRoom& words = {}) {
  return textOf(shown(model::AnnotationKind::label, text), {.mode = LabelMode::on}, widestMm,
                words);
}

TextLine lineOf(const std::vector<TextRun>& runs) {
  TextLine line;
  line.runs = runs;
  return line;
}

LetteringText textAt(std::vector<TextLine> lines, TextAnchor anchor) {
  return {.lines = std::move(lines), .at = {50.0f, 20.0f}, .leading = 5.0f, .anchor = anchor};
}

}  // namespace

class LetteringTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    auto made = Typesetting::create();
    QVERIFY(made.ok());
    m_typesetting = std::move(*made);
  }

  /// The fonts are those that are built in, not substitutes that the machine makes for a font it
  /// lacks.
  void fontsAreTheirOwn_data() {
    QTest::addColumn<bool>("isBold");
    QTest::addColumn<bool>("isItalic");
    QTest::addColumn<QString>("file");
    QTest::newRow("plain") << false << false << ":/fonts/labels.ttf";
    QTest::newRow("bold") << true << false << ":/fonts/labels-bold.ttf";
    QTest::newRow("oblique") << false << true << ":/fonts/labels-oblique.ttf";
    QTest::newRow("both") << true << true << ":/fonts/labels-bold-oblique.ttf";
  }
  void fontsAreTheirOwn() {
    QFETCH(bool, isBold);
    QFETCH(bool, isItalic);
    QFETCH(QString, file);
    const LetterStyle style{.bold = isBold, .italic = isItalic};
    const QRawFont embedded(file, labelFontPixels, QFont::PreferNoHinting);
    const QRawFont used = QRawFont::fromFont(labelFont(style));
    QVERIFY(embedded.isValid());
    QCOMPARE(used.familyName(), QStringLiteral("DejaVu Sans"));
    QCOMPARE(used.styleName(), embedded.styleName());
    for (const QChar letter : QStringLiteral("Hagilß•"))
      QCOMPARE(used.pathForGlyph(used.glyphIndexesForString(letter).front()),
               embedded.pathForGlyph(embedded.glyphIndexesForString(letter).front()));
  }

  void mixedRunsAreAsWideAsTheirRuns() {
    const QString word = QStringLiteral("Musculus");
    const float regular = textWidthMm(word, 10.0f);
    const float heavy = textWidthMm(lineOf({{word, bold}}), 10.0f);
    QVERIFY(heavy > 1.08f * regular);
    const TextLine mixed =
        lineOf({{"a ", plain}, {word, bold}, {" b ", italic}, {word, both}, {word, plain}});
    float sum = 0.0f;
    for (const TextRun& run : mixed.runs)
      sum += textWidthMm(lineOf({run}), 10.0f);
    QVERIFY(std::abs(textWidthMm(mixed, 10.0f) - sum) < 1e-3f);
    QVERIFY(std::abs(textWidthMm(mixed, 20.0f) - 2.0f * sum) < 1e-3f);
    TextLine indented = mixed;
    indented.indent = 2.0f;
    QVERIFY(std::abs(textWidthMm(indented, 10.0f) - sum - 20.0f * millimetresPerPoint) < 1e-3f);
  }

  /// Letters stand where they are measured, whichever side they are aligned to.
  void outlinesAreWithinTheirWidth() {
    const TextLine line = lineOf({{"Hilum ", plain}, {"renale ", bold}, {"H", italic}});
    const auto width = double(textWidthMm(line, 10.0f));
    for (const TextAnchor anchor : {TextAnchor::start, TextAnchor::middle, TextAnchor::end}) {
      const QRectF box = outlineOf(textAt({line}, anchor)).boundingRect();
      const double left = 50.0 - 0.5 * width * double(int(anchor));
      QVERIFY(box.left() > left && box.left() < left + 0.6);
      QVERIFY(box.right() < left + width + 0.3 && box.right() > left + width - 0.6);
    }
    TextLine indented = line;
    indented.indent = 1.0f;
    const QPainterPath path = outlineOf(textAt({line, indented}, TextAnchor::start));
    const QRectF second = path.intersected([] {
                                QPainterPath below;
                                below.addRect(0, 20.8, 200, 6);
                                return below;
                              }())
                              .boundingRect();
    QVERIFY(std::abs(second.left() - path.boundingRect().left() -
                     10.0 * double(millimetresPerPoint)) < 0.05);
  }

  /// A line of the drawing that shows between two words would read as a dash.
  void halosCloseTheGapsBetweenWords() {
    const TextLine line = lineOf({{"Pin ", plain}, {"here", bold}});
    Lettering lettering{.ground = {255, 255, 255}, .items = {}};
    lettering.items.push_back(
        {.name = {}, .shapes = {}, .text = textAt({line}, TextAnchor::start)});
    constexpr int perMm = 10;
    const QPointF at(double(lettering.items[0].text->at.x), double(lettering.items[0].text->at.y));
    QImage image(100 * perMm, 100 * perMm, QImage::Format_RGB32);
    image.fill(Qt::red);
    QPainter painter(&image);
    painter.scale(perMm, perMm);
    paintLettering(painter, lettering, [](QPainter&, const LetteringText&) {});
    painter.end();
    const double gap = double(textWidthMm(lineOf({{"Pin", plain}}), 10.0f)) +
                       0.5 * double(textWidthMm(lineOf({{" ", plain}}), 10.0f));
    for (double above = 0.1; above < 1.8; above += 0.1)
      QCOMPARE(image.pixelColor(QPoint(int(perMm * (at.x() + gap)), int(perMm * (at.y() - above)))),
               QColor(Qt::white));
    // One word has no gap; its own letters are enough.
    QCOMPARE(haloOf(textAt({lineOf({{"Pin", plain}})}, TextAnchor::start)),
             outlineOf(textAt({lineOf({{"Pin", plain}})}, TextAnchor::start)));
  }

  void keysSayWhatLabelsSay() {
    ShownLabel label;
    label.item.kind = model::AnnotationKind::distance;
    label.length = {.mm = 88.4f};
    QCOMPARE(QString::fromStdString(keyText(label, {})), QStringLiteral("88\u00a0mm"));
    label.text = "Conjugata vera";
    QCOMPARE(QString::fromStdString(keyText(label, {})),
             QStringLiteral("Conjugata vera 88\u00a0mm"));
    const std::pair<float, const char*> lengths[] = {{3.84f, "3.8 mm"},
                                                     {0.1f, "0.1 mm"},
                                                     {0.0038f, "3.8 µm"},
                                                     {0.0135f, "14 µm"},
                                                     {2e-5f, "20 nm"}};
    label.text.clear();
    for (const auto& [length, text] : lengths) {
      label.length = {.mm = length};
      QCOMPARE(QString::fromStdString(keyText(label, {})).replace(QChar(QChar::Nbsp), ' '),
               QString::fromUtf8(text));
    }
    label.unit = model::DrawnUnit::doubtedMillimetre;
    label.length = {.mm = 0.045f};
    QCOMPARE(QString::fromStdString(keyText(label, {})), QStringLiteral("45\u00a0µm?"));
    label.text = "Conjugata vera";
    label.length = {.mm = 0.0f};
    QCOMPARE(QString::fromStdString(keyText(label, {})), QStringLiteral("Conjugata vera touching"));
    QCOMPARE(QString::fromStdString(keyText(label, {.language = "de"})),
             QStringLiteral("Conjugata vera berühren sich"));
    // Of surfaces that import has moved no more is told than is known.
    label.text.clear();
    label.unit = model::DrawnUnit::millimetre;
    const std::pair<model::DrawnLength, const char*> unsure[] = {
        {{88.4f, 0.3f}, "88 mm"},    {{88.4f, 0.8f}, "≈ 88 mm"}, {{3.44f, 0.04f}, "3.4 mm"},
        {{3.44f, 0.2f}, "≈ 3.4 mm"}, {{3.44f, 0.8f}, "≈ 3 mm"},  {{0.3f, 0.8f}, "< 2 mm"},
        {{0.0f, 0.3f}, "< 0.3 mm"},  {{0.0f, 0.8f}, "< 0.8 mm"}};
    for (const auto& [length, text] : unsure) {
      label.length = length;
      QCOMPARE(QString::fromStdString(keyText(label, {})).replace(QChar(QChar::Nbsp), ' '),
               QString::fromUtf8(text));
    }
    label.item.kind = model::AnnotationKind::callout;
    label.length.reset();
    label.text = "**Ren** *dexter*";
    QCOMPARE(QString::fromStdString(keyText(label, {})), QStringLiteral("Ren dexter"));
  }

  void calloutsAreParsed() {
    const LabelText text = callout(QStringLiteral("**Ren** *dexter*\n\n- **a** b\n- c"));
    QVERIFY(text.list);
    QCOMPARE(text.lines.size(), std::size_t(4));
    QVERIFY(text.lines[0] == lineOf({{"Ren", bold}, {" ", plain}, {"dexter", italic}}));
    QVERIFY(text.lines[1].runs.empty());
    QVERIFY(text.lines[2] == lineOf({{"• ", plain}, {"a", bold}, {" b", plain}}));
    QVERIFY(text.lines[3] == lineOf({{"• c", plain}}));
    QCOMPARE(plainText(text.lines), QStringLiteral("Ren dexter  • a b • c"));
    for (const model::AnnotationKind kind :
         {model::AnnotationKind::label, model::AnnotationKind::pin}) {
      const LabelText set = textOf(shown(kind, "**a**"), {.mode = LabelMode::on}, 60.0f);
      QVERIFY(set.lines == std::vector{TextLine(QStringLiteral("**a**"))});
    }
  }

  /// An item's further lines stand under its first word; bold goes on over line ends.
  void itemsHang() {
    const QString text = QStringLiteral("- one **two three four five six seven** eight nine ten");
    const LabelText set = callout(text, 30.0f);
    QVERIFY(set.lines.size() >= 3);
    QCOMPARE(set.lines.front().indent, 0.0f);
    const float bullet = textWidthMm(QStringLiteral("• "), 10.0f);
    float widest = 0.0f;
    int heavy = 0;
    for (std::size_t i = 0; i < set.lines.size(); ++i) {
      widest = std::max(widest, textWidthMm(set.lines[i], 10.0f));
      if (i > 0)
        QVERIFY(std::abs(set.lines[i].indent * 10.0f * millimetresPerPoint - bullet) < 1e-3f);
      for (const TextRun& run : set.lines[i].runs)
        heavy += run.style.bold ? int(run.text.split(' ', Qt::SkipEmptyParts).size()) : 0;
    }
    QCOMPARE(heavy, 6);
    QVERIFY(widest <= 30.0f);
    QVERIFY(std::abs(set.box.x - widest - 2.0f * paddingOf(model::AnnotationKind::callout, {}).x) <
            1e-3f);
    QCOMPARE(plainText(set.lines),
             QStringLiteral("• one two three four five six seven eight nine ten"));
  }

  void joinedWordsKeepTheirStyles() {
    const LabelText set = callout(QStringLiteral("**Left**-*kidney-artery* in**ter**lobar"), 14.0f);
    QVERIFY(set.lines.size() >= 2);
    QString words;
    for (const TextLine& line : set.lines)
      words += plainText(line).remove(' ');
    QCOMPARE(words, QStringLiteral("Left-kidney-arteryinterlobar"));
    QVERIFY(set.lines.front().runs.front() == (TextRun{"Left", bold}));
  }

  /// Long words end their lines between syllables of their language; others between any letters.
  void syllables_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("syllables");
    QTest::newRow("German") << "de"
                            << "Zwölf-fin-ger-darm-schleim-haut";
    QTest::newRow("of a region") << "de-AT"
                                 << "Bauch-spei-chel-drü-sen-gang";
    QTest::newRow("Dutch") << "nl"
                           << "twaalf-vin-ge-ri-ge-darm";
    QTest::newRow("Norwegian") << "nb"
                               << "buk-spytt-kjertelgan-gen";
    QTest::newRow("English") << "en"
                             << "in-ter-ver-te-bral";
    QTest::newRow("Latin has no patterns") << "la"
                                           << "sternocleidomastoideus";
    QTest::newRow("no language") << ""
                                 << "Zwölffingerdarmschleimhaut";
    QTest::newRow("no tag") << "../de"
                            << "Zwölffingerdarmschleimhaut";
  }
  void syllables() {
    QFETCH(QString, language);
    QFETCH(QString, syllables);
    const QString word = QString(syllables).remove('-');
    std::set<qsizetype> ends;
    for (qsizetype i = 0, hyphens = 0; i < syllables.size(); ++i)
      if (syllables[i] == '-')
        ends.insert(i - hyphens++);
    const std::vector<qsizetype> found =
        Hyphenation(language.toStdString()).syllableEnds("(" + word + ")");
    if (found.empty() && !ends.empty())
      SLINE_ABSENT("the dictionary of syllables is not installed");
    QCOMPARE(found.size(), ends.size());
    for (const qsizetype end : found)
      QVERIFY(ends.contains(end - 1));

    const float width = 0.62f * textWidthMm(word, 10.0f);
    const LabelText set = textOf(shown(model::AnnotationKind::label, word),
                                 {.mode = LabelMode::on, .language = language.toStdString()}, width,
                                 {.whole = width, .part = width});
    QVERIFY(set.lines.size() > 1);
    QString read;
    for (const TextLine& line : set.lines) {
      QVERIFY(textWidthMm(line, 10.0f) <= width + 1e-3f);
      if (!read.isEmpty() && !ends.empty())
        QVERIFY2(ends.contains(read.size()), qPrintable(plainText(set.lines, '|')));
      read += plainText(line).remove('-');
    }
    QCOMPARE(read, word);
  }

  /// Text in a box lies within it, in the left column and in the right.
  void framesHoldTheirTexts() {
    for (const char* text : {"**WWW** *fff*\n- ***jjj*** WWWWW iiiii *lllll* WWWW\n- b",
                             "*Vesica* **urinaria** und mehr davon, als eine Zeile fasst"})
      for (const LabelPost post : {LabelPost::left, LabelPost::right}) {
        LabelPlate plate{.style = {.mode = LabelMode::on}};
        plate.labels = {shown(model::AnnotationKind::callout, text)};
        plate.texts = {callout(text, 40.0f)};
        const bool left = post == LabelPost::left;
        plate.labels[0].item.places = {{left ? 90.0f : 10.0f, 30.0f}};
        const LabelBox box{{20.0f, 10.0f}, glm::vec2(20.0f, 10.0f) + plate.texts[0].box};
        plate.layout.labels = {{.id = {1}, .post = post, .box = box}};
        const Lettering lettering = letteringOf(plate);
        const LetteringText& set = *lettering.items.front().text;
        const QRectF frame(QPointF(double(box.low.x), double(box.low.y)),
                           QPointF(double(box.high.x), double(box.high.y)));
        QVERIFY(frame.contains(outlineOf(set).boundingRect()));
        const bool list = QString(text).contains("\n- ");
        QVERIFY(set.anchor == (left && !list ? TextAnchor::end : TextAnchor::start));
        QCOMPARE(lettering.items.front().name.find('*'), std::string::npos);
      }
  }

  void longTextsAreCutShort() {
    const QString word = QStringLiteral("**a** *b* ");
    const LabelText set = callout(word.repeated(200'000));
    QVERIFY(set.box.y > 400.0f);
    QVERIFY(plainText(set.lines.back()).endsWith(QChar(0x2026)));
    // No cut is within a character.
    const LabelText umlauts = callout(QStringLiteral("xÄ").repeated(20'000));
    QVERIFY(!plainText(umlauts.lines).contains(QChar::ReplacementCharacter));
  }

  /// A text without spaces breaks where its script lets lines end.
  void scriptsTellWhereLinesEnd() {
    const QString text = QString::fromUtf8(
        "骶骨是由五块融合的椎骨组成的三角形骨骼，与两侧髋骨相关节（位于脊柱下端）");
    const LabelText set = label(text, 30.0f);
    QVERIFY(set.lines.size() > 2);
    for (const TextLine& line : set.lines) {
      QVERIFY(textWidthMm(line, 10.0f) <= 30.0f);
      // No line begins with a sign that belongs to the one before, and none ends with an opening
      // one.
      const QString words = plainText(line);
      QVERIFY2(!QString::fromUtf8("，）").contains(words.front()) &&
                   !QString::fromUtf8("（").contains(words.back()),
               qPrintable(words));
      QVERIFY(!line.hyphenated);
    }
    QCOMPARE(plainText(set.lines), text);
    QCOMPARE(label(QString::fromUtf8("骶骨"), 30.0f).lines.size(), std::size_t(1));
  }

  /// Between a structure's names in two languages a line ends behind the slash.
  void slashesEndLines() {
    bool broken = false;
    for (float width = 16.0f; width < 90.0f; width += 2.0f) {
      const LabelText set =
          label(QStringLiteral("Harnblase / Vesica urinaria / urinary bladder"), width);
      broken = broken || set.lines.size() > 1;
      for (const TextLine& line : set.lines)
        QVERIFY2(!plainText(line).trimmed().startsWith('/'), qPrintable(plainText(line)));
    }
    QVERIFY(broken);
  }

  void widestWordsAreParted_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("hyphens");
    QTest::addColumn<int>("lines");
    QTest::newRow("Latin") << "Hypogastricoretroperitoneoprostaticovesicalfascia" << true << 3;
    QTest::newRow("Greek") << QString::fromUtf8("στερνοκλειδομαστοειδήςμυςτουτραχήλου") << true
                           << 3;
    QTest::newRow("endless") << QString(300, 'x') << true << 0;
    QTest::newRow("number") << QString(60, '7') << false << 0;
    QTest::newRow("marks") << QString::fromUtf8("e\u0301").repeated(60) << false << 0;
    QTest::newRow("two words") << "of Zwischenwirbelscheibenvorfaelle" << true << 3;
    QTest::newRow("program") << "left_Zwischenwirbelscheibenvorfaelle" << true << 3;
  }
  void widestWordsAreParted() {
    QFETCH(QString, text);
    QFETCH(bool, hyphens);
    QFETCH(int, lines);
    constexpr float most = 34.0f;
    for (const float widest : {20.0f, most}) {
      const LabelText set = label(text, widest, {.whole = most, .part = most});
      QVERIFY(lines == 0 || int(set.lines.size()) == lines);
      QVERIFY(set.lines.size() > 1);
      float narrowest = most;
      for (std::size_t i = 0; i < set.lines.size(); ++i) {
        const QString words = plainText(set.lines[i]);
        QVERIFY2(textWidthMm(set.lines[i], 10.0f) <= most, qPrintable(words));
        QVERIFY(!words.front().isMark());
        QCOMPARE(set.lines[i].hyphenated, words.endsWith('-'));
        if (set.lines[i].hyphenated)
          QVERIFY(hyphens && i + 1 < set.lines.size() && set.lines[i + 1].joined);
        if (hyphens && i > 0 && set.lines[i].joined && i + 1 == set.lines.size())
          narrowest = textWidthMm(set.lines[i], 10.0f);
      }
      QVERIFY2(narrowest > 8.0f, "a word's last letters stand alone");
      QCOMPARE(plainText(set.lines), text);
    }
    // Without widths for words they stay whole.
    if (hyphens)
      for (const TextLine& line : label(text, 34.0f).lines)
        QVERIFY(!line.hyphenated);
  }

  /// Words narrower than a column may be are never divided, however short lines are.
  void usualWordsAreWhole() {
    const LabelText set = label(QStringLiteral("intervertebral sternocleidomastoid"), 12.0f,
                                {.whole = 49.0f, .part = 20.0f});
    QVERIFY(set.lines == (std::vector<TextLine>{QStringLiteral("intervertebral"),
                                                QStringLiteral("sternocleidomastoid")}));
  }

  void softHyphensPartWords() {
    const QString text = QStringLiteral("Zwischenwirbel\u00adscheiben\u00advorfall");
    const LabelText set = label(text, 30.0f);
    QCOMPARE(set.lines.size(), std::size_t(2));
    QVERIFY(plainText(set.lines[0]).endsWith('-') && set.lines[0].hyphenated);
    QCOMPARE(plainText(set.lines), text);
  }

  void nothingIsNothing() {
    for (const char* text : {"", " \n ", "\n\n"})
      QVERIFY(callout(text).lines.empty());
    QCOMPARE(callout("a\n \n\n").lines.size(), std::size_t(1));
    QVERIFY(callout("****").lines == std::vector{TextLine(QStringLiteral("****"))});
  }

 private:
  std::unique_ptr<Typesetting> m_typesetting;
};

}  // namespace sline::test

SLINE_TEST(sline::test::LetteringTest)
#include "lettering_test.moc"
