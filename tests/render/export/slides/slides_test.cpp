// SPDX-License-Identifier: Apache-2.0
// Tests presentations: every part is well formed and found, labels stand where pictures have them,
// and words stay words.
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "model/disk/zip_archive.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "render/export/pixels/pixel_files.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/slides/slide_options.h"
#include "render/export/slides/slide_page.h"
#include "render/export/slides/slides_file.h"
#include "render/export/svg/svg_file.h"
#include "render/lettering/typesetting.h"
#include "tests/render/export/slides/lesson.h"
#include "tests/render/export/slides/opened_slides.h"
#include "tests/support/suite.h"

using namespace sline;
using test::OpenedSlides;

namespace {

std::string written(const render::ExportOrder& order) {
  const QTemporaryDir folder;
  const QString name = folder.filePath("a.pptx");
  const Status status = render::writeSlides(order, name.toStdString(), {});
  if (!status.ok())
    qWarning("%s", status.error().text().c_str());
  QFile file(name);
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

/// Returns the order as its figure is laid out for a picture.
render::ExportOrder figureOf(const render::ExportOrder& order) {
  const model::View* const view = render::shownView(order);
  return view && render::showsViews(order) ? render::slideOfView(order, *view)
                                           : render::slideFigure(order, view);
}

render::SlideBox figureFrame(const render::ExportOrder& order) {
  return render::slideFrames(order.of<render::SlideOptions>().shape,
                             render::hasText(render::shownView(order), order))
      .figure;
}

glm::vec2 onSlide(const render::ExportOrder& order, const glm::vec2& place) {
  return figureFrame(order).at + render::slideScale * place;
}

double apart(const QPointF& a, const glm::vec2& b) {
  return std::hypot(a.x() - double(b.x), a.y() - double(b.y));
}

/// Returns the words without breaks and hyphens at them.
QString bare(QString words) {
  return words.replace("-\n", "").replace('\n', ' ').simplified();
}

}  // namespace

class SlidesTest : public QObject {
  Q_OBJECT

 private slots:
  void packagesAreWhole_data() {
    QTest::addColumn<int>("number");
    for (const int number : {0, 1, 3, 5, 7, 9, 14})
      QTest::newRow(qPrintable(QString("deck %1").arg(number))) << number;
  }
  void packagesAreWhole() {
    QFETCH(int, number);
    const render::ExportOrder order = test::oddLesson(number);
    const std::string bytes = written(order);
    const OpenedSlides opened(bytes);
    QVERIFY2(opened.faults().isEmpty(), qPrintable(opened.faults().join('\n')));
    QVERIFY(opened.slides() >= std::max(1, int(order.scene.views().size())));
    for (int i = 1; i <= opened.slides(); ++i)
      QVERIFY(opened.slide(i));
    // No control character is left, escaped or not.
    for (const auto& [name, text] : opened.parts())
      if (name.ends_with(".xml"))
        for (const char each : text)
          QVERIFY2(std::uint8_t(each) >= 0x20 || each == '\n', name.c_str());
    QVERIFY(written(order) == bytes);
  }

  /// The checks themselves find what is wrong.
  void spoiledPackagesAreNot_data() {
    QTest::addColumn<QString>("part");
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("after");
    const QString slide = "ppt/slides/slide1.xml";
    QTest::newRow("well formed") << slide << "</p:sld>"
                                 << "";
    QTest::newRow("relations") << slide << "rId2"
                               << "rId9";
    QTest::newRow("targets") << "ppt/_rels/presentation.xml.rels"
                             << "slide1"
                             << "slide7";
    QTest::newRow("types") << "[Content_Types].xml"
                           << "/ppt/slides/slide1"
                           << "/ppt/slides/slide2";
    QTest::newRow("numbers") << slide << "id=\"4\""
                             << "id=\"3\"";
    QTest::newRow("order") << slide << "</p:nvPr></p:nvSpPr><p:spPr/>"
                           << "</p:nvPr></p:nvSpPr><p:txBody/><p:spPr/>";
    QTest::newRow("known children") << slide << "<a:t>"
                                    << "<a:b/><a:t>";
  }
  void spoiledPackagesAreNot() {
    QFETCH(QString, part);
    QFETCH(QString, before);
    QFETCH(QString, after);
    static const OpenedSlides whole(written(test::lessonOf({"liver"})));
    std::vector<model::ZipMember> members;
    for (const auto& [name, text] : whole.parts()) {
      const bool spoiled = name == part.toStdString();
      QString content = QString::fromLatin1(text.data(), qsizetype(text.size()));
      QVERIFY(!spoiled || content.contains(before));
      if (spoiled)
        content.replace(content.indexOf(before), before.size(), after);
      members.push_back({name, content.toLatin1().toStdString()});
    }
    std::vector<const model::ZipMember*> all;
    for (const model::ZipMember& member : members)
      all.push_back(&member);
    QVERIFY(!OpenedSlides(*model::zipped(all)).faults().isEmpty());
  }

