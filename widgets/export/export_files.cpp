// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_files.h"

#include <QSet>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "model/edit/look.h"
#include "model/edit/views.h"
#include "model/scene/visible_structures.h"
#include "render/export/motion/film_options.h"
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

/// Returns a page of the same shape for a film's picture, so small that letters can be read on a
/// screen, whatever paper was chosen for other kinds: 10 points are 1/30 of its height.
glm::vec2 filmPage(const glm::vec2& sizeMm) {
  constexpr float shorterSide = 106.0f;
  return sizeMm * (shorterSide / std::min(sizeMm.x, sizeMm.y));
}

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
    order.scene = model::withInkAlone(order.scene).scene;
    order.environment.background = render::Background::white;
  }
  order.labels.onDark = order.environment.background == render::Background::dark;
  if (pageUseOf(draft.kind) == render::PageUse::shape)
    order.page.sizeMm = filmPage(render::filmPageMm(order));
  if (pageUseOf(draft.kind) == render::PageUse::slides) {
    order.page.sizeMm = render::slidePageMm(order);
    order.marks.viewName = false;  // it is the title
  }
  if (isSheet(draft))
    order.page.sizeMm = render::sheetFigureMm(order);
  const float aspect = order.page.sizeMm.x / order.page.sizeMm.y;
  if (pageUseOf(draft.kind) != render::PageUse::none)
    order.camera = reframed(order.camera, source.aspect, aspect);
  return file;
}

}  // namespace

QString safeFileName(const QString& text) {
  constexpr int longestBytes = 120;  // file systems take 255; the target's own name comes before
  static const QString separating = QStringLiteral("/\\:*?\"<>|");
  QString name;
  for (const QChar each : text)
    if (separating.contains(each))
      name += QLatin1Char('-');
    else
      name += each.isSurrogate() || each.isPrint() ? each : QChar(u' ');
  name = name.simplified();
  while (name.toUtf8().size() > longestBytes)
    name.chop(name.size() > 1 && name.back().isLowSurrogate() ? 2 : 1);
  // Windows drops these characters at the end, and hides files that begin with a dot.
  while (name.endsWith(QLatin1Char('.')) || name.endsWith(QLatin1Char(' ')))
    name.chop(1);
  while (name.startsWith(QLatin1Char('.')))
    name.remove(0, 1);
  return name.isEmpty() ? QStringLiteral("picture") : name;
}

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
         draft.order.of<render::SheetOptions>().kind != render::SheetKind::none;
}

std::vector<ExportFile> exportFiles(const ExportDraft& draft, const ExportSource& source) {
  const bool each = draft.subject == ExportSubject::savedViews && showsOneView(draft.kind) &&
                    !source.scene.views().empty();
  std::vector<ExportFile> files;
  if (!each) {
    files.push_back(fileOf(draft, source, nullptr));
    files.back().target = pathOf(draft.target);
    return files;
  }
  const render::ExportFormat* format = formatOf(draft.kind);
  const QString ending = QLatin1Char('.') + QLatin1String(format->extension);
  QString stem = draft.target;
  if (stem.endsWith(ending, Qt::CaseInsensitive))
    stem.chop(ending.size());
  QSet<QString> taken;
  for (const model::View& view : source.scene.views()) {
    const QString name = safeFileName(QString::fromStdString(view.name));
    QString free = name;
    // On many disks, names that differ only in case are the same.
    for (int i = 2; taken.contains(free.toCaseFolded()); ++i)
      free = QStringLiteral("%1 %2").arg(name).arg(i);
    taken.insert(free.toCaseFolded());
    files.push_back(fileOf(draft, source, &view));
    files.back().target = pathOf(QStringLiteral("%1 - %2%3").arg(stem, free, ending));
  }
  return files;
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
