// SPDX-License-Identifier: Apache-2.0
#include <sqlite3.h>

#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>
#include <map>
#include <memory>

#include "render/export/anki/anki_cards.h"
#include "render/export/anki/anki_file.h"
#include "render/export/anki/anki_options.h"
#include "render/export/anki/anki_package.h"
#include "render/export/anki/anki_text.h"
#include "render/export/anki/card_painter.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {

void addBall(model::Scene& scene, const std::string& name, float x, const std::string& label) {
  model::Node node;
  node.name = name;
  node.mesh = test::moved(*test::sphere(10.0f, 2), 1.0f, {x, 0.0f, 0.0f});
  const auto id = scene.append(std::move(node));
  model::Annotation annotation;
  annotation.text = label;
  annotation.anchors = {model::SurfacePoint{id, 0, {0.3f, 0.3f}}};
  scene.appendAnnotation(annotation);
}

/// Returns an order with three labels, one of them with markup in its text, and one that is not
/// seen.
render::ExportOrder order() {
  render::ExportOrder made;
  addBall(made.scene, "left", 30.0f, "Leber & <b>Galle</b>");
  addBall(made.scene, "middle", 0.0f, "肝臓\t„rechts“");
  addBall(made.scene, "right", -30.0f, "Ren \"dexter\"");
  std::vector<model::Annotation> annotations = made.scene.annotations();
  model::Annotation hidden = annotations.front();
  hidden.text = "planted: not seen";
  hidden.visible = false;
  made.scene.appendAnnotation(hidden);
  made.camera = model::anatomicalCamera(model::AnatomicalView::anterior, made.scene.visibleBounds(),
                                        16.0f / 9.0f);
  made.viewName = "Von vorn: Übersicht";
  made.page.dpi = 60.0f;
  return made;
}

QByteArray readAll(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

QStringList allIn(const QString& folder) {
  return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
}

/// Returns the fields of the lines that are notes.
std::vector<QStringList> notesIn(const QByteArray& text) {
  std::vector<QStringList> notes;
  for (const QString& line : QString::fromUtf8(text).split('\n', Qt::SkipEmptyParts))
    if (!line.startsWith('#'))
      notes.push_back(line.split('\t'));
  return notes;
}

/// Returns the pictures that a side of a card shows, the lowest first.
QStringList picturesIn(const QString& html) {
  static const QRegularExpression image("<img src=\"([a-z0-9.-]+)\" alt=\"[^<>\"]*\"");
  QStringList names;
  for (auto each = image.globalMatch(html); each.hasNext();)
    names << each.next().captured(1);
  return names;
}

QImage imageNamed(const render::AnkiDeck& deck, const std::string& name) {
  for (const model::ZipMember& member : deck.media)
    if (member.name == name)
      return QImage::fromData(QByteArray::fromStdString(member.bytes));
  return {};
}

/// Returns the box in which two pictures differ.
QRect changed(const QImage& a, const QImage& b) {
  QRect box;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a.pixel(x, y) != b.pixel(x, y))
        box = box.united(QRect(x, y, 1, 1));
  return box;
}

/// Returns the box of the yellow mark that stands in place of a name.
QRect markIn(const QImage& image) {
  QRect mark;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor c = image.pixelColor(x, y);
      if (c.alpha() == 255 && c.red() > 220 && c.green() > 180 && c.blue() < 160)
        mark = mark.united(QRect(x, y, 1, 1));
    }
  return mark;
}

/// Opens a package's collection, which it writes beside it.
QString collectionOf(const QTemporaryDir& folder, const QString& package) {
  const std::string bytes = readAll(package).toStdString();
  const auto zip = model::ZipReader::open(bytes);
  const QString collection = folder.filePath("collection.anki2");
  QFile out(collection);
  if (zip.ok() && out.open(QIODevice::WriteOnly))
    out.write(QByteArray::fromStdString(*zip->read(*zip->find("collection.anki2"))));
  return collection;
}

