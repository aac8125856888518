// SPDX-License-Identifier: Apache-2.0
// Tests the students' page as a file: its parts, its policy, and that texts stay texts and what is
// not to be named is not.
#include <QCryptographicHash>
#include <QRegularExpression>

#include "model/edit/views.h"
#include "render/export/students/students_options.h"
#include "render/export/students/web_program.h"
#include "tests/render/export/slides/lesson.h"
#include "tests/render/export/students/page_parts.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

using nlohmann::json;

bool says(const std::string& html, std::string_view words) {
  return html.find(words) != std::string::npos;
}

QByteArray hashOf(const QByteArray& text) {
  return "'sha256-" + QCryptographicHash::hash(text, QCryptographicHash::Sha256).toBase64() + "'";
}

/// Returns a scene of three organs in a group, one of which is in focus, with a view that says
/// something.
render::ExportOrder organs() {
  render::ExportOrder order = lessonOf({"liver", "spleen", "left kidney"});
  order.page.sizeMm = {160.0f, 90.0f};
  std::vector<model::Node> nodes = order.scene.nodes();
  nodes[0].name = "liver";
  order.scene.setNodes(nodes);
  model::Annotation callout;
  callout.kind = model::AnnotationKind::callout;
  callout.text = "The **largest** gland; see [the spleen](#structure=spleen)\n- one\n- two";
  callout.anchors = {model::SurfacePoint{nodes[0].id, 1, {0.3f, 0.3f}}};
  order.scene.appendAnnotation(callout);
  std::vector<model::View> views;
  model::View& view = addView(order, views, "Front");
  view.words.title.text = "In front";
  view.words.title.texts["de"] = "Von vorn";
  view.words.text.text = "Look at *this*: [back](#view=1)";
  view.words.notes.text = "QZXNOTES";
  order.scene.setViews(views);
  return order;
}

}  // namespace

class StudentsPageTest : public QObject {
  Q_OBJECT

 private slots:
  void allIsInOneFile() {
    const render::StudentsPage page = pageOf(organs());
    QVERIFY(page.files.empty());
    QVERIFY(QByteArray::fromStdString(page.html).startsWith("<!doctype html>\n<html lang=\"en\""));
    QVERIFY(!says(page.html, "{{"));
    const QByteArray style = elementOf(page.html, "<style>");
    const QByteArray script = elementOf(page.html, "<script>");
    const QByteArray policy =
        attributeOf(page.html, "<meta http-equiv=\"Content-Security-Policy\"", "content");
    QCOMPARE(policy, "default-src 'none'; script-src " + hashOf(script) +
                         " 'wasm-unsafe-eval'; style-src " + hashOf(style) +
                         "; img-src data: blob:; base-uri 'none'; form-action 'none'");
    // All of the script, in which no text ends the element.
    const std::string bundled = render::pageTemplate()->script;
    QVERIFY(bundled.find("</script") != std::string::npos);
    QCOMPARE(script, QByteArray::fromStdString(bundled)
                         .replace("</script", "<\\/script")
                         .replace("<!--", "<\\!--"));
    QVERIFY(script.contains("\"<\\/script>\" + \"<\\!--\""));
    QCOMPARE(gunzipped(QByteArray::fromBase64(
                 elementOf(page.html, "<script type=\"text/plain\" id=\"program\""))),
             QByteArray::fromStdString(render::pageTemplate()->wasm));
    QVERIFY(!gunzipped(QByteArray::fromBase64(
                           elementOf(page.html, "<script type=\"text/plain\" id=\"scene\"")))
                 .isEmpty());
    QCOMPARE(pageOf(organs()).html, page.html);
  }

