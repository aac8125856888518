// SPDX-License-Identifier: Apache-2.0
// Tests that of each kind of file the order has what files of that kind have, whoever asked, and
// that each picture of a saved view shows all that the view shows, whatever the page's shape.
#include <QtTest>
#include <cmath>

#include "model/camera/camera_moves.h"
#include "model/edit/views.h"
#include "render/export/formats/assembled.h"
#include "render/export/motion/film.h"
#include "render/export/motion/film_options.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/slides/slide_page.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {
namespace {

using render::ExportFormat;
using render::ExportOrder;
using render::ExportWish;
using render::ViewSubject;

constexpr float apart = 100.0f;  // mm, of the two balls from the middle

/// Two balls side by side, seen whole on a wide page from the front and from behind.
model::Scene twoBalls() {
  model::Scene scene;
  for (const float x : {-apart, apart})
    scene.append(
        {.name = x < 0.0f ? "Right" : "Left", .mesh = moved(*sphere(15.0f, 3), 1.0f, {x, 0, 0})});
  std::vector<model::View> views;
  for (const float y : {-400.0f, 400.0f}) {
    model::Camera camera{.eye = {0.0f, y, 0.0f}, .target = {}, .up = {0.0f, 0.0f, 1.0f}};
    camera.projection = model::Projection::orthographic;
    camera.heightMm = 140.0f;  // 249 mm wide on a wide page
    views.push_back({.name = y < 0.0f ? "Front" : "Back", .camera = camera});
  }
  scene.setViews(views);
  return scene;
}

ExportWish wishFor(const glm::vec2& pageMm, ViewSubject subject) {
  ExportWish wish;
  wish.order.scene = twoBalls();
  wish.order.camera = wish.order.scene.views().front().camera;
  wish.order.page.sizeMm = pageMm;
  wish.order.of<render::ViewsOptions>().subject = subject;
  wish.target = "/nowhere/balls";
  return wish;
}

/// Tells whether both balls lie on the page.
bool showsAll(const ExportOrder& order) {
  for (const float x : {-apart - 15.0f, apart + 15.0f}) {
    const glm::vec2& page = order.page.sizeMm;
    const auto at = model::pixelOf(order.camera, {x, 0.0f, 0.0f}, page);
    if (!at || !(at->x >= -0.01f && at->x <= page.x + 0.01f))
      return false;
  }
  return true;
}

}  // namespace

class AssembledTest : public QObject {
  Q_OBJECT

 private slots:
  void viewsFitTheirPages_data();
  void viewsFitTheirPages();
  void toursFitTheirPages();
  void whatTheKindHas();
  void framedOnTheirOwnPage();
  void framingMayFail();
  void inkComesLast();
};

void AssembledTest::viewsFitTheirPages_data() {
  QTest::addColumn<QString>("kind");
  QTest::addColumn<glm::vec2>("page");
  for (const ExportFormat& format : render::exportFormats())
    if (format.has(render::viewsOption) && format.page != render::PageUse::none)
      for (const glm::vec2 page : {glm::vec2(90.0f, 160.0f), glm::vec2(160.0f, 90.0f)})
        QTest::addRow("%s, %s", format.id, page.x < page.y ? "upright" : "wide")
            << QString::fromLatin1(format.id) << page;
}

/// (Before, pictures, decks, questions and slides of a page that is not wide cut off what their
/// view shows at its sides, where the command line wrote them; the window's went by its own shape.)
void AssembledTest::viewsFitTheirPages() {
  QFETCH(QString, kind);
  QFETCH(glm::vec2, page);
  const ExportFormat& format = *render::exportFormat(kind.toStdString());
  const ExportWish wish = wishFor(page, ViewSubject::all);
  const auto pieces = render::assembled(wish, format);
  QVERIFY(pieces.ok());
  QCOMPARE(pieces->size(), format.oneView ? std::size_t(2) : std::size_t(1));
  std::vector<ExportOrder> pictures;
  for (const render::ExportPiece& piece : *pieces)
    for (const ExportOrder& one : render::pagesOf(piece.order, format))
      pictures.push_back(one);
  QCOMPARE(pictures.size(), std::size_t(2));
  for (std::size_t i = 0; i < 2; ++i) {
    QCOMPARE(pictures[i].viewName, wish.order.scene.views()[i].name);
    QVERIFY(showsAll(pictures[i]));
  }
  if (format.oneView)
    QVERIFY(pieces->front().target != pieces->back().target);
}

