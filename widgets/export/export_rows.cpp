// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_rows.h"

#include <QLocale>
#include <algorithm>

#include "widgets/export/export_draft.h"
#include "widgets/export/kind_rows.h"
#include "widgets/export/row_binding.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

using render::Background;
using render::ExportOrder;
using render::LabelMode;

RowChoice choice(std::initializer_list<RowChoice::Entry> entries) {
  return {entries};
}

std::vector<ExportRow> pictureRows() {
  const RowChoice backgrounds =
      choice({{QStringLiteral("white"), tr("White"), int(Background::white)},
              {QStringLiteral("paper"), tr("Paper"), int(Background::paper)},
              {QStringLiteral("dark"), tr("Dark"), int(Background::dark)},
              {QStringLiteral("transparent"), tr("Transparent"), int(Background::transparent)}});
  return {bound(
      {.id = QStringLiteral("background"),
       .part = ExportPart::picture,
       .text = tr("Back&ground"),
       .tip = tr("What lies behind the drawing"),
       .kinds = {},
       .control = backgrounds,
       .read = {},
       .write = {}},
      [](auto& o) -> auto& { return o.look.background; })};
}

RowChoice languageChoice(const QStringList& languages) {
  RowChoice all = choice({{QString(), tr("The scene's own"), QString()}});
  for (const QString& tag : languages) {
    const QString name = QLocale(tag).nativeLanguageName();
    const bool known = QLocale(tag).language() != QLocale::C && !name.isEmpty();
    all.entries.push_back({tag,
                           tag == QLatin1String("la") ? tr("Latin")
                           : known                    ? name
                                                      : tag,
                           tag});
  }
  return all;
}

std::vector<ExportRow> labelRows(const QStringList& languages) {
  const RowChoice modes =
      choice({{QStringLiteral("on"), tr("Texts"), int(LabelMode::on)},
              {QStringLiteral("numbers"), tr("Numbers"), int(LabelMode::numbers)},
              {QStringLiteral("blank"), tr("Blank lines, for a test"), int(LabelMode::blank)},
              {QStringLiteral("off"), tr("None"), int(LabelMode::off)}});
  ExportRow language = bound(
      {.id = QStringLiteral("language"),
       .part = ExportPart::labels,
       .text = tr("Lan&guage"),
       .tip = tr("Of texts and numbers; where a label has no text in it, "
                 "the scene's own"),
       .kinds = {},
       .control = languageChoice(languages),
       .read = {},
       .write = {}},
      [](auto& o) -> auto& { return o.labels.language; });
  // Which languages there are is a matter of the scene.
  language.kept = false;
  return {bound(
              {.id = QStringLiteral("labels"),
               .part = ExportPart::labels,
               .text = tr("&Labels"),
               .tip = tr("How the scene's labels stand in the picture"),
               .kinds = {},
               .control = modes,
               .read = {},
               .write = {}},
              [](auto& o) -> auto& { return o.labels.mode; }),
          language,
          bound(
              {.id = QStringLiteral("labelSize"),
               .part = ExportPart::labels,
               .text = tr("Le&tters"),
               .tip = tr("How large the letters of labels are on paper"),
               .kinds = {},
               .control = RowNumber{.low = double(render::letterLimitsPt.low),
                                    .high = double(render::letterLimitsPt.high),
                                    .decimals = 1,
                                    .step = 1,
                                    .unit = tr("pt")},
               .read = {},
               .write = {}},
              [](auto& o) -> auto& { return o.labels.points; })};
}

template <class Field>
ExportRow mark(const char* id, const QString& text, const QString& tip, Field field) {
  return bound({.id = QLatin1String(id),
                .part = ExportPart::marks,
                .text = text,
                .tip = tip,
                .kinds = {},
                .control = RowSwitch{},
                .read = {},
                .write = {}},
               field);
}

std::vector<ExportRow> markRows() {
  return {mark(
              "sides", tr("&Right and left"), tr("R and L, and the body's other directions"),
              [](auto& o) -> auto& { return o.marks.sides; }),
          mark(
              "viewName", tr("&Name of the view"), tr("“Anterior view”, or the saved view's name"),
              [](auto& o) -> auto& { return o.marks.viewName; }),
          mark(
              "scaleBar", tr("S&cale bar"), tr("How long a centimetre is"),
              [](auto& o) -> auto& { return o.marks.scaleBar; }),
          mark(
              "sectionState", tr("S&ections"), tr("What sections have taken away"),
              [](auto& o) -> auto& { return o.marks.sectionState; })};
}

}  // namespace

bool ExportRow::isFor(const QString& kind) const {
  return kinds.isEmpty() ? pageUseOf(kind) != render::PageUse::none : kinds.contains(kind);
}

QVariant ExportRow::toSettings(const ExportOrder& order) const {
  const QVariant value = read(order);
  if (const auto* several = std::get_if<RowChoice>(&control))
    for (const RowChoice::Entry& entry : several->entries)
      if (entry.value == value)
        return entry.id;
  return value;
}

void ExportRow::fromSettings(ExportOrder& order, const QVariant& value) const {
  if (!kept || !value.isValid())
    return;
  if (const auto* several = std::get_if<RowChoice>(&control)) {
    for (const RowChoice::Entry& entry : several->entries)
      if (entry.id == value.toString())
        write(order, entry.value);
  } else if (const auto* number = std::get_if<RowNumber>(&control)) {
    bool isNumber = false;
    const double typed = value.toDouble(&isNumber);
    if (isNumber && typed >= number->low && typed <= number->high)
      write(order, typed);
  } else {
    write(order, value);
  }
}

std::vector<ExportRow> exportRows(const QStringList& languages) {
  std::vector<ExportRow> rows = pictureRows();
  for (const std::vector<ExportRow>& more :
       {labelRows(languages), markRows(), kindRows(), creditRows()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace sline::widgets
