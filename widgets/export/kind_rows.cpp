// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/kind_rows.h"

#include "render/export/formats/export_formats.h"
#include "widgets/export/row_binding.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

using render::Motion;
using render::Paper;
using render::SheetKind;

/// The kinds that have that choice.
QStringList kindsWith(bool render::KindChoices::*choice) {
  QStringList kinds;
  for (const render::ExportFormat& format : render::exportFormats())
    if (format.choices.*choice)
      kinds << QLatin1String(format.id);
  return kinds;
}

template <class Number>
RowNumber numberWithin(const Limits<Number>& limits, int decimals, double step,
                       const QString& unit) {
  return {.low = double(limits.low),
          .high = double(limits.high),
          .decimals = decimals,
          .step = step,
          .unit = unit};
}

ExportRow row(const char* id, const QString& text, const QString& tip, const QStringList& kinds) {
  return {.id = QLatin1String(id),
          .part = ExportPart::kind,
          .text = text,
          .tip = tip,
          .kinds = kinds,
          .control = RowSwitch{},
          .read = {},
          .write = {}};
}

ExportRow with(ExportRow row, const RowControl& control) {
  row.control = control;
  return row;
}

ExportRow notKept(ExportRow row) {
  row.kept = false;
  return row;
}

std::vector<ExportRow> pixelRows() {
  using Choices = render::KindChoices;
  const RowChoice depths{
      {{QStringLiteral("8"), tr("8 bits"), 8}, {QStringLiteral("16"), tr("16 bits"), 16}}};
  return {bound(
              with(row("bits", tr("&Depth"), tr("Of each colour; 16 bits for work that follows"),
                       kindsWith(&Choices::depth)),
                   depths),
              [](auto& o) -> auto& { return o.pixels.bits; }),
          bound(
              row("grey", tr("&Grey"), tr("Without colours, with a grey profile"),
                  kindsWith(&Choices::grey)),
              [](auto& o) -> auto& { return o.pixels.grey; }),
          bound(
              row("pureInk", tr("Black in&k alone"),
                  tr("For print without tones: each pixel is ink or paper; what is shaded is "
                     "hatched instead"),
                  kindsWith(&Choices::pureInk)),
              [](auto& o) -> auto& { return o.pixels.pureInk; })};
}

std::vector<ExportRow> sheetRows() {
  const QStringList kindsOfSheets = kindsWith(&render::KindChoices::sheet);
  const RowChoice kinds{
      {{QStringLiteral("none"), tr("The figure alone"), int(SheetKind::none)},
       {QStringLiteral("figure"), tr("With title and legend"), int(SheetKind::figure)},
       {QStringLiteral("teaching"), tr("For teaching, with self-test"), int(SheetKind::teaching)},
       {QStringLiteral("patient"), tr("For a patient"), int(SheetKind::patient)}}};
  const RowChoice papers{{{QStringLiteral("a4"), tr("A4"), int(Paper::a4)},
                          {QStringLiteral("letter"), tr("US Letter"), int(Paper::letter)}}};
  return {
      bound(
          with(row("sheet", tr("Shee&t"), tr("The page around the figure, of a paper of its own"),
                   kindsOfSheets),
               kinds),
          [](auto& o) -> auto& { return o.sheet.kind; }),
      bound(
          with(row("sheetPaper", tr("Paper of the sheet"), tr("Of sheets alone"), kindsOfSheets),
               papers),
          [](auto& o) -> auto& { return o.sheet.paper; }),
      notKept(bound(
          with(row("sheetTitle", tr("T&itle"), tr("At the head of a sheet"), kindsOfSheets),
               RowText{.longest = 120}),
          [](auto& o) -> auto& { return o.sheet.title; })),
      notKept(bound(
          with(row("sheetText", tr("Text"),
                   tr("Of a sheet for a patient; each line is a paragraph"), kindsOfSheets),
               RowText{.longest = 4000, .lines = 3}),
          [](auto& o) -> auto& { return o.sheet.text; })),
      bound(
          row("sheetLandscape", tr("Landscape"), tr("Wider than high"), kindsOfSheets),
          [](auto& o) -> auto& { return o.sheet.landscape; })};
}

std::vector<ExportRow> filmRows() {
  const QStringList films = kindsWith(&render::KindChoices::film);
  const RowChoice motions{
      {{QStringLiteral("turntable"), tr("Once around"), int(Motion::turntable)},
       {QStringLiteral("tour"), tr("From view to view"), int(Motion::tour)},
       {QStringLiteral("gammaSweep"), tr("Γ from 0 to 5"), int(Motion::gammaSweep)}}};
  return {bound(
              with(row("motion", tr("&Motion"), tr("What moves in the film"), films), motions),
              [](auto& o) -> auto& { return o.film.motion; }),
          bound(
              with(row("seconds", tr("Len&gth"), tr("Of the whole film"), films),
                   numberWithin(render::filmSecondsLimits, 1, 1.0, tr("s"))),
              [](auto& o) -> auto& { return o.film.seconds; }),
          bound(
              with(row("framesPerSecond", tr("Pictures a secon&d"),
                       tr("More are smoother, and more to draw"), films),
                   numberWithin(render::framesPerSecondLimits, 0, 5.0, {})),
              [](auto& o) -> auto& { return o.film.framesPerSecond; }),
          bound(
              with(row("filmHeight", tr("Height of the film"),
                       tr("The page's shape gives the width"), films),
                   numberWithin(render::filmHeightLimits, 0, 90.0, tr("px"))),
              [](auto& o) -> auto& { return o.film.height; })};
}

std::vector<ExportRow> ankiRows() {
  const QStringList decks = kindsWith(&render::KindChoices::anki);
  return {notKept(bound(
              with(row("deck", tr("&Deck"), tr("Its name in Anki; else the view's name"), decks),
                   RowText{.longest = 120}),
              [](auto& o) -> auto& { return o.anki.deck; })),
          bound(
              row("othersShown", tr("S&how the other labels"),
                  tr("A card asks for one label and shows the others"), decks),
              [](auto& o) -> auto& { return o.anki.othersShown; })};
}

}  // namespace

std::vector<ExportRow> kindRows() {
  std::vector<ExportRow> rows;
  for (const std::vector<ExportRow>& more : {pixelRows(), sheetRows(), filmRows(), ankiRows()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

std::vector<ExportRow> creditRows() {
  QStringList all;
  for (const render::ExportFormat& format : render::exportFormats())
    all << QLatin1String(format.id);
  const auto line = [&all](const char* id, const QString& text, const QString& tip) {
    ExportRow made = notKept(with(row(id, text, tip, all), RowText{.longest = 200}));
    made.part = ExportPart::credit;
    return made;
  };
  return {
      bound(
          line("author", tr("Author"),
               tr("Written into the file, which says of nobody who made it where this is empty")),
          [](auto& o) -> auto& { return o.credit.author; }),
      bound(
          line("copyright", tr("Rights"),
               tr("Whose it is or what others may do with it, as in “CC BY 4.0”")),
          [](auto& o) -> auto& { return o.credit.copyright; })};
}

}  // namespace sline::widgets
