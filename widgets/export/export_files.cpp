// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_files.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "model/edit/views.h"
#include "model/scene/visible_structures.h"
#include "render/export/motion/film_options.h"
#include "render/export/order/ink_alone.h"
#include "render/export/order/view_orders.h"
#include "render/export/pdf/lesson.h"
#include "render/export/pdf/sheet_figure.h"
#include "render/export/pdf/sheet_layout.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/plate/plate_image.h"
#include "render/export/slides/slide_page.h"
#include "render/lettering/typesetting.h"
#include "widgets/session/names_by_language.h"
#include "widgets/text/path_text.h"

namespace sline::widgets {

namespace {

/// Returns what the saved view says that shows just what is seen; nothing where none does.
model::ViewWords wordsOfSeen(const ExportSource& source) {
  for (const model::View& view : source.scene.views())
    if (view.camera == source.camera &&
        model::withViewApplied(source.scene, view).scene == source.scene)
      return view.words;
  return {};
}

ExportFile fileOf(const ExportDraft& draft, const ExportSource& source, const model::View* view) {
  ExportFile file{.order = draft.order, .filled = draft.filled, .target = {}};
  render::ExportOrder& order = file.order;
  order.scene = view ? model::withViewApplied(source.scene, *view).scene : source.scene;
  order.camera = view ? view->camera : source.camera;
  order.viewName = view ? view->name : viewNameOf(source.camera);
  order.words = view ? view->words : wordsOfSeen(source);
  order.environment.keyLight = source.keyLight;
  // Options that were chosen for other kinds do not apply to this one.
  if (const render::ExportFormat* kind = formatOf(draft.kind))
    render::dropForeignOptions(order, *kind);
  if (order.pureInk) {
    render::leaveInkAlone(order);
    order.environment.background = render::Background::white;
  }
  order.labels.ground = order.environment.background;
  if (pageUseOf(draft.kind) == render::PageUse::shape)
    order.page.sizeMm = render::filmPageMm(order);
  if (pageUseOf(draft.kind) == render::PageUse::slides)
    order = render::slideFigure(order, render::shownView(order));
  if (hasViews(draft.kind) && holdsViews(draft.kind))
    order.of<render::ViewsOptions>().subject =
        wantsViews(draft) ? render::ViewSubject::all : render::ViewSubject::shown;
  if (isSheet(draft) && !isLesson(draft, source.scene))
    order.page.sizeMm = render::sheetFigureMm(order);
  const float aspect = order.page.sizeMm.x / order.page.sizeMm.y;
  if (pageUseOf(draft.kind) != render::PageUse::none)
    order.camera = reframed(order.camera, source.aspect, aspect);
  return file;
}

}  // namespace

std::string viewNameOf(const model::Camera& camera) {
  const auto side = model::anatomicalViewOf(camera);
  return side ? std::string(model::anatomicalViewNames[std::size_t(*side)]) : std::string();
}

model::Camera reframed(model::Camera camera, float before, float aspect) {
  const float wider = before / aspect;
  if (!(wider > 1.0f) || !std::isfinite(wider))
    return camera;
  constexpr float widest = 150.0f;  // degrees
  const float half = model::edgeSlope(camera);
  camera.fovyDegrees = std::min(widest, 2.0f * glm::degrees(std::atan(wider * half)));
  camera.heightMm *= wider;
  return camera;
}

bool hasOwnPage(const ExportDraft& draft) {
  return isSheet(draft) || pageUseOf(draft.kind) == render::PageUse::slides ||
         (pageUseOf(draft.kind) == render::PageUse::shape &&
          draft.order.of<render::FilmOptions>().format != render::FilmFormat::page);
}

bool isSheet(const ExportDraft& draft) {
  const render::ExportFormat* kind = formatOf(draft.kind);
  return kind && kind->has(render::sheetOption) &&
         (draft.order.of<render::SheetOptions>().kind != render::SheetKind::none ||
          wantsViews(draft));
}

bool isLesson(const ExportDraft& draft, const model::Scene& scene) {
  return holdsViews(draft.kind) && wantsViews(draft) && !scene.views().empty();
}

std::vector<ExportFile> exportFiles(const ExportDraft& draft, const ExportSource& source) {
  const std::vector<model::View>& views = source.scene.views();
  std::vector<ExportFile> files;
  if (!wantsViews(draft) || holdsViews(draft.kind) || views.empty()) {
    files.push_back(fileOf(draft, source, nullptr));
    files.back().target = pathOf(draft.target);
    return files;
  }
  const auto targets =
      render::viewTargets(pathOf(draft.target), views, formatOf(draft.kind)->extension);
  for (std::size_t i = 0; i < views.size(); ++i) {
    files.push_back(fileOf(draft, source, &views[i]));
    files.back().target = targets[i];
  }
  return files;
}

std::vector<ExportFile> previewedFiles(const ExportDraft& draft,
                                       const std::vector<ExportFile>& files) {
  const render::ExportOrder& whole = files.front().order;
  if (!isLesson(draft, whole.scene))
    return files;
  std::vector<ExportFile> pages;
  for (const model::View& view : whole.scene.views()) {
    ExportFile page{.order = isSheet(draft) ? render::lessonSheet(whole, view)
                                            : render::orderOfView(whole, view),
                    .filled = false,
                    .target = files.front().target};
    if (pageUseOf(draft.kind) == render::PageUse::slides)
      page.order = render::slideFigure(std::move(page.order), &view);
    page.order.of<render::ViewsOptions>().subject = render::ViewSubject::shown;
    pages.push_back(std::move(page));
  }
  return pages;
}

render::ExportOrder readyOrder(const ExportFile& file) {
  render::ExportOrder order = file.order;
  if (!file.filled)
    return order;
  // A window has what text needs.
  const auto typesetting = render::Typesetting::create();
  const model::FreeSides sides =
      typesetting.ok() ? render::sidesOfPlate(render::sheetFigure(order), **typesetting)
                       : model::FreeSides();
  order.camera = model::fittedToVisible(order.scene, order.camera,
                                        order.page.sizeMm.x / order.page.sizeMm.y, sides);
  return order;
}

QStringList labelLanguages(const model::Scene& scene) {
  QStringList languages = knownLanguages();
  for (const model::Annotation& annotation : scene.annotations())
    for (const auto& [tag, text] : annotation.texts)
      if (const QString language = QString::fromStdString(tag); !languages.contains(language))
        languages << language;
  languages.sort();
  return languages;
}

}  // namespace sline::widgets