  void labelsStandAsInPictures_data() {
    QTest::addColumn<QStringList>("labels");
    QTest::addColumn<int>("shape");
    QTest::addColumn<bool>("text");
    const QStringList few{"liver", "spleen", "left kidney", "right adrenal gland", "pancreas"};
    const QStringList odd{"حوض عظم الفخذ", "Vena \"cava\" <inferior>", "🫀 heart",
                          "Musculus sternocleidomastoideus longissimus thoracis et lumborum"};
    QTest::newRow("wide") << few << int(render::SlideShape::wide) << false;
    QTest::newRow("wide with text") << few << int(render::SlideShape::wide) << true;
    QTest::newRow("standard") << few << int(render::SlideShape::standard) << false;
    QTest::newRow("standard with text") << few << int(render::SlideShape::standard) << true;
    QTest::newRow("odd names") << odd << int(render::SlideShape::wide) << false;
    QStringList many;
    for (int i = 1; i <= 100; ++i)
      many << QString("label %1").arg(i);
    QTest::newRow("a hundred") << many << int(render::SlideShape::wide) << false;
  }
  void labelsStandAsInPictures() {
    QFETCH(QStringList, labels);
    QFETCH(int, shape);
    QFETCH(bool, text);
    std::vector<std::string> names;
    for (const QString& label : labels)
      names.push_back(label.toStdString());
    render::ExportOrder order = test::lessonOf(names);
    if (names.size() > 50)
      order.labels.points = 4.0f;
    order.of<render::SlideOptions>().shape = render::SlideShape(shape);
    std::vector<model::View> views;
    if (text) {
      order.viewName = "front";
      test::addView(order, views, "front").words.text.text = "Words beside it";
      order.scene.setViews(views);
    }
    const render::FigurePlate plate = render::figurePlate(figureOf(order));
    const OpenedSlides opened(written(order));
    QVERIFY2(opened.faults().isEmpty(), qPrintable(opened.faults().join('\n')));
    const auto groups = test::groupsOn(opened.slide(1));
    const render::Lettering lettering = render::letteringOf(*plate.labels);
    int found = 0;
    for (std::size_t i = 0; i < plate.labels->labels.size(); ++i) {
      const render::ShownLabel& label = plate.labels->labels[i];
      const render::PlacedLabel* placed = plate.labels->layout.find(label.item.id);
      if (!placed)
        continue;
      const QString words = render::plainText(plate.labels->texts[i].lines);
      QVERIFY2(groups.contains(words), qPrintable(words));
      const pugi::xml_node group = groups.at(words);
      const auto box = group.select_node("p:sp[p:nvSpPr/p:cNvSpPr/@txBox]").node();
      QCOMPARE(bare(test::wordsOf(box)), words.simplified());
      checkPlace(order, box, *placed, *lettering.items[std::size_t(found)].text);
      const auto dot = group.select_node("p:sp[p:spPr/a:prstGeom/@prst='ellipse']").node();
      QVERIFY2(apart(test::placeOf(dot).center(), onSlide(order, label.item.places.front())) < 0.5,
               qPrintable(words));
      ++found;
    }
    QVERIFY2(found >= std::min<int>(int(names.size()), 40), qPrintable(QString::number(found)));
  }