void AssembledTest::toursFitTheirPages() {
  ExportWish wish = wishFor({160.0f, 90.0f}, ViewSubject::shown);
  wish.order.of<render::FilmOptions>().motion = render::Motion::tour;
  wish.order.of<render::FilmOptions>().format = render::FilmFormat::square;
  const auto pieces = render::assembled(wish, *render::exportFormat("mp4"));
  QVERIFY(pieces.ok());
  ExportOrder order = pieces->front().order;
  QCOMPARE(order.page.sizeMm.x, order.page.sizeMm.y);
  const auto film = render::Film::create(order);
  QVERIFY(film.ok());
  for (const int frame : {0, film->frames() - 1}) {
    order.camera = film->at(frame).camera;
    QVERIFY(showsAll(order));
  }
}

void AssembledTest::whatTheKindHas() {
  ExportWish wish = wishFor({160.0f, 90.0f}, ViewSubject::asKind);
  wish.order.of<render::SheetOptions>().kind = render::SheetKind::teaching;
  const auto subjectOf = [&wish](const char* kind) {
    return render::assembled(wish, *render::exportFormat(kind))
        ->front()
        .order.of<render::ViewsOptions>()
        .subject;
  };
  // As the kind has it: slides are of all views, others of what is shown.
  QCOMPARE(subjectOf("pptx"), ViewSubject::all);
  QCOMPARE(subjectOf("pdf"), ViewSubject::shown);
  QCOMPARE(subjectOf("anki"), ViewSubject::shown);
  const auto picture = render::assembled(wish, *render::exportFormat("png"));
  QCOMPARE(picture->front().order.page.sizeMm, wish.order.page.sizeMm);
  const auto sheet = render::assembled(wish, *render::exportFormat("pdf"));
  QCOMPARE(sheet->front().order.of<render::SheetOptions>().kind, render::SheetKind::teaching);
  QVERIFY(sheet->front().order.page.sizeMm != wish.order.page.sizeMm);
}

/// What is shown is framed once for each file, on the page of its kind; surfaces have none.
void AssembledTest::framedOnTheirOwnPage() {
  ExportWish wish = wishFor({90.0f, 160.0f}, ViewSubject::shown);
  std::vector<glm::vec2> pages;
  wish.framing = [&pages](const ExportOrder& order) {
    pages.push_back(order.page.sizeMm);
    model::Camera camera = order.camera;
    camera.heightMm = 77.0f;
    return Result(camera);
  };
  const auto heightOf = [&](const char* kind) {
    const auto pieces = render::assembled(wish, *render::exportFormat(kind));
    return pieces->front().order.camera.heightMm;
  };
  QCOMPARE(heightOf("png"), 77.0f);
  QCOMPARE(heightOf("mp4"), 77.0f);
  QCOMPARE(heightOf("pptx"), 77.0f);
  QCOMPARE(heightOf("page"), 140.0f);
  QCOMPARE(pages.size(), std::size_t(3));
  QCOMPARE(pages[0], wish.order.page.sizeMm);
  QCOMPARE(pages[1], render::filmPageMm(wish.order));
  QCOMPARE(pages[2], render::slidePageMm(wish.order));
}

void AssembledTest::framingMayFail() {
  ExportWish wish = wishFor({160.0f, 90.0f}, ViewSubject::shown);
  wish.framing = [](const ExportOrder&) -> Result<model::Camera> {
    return Error{.reason = "there is no such view"};
  };
  QCOMPARE(render::assembled(wish, *render::exportFormat("svg")).error().reason,
           std::string("there is no such view"));
  QVERIFY(!render::assembledPicture(wish).ok());
}

/// With ink alone nothing keeps a colour, each view's own look neither, and the ground is white.
void AssembledTest::inkComesLast() {
  ExportWish wish = wishFor({160.0f, 90.0f}, ViewSubject::all);
  model::View view = model::viewOf(wish.order.scene, wish.order.camera, "Red");
  for (model::Look& look : *view.looks)
    look.style.colour = Colour{200, 10, 10};
  wish.order.scene.setViews({view});
  wish.order.pureInk = true;
  wish.order.environment.background = render::Background::dark;
  for (const char* kind : {"png", "pdf", "svg"}) {
    const ExportFormat& format = *render::exportFormat(kind);
    const auto pieces = render::assembled(wish, format);
    const ExportOrder page = render::pagesOf(pieces->front().order, format).front();
    QCOMPARE(page.environment.background, render::Background::white);
    QCOMPARE(page.labels.ground, render::Background::white);
    for (const model::Node& node : page.scene.nodes())
      if (!node.isGroup()) {
        const model::ResolvedStyle style = page.scene.resolve(node.id);
        QVERIFY(!style.inkColour || *style.inkColour == (Colour{0, 0, 0}));
      }
    QVERIFY(page.labels.inColour && !page.labels.inColour->empty());
  }
}

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::AssembledTest)
#include "assembled_test.moc"
