// SPDX-License-Identifier: Apache-2.0
// Tests what a view says as it stands at the foot of a picture.
#include <QtTest>

#include "render/lettering/caption.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

constexpr CaptionPlace wide{.middle = 80.0f, .foot = 85.0f, .width = 112.0f, .height = 40.0f};
const LabelStyle captionStyle{.mode = LabelMode::off, .language = {}};

QString words(const Caption& caption) {
  return plainText(caption.item.text->lines);
}

}  // namespace

class CaptionTest : public QObject {
  Q_OBJECT

 private slots:
  /// The box stands on its foot, in its middle, within the room; the title is bold, line by line.
  void stands() {
    const auto caption =
        captionOf(captionMarkup("The floor",
                                "Seen *from below*, where the levator ani spans the "
                                "outlet of the pelvis from side to side."),
                  captionStyle, wide);
    QVERIFY(caption && !caption->shortened);
    QVERIFY(qAbs(caption->box.high.y - wide.foot) < 1e-3f);
    QVERIFY(qAbs(caption->box.middle().x - wide.middle) < 1e-3f);
    QVERIFY(caption->box.size().x <= wide.width && caption->box.size().y <= wide.height);
    const auto& lines = caption->item.text->lines;
    QVERIFY(lines.size() >= 3);
    QCOMPARE(plainText(lines.front()), QString("The floor"));
    QVERIFY(lines.front().runs.front().style.bold);
    QVERIFY(!lines[1].runs.front().style.bold);
    QCOMPARE(lines[1].runs[1].text.left(4), QString("from"));
    QVERIFY(lines[1].runs[1].style.italic);
  }

  /// A title is plain whatever it is made of; a text without marks stays as it was typed.
  void hostile_data() {
    QTest::addColumn<QString>("title");
    for (const char* title : {"<b>Liver</b> &amp;", "**not** *marked*", "- no item", "a\\*b",
                              "* * *", "***", "\\", "<script>alert(1)</script>", "%1 %n"})
      QTest::newRow(title) << QString(title);
  }
  void hostile() {
    QFETCH(QString, title);
    const auto caption =
        captionOf(captionMarkup(title.toStdString(), title.toStdString()), captionStyle, wide);
    QVERIFY(caption);
    QCOMPARE(plainText(caption->item.text->lines.front()), title);
    QVERIFY(caption->item.text->lines.front().runs.front().style.bold);
    if (title.startsWith('<'))
      QCOMPARE(words(*caption), title + ' ' + title);
  }

  /// What is too long is cut at the height, and says so.
  void tooLong() {
    const std::string many = QString("many words ").repeated(400).toStdString();
    const auto caption = captionOf(many, captionStyle, wide);
    QVERIFY(caption && caption->shortened);
    QVERIFY(caption->box.size().y <= wide.height && caption->box.size().x <= wide.width);
    QVERIFY(words(*caption).endsWith(QChar(0x2026)));
    const auto word = captionOf(std::string(3000, 'x'), captionStyle, wide);
    QVERIFY(word && word->box.size().x <= wide.width && word->box.size().y <= wide.height);
  }

  void nothing() {
    for (const char* empty : {"", " ", "\n\n"})
      QVERIFY2(!captionOf(captionMarkup("", empty), captionStyle, wide), empty);
    QVERIFY(!captionOf("words", captionStyle, {.width = 1.0f, .height = 40.0f}));
    QVERIFY(!captionOf("words", captionStyle, {.width = 100.0f, .height = 1.0f}));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::CaptionTest)
#include "caption_test.moc"