  void checkPlace(const render::ExportOrder& order, const pugi::xml_node& box,
                  const render::PlacedLabel& placed, const render::LetteringText& lettered) {
    const QRectF there = test::placeOf(box);
    const glm::vec2 low = onSlide(order, placed.box.low);
    const glm::vec2 high = onSlide(order, placed.box.high);
    QVERIFY(std::abs(there.center().y() - double(0.5f * (low.y + high.y))) < 0.5);
    const std::string side = box.select_node(".//a:pPr/@algn").attribute().value();
    const double inset =
        (side == "r" ? box.select_node(".//a:bodyPr/@rIns") : box.select_node(".//a:bodyPr/@lIns"))
            .attribute()
            .as_double() /
        36'000.0;
    // The text begins where pictures have it.
    const double text = side == "r" ? there.right() - inset : there.left() + inset;
    const auto edge = double(onSlide(order, lettered.at).x);
    QVERIFY2(std::abs(text - edge) < 0.5 && there.left() > double(low.x) - 0.5 &&
                 there.right() < double(high.x) + 0.5,
             qPrintable(QString("%1 %2").arg(text).arg(edge)));
  }

  void leadersAreLinesToTheTexts() {
    render::ExportOrder order = test::lessonOf({"in front", "beside"});
    const glm::vec3 behind{0.0f, 60.0f, 0.0f};
    const auto hidden = test::addBall(order.scene, behind, 4.0f, "hidden");
    std::vector<model::Node> nodes = order.scene.nodes();
    for (model::Node& node : nodes)
      node.style.gamma = Gamma::clamped(5.0f);  // nothing shows through
    order.scene.setNodes(nodes);
    const OpenedSlides opened(written(order));
    QVERIFY2(opened.faults().isEmpty(), qPrintable(opened.faults().join('\n')));
    const render::FigurePlate plate = render::figurePlate(figureOf(order));
    QVERIFY(plate.labels->layout.find(hidden)->hidden);
    const auto groups = test::groupsOn(opened.slide(1));
    int glued = 0;
    for (const auto& [name, group] : groups) {
      const bool dashed = !group.select_nodes(".//a:ln/a:custDash").empty();
      QCOMPARE(dashed, name == QString("hidden"));
      glued += int(group.select_nodes("p:cxnSp//a:endCxn").size());
      if (name == QString("hidden"))
        QVERIFY(
            group.select_node("p:sp[p:spPr/a:prstGeom/@prst='ellipse']/p:spPr/a:ln/a:solidFill"));
    }
    // Each leader follows the text that is moved.
    int leaders = 0;
    for (const render::PlacedLabel& placed : plate.labels->layout.labels)
      leaders += placed.leader.empty() ? 0 : 1;
    QCOMPARE(leaders, 3);
    QCOMPARE(glued, leaders);
  }

  void calloutsAreFramed() {
    render::ExportOrder order = test::lessonOf({"one"});
    test::addBall(order.scene, {40.0f, 0.0f, 0.0f}, 10.0f,
                  "**Bold** words\n- first\n- *second* one that is rather long and breaks",
                  model::AnnotationKind::callout);
    test::fitCamera(order);
    const OpenedSlides opened(written(order));
    const auto frame =
        opened.slide(1).select_node("//p:sp[p:spPr/a:prstGeom/@prst='roundRect']").node();
    QVERIFY(frame);
    QCOMPARE(bare(test::wordsOf(frame)),
             QString("Bold words first second one that is rather long and breaks"));
    QCOMPARE(int(frame.select_nodes(".//a:buChar").size()), 2);
    QCOMPARE(QString(frame.select_node(".//a:r[a:rPr/@b='1']/a:t").node().child_value()),
             QString("Bold"));
    QVERIFY(frame.select_node(".//a:r[a:rPr/@i='1']"));
    QVERIFY(frame.select_node("p:spPr/a:solidFill"));
  }