  void filesBesideEachOther() {
    render::StudentsOptions own{.title = "Lesson", .folder = true};
    const render::StudentsPage page = pageOf(organs(), own);
    for (const char* name : {"page.css", "page.js", "engine.wasm", "anatomy.scene"})
      QVERIFY2(page.files.contains(name), name);
    QVERIFY(says(page.html, "data-src=\"engine.wasm\"") &&
            says(page.html, "<script src=\"page.js\">"));
    QCOMPARE(elementOf(page.html, "<script type=\"text/plain\" id=\"program\""), QByteArray());
    const QByteArray policy =
        attributeOf(page.html, "<meta http-equiv=\"Content-Security-Policy\"", "content");
    QVERIFY2(policy.contains("script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; connect-src "
                             "'self'; img-src"),
             policy.constData());
    // What is the same for every scene is.
    const render::StudentsPage other = pageOf(lessonOf({"heart"}), own);
    for (const char* name : {"page.css", "page.js", "engine.wasm"})
      QVERIFY2(page.files.at(name) == other.files.at(name), name);
    QVERIFY(page.files.at("anatomy.scene") != other.files.at("anatomy.scene"));
    // A learning system may be elsewhere.
    own.report = "cmi5";
    const render::StudentsPage told = pageOf(organs(), own);
    QVERIFY(says(told.html, "connect-src 'self' https: http:;"));
    QCOMPARE(factsOf(told.html)["report"], json("cmi5"));
    QVERIFY(!factsOf(page.html).contains("report"));
  }

  void facts() {
    render::ExportOrder order = organs();
    order.credit = {.author = "Jane Doe", .copyright = "CC BY 4.0"};
    const render::StudentsPage page = pageOf(order);
    const json facts = factsOf(page.html);
    QCOMPARE(facts["schema"], json(1));
    QCOMPARE(facts["title"], json("Lesson"));
    QCOMPARE(facts["languages"], json({"en", "la", "de", "nl", "nb"}));
    QCOMPARE(facts["credits"], json({"Jane Doe, CC BY 4.0"}));
    const json& liver = facts["nodes"][0];
    QCOMPARE(liver["names"]["de"], json("Leber"));
    QCOMPARE(liver["group"], json(false));
    QCOMPARE(liver["gamma"], json(2.0));
    QCOMPARE(liver["colour"], json("#c8c8c8"));
    const json spleen = facts["nodes"][1]["id"];
    QCOMPARE(liver["note"]["en"],
             json::parse("[[{\"text\":\"The \"},{\"text\":\"largest\",\"bold\":true},{\"text\":\" "
                         "gland; see \"},{\"text\":\"the spleen\",\"structure\":" +
                         spleen.dump() +
                         "}],[{\"text\":\"\u2022 \"},{\"text\":\"one\"}],[{\"text\":\"\u2022 "
                         "\"},{\"text\":\"two\"}]]"));
    QCOMPARE(facts["views"].size(), std::size_t(1));
    const json& view = facts["views"][0];
    QCOMPARE(view["title"]["de"], json("Von vorn"));
    QCOMPARE(view["title"]["nb"], json("In front"));
    QCOMPARE(view["words"]["en"],
             json::parse("[[{\"text\":\"Look at \"},{\"text\":\"this\",\"italic\":true},{\"text\":"
                         "\": \"},{\"text\":\"back\",\"view\":1}]]"));
    QVERIFY(view["alt"]["en"].get<std::string>().starts_with("Drawing of 3 structures"));
    QVERIFY(facts["alt"]["de"].get<std::string>().starts_with("Zeichnung von 3 Strukturen"));
    QCOMPARE(facts["labels"].size(), std::size_t(4));
    QCOMPARE(facts["labels"][1]["kind"], json("label"));
    QCOMPARE(facts["labels"][1]["words"]["de"], json::parse("[[{\"text\":\"Milz\"}]]"));
    QCOMPARE(facts["labels"][1]["structures"], json({spleen}));
    QVERIFY(!unpackedPage(page).contains("QZXNOTES"));
  }

  void stills() {
    const std::string html = pageOf(organs()).html;
    const QByteArray figure = elementOf(html, "<figure>");
    QVERIFY(figure.contains("<h2>In front</h2>"));
    QVERIFY(figure.contains("<p>Look at this: back</p>"));
    QVERIFY(figure.contains("<li value=\"1\">"));
    QVERIFY(figure.contains("left kidney</li>"));
    QVERIFY(attributeOf(html, "<img", "alt").startsWith("Drawing of 3 structures, seen from the"));
    const QByteArray source = attributeOf(html, "<img", "src");
    QVERIFY(source.startsWith("data:image/webp;base64,"));
    QCOMPARE(QByteArray::fromBase64(source.mid(23)).mid(8, 4), QByteArray("WEBP"));
  }

