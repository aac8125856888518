// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_texts.h"
#include "model/scene/visible_structures.h"
#include "render/export/anki/anki_file.h"
#include "render/export/anki/anki_options.h"
#include "render/export/motion/film_options.h"
#include "render/export/packages/picture_questions.h"
#include "render/export/pdf/lesson.h"
#include "render/export/pdf/sheet_layout.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/plate/source_credits.h"
#include "render/export/slides/slide_page.h"
#include "render/export/students/students_options.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <string_view>

#include "widgets/export/finished_page.h"
#include "widgets/export/note_texts.h"
#include "widgets/session/names_by_language.h"
#include "widgets/text/path_text.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

QString numberText(qlonglong number) {
  return QLocale().toString(number);
}

int shownStructures(const model::Scene& scene) {
  return int(model::visibleStructures(scene).size());
}

int shownLabels(const model::Scene& scene) {
  return int(std::count_if(scene.annotations().begin(), scene.annotations().end(),
                           [](const model::Annotation& each) { return each.visible; }));
}

QString subjectText(const ExportDraft& draft, const std::vector<render::ExportPiece>& files) {
  const int structures = shownStructures(files.front().order.scene);
  if (files.size() > 1)
    return tr("%n files, one for each saved view: %1 … %2.", nullptr, int(files.size()))
        .arg(textOf(files.front().target.filename()), textOf(files.back().target.filename()));
  const render::ExportOrder& order = files.front().order;
  if (isLesson(draft, order.scene) && isSheet(draft))
    return tr("%1 views on about %n pages, with contents, index and bookmarks.", nullptr,
              int(render::lessonPages(order)))
        .arg(numberText(qlonglong(order.scene.views().size())));
  if (pageUseOf(draft.kind) == render::PageUse::slides && render::showsViews(order))
    return tr("%n slides, one for each saved view.", nullptr, int(order.scene.views().size()));
  return pageUseOf(draft.kind) != render::PageUse::none
             ? tr("%n structures, seen as in the window.", nullptr, structures)
             : tr("%n structures as surfaces.", nullptr, structures);
}

/// Tells whether the sheet labels a scene that has no labels.
bool sheetAddsLabels(const ExportDraft& draft) {
  return isSheet(draft) &&
         (draft.order.labels.mode != render::LabelMode::off ||
          draft.order.of<render::SheetOptions>().kind != render::SheetKind::figure);
}

/// Says how many cards there will be, or questions.
QString cardText(const ExportDraft& draft, const render::ExportOrder& order) {
  const render::ExportFormat& format = *formatOf(draft.kind);
  if (format.has(render::quizFindOption) && format.page != render::PageUse::none)
    return tr("At most %n questions with pictures.", nullptr, int(render::questionsAtMost(order)));
  if (!format.has(render::cardsOption))
    return {};
  const auto cards = int(render::ankiCardsAtMost(order));
  return isLesson(draft, order.scene)
             ? tr("At most %n cards, in a deck for each view.", nullptr, cards)
             : tr("At most %n cards.", nullptr, cards);
}

QString labelText(const ExportDraft& draft, const std::vector<render::ExportPiece>& files) {
  int labels = 0;
  for (const render::ExportPiece& file : files)
    labels = std::max(labels, shownLabels(file.order.scene));
  if (labels == 0 && sheetAddsLabels(draft))
    return tr("The sheet labels what is seen.");
  const render::LabelStyle& style = files.front().order.labels;
  if (labels == 0 || style.mode == render::LabelMode::off)
    return tr("No labels.");
  if (style.mode == render::LabelMode::numbers)
    return tr("%n labels as numbers.", nullptr, labels);
  if (style.mode == render::LabelMode::blank)
    return tr("%n labels as blank lines.", nullptr, labels);
  const QString tag = QString::fromStdString(style.language);
  return tag.isEmpty() ? tr("%n labels in the scene's own language.", nullptr, labels)
                       : tr("%n labels, language: %1.", nullptr, labels).arg(languageName(tag));
}

QString sizeText(const ExportDraft& draft, const std::vector<render::ExportPiece>& files) {
  render::ExportPage page = draft.order.page;
  if (isSheet(draft))
    page.sizeMm = render::sheetPaperMm(files.front().order);
  const render::FilmOptions& film = draft.order.of<render::FilmOptions>();
  if (pageUseOf(draft.kind) == render::PageUse::shape) {
    const glm::ivec2 size = render::filmSize(draft.order);
    return tr("%1 seconds, %2 × %3 pixels, %4 pictures a second.")
        .arg(QLocale().toString(film.seconds, 'g', 4), numberText(size.x), numberText(size.y),
             numberText(film.framesPerSecond));
  }
  if (pageUseOf(draft.kind) == render::PageUse::slides) {
    page.sizeMm = render::slideSizeMm(draft.order.of<render::SlideOptions>().shape);
    return tr("%1, labels as text and lines.").arg(millimetresText(page));
  }
  if (pageUseOf(draft.kind) == render::PageUse::drawing)
    return tr("%1, as lines and shapes of any sharpness.").arg(millimetresText(page));
  return tr("%1, %2 at %3 dpi.")
      .arg(millimetresText(page), pixelsText(page), numberText(std::lround(page.dpi)));
}

