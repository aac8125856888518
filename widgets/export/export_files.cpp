// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_files.h"

#include <algorithm>
#include <utility>

#include "model/edit/views.h"
#include "model/scene/visible_structures.h"
#include "widgets/session/names_by_language.h"
#include "widgets/text/path_text.h"

namespace sline::widgets {

namespace {

/// Returns the saved view that shows just what is seen; null where none does.
const model::View* viewOfSeen(const ExportSource& source) {
  const std::vector<model::View>& views = source.scene.views();
  const auto found = std::find_if(views.begin(), views.end(), [&source](const model::View& view) {
    return view.camera == source.camera &&
           model::withViewApplied(source.scene, view).scene == source.scene;
  });
  return found == views.end() ? nullptr : &*found;
}

render::ExportWish wishOf(const ExportDraft& draft, const ExportSource& source) {
  render::ExportWish wish{.order = asChosen(draft),
                          .framing = {},
                          .filled = draft.filled,
                          .target = pathOf(draft.target)};
  render::ExportOrder& order = wish.order;
  // Options that were chosen for other kinds are not seen and do not apply to this one.
  if (const render::ExportFormat* kind = formatOf(draft.kind))
    render::dropForeignOptions(order, *kind);
  order.scene = source.scene;
  order.camera = source.camera;
  if (const model::View* view = viewOfSeen(source)) {
    order.viewName = view->name;
    order.words = view->words;
  } else if (const auto side = model::anatomicalViewOf(source.camera)) {
    order.viewName = std::string(model::anatomicalViewNames[std::size_t(*side)]);
  }
  order.environment.keyLight = source.keyLight;
  // A page shows all that the window does.
  wish.framing = [camera = source.camera,
                  aspect = source.aspect](const render::ExportOrder& asked) {
    const glm::vec2& page = asked.page.sizeMm;
    return Result(render::widened(camera, aspect * page.y / page.x));
  };
  return wish;
}

}  // namespace

std::vector<render::ExportPiece> exportFiles(const ExportDraft& draft, const ExportSource& source) {
  const render::ExportFormat* format = formatOf(draft.kind);
  const render::ExportWish wish = wishOf(draft, source);
  // A window's framing never fails.
  return render::assembled(wish, format ? *format : render::exportFormats().front()).value();
}

std::vector<render::ExportPiece> previewedFiles(const ExportDraft& draft,
                                                const std::vector<render::ExportPiece>& files) {
  const render::ExportPiece& whole = files.front();
  const render::ExportFormat* format = formatOf(draft.kind);
  if (!format || !render::isLesson(whole.order, *format))
    return files;
  std::vector<render::ExportPiece> pages;
  for (render::ExportOrder& page : render::pagesOf(whole.order, *format))
    pages.push_back({.order = std::move(page), .filled = false, .target = whole.target});
  return pages;
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