  void languages() {
    render::ExportOrder order = organs();
    order.labels.language = "de";
    QCOMPARE(factsOf(pageOf(order).html)["language"], json("de"));
    QVERIFY(says(pageOf(order).html, "<html lang=\"de\" dir=\"ltr\">"));
    QVERIFY(says(pageOf(order).html, "<h2>Von vorn</h2>"));
    const json few =
        factsOf(pageOf(order, {.title = "Lesson", .languages = "la, nl"}).html)["languages"];
    QCOMPARE(few, json({"de", "la", "nl"}));
    order.labels.language = "ar";
    QVERIFY(says(pageOf(order).html, "<html lang=\"ar\" dir=\"rtl\">"));
  }

  /// What is in focus comes first, all else afterwards.
  void focusFirst() {
    render::ExportOrder order = organs();
    const char* later = "<script type=\"text/plain\" id=\"scene-context\"";
    QVERIFY(elementOf(pageOf(order).html, later).isEmpty());
    model::Focus focus;
    focus.targets = {order.scene.nodes()[1].id};
    order.scene.setFocus(focus);
    const std::string html = pageOf(order).html;
    QVERIFY(!elementOf(html, later).isEmpty());
    QCOMPARE(factsOf(html)["nodes"][1]["focus"], json(true));
    QCOMPARE(factsOf(html)["nodes"][0]["focus"], json(false));
  }

  void textsStayTexts_data() {
    QTest::addColumn<QString>("text");
    for (const char* text :
         {"<img src=x onerror=alert(1)>", "</script><script>alert(1)</script>", "<!--<script>",
          "\" onload=\"alert(1)", "</title><b>", "&lt;b&gt; &amp;", "{{SCRIPT}} {{FACTS}}", "]]>",
          "\u2028\u2029 \x01\x1b[31m", "\u202eabc", "${alert(1)} `"})
      QTest::newRow(text) << QString::fromUtf8(text);
  }
  void textsStayTexts() {
    QFETCH(QString, text);
    const std::string hostile = text.toStdString();
    render::ExportOrder order = organs();
    std::vector<model::Node> nodes = order.scene.nodes();
    for (model::Node& node : nodes)
      node.name = hostile;
    order.scene.setNodes(nodes);
    std::vector<model::Annotation> annotations = order.scene.annotations();
    for (model::Annotation& annotation : annotations)
      annotation.text = hostile;
    annotations[0].texts["de"] = hostile;
    order.scene.setAnnotations(annotations);
    std::vector<model::View> views = order.scene.views();
    views[0].name = hostile;
    views[0].words.title.text = views[0].words.text.text = hostile;
    views[0].words.description.text = hostile;
    order.scene.setViews(views);
    order.credit.author = hostile;
    const std::string html = pageOf(order, {.title = hostile}).html;
    const json facts = factsOf(html);
    QCOMPARE(facts["title"], json(hostile));
    QCOMPARE(facts["nodes"][0]["names"]["en"], json(hostile));
    QCOMPARE(facts["labels"][0]["words"]["de"][0][0]["text"], json(hostile));
    const QByteArray page = QByteArray::fromStdString(html);
    // There are as many tags as in a page without such texts.
    const QByteArray calm = QByteArray::fromStdString(pageOf(organs()).html);
    for (const char* tag : {"<script", "</script", "<img", "<title", "</title", "<!--", "<b>"})
      QVERIFY2(page.count(tag) <= calm.count(tag), tag);
    QCOMPARE(page.count("onload=\"alert"), 0);
    QCOMPARE(
        attributeOf(html, "<meta http-equiv=\"Content-Security-Policy\"", "content"),
        attributeOf(calm.toStdString(), "<meta http-equiv=\"Content-Security-Policy\"", "content"));
  }