QString weightText(const std::vector<render::ExportPiece>& files, std::optional<double> bytes) {
  if (!bytes)
    return tr("Its size is being measured.");
  if (*bytes <= 0.0)
    return {};
  constexpr double megabyte = 1e6;
  const QString size = QLocale().formattedDataSize(qint64(*bytes), *bytes < megabyte ? 0 : 1,
                                                   QLocale::DataSizeSIFormat);
  return files.size() == 1 ? tr("About %1.").arg(size) : tr("About %1 each.").arg(size);
}

QString creditText(const ExportDraft& draft) {
  return draft.order.credit.empty() ? QString()
                                    : tr("Author and rights are in the file as you typed them.");
}

QString descriptionText(const ExportDraft& draft) {
  return draft.order.altText == "off"
             ? QString()
             : tr("What is seen is also told in words, for who does not see it.");
}

/// Tells whether the file is a page that has a quiz and no names.
bool isSilentPage(const ExportDraft& draft) {
  const render::ExportFormat* format = formatOf(draft.kind);
  const render::OptionList options =
      format && format->options ? format->options() : render::OptionList();
  const bool page = std::any_of(
      options.begin(), options.end(),
      [](const render::ExportOption* one) { return std::string_view(one->id) == "pageQuiz"; });
  return page && draft.order.of<render::StudentsOptions>().quiz == render::QuizMode::only;
}

QString privacyText(const ExportDraft& draft) {
  if (isSilentPage(draft))
    return tr(
        "No name of a structure can be read in the file; answers are there as checksums. No "
        "paths, user names, dates or patient data are.");
  if (pageUseOf(draft.kind) == render::PageUse::slides)
    return tr(
        "Names, and the views' texts and notes, are in the file as the scene has them. No "
        "paths, user names, dates or patient data are.");
  return holdsNames(draft.kind)
             ? tr("Names of structures, groups and views are in the file as the scene has them. No "
                  "paths, user names, dates or patient data are.")
             : tr("Nothing is in the file but what is seen: no paths, user names, dates or patient "
                  "data.");
}

}  // namespace

QString titleOf(const render::ExportFormat& format) {
  return QCoreApplication::translate("sline::render::ExportFormat", format.title);
}

QString helpOf(const render::ExportFormat& format) {
  return QCoreApplication::translate("sline::render::ExportFormat", format.help);
}

QString millimetresText(const render::ExportPage& page) {
  const auto side = [](float millimetres) {
    const float tenths = std::round(10.0f * millimetres) / 10.0f;
    return QLocale().toString(double(tenths), 'f', tenths == std::round(tenths) ? 0 : 1);
  };
  return tr("%1 × %2 mm").arg(side(page.sizeMm.x), side(page.sizeMm.y));
}

QString pixelsText(const render::ExportPage& page) {
  const glm::ivec2 pixels = render::pixelsOf(page);
  return tr("%1 × %2 pixels").arg(numberText(pixels.x), numberText(pixels.y));
}

QStringList exportSummary(const ExportDraft& draft, const std::vector<render::ExportPiece>& files,
                          const std::vector<render::ExportPiece>& pages,
                          std::optional<double> bytes) {
  QStringList sentences{subjectText(draft, files), cardText(draft, files.front().order)};
  if (pageUseOf(draft.kind) != render::PageUse::none)
    sentences << labelText(draft, pages) << sizeText(draft, files);
  sentences << weightText(files, bytes) << privacyText(draft) << descriptionText(draft)
            << creditText(draft);
  sentences.removeAll(QString());
  return sentences;
}

QString exportDoubt(const std::vector<render::ExportPiece>& pages) {
  for (const render::ExportPiece& file : pages) {
    if (shownStructures(file.order.scene) > 0)
      continue;
    return pages.size() == 1 ? tr("No structure is shown: the picture would be empty.")
                             : tr("The view “%1” shows no structure: its picture would be empty.")
                                   .arg(QString::fromStdString(file.order.viewName));
  }
  return {};
}

QString exportRemarks(const ExportDraft& draft, const render::ExportOrder& order,
                      const render::ExportNotes& page) {
  constexpr qsizetype most = 3;  // lines; the rest is reported when all is written
  render::ExportNotes notes = page;
  for (const render::ExportNote& note : formatOf(draft.kind)->foreseen(order))
    render::addNote(notes, note);
  if (!render::namesSources(*formatOf(draft.kind)))
    for (const render::ExportNote& note : render::creditNotes(order))
      render::addNote(notes, note);
  QStringList remarks = noteTexts(notes);
  const bool sheet =
      isSheet(draft) && draft.order.of<render::SheetOptions>().kind != render::SheetKind::patient;
  if (sheet && !draft.order.of<render::SheetOptions>().text.empty())
    remarks.prepend(tr("The text is for a patient's sheet: this one does not have it."));
  return remarks.mid(0, most).join(QLatin1Char('\n'));
}

}  // namespace sline::widgets