  void viewsHaveTheirWords() {
    render::ExportOrder order = test::lessonOf({"liver"});
    std::vector<model::Annotation> annotations = order.scene.annotations();
    annotations[0].texts["de"] = "Leber";
    order.scene.setAnnotations(annotations);
    order.labels.language = "de+la";
    std::vector<model::View> views;
    model::View& first = test::addView(order, views, "First");
    first.words.title.texts["de"] = "Von vorn & <so>";
    first.words.text.text = "Plain **bold**\n- item";
    first.words.notes.text = "one\ntwo";
    test::addView(order, views, "anterior");
    order.scene.setViews(views);
    const OpenedSlides opened(written(order));
    QVERIFY2(opened.faults().isEmpty(), qPrintable(opened.faults().join('\n')));
    QCOMPARE(opened.slides(), 2);
    const pugi::xml_node slide = opened.slide(1);
    const auto title = slide.select_node("//p:sp[.//p:ph/@type='title']").node();
    QCOMPARE(test::wordsOf(title), QString("Von vorn & <so>"));
    QCOMPARE(std::string(title.select_node(".//a:rPr/@lang").attribute().value()), "de-DE");
    const auto text = slide.select_node("//p:sp[.//p:ph/@type='body']").node();
    QCOMPARE(test::wordsOf(text), QString("Plain bold\nitem"));
    QVERIFY(!text.select_node(".//a:rPr/@lang"));
    QCOMPARE(QString(text.select_node(".//a:r[a:rPr/@b='1']/a:t").node().child_value()),
             QString("bold"));
    QCOMPARE(int(text.select_nodes(".//a:buChar").size()), 1);
    // They are not said again in the picture, where a caption would lie over what has labels.
    QCOMPARE(test::wordsOf(slide).count("Von vorn"), 1);
    QCOMPARE(test::wordsOf(slide).count("Plain bold"), 1);
    const auto groups = test::groupsOn(slide);
    QVERIFY(groups.contains("Leber"));
    QCOMPARE(std::string(groups.at("Leber").select_node(".//a:rPr/@lang").attribute().value()),
             "de-DE");
    const std::string notes = opened.target("ppt/slides/slide1.xml", "notesSlide");
    QVERIFY(opened.has(notes));
    QCOMPARE(test::wordsOf(opened.root(notes)), QString("one\ntwo"));
    // A side of the body is called in the language of the labels; what is not said has no place.
    QCOMPARE(test::wordsOf(opened.slide(2)).section('\n', 0, 0), QString("Ansicht von vorn"));
    QVERIFY(!opened.slide(2).select_node("//p:ph[@type='body']"));
    QVERIFY(opened.target("ppt/slides/slide2.xml", "notesSlide").empty());
    // What is shown alone has one slide.
    order.of<render::ViewsOptions>().subject = render::ViewSubject::shown;
    order.viewName = "First";
    const OpenedSlides shown(written(order));
    QCOMPARE(shown.slides(), 1);
    QCOMPARE(test::wordsOf(shown.slide(1)).section('\n', 0, 0), QString("Von vorn & <so>"));
  }

  void rightToLeft() {
    const OpenedSlides opened(written(test::lessonOf({"حوض عظم الفخذ", "liver"})));
    const auto groups = test::groupsOn(opened.slide(1));
    for (const auto& [name, group] : groups)
      QCOMPARE(std::string(group.select_node(".//a:pPr/@rtl").attribute().value()),
               std::string(name.isRightToLeft() ? "1" : "0"));
    QVERIFY(groups.contains("liver") && groups.contains("حوض عظم الفخذ"));
    // The bullets of a list stand at its right.
    render::ExportOrder order = test::lessonOf({"one"});
    test::addBall(order.scene, {40.0f, 0.0f, 0.0f}, 10.0f, "المثانة\n- العضلة\n- المثلث",
                  model::AnnotationKind::callout);
    test::fitCamera(order);
    const OpenedSlides listed(written(order));
    QVERIFY2(listed.faults().isEmpty(), qPrintable(listed.faults().join('\n')));
    const auto paragraphs = listed.slide(1).select_nodes(
        "//p:sp[p:spPr/a:prstGeom/@prst='roundRect']//a:pPr[@rtl='1' and @algn='r']");
    QCOMPARE(int(paragraphs.size()), 3);
  }