  void oddScenes() {
    for (int number = 0; number < 12; ++number) {
      const json facts = factsOf(pageOf(oddLesson(number)).html);
      QVERIFY2(facts.is_object(), std::to_string(number).c_str());
    }
  }

  /// Nothing names a structure in clear: no text, no attribute, no packed data.
  void quizAloneNamesNothing() {
    render::ExportOrder order = lessonOf({"liverquzx", "spleenquzx", "left kidney"});
    std::vector<model::Node> nodes = order.scene.nodes();
    nodes[1].name = "ventricle";
    order.scene.setNodes(nodes);
    std::vector<model::View> views;
    addView(order, views, "The liverquzx in front").words.text.text = "Here is the liverquzx";
    views.back().words.description.text = "A liverquzx";
    order.scene.setViews(views);
    order.viewName = "The liverquzx";
    const std::vector<QByteArray> names{"liverquzx", "spleenquzx", "kidney",
                                        "Niere",     "ren sin",    "ventricle"};
    const QByteArray open = unpackedPage(pageOf(order));
    for (const QByteArray& name : names)
      QVERIFY2(open.contains(name) || name == "ren sin", name.constData());
    for (const bool folder : {false, true}) {
      const render::StudentsPage page =
          pageOf(order, {.quiz = render::QuizMode::only, .folder = folder});
      const QByteArray all = unpackedPage(page);
      for (const QByteArray& name : names)
        QVERIFY2(!all.toLower().contains(name.toLower()), name.constData());
      const json facts = factsOf(page.html);
      QCOMPARE(facts["quiz"]["mode"], json("only"));
      QCOMPARE(facts["quiz"]["questions"].size(), std::size_t(3));
      for (const json& question : facts["quiz"]["questions"]) {
        QCOMPARE(question["kind"], json("name"));
        QVERIFY(!question.contains("words") && !question["answers"].empty());
      }
      QCOMPARE(facts["title"], json("Anatomy"));
      QCOMPARE(facts["views"][0]["title"]["en"], json("Anterior view"));
      QCOMPARE(elementOf(page.html, "<ol>"), QByteArray());
    }
  }

  void whatIsNeverShown() {
    render::ExportOrder order = organs();
    std::vector<model::Node> nodes = order.scene.nodes();
    nodes[2].style.visible = false;
    nodes[2].name = "QZXHIDDEN";
    order.scene.setNodes(nodes);
    std::vector<model::View> views;
    addView(order, views, "Without");
    order.scene.setViews(views);
    QCOMPARE(factsOf(pageOf(order).html)["nodes"].size(), std::size_t(2));
    QVERIFY(!unpackedPage(pageOf(order)).contains("QZXHIDDEN"));
    // What one view shows is there, hidden.
    for (model::Look& look : *views[0].looks)
      look.style.visible = true;
    order.scene.setViews(views);
    const json facts = factsOf(pageOf(order).html);
    QCOMPARE(facts["nodes"].size(), std::size_t(3));
    QCOMPARE(facts["nodes"][2]["visible"], json(false));
  }

  void noPicturesAreDescribed() {
    render::ExportOrder order = organs();
    order.altText = "off";
    QCOMPARE(factsOf(pageOf(order).html)["alt"], json::object());
    order.altText = "Said by hand";
    QCOMPARE(factsOf(pageOf(order).html)["alt"]["nl"], json("Said by hand"));
  }

  void withoutItsProgram() {
    const QByteArray before = qgetenv("SLINE_PAGE");
    qputenv("SLINE_PAGE", "/nowhere");
    const auto page = render::studentsPage(organs(), {}, {});
    qputenv("SLINE_PAGE", before);
    QVERIFY(!page.ok());
    QVERIFY2(page.error().text().find("install emscripten") != std::string::npos,
             page.error().text().c_str());
  }

  void stopsWhereItIsNotWanted() {
    const auto page = render::studentsPage(
        organs(), {}, [](double share, std::string_view) { return share < 0.3; });
    QVERIFY(!page.ok());
    QCOMPARE(page.error().reason, std::string("the export was stopped"));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::StudentsPageTest)
#include "students_page_test.moc"
