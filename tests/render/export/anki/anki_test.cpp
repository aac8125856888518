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
#include <memory>

#include "render/export/anki/anki_cards.h"
#include "render/export/anki/anki_file.h"
#include "render/export/anki/anki_options.h"
#include "render/export/anki/anki_package.h"
#include "render/export/anki/anki_text.h"
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

QString pictureIn(const QString& html) {
  static const QRegularExpression image("^<img src=\"([a-z0-9.-]+)\" alt=\"[^<>\"]*\">");
  return image.match(html).captured(1);
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
    QVERIFY(text.startsWith("#separator:tab\n#html:true\n#columns:Id\tFront\tBack\tTags\n"));
    QVERIFY(text.contains("\n#deck:Von vorn: Übersicht\n"));
    const auto notes = notesIn(text);
    QCOMPARE(int(notes.size()), 3);
    QStringList labels;
    QStringList pictures{"deck.txt"};
    for (const QStringList& note : notes) {
      QCOMPARE(note.size(), 4);
      for (const int column : {1, 2}) {
        pictures << pictureIn(note[column]);
        QVERIFY2(!QImage(deck + "/" + pictures.last()).isNull(), qPrintable(note[column]));
      }
      labels << note[2].mid(note[2].indexOf("<br>") + 4);
      QCOMPARE(note[3], QString("Sline Von_vorn__Übersicht"));
    }
    QCOMPARE(labels, QStringList({"Leber &amp; &lt;b&gt;Galle&lt;/b&gt;", "肝臓 „rechts“",
                                  "Ren &quot;dexter&quot;"}));
    // There are six pictures, all different, and nothing else.
    pictures.sort();
    QCOMPARE(pictures.removeDuplicates(), 0);
    QCOMPARE(allIn(deck), pictures);
    QVERIFY(!text.contains("planted"));
  }

  void questionsAskForOneLabel_data() {
    QTest::addColumn<bool>("others");
    QTest::newRow("others hidden") << false;
    QTest::newRow("others shown") << true;
  }
  void questionsAskForOneLabel() {
    QFETCH(bool, others);
    render::ExportOrder asked = order();
    asked.of<render::AnkiOptions>().othersShown = others;
    asked.page.dpi = 150.0f;
    const auto deck = render::ankiCards(asked, {});
    QVERIFY(deck.ok());
    QCOMPARE(int(deck->notes.size()), 3);
    std::vector<QRect> boxes;
    for (const render::AnkiNote& note : deck->notes) {
      const QImage question = imageNamed(*deck, note.question);
      const QImage answer = imageNamed(*deck, note.answer);
      QCOMPARE(question.size(), QSize(945, 531));
      boxes.push_back(changed(question, answer));
      // Only the text changes, beside the anatomy.
      QVERIFY(!boxes.back().isEmpty());
      QVERIFY2(boxes.back().width() < 300 && boxes.back().height() < 60,
               qPrintable(QString("%1 × %2").arg(boxes.back().width()).arg(boxes.back().height())));
      // Something yellow marks the question.
      int yellow = 0;
      QRect asking;
      for (int y = boxes.back().top(); y <= boxes.back().bottom(); ++y)
        for (int x = boxes.back().left(); x <= boxes.back().right(); ++x) {
          const QColor c = question.pixelColor(x, y);
          if (c.red() > 220 && c.blue() < 160) {
            ++yellow;
            asking = asking.united(QRect(x, y, 1, 1));
          }
        }
      // The question shows none of the text, which is longer than the mark.
      QVERIFY(boxes.back().width() > asking.width() + 10);
      QVERIFY(yellow > 200);
    }
    for (std::size_t i = 0; i < 3; ++i)
      QVERIFY(!boxes[i].intersects(boxes[(i + 1) % 3]));
    // This compares what one card shows in the place where another has its label.
    const QImage first = imageNamed(*deck, deck->notes[0].answer);
    const QImage second = imageNamed(*deck, deck->notes[1].answer);
    QCOMPARE(changed(first, second).isEmpty(), others);
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
    asked.of<render::AnkiOptions>().calloutsAsked = true;
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
    const QImage one = imageNamed(*before, before->notes[0].question);
    const QImage other = imageNamed(*shorter, shorter->notes[0].question);
    const auto yellow = [](const QImage& image) {
      int count = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          count += image.pixelColor(x, y).blue() < 160 && image.pixelColor(x, y).red() > 220;
      return count;
    };
    QVERIFY(yellow(one) > 20);
    // The place of the mark between pixels may differ.
    QVERIFY(std::abs(yellow(one) - yellow(other)) <= yellow(one) / 5);
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
    const QString collection = folder.filePath("collection.anki2");
    QFile out(collection);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(QByteArray::fromStdString(*zip->read(*zip->find("collection.anki2"))));
    out.close();
    QCOMPARE(rowsOf(collection, "PRAGMA integrity_check").front().front(), QString("ok"));
    const auto cards =
        rowsOf(collection,
               "SELECT flds, sfld, tags, did, mid, type, queue FROM notes JOIN cards "
               "ON cards.nid = notes.id ORDER BY due");
    QCOMPARE(int(cards.size()), 3);
    QCOMPARE(cards[0][1], QString("Leber &amp; &lt;b&gt;Galle&lt;/b&gt;"));
    QCOMPARE(cards[2][2], QString(" Sline Von_vorn__Übersicht "));
    const auto col = rowsOf(collection, "SELECT ver, models, decks FROM col").front();
    QCOMPARE(col[0], QString("11"));
    const QJsonObject decks = QJsonDocument::fromJson(col[2].toUtf8()).object();
    QCOMPARE(decks[cards[0][3]].toObject()["name"].toString(), QString("Anatomie::Bauch \"1\""));
    const QJsonObject type =
        QJsonDocument::fromJson(col[1].toUtf8()).object()[cards[0][4]].toObject();
    QCOMPARE(type["flds"].toArray().size(), 3);
    // All pictures that notes name are there, under their numbers.
    const QJsonObject media =
        QJsonDocument::fromJson(QByteArray::fromStdString(*zip->read(*zip->find("media"))))
            .object();
    QCOMPARE(media.size(), 6);
    for (const QStringList& card : cards) {
      const QStringList fields = card[0].split(QChar(0x1f));
      QCOMPARE(fields.size(), 3);
      for (const int field : {1, 2}) {
        QString number;
        for (auto entry = media.begin(); entry != media.end(); ++entry)
          if (entry.value().toString() == pictureIn(fields[field]))
            number = entry.key();
        const auto* member = zip->find(number.toStdString());
        QVERIFY2(member, qPrintable(fields[field]));
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
    QCOMPARE(int(zip->entries().size()), 7);
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
      QVERIFY(third->notes[i].question != first->notes[i].question);
    }
  }

  void namesFit() {
    render::AnkiDeck deck{.name = "one\ntwo", .tags = {}, .notes = {}, .media = {}};
    QVERIFY(render::ankiText(deck).find("#deck:one two\n") != std::string::npos);
    QCOMPARE(render::ankiTag("Vena cava::inf. 🫀"), std::string("Vena_cava__inf__🫀"));
    QCOMPARE(render::htmlText("a\x01\n<i>\xff"), std::string("a� &lt;i&gt;�"));
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
