// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/note_texts.h"

#include <QLocale>

#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

/// Returns the user's name for a mark, given the renderer's.
QString markName(const QString& name) {
  if (name.startsWith(QLatin1String("side ")))
    return name.mid(5);
  if (name == QLatin1String("view"))
    return tr("the view's name");
  if (name == QLatin1String("scale"))
    return tr("the scale bar");
  if (name == QLatin1String("legend"))
    return tr("the legend");
  if (name == QLatin1String("caption"))
    return tr("the view's text");
  if (name.startsWith(QLatin1String("gamma")))
    return tr("what Γ follows");
  return tr("what sections have taken away");
}

QString listed(const render::ExportNote& note) {
  constexpr qsizetype longest = 60;  // characters of a name
  constexpr std::size_t most = 5;
  const bool marks = note.kind == render::ExportNote::Kind::marksWithoutRoom;
  QStringList names;
  for (std::size_t i = 0; i < std::min(most, note.names.size()); ++i) {
    QString name = QString::fromStdString(note.names[i]).simplified();
    if (name.size() > longest)
      name = name.left(longest) + QChar(u'…');
    names << (marks ? markName(name) : tr("“%1”").arg(name));
  }
  const QString list = names.join(QStringLiteral(", "));
  return note.names.size() > most
             ? tr("%1 and %n more", nullptr, int(note.names.size() - most)).arg(list)
             : list;
}

/// Returns the same of what holds for the file as a whole.
QString factOfFile(render::ExportNote::Kind kind) {
  using Kind = render::ExportNote::Kind;
  switch (kind) {
    case Kind::standsOnWhite:
      return tr("What is transparent stands on white.");
    case Kind::depthNotKept:
      return tr("This kind has fewer bits than were chosen.");
    case Kind::filmRounded:
      return tr("The film is %1 pixels large, as its sides are even numbers.");
    case Kind::filmStretched:
      return tr("The film takes %1 seconds, as it has whole pictures alone.");
    case Kind::pageLarge:
      return tr("The page has %1 million triangles, too many for telephones.");
    case Kind::pageSimplified:
      return tr("Surfaces are simplified and off by %1 mm at most, which the page says.");
    case Kind::pictureFramed:
      return tr(
          "Anatomy leaves no ground for names: the drawing ends at a frame, %1 mm within the "
          "page's "
          "left and right edge.");
    case Kind::creditsLeftOut:
      return tr("The file does not say whose work its surfaces are, as their terms ask: %1.");
    case Kind::subtitlesEmpty:
      return tr("The subtitles are empty, as no view says anything.");
    case Kind::quizEmpty:
      return tr("The quiz asks nothing, as no label is to be asked for.");
    default:
      return {};
  }
}

/// Returns the fact alone, without what to do; `%1` stands for the names.
QString fact(const render::ExportNote& note) {
  using Kind = render::ExportNote::Kind;
  const auto count = int(note.names.size());
  switch (note.kind) {
    case Kind::labelsWithoutRoom:
      return tr("%n labels found no room: %1.", nullptr, count);
    case Kind::labelsOfHidden:
      return tr("%n labels are left out, as nothing is drawn there: %1.", nullptr, count);
    case Kind::labelsOffPage:
      return tr("%n labels point to places beside the picture: %1.", nullptr, count);
    case Kind::labelsHidden:
      return tr("%n labels point with a dashed line to what is hidden in this picture: %1.",
                nullptr, count);
    case Kind::labelsOnAnatomy:
      return tr("%n labels stand on anatomy, which leaves no room beside it: %1.", nullptr, count);
    case Kind::labelsUntranslated:
      return tr("%n labels have no text in the language and stand in the scene's own: %1.", nullptr,
                count);
    case Kind::cardsWithoutRoom:
      return tr("%n labels found no room and have no card: %1.", nullptr, count);
    case Kind::labelsNotAsked:
      return tr("%n labels are not asked for, as one does not see there what is named: %1.",
                nullptr, count);
    case Kind::labelsDoubted:
      return tr("%n labels are not asked for, as what they name may lie on the other side: %1.",
                nullptr, count);
    case Kind::marksWithoutRoom:
      return tr("At the picture's edge there is no room for: %1.");
    case Kind::legendWithoutRoom:
      return tr("%n structures found no room in the legend: %1.", nullptr, count);
    case Kind::legendEmpty:
      return tr("The legend is empty: nothing that is shown has a label, or is in focus.");
    case Kind::sidesUnknown:
      return tr("R and L are left out: nobody knows the directions of what is drawn.");
    case Kind::textShortened:
      return tr("%n texts are shortened: %1.", nullptr, count);
    case Kind::footCutOff:
      return tr(
          "The picture ends %1 mm above its foot, as what is written there has no other "
          "room.");
    case Kind::sectionsUncut:
      return tr("%n sections cut nothing in the file, which holds whole surfaces: %1.", nullptr,
                count);
    case Kind::noiseNotDrawn:
      return tr("%n structures are drawn without noise, which is made of pixels: %1.", nullptr,
                count);
    default:
      return factOfFile(note.kind);
  }
}