  void picturesAreSvgWithPixels() {
    render::ExportOrder order = test::lessonOf({"QZXLABEL"});
    const OpenedSlides opened(written(order));
    const auto blip = opened.slide(1).select_node("//p:pic//a:blip").node();
    QCOMPARE(std::string(blip.attribute("r:embed").value()), "rId2");
    QCOMPARE(std::string(blip.select_node(".//asvg:svgBlip/@r:embed").attribute().value()), "rId3");
    const QImage pixels =
        QImage::fromData(QByteArray::fromStdString(opened.parts().at("ppt/media/image1.png")));
    const glm::ivec2 size = render::pixelsOf(figureOf(order).page);
    QCOMPARE(pixels.size(), QSize(size.x, size.y));
    const std::string& svg = opened.parts().at("ppt/media/image1.svg");
    QVERIFY(svg.find("<path") != std::string::npos);
    // Labels are on the slide, and not in the picture.
    QVERIFY(svg.find("<text") == std::string::npos);
    QVERIFY(!opened.slide(1).select_nodes("//p:grpSp").empty());
  }

  /// The test asks what others ask, and nothing where there is nothing to ask.
  void testsAskSomeThings() {
    render::ExportOrder order = test::lessonOf({"aorta", "vena cava", "liver"});
    order.of<render::SlideOptions>().selfTest = true;
    order.of<render::TestOptions>().names = "Vena-Cava, liver";
    const OpenedSlides some(written(order));
    QCOMPARE(some.slides(), 3);
    // One label of three has no number.
    QCOMPARE(test::groupsOn(some.slide(1)).size(), test::groupsOn(some.slide(2)).size() + 1);
    QVERIFY(test::groupsOn(some.slide(1)).contains("aorta"));
    const QString key = test::wordsOf(some.slide(3));
    QVERIFY2(key.contains("vena cava") && key.contains("liver") && !key.contains("aorta"),
             qPrintable(key));
    order.of<render::TestOptions>() = {.of = render::AskedOf::focus};
    QCOMPARE(OpenedSlides(written(order)).slides(), 1);
  }

  /// Where labels are numbers on the slide, the test and its key have the same.
  void testsKeepNumbers() {
    render::ExportOrder order = test::lessonOf({"aorta", "vena cava", "liver"});
    order.labels.mode = render::LabelMode::numbers;
    order.of<render::SlideOptions>().selfTest = true;
    const auto numberOf = [](const OpenedSlides& slides, const QString& name) {
      for (const QString& line : test::wordsOf(slides.slide(3)).split('\n').mid(1))
        if (line.section(QChar(0x2002), 1) == name)
          return line.section(QChar(0x2002), 0, 0);
      return QString();
    };
    const OpenedSlides all(written(order));
    for (const char* name : {"aorta", "vena cava", "liver"}) {
      order.of<render::TestOptions>().names = name;
      const OpenedSlides alone(written(order));
      QCOMPARE(alone.slides(), 3);
      QCOMPARE(numberOf(alone, name), numberOf(all, name));
      QVERIFY(!numberOf(alone, name).isEmpty());
    }
  }

  void labelsByClicks() {
    render::ExportOrder order = test::lessonOf({"one", "two", "three"});
    QVERIFY(!OpenedSlides(written(order)).slide(1).child("p:timing"));
    order.of<render::SlideOptions>().onClick = true;
    const OpenedSlides opened(written(order));
    QVERIFY2(opened.faults().isEmpty(), qPrintable(opened.faults().join('\n')));
    const auto groups = test::groupsOn(opened.slide(1));
    QStringList appearing;
    for (const auto& target : opened.slide(1).select_nodes("//p:spTgt"))
      for (const auto& [name, group] : groups)
        if (std::string(group.select_node("p:nvGrpSpPr/p:cNvPr/@id").attribute().value()) ==
            target.node().attribute("spid").value())
          appearing << name;
    QCOMPARE(appearing, QStringList({"one", "two", "three"}));
    QCOMPARE(int(opened.slide(1).select_nodes("//p:cTn[@nodeType='clickEffect']").size()), 3);
    std::set<int> ids;
    for (const auto& node : opened.slide(1).select_nodes("//p:cTn"))
      QVERIFY(ids.insert(node.node().attribute("id").as_int()).second);
  }