/// Returns the rows of a query as text.
std::vector<QStringList> rowsOf(const QString& file, const char* query) {
  sqlite3* opened = nullptr;
  sqlite3_open_v2(file.toUtf8().constData(), &opened, SQLITE_OPEN_READONLY, nullptr);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> database(opened, sqlite3_close);
  std::vector<QStringList> rows;
  sqlite3_exec(
      database.get(), query,
      [](void* to, int count, char** values, char**) {
        QStringList row;
        for (int i = 0; i < count; ++i)
          row << QString::fromUtf8(values[i]);
        static_cast<std::vector<QStringList>*>(to)->push_back(row);
        return 0;
      },
      &rows, nullptr);
  return rows;
}

}  // namespace

class AnkiTest : public QObject {
  Q_OBJECT

 private slots:
  void textDeck() {
    const QTemporaryDir folder;
    const QString deck = folder.filePath("Karten ü");
    QVERIFY(render::writeAnki(order(), deck.toStdString(), {}).ok());
    const QByteArray text = readAll(deck + "/deck.txt");
    QVERIFY(text.startsWith("#separator:tab\n#html:true\n#columns:Id\tFront\tBack\tTags\tDeck\n"));
    const auto cards = notesIn(text);
    QCOMPARE(int(cards.size()), 6);  // what is this, and which number is it, of three labels
    QStringList labels;
    QSet<QString> ids;
    QSet<QString> pictures{"deck.txt"};
    for (const QStringList& card : cards) {
      QCOMPARE(card.size(), 5);
      ids << card[0];
      for (const int column : {1, 2}) {
        QCOMPARE(picturesIn(card[column]).size(), 2);
        for (const QString& picture : picturesIn(card[column])) {
          pictures << picture;
          QVERIFY2(!QImage(deck + "/" + picture).isNull(), qPrintable(card[column]));
        }
      }
      if (!card[0].endsWith("-n"))
        labels << card[2].mid(card[2].indexOf("<br>") + 4);
      QCOMPARE(card[3], QString("Sline Von_vorn__Übersicht"));
      QCOMPARE(card[4], QString("Von vorn: Übersicht"));
    }
    QCOMPARE(ids.size(), 6);
    QCOMPARE(labels, QStringList({"肝臓 „rechts“", "Ren &quot;dexter&quot;",
                                  "Leber &amp; &lt;b&gt;Galle&lt;/b&gt;"}));
    // The drawing, the numbers, and for each label its mark and its name; and nothing else.
    QCOMPARE(pictures.size(), 1 + 8);
    QStringList all(pictures.begin(), pictures.end());
    all.sort();
    QCOMPARE(allIn(deck), all);
    QVERIFY(!text.contains("planted"));
  }

  void questionsAskForOneLabel() {
    render::ExportOrder asked = order();
    asked.page.dpi = 150.0f;
    const auto deck = render::ankiCards(asked, {});
    QVERIFY(deck.ok());
    QCOMPARE(int(deck->notes.size()), 3);
    std::vector<QRect> boxes;
    for (const render::AnkiNote& note : deck->notes) {
      QCOMPARE(note.marked.ground, note.named.ground);
      QCOMPARE(imageNamed(*deck, note.marked.ground).size(), QSize(945, 531));
      const QImage question = imageNamed(*deck, note.marked.over);
      const QImage answer = imageNamed(*deck, note.named.over);
      QCOMPARE(question.size(), QSize(945, 531));
      boxes.push_back(changed(question, answer));
      // Only the text changes, beside the anatomy: a few lines of large letters.
      const double letters = 945.0 * double(render::phoneLetters);
      QVERIFY(!boxes.back().isEmpty());
      QVERIFY2(boxes.back().width() < 14.0 * letters && boxes.back().height() < 4.0 * letters,
               qPrintable(QString("%1 × %2").arg(boxes.back().width()).arg(boxes.back().height())));
      // The question shows none of the text, which is longer than the mark.
      const QRect mark = markIn(question);
      QVERIFY(boxes.back().contains(mark));
      QVERIFY(boxes.back().width() > mark.width() + 10);
      // On a phone, 360 pixels wide, the mark is as high as a line of text that one reads there.
      QVERIFY2(360.0 * mark.height() / question.width() > 16.0,
               qPrintable(QString::number(mark.height())));
    }
    for (std::size_t i = 0; i < 3; ++i)
      QVERIFY(!boxes[i].intersects(boxes[(i + 1) % 3]));
  }