QString remedy(render::ExportNote::Kind kind) {
  using Kind = render::ExportNote::Kind;
  switch (kind) {
    case Kind::labelsWithoutRoom:
      return tr("Take a larger page, smaller letters, or numbers.");
    case Kind::labelsOfHidden:
      return tr("Show the structures, or hide the labels, too.");
    case Kind::labelsOffPage:
      return tr("Choose a view that shows them.");
    case Kind::labelsHidden:
    case Kind::labelsNotAsked:
      return tr("Choose a view that shows it, or draw less of what is before it.");
    case Kind::labelsDoubted:
      return tr("Say that names are right, or give it another name.");
    case Kind::labelsOnAnatomy:
      return tr("Choose a view that leaves some, a larger page or smaller letters.");
    case Kind::pictureFramed:
      return tr("Choose a view from farther away, or no labels.");
    case Kind::labelsUntranslated:
      return tr("Write them in the list of labels, or choose another language.");
    case Kind::legendWithoutRoom:
      return tr("Take a larger page or smaller letters, or list fewer.");
    case Kind::legendEmpty:
      return tr("Let it list all structures.");
    case Kind::cardsWithoutRoom:
    case Kind::marksWithoutRoom:
      return tr("Take a larger page or smaller letters.");
    case Kind::sidesUnknown:
      return tr("Say them when the files are imported.");
    case Kind::textShortened:
      return tr("Write less, or take larger paper.");
    case Kind::footCutOff:
      return tr("Choose a view that leaves room, or leave words or credits out.");
    case Kind::sectionsUncut:
      return tr("Export a picture or a drawing to show the cut.");
    case Kind::noiseNotDrawn:
      return tr("Export a picture, or take streamline hatching.");
    case Kind::standsOnWhite:
      return tr("Take PNG, TIFF, SVG or WebP to keep it transparent.");
    case Kind::depthNotKept:
      return tr("Take PNG or TIFF for more.");
    case Kind::pageLarge:
      return tr("Let surfaces be off by 0.2 mm, or export less.");
    case Kind::creditsLeftOut:
      return tr("Let it say them in a line, or say them where it is published.");
    case Kind::subtitlesEmpty:
      return tr("Write what views say.");
    case Kind::quizEmpty:
      return tr("Label structures, or choose no quiz.");
    case Kind::filmRounded:
    case Kind::filmStretched:
    case Kind::pageSimplified:
      return {};
  }
  return {};
}

/// Returns the detail; a number, in seconds, is written as the locale writes it.
QString detailOf(const render::ExportNote& note) {
  const QString detail = QString::fromStdString(note.detail);
  bool isNumber = false;
  const double number = detail.toDouble(&isNumber);
  return isNumber ? QLocale().toString(number, 'g', 6) : detail;
}

}  // namespace

QString noteText(const render::ExportNote& note) {
  const QString text = fact(note);
  const QString filled = text.contains(QLatin1String("%1"))
                             ? text.arg(note.names.empty() ? detailOf(note) : listed(note))
                             : text;
  return (filled + QLatin1Char(' ') + remedy(note.kind)).trimmed();
}

QStringList noteTexts(const render::ExportNotes& notes) {
  QStringList texts;
  for (const render::ExportNote& note : notes)
    texts << noteText(note);
  return texts;
}

}  // namespace sline::widgets