  void selfTestsHaveKeys() {
    render::ExportOrder order = test::lessonOf({"liver", "spleen", "kidney"});
    order.of<render::SlideOptions>().selfTest = true;
    const OpenedSlides opened(written(order));
    QCOMPARE(opened.slides(), 3);
    const QString test = test::wordsOf(opened.slide(2));
    const QString key = test::wordsOf(opened.slide(3));
    const std::string asked = opened.parts().at("ppt/slides/slide2.xml");
    for (const char* name : {"liver", "spleen", "kidney"}) {
      QVERIFY2(asked.find(name) == std::string::npos, name);
      QVERIFY2(key.contains(name), name);
    }
    // Each number stands at what the key says.
    const auto shown = test::groupsOn(opened.slide(1));
    const auto numbered = test::groupsOn(opened.slide(2));
    for (const QString& line : key.split('\n').mid(1)) {
      const QString number = line.section(QChar(0x2002), 0, 0);
      const QString name = line.section(QChar(0x2002), 1);
      const auto dot = [](const pugi::xml_node& group) {
        return test::placeOf(group.select_node("p:sp[p:spPr/a:prstGeom/@prst='ellipse']").node())
            .center();
      };
      QVERIFY2(numbered.contains(number) && shown.contains(name), qPrintable(line));
      const QPointF way = dot(numbered.at(number)) - dot(shown.at(name));
      QVERIFY2(std::hypot(way.x(), way.y()) < 1.0, qPrintable(line));
    }
    QVERIFY(opened.target("ppt/slides/slide2.xml", "image") ==
            opened.target("ppt/slides/slide1.xml", "image"));
    order.labels.mode = render::LabelMode::off;
    QCOMPARE(OpenedSlides(written(order)).slides(), 1);
  }

  void longWordsAreSmaller() {
    render::ExportOrder order = test::lessonOf({"liver"});
    order.viewName = "front";
    std::vector<model::View> views;
    model::View& view = test::addView(order, views, "front");
    for (int i = 0; i < 300; ++i)
      view.words.text.text += "words ";
    view.words.title.text = "short";
    order.scene.setViews(views);
    const OpenedSlides opened(written(order));
    const auto fit = [&](const char* type) {
      const std::string way = std::string("//p:sp[.//p:ph/@type='") + type + "']//a:normAutofit";
      return opened.slide(1).select_node(way.c_str()).node().attribute("fontScale").as_int(100'000);
    };
    QCOMPARE(fit("title"), 100'000);
    QVERIFY2(fit("body") < 75'000 && fit("body") >= 25'000,
             qPrintable(QString::number(fit("body"))));
  }

  void sayNothingUnasked() {
    render::ExportOrder order = test::lessonOf({"liver"});
    const OpenedSlides plain(written(order));
    QVERIFY(!plain.root("docProps/core.xml").child("dc:creator"));
    order.credit = {"Zoë <&", "CC BY 4.0"};
    const OpenedSlides opened(written(order));
    const pugi::xml_node core = opened.root("docProps/core.xml");
    QCOMPARE(QString(core.child_value("dc:creator")), QString("Zoë <&"));
    QCOMPARE(QString(core.child_value("dc:description")), QString("CC BY 4.0"));
  }

  void areHardlyLargerThanTheirPictures() {
    render::ExportOrder order = test::lessonOf({"liver", "spleen", "kidney", "heart"});
    order.page.dpi = 300.0f;
    const std::size_t slides = written(order).size();
    const render::ExportOrder figure = figureOf(order);
    const QTemporaryDir folder;
    const QString svg = folder.filePath("a.svg");
    const QString png = folder.filePath("a.png");
    QVERIFY(render::writeSvg(figure, svg.toStdString(), {}).ok());
    QVERIFY(render::writePng(figure, png.toStdString(), {}).ok());
    const qint64 both = QFileInfo(svg).size() + QFileInfo(png).size();
    // Of such small pictures what every presentation has is a part: 12 kB.
    QVERIFY2(double(slides) < 1.2 * double(both) + 12e3,
             qPrintable(QString("%1 of %2").arg(slides).arg(both)));
  }

  void stopsWhenAsked() {
    const QTemporaryDir folder;
    const QString name = folder.filePath("a.pptx");
    const auto never = [](double share, std::string_view) { return share < 0.3; };
    QVERIFY(!render::writeSlides(test::lessonOf({"liver"}), name.toStdString(), {never}).ok());
    QVERIFY(!QFile::exists(name));
  }
};

SLINE_TEST_WITH_GUI(SlidesTest)
#include "slides_test.moc"