  void lettersForPhones_data() {
    QTest::addColumn<float>("width");
    QTest::addColumn<float>("points");
    QTest::newRow("usual page") << 160.0f << 10.0f;
    QTest::newRow("a poster") << 900.0f << 10.0f;
    QTest::newRow("large already") << 80.0f << 20.0f;
  }
  void lettersForPhones() {
    QFETCH(float, width);
    QFETCH(float, points);
    render::ExportOrder asked = order();
    asked.page.sizeMm = {width, 0.6f * width};
    asked.labels.points = points;
    const float size = render::forPhones(asked).labels.points;
    QVERIFY(size >= points);
    const float share = size * render::millimetresPerPoint / width;
    QVERIFY2(share >= 0.03f, qPrintable(QString::number(double(share))));
  }

  /// Where a name is covered all others are shown, but for those that are the same.
  void coveredNames() {
    render::ExportOrder asked = order();
    asked.of<render::AnkiOptions>() = {.deck = {}, .findIt = false, .cover = true};
    const auto deck = render::ankiCards(asked, {});
    QVERIFY(deck.ok());
    QCOMPARE(int(deck->notes.size()), 3);
    for (std::size_t i = 0; i < 3; ++i) {
      const QImage covered = imageNamed(*deck, deck->notes[i].covered.over);
      QVERIFY(deck->notes[i].numbered.empty());
      for (std::size_t k = 0; k < 3; ++k) {
        const QImage named = imageNamed(*deck, deck->notes[k].named.over);
        const QRect name = changed(named, imageNamed(*deck, deck->notes[k].marked.over));
        const bool shown = changed(covered.copy(name), named.copy(name)).isEmpty();
        QVERIFY2(shown == (k != i), qPrintable(QString("%1 %2").arg(i).arg(k)));
      }
      QVERIFY(!markIn(covered).isEmpty());
    }
    std::vector<model::Annotation> annotations = asked.scene.annotations();
    annotations[1].text = annotations[0].text;
    asked.scene.setAnnotations(annotations);
    const auto twins = render::ankiCards(asked, {});
    QVERIFY(twins.ok());
    const QImage covered = imageNamed(*twins, twins->notes[0].covered.over);
    for (const std::size_t other : {1, 2}) {
      const QImage named = imageNamed(*twins, twins->notes[other].named.over);
      const QRect name = changed(named, imageNamed(*twins, twins->notes[other].marked.over));
      QCOMPARE(changed(covered.copy(name), named.copy(name)).isEmpty(), other == 2);
    }
  }

  /// One is given a name and looks for its number; the first of one name asks for all of them.
  void numbersAreFound() {
    const auto single = render::ankiCards(order(), {});
    QVERIFY(single.ok());
    QStringList numbers;
    for (const render::AnkiNote& note : single->notes) {
      QCOMPARE(note.numbered.over, single->notes[0].numbered.over);
      QVERIFY(note.numbered.words.find(note.label) == 0);
      QVERIFY(note.numbered.words.find("Which number is it?") != std::string::npos);
      numbers << QString::fromStdString(note.numbers);
    }
    QCOMPARE(numbers, QStringList({"1", "2", "3"}));
    render::ExportOrder asked = order();
    asked.labels.language = "de";
    std::vector<model::Annotation> annotations = asked.scene.annotations();
    annotations[2].text = annotations[0].text;
    asked.scene.setAnnotations(annotations);
    const auto deck = render::ankiCards(asked, {});
    QVERIFY(deck.ok());
    QStringList asks;
    for (const render::AnkiNote& note : deck->notes)
      asks << QString::fromStdString(note.numbers + (note.numbered.empty() ? "" : "?"));
    QCOMPARE(asks, QStringList({"1?", "2, 3?", ""}));
    QVERIFY(deck->notes[0].numbered.words.find("Welche Nummer ist es?") != std::string::npos);
  }

