// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_draft.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/export/export_rows.h"
#include "widgets/export/page_presets.h"

namespace sline::widgets {

namespace {

// What the dialog offers for a kind that says nothing of itself here: all.
struct KindTraits {
  const char* kind;
  bool oneView = true;
  PageUse page = PageUse::pixels;
  bool names = false;
};
constexpr std::array traits{
    KindTraits{.kind = "png"},
    KindTraits{.kind = "tiff"},
    KindTraits{.kind = "jpeg"},
    KindTraits{.kind = "exr"},
    KindTraits{.kind = "webp-picture"},
    KindTraits{.kind = "jp2"},
    KindTraits{.kind = "svg", .page = PageUse::drawing, .names = true},
    KindTraits{.kind = "pdf", .page = PageUse::drawing, .names = true},
    KindTraits{.kind = "glb", .oneView = false, .page = PageUse::none, .names = true},
    KindTraits{.kind = "mp4", .oneView = false, .page = PageUse::shape},
    KindTraits{.kind = "webp", .oneView = false, .page = PageUse::shape},
    KindTraits{.kind = "gif", .oneView = false, .page = PageUse::shape},
    KindTraits{.kind = "frames", .oneView = false, .page = PageUse::shape},
    KindTraits{.kind = "anki", .oneView = false, .names = true},
};

const KindTraits& traitsOf(const QString& kind) {
  static constexpr KindTraits all{.kind = "", .names = true};
  const auto* const found = std::find_if(traits.begin(), traits.end(), [&kind](const auto& each) {
    return kind == QLatin1String(each.kind);
  });
  return found == traits.end() ? all : *found;
}

QString keyOf(const char* name) {
  return QStringLiteral("export/") + QLatin1String(name);
}

/// The number under that key, where it lies within the limits.
float numberIn(const QSettings& settings, const char* name, float standard, glm::vec2 limits) {
  bool read = false;
  const float value = settings.value(keyOf(name)).toFloat(&read);
  return read && value >= limits.x && value <= limits.y ? value : standard;
}

}  // namespace

const render::ExportFormat* formatOf(const QString& kind) {
  for (const render::ExportFormat& format : render::exportFormats())
    if (kind == QLatin1String(format.id))
      return &format;
  return nullptr;
}

bool showsOneView(const QString& kind) {
  return traitsOf(kind).oneView;
}

bool pageIsAsPreviewed(const QString& kind) {
  return showsOneView(kind) || kind == QLatin1String("anki");
}

PageUse pageUseOf(const QString& kind) {
  return traitsOf(kind).page;
}

bool holdsNames(const QString& kind) {
  return traitsOf(kind).names;
}

ExportDraft rememberedDraft(const QSettings& settings) {
  ExportDraft draft;
  draft.kind = settings.value(keyOf("kind")).toString();
  if (!formatOf(draft.kind))
    draft.kind = QLatin1String(render::exportFormats().front().id);
  draft.subject = settings.value(keyOf("subject")).toString() == QLatin1String("savedViews")
                      ? ExportSubject::savedViews
                      : ExportSubject::seen;
  draft.filled = settings.value(keyOf("filled")).toBool();
  draft.unit = settings.value(keyOf("unit")).toString() == QLatin1String("pixels")
                   ? PageUnit::pixels
                   : PageUnit::millimetres;
  render::ExportPage& page = draft.order.page;
  page.sizeMm.x = numberIn(settings, "width", page.sizeMm.x, pageLimitsMm);
  page.sizeMm.y = numberIn(settings, "height", page.sizeMm.y, pageLimitsMm);
  page.dpi = numberIn(settings, "dpi", page.dpi, dpiLimits);
  draft.order.labels.mode = render::LabelMode::on;
  for (const ExportRow& row : exportRows({}))
    row.fromSettings(draft.order, settings.value(keyOf("options/") + row.id));
  return draft;
}

void remember(const ExportDraft& draft, QSettings& settings) {
  const render::ExportPage& page = draft.order.page;
  settings.setValue(keyOf("kind"), draft.kind);
  settings.setValue(keyOf("subject"), draft.subject == ExportSubject::savedViews
                                          ? QStringLiteral("savedViews")
                                          : QStringLiteral("seen"));
  settings.setValue(keyOf("filled"), draft.filled);
  settings.setValue(keyOf("unit"), draft.unit == PageUnit::pixels ? QStringLiteral("pixels")
                                                                  : QStringLiteral("millimetres"));
  settings.setValue(keyOf("width"), double(page.sizeMm.x));
  settings.setValue(keyOf("height"), double(page.sizeMm.y));
  settings.setValue(keyOf("dpi"), double(page.dpi));
  // Names and a patient's text lie in no settings, nor what an older program left of them.
  for (const ExportRow& row : exportRows({}))
    if (row.kept)
      settings.setValue(keyOf("options/") + row.id, row.toSettings(draft.order));
    else
      settings.remove(keyOf("options/") + row.id);
  if (!draft.target.isEmpty())
    settings.setValue(keyOf("folder"), QFileInfo(draft.target).path());
}

QString withEndingOf(const QString& target, const QString& kind) {
  const render::ExportFormat* format = formatOf(kind);
  if (target.isEmpty() || !format)
    return target;
  // A folder has none.
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
