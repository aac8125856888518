// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_draft.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "render/export/formats/assembled.h"
#include "render/export/order/view_orders.h"
#include "render/vectors/vector_drawing.h"
#include "widgets/export/option_fields.h"

namespace sline::widgets {

namespace {

/// Returns the format of the kind; for an unknown kind one that offers everything.
const render::ExportFormat& traitsOf(const QString& kind) {
  static constexpr render::ExportFormat all{.names = true};
  const render::ExportFormat* const found = formatOf(kind);
  return found ? *found : all;
}

constexpr std::array<std::pair<render::ViewSubject, const char*>, 3> subjectNames{
    {{render::ViewSubject::asKind, "usual"},
     {render::ViewSubject::shown, "seen"},
     {render::ViewSubject::all, "savedViews"}}};

QString keyOf(const char* name) {
  return QStringLiteral("export/") + QLatin1String(name);
}

/// Tells whether the window, too, shows what the option is about.
bool windowShows(const render::ExportOption& option) {
  static constexpr std::array<std::string_view, 5> ids{"background", "labels", "language",
                                                       "labelSize", "scaleBar"};
  return std::find(ids.begin(), ids.end(), option.id) != ids.end();
}

QString seenKey(const render::ExportOption& option) {
  return keyOf("seen/") + QLatin1String(option.id);
}

/// Returns the number under that key if it lies within the limits, otherwise the standard.
float numberIn(const QSettings& settings, const char* name, float standard,
               const Limits<float>& limits) {
  bool read = false;
  const float value = settings.value(keyOf(name)).toFloat(&read);
  return read && limits.contain(value) ? value : standard;
}

}  // namespace

const render::ExportFormat* formatOf(const QString& kind) {
  return render::exportFormat(kind.toStdString());
}

bool hasViews(const QString& kind) {
  const render::ExportFormat* format = formatOf(kind);
  return format && format->has(render::viewsOption);
}

bool holdsViews(const QString& kind) {
  const render::ExportFormat* format = formatOf(kind);
  return format && format->holdsViews();
}

render::ExportOrder asChosen(const ExportDraft& draft) {
  render::ExportOrder order = draft.order;
  order.of<render::ViewsOptions>().subject = draft.subject;
  return order;
}

bool wantsViews(const ExportDraft& draft) {
  return render::meansAllViews(draft.subject, traitsOf(draft.kind));
}

bool isSheet(const ExportDraft& draft) {
  return render::isOnPaper(asChosen(draft), traitsOf(draft.kind));
}

bool isLesson(const ExportDraft& draft, const model::Scene& scene) {
  return holdsViews(draft.kind) && wantsViews(draft) && !scene.views().empty();
}

bool hasOwnPage(const ExportDraft& draft) {
  return render::hasOwnPage(asChosen(draft), traitsOf(draft.kind));
}

bool pageIsAsPreviewed(const QString& kind) {
  return traitsOf(kind).page == render::PageUse::pixels ||
         traitsOf(kind).page == render::PageUse::drawing;
}

render::PageUse pageUseOf(const QString& kind) {
  return traitsOf(kind).page;
}

bool holdsNames(const QString& kind) {
  return traitsOf(kind).names;
}

ExportDraft rememberedDraft(const QSettings& settings, const render::ExportOrder& seen) {
  ExportDraft draft;
  draft.kind = settings.value(keyOf("kind")).toString();
  if (!formatOf(draft.kind))
    draft.kind = QLatin1String(render::exportFormats().front().id);
  for (const auto& [subject, name] : subjectNames)
    if (settings.value(keyOf("subject")).toString() == QLatin1String(name))
      draft.subject = subject;
  draft.filled = settings.value(keyOf("filled")).toBool();
  draft.unit = settings.value(keyOf("unit")).toString() == QLatin1String("pixels")
                   ? PageUnit::pixels
                   : PageUnit::millimetres;
  render::ExportPage& page = draft.order.page;
  page.sizeMm.x = numberIn(settings, "width", page.sizeMm.x, render::pageLimitsMm);
  page.sizeMm.y = numberIn(settings, "height", page.sizeMm.y, render::pageLimitsMm);
  page.dpi = numberIn(settings, "dpi", page.dpi, render::dpiLimits);
  for (const render::ExportOption* option : render::exportOptions()) {
    if (windowShows(*option))
      option->field.write(draft.order, option->field.read(seen));
    const bool still = !windowShows(*option) || settings.value(seenKey(*option)).toString() ==
                                                    valueIn(seen, *option).toString();
    if (option->kept && still)
      setValue(draft.order, *option, settings.value(keyOf("options/") + QLatin1String(option->id)));
  }
  return draft;
}

void follow(ExportDraft& draft, const render::ExportOrder& before, const render::ExportOrder& now) {
  for (const render::ExportOption* option : render::exportOptions())
    if (windowShows(*option) && option->field.read(before) != option->field.read(now))
      option->field.write(draft.order, option->field.read(now));
}

void remember(const ExportDraft& draft, const render::ExportOrder& seen, QSettings& settings) {
  const render::ExportPage& page = draft.order.page;
  settings.setValue(keyOf("kind"), draft.kind);
  for (const auto& [subject, name] : subjectNames)
    if (draft.subject == subject)
      settings.setValue(keyOf("subject"), QLatin1String(name));
  settings.setValue(keyOf("filled"), draft.filled);
  settings.setValue(keyOf("unit"), draft.unit == PageUnit::pixels ? QStringLiteral("pixels")
                                                                  : QStringLiteral("millimetres"));
  settings.setValue(keyOf("width"), double(page.sizeMm.x));
  settings.setValue(keyOf("height"), double(page.sizeMm.y));
  settings.setValue(keyOf("dpi"), double(page.dpi));
  // Settings must not keep names or a patient's text, nor those that an older program left.
  for (const render::ExportOption* option : render::exportOptions()) {
    const QString key = keyOf("options/") + QLatin1String(option->id);
    if (option->kept && option->title)
      settings.setValue(key, valueIn(draft.order, *option));
    else
      settings.remove(key);
    if (option->kept && windowShows(*option))
      settings.setValue(seenKey(*option), valueIn(seen, *option).toString());
  }
  if (!draft.target.isEmpty())
    settings.setValue(keyOf("folder"), QFileInfo(draft.target).absolutePath());
}

QString withEndingOf(const QString& target, const QString& kind) {
  const render::ExportFormat* format = formatOf(kind);
  if (target.isEmpty() || !format)
    return target;
  // A folder has no ending.
  const QString ending = QLatin1Char('.') + QLatin1String(format->extension);
  const QString alternative = QLatin1Char('.') + QLatin1String(format->otherExtension);
  if (target.endsWith(ending, Qt::CaseInsensitive) ||
      (alternative.size() > 1 && target.endsWith(alternative, Qt::CaseInsensitive)))
    return target;
  for (const render::ExportFormat& other : render::exportFormats()) {
    const QString old = QLatin1Char('.') + QLatin1String(other.extension);
    if (old.size() > 1 && target.endsWith(old, Qt::CaseInsensitive))
      return target.chopped(old.size()) + (ending.size() > 1 ? ending : QString());
  }
  return ending.size() > 1 ? target + ending : target;
}

}  // namespace sline::widgets