  /// Each view has a deck within the deck, with the labels that it shows.
  void viewsAreDecks() {
    render::ExportOrder asked = order();
    model::View front{.name = "front", .camera = asked.camera};
    front.words.title.text = "Von vorn :: {{c1::<b>eins</b>}}";
    model::View back{.name = "back", .camera = asked.camera};
    back.camera.eye = -back.camera.eye;
    back.annotations = std::vector{asked.scene.annotations()[0].id};
    model::View none{.name = "none", .camera = asked.camera};
    none.annotations = std::vector<model::AnnotationId>();
    asked.scene.setViews({front, back, none});
    asked.of<render::AnkiOptions>().deck = "Bauch";
    asked.of<render::ViewsOptions>().subject = render::ViewSubject::all;
    QCOMPARE(render::ankiCardsAtMost(asked), std::size_t(8));
    const QTemporaryDir folder;
    const QString file = folder.filePath("deck.apkg");
    QVERIFY(render::writeAnki(asked, file.toStdString(), {}).ok());
    const QString collection = collectionOf(folder, file);
    const QString col = rowsOf(collection, "SELECT decks FROM col").front().front();
    const QJsonObject decks = QJsonDocument::fromJson(col.toUtf8()).object();
    QStringList names;
    for (const QJsonValue& deck : decks)
      names << deck.toObject()["name"].toString();
    names.sort();
    QCOMPARE(names.join(' '), "Bauch Bauch::Von vorn : {{c1: <b>eins</b>}} Bauch::back Default");
    std::map<QString, int> cards;
    for (const QStringList& card :
         rowsOf(collection, "SELECT did, ord, tags FROM cards JOIN notes ON cards.nid = notes.id"))
      ++cards[decks[card[0]].toObject()["name"].toString() + card[1] + card[2]];
    QCOMPARE(cards["Bauch::Von vorn : {{c1: <b>eins</b>}}0 Sline front "], 3);
    QCOMPARE(cards["Bauch::Von vorn : {{c1: <b>eins</b>}}1 Sline front "], 3);
    QCOMPARE(cards["Bauch::back0 Sline back "], 1);
    QCOMPARE(int(cards.size()), 4);
    const auto fields = rowsOf(collection, "SELECT flds FROM notes");
    asked.marks.viewName = !asked.marks.viewName;  // the deck's, which no picture says
    QVERIFY(render::writeAnki(asked, file.toStdString(), {}).ok());
    QCOMPARE(rowsOf(collectionOf(folder, file), "SELECT flds FROM notes"), fields);
  }

  /// A callout is a sentence; nobody can guess it.
  void calloutsAreAskedOnlyIfWanted() {
    render::ExportOrder asked = order();
    std::vector<model::Annotation> annotations = asked.scene.annotations();
    annotations[1].kind = model::AnnotationKind::callout;
    asked.scene.setAnnotations(annotations);
    const auto labels = render::ankiCards(asked, {});
    QVERIFY(labels.ok());
    QCOMPARE(int(labels->notes.size()), 2);
    asked.of<render::TestOptions>().callouts = true;
    const auto all = render::ankiCards(asked, {});
    QVERIFY(all.ok());
    QCOMPARE(int(all->notes.size()), 3);
  }

  void questionGivesNoLengthAway() {
    render::ExportOrder asked = order();
    const auto before = render::ankiCards(asked, {});
    std::vector<model::Annotation> annotations = asked.scene.annotations();
    annotations[0].text = "Le";
    asked.scene.setAnnotations(annotations);
    const auto shorter = render::ankiCards(asked, {});
    QVERIFY(before.ok() && shorter.ok());
    const QRect one = markIn(imageNamed(*before, before->notes[0].marked.over));
    const QRect other = markIn(imageNamed(*shorter, shorter->notes[0].marked.over));
    QVERIFY(one.width() > 10);
    // The place of the mark between pixels may differ.
    QVERIFY(std::abs(one.width() - other.width()) <= 2);
    QVERIFY(std::abs(one.height() - other.height()) <= 2);
  }

  void package() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("deck.apkg");
    render::ExportOrder asked = order();
    asked.of<render::AnkiOptions>().deck = "Anatomie::Bauch \"1\"";
    QVERIFY(render::writeAnki(asked, file.toStdString(), {}).ok());
    const std::string bytes = readAll(file).toStdString();
    const auto zip = model::ZipReader::open(bytes);
    QVERIFY(zip.ok());
    const QString collection = collectionOf(folder, file);
    QCOMPARE(rowsOf(collection, "PRAGMA integrity_check").front().front(), QString("ok"));
    const auto cards =
        rowsOf(collection,
               "SELECT flds, sfld, tags, did, mid, type, queue, ord FROM notes JOIN cards "
               "ON cards.nid = notes.id ORDER BY due");
    QCOMPARE(int(cards.size()), 6);
    QCOMPARE(cards[0][1], QString("肝臓 „rechts“"));  // has the number 1
    QCOMPARE(cards[0][7] + cards[1][7] + cards[2][7] + cards[3][7], QString("0101"));
    QCOMPARE(cards[4][2], QString(" Sline Von_vorn__Übersicht "));
    const auto col = rowsOf(collection, "SELECT ver, models, decks FROM col").front();
    QCOMPARE(col[0], QString("11"));
    const QJsonObject decks = QJsonDocument::fromJson(col[2].toUtf8()).object();
    QCOMPARE(decks[cards[0][3]].toObject()["name"].toString(), QString("Anatomie::Bauch \"1\""));
    const QJsonObject type =
        QJsonDocument::fromJson(col[1].toUtf8()).object()[cards[0][4]].toObject();
    QCOMPARE(type["flds"].toArray().size(), 6);
    // A template asks only where its field is filled.
    const QJsonArray templates = type["tmpls"].toArray();
    QCOMPARE(templates.size(), 3);
    QCOMPARE(templates[1].toObject()["qfmt"].toString(),
             QString("{{#Numbered}}{{Numbered}}{{/Numbered}}"));
    QCOMPARE(type["req"].toArray()[2].toArray()[2].toArray()[0].toInt(), 4);
    // All pictures that notes name are there, under their numbers.
    const QJsonObject media =
        QJsonDocument::fromJson(QByteArray::fromStdString(*zip->read(*zip->find("media"))))
            .object();
    QCOMPARE(media.size(), 8);
    for (const QStringList& card : cards) {
      const QStringList fields = card[0].split(QChar(0x1f));
      QCOMPARE(fields.size(), 6);
      QVERIFY(fields[4].isEmpty());  // no name is covered
      for (const QString& picture : picturesIn(fields.join(' '))) {
        QString number;
        for (auto entry = media.begin(); entry != media.end(); ++entry)
          if (entry.value().toString() == picture)
            number = entry.key();
        const auto* member = zip->find(number.toStdString());
        QVERIFY2(member, qPrintable(picture));
        QVERIFY(!QImage::fromData(QByteArray::fromStdString(*zip->read(*member))).isNull());
      }
    }
  }

  void zipIsTheFolder() {
    const QTemporaryDir folder;
    QVERIFY(render::writeAnki(order(), folder.filePath("deck").toStdString(), {}).ok());
    QVERIFY(render::writeAnki(order(), folder.filePath("deck.ZIP").toStdString(), {}).ok());
    const std::string bytes = readAll(folder.filePath("deck.ZIP")).toStdString();
    const auto zip = model::ZipReader::open(bytes);
    QVERIFY(zip.ok());
    QCOMPARE(int(zip->entries().size()), 9);
    for (const auto& entry : zip->entries())
      QCOMPARE(QByteArray::fromStdString(*zip->read(entry)),
               readAll(folder.filePath("deck/" + QString::fromStdString(entry.name))));
  }

  void sameBytesAndSteadyIds() {
    const auto first = render::ankiCards(order(), {});
    const auto second = render::ankiCards(order(), {});
    QVERIFY(first.ok() && second.ok());
    QVERIFY(*render::ankiPackage(*first) == *render::ankiPackage(*second));
    // Another look keeps the notes and renames the pictures.
    render::ExportOrder dark = order();
    dark.environment.background = render::Background::dark;
    const auto third = render::ankiCards(dark, {});
    for (std::size_t i = 0; i < 3; ++i) {
      QCOMPARE(third->notes[i].id, first->notes[i].id);
      QVERIFY(third->notes[i].marked.over != first->notes[i].marked.over);
    }
  }

  void namesFit() {
    render::AnkiNote note;
    note.marked.ground = "a.png";
    const render::AnkiDeck deck{
        .name = "one\ntwo", .description = {}, .parts = {{}}, .notes = {note}, .media = {}};
    QVERIFY(render::ankiText(deck).ends_with("\tone two\n"));
    QCOMPARE(render::htmlText("[sound:a.mp3] {{Label}}"),
             std::string("&#91;sound:a.mp3] &#123;&#123;Label}}"));
    QCOMPARE(render::ankiTag("Vena cava::inf. 🫀"), std::string("Vena_cava__inf__🫀"));
    QCOMPARE(render::htmlText("a\x01\n<i>\xff"), std::string("a� &lt;i&gt;�"));
  }

  void someCardIsWanted() {
    render::ExportOrder asked = order();
    asked.of<render::AnkiOptions>() = {.deck = {}, .nameIt = false, .findIt = false};
    const auto deck = render::ankiCards(asked, {});
    QVERIFY(!deck.ok() && deck.error().reason.find("no kind of card") != std::string::npos);
  }

  void refusesAndStops() {
    const QTemporaryDir folder;
    const auto target = [&folder](const QString& name) {
      return std::filesystem::path(folder.filePath(name).toStdString());
    };
    render::ExportOrder bare = order();
    bare.scene.setAnnotations({});
    for (const char* name : {"deck", "deck.apkg", "deck.zip"}) {
      const Status empty = render::writeAnki(bare, target(name), {});
      QVERIFY(!empty.ok());
      QVERIFY(empty.error().reason.find("no labels") != std::string::npos);
      for (const int calls : {0, 1, 3}) {
        int asked = 0;
        const Status stopped = render::writeAnki(
            order(), target(name), [&](double, std::string_view) { return asked++ < calls; });
        QVERIFY(!stopped.ok());
        QCOMPARE(stopped.error().file, target(name).string());
      }
    }
    QVERIFY(allIn(folder.path()).isEmpty());
    QVERIFY(QDir(folder.path()).mkpath("full/of mine"));
    QVERIFY(QDir(folder.path()).mkpath("full.apkg"));
    for (const char* name :
         {"nowhere/deck", "nowhere/deck.apkg", "full", "full.apkg", "nowhere/deck.zip"}) {
      const Status written = render::writeAnki(order(), target(name), {});
      QVERIFY2(!written.ok(), name);
      QCOMPARE(written.error().file, target(name).string());
      QVERIFY(!written.error().reason.empty() && !written.error().remedy.empty());
    }
    QCOMPARE(allIn(folder.path()), QStringList({"full", "full.apkg"}));
  }
};

SLINE_TEST_WITH_GUI(AnkiTest)
#include "anki_test.moc"
