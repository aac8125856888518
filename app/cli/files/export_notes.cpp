// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/export_notes.h"

#include <algorithm>

namespace sline::cli {

namespace {

/// Returns the text on one line, without characters that a terminal would obey.
std::string plain(const std::string& text) {
  constexpr std::size_t longest = 80;
  std::string line = text;
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  if (line.size() <= longest)
    return line;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0u) == 0x80u)
    --end;
  return line.substr(0, end) + "…";
}

/// Returns `"liver", "spleen" and 4 more`.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    list += (i == 0 ? "\"" : ", \"") + plain(names[i]) + "\"";
  if (names.size() > most)
    list += " and " + std::to_string(names.size() - most) + " more";
  return list;
}

std::string counted(std::size_t count, const std::string& one, const std::string& several) {
  return count == 1 ? "1 " + one : std::to_string(count) + " " + several;
}

/// Returns the text of a note on a film's size or length.
std::string filmText(const render::ExportNote& note) {
  if (note.kind == render::ExportNote::Kind::filmRounded)
    return "the film is " + plain(note.detail) +
           " pixels large, as sides of films are even numbers. Give an even --film-height";
  return "the film takes " + plain(note.detail) +
         " seconds, as it has whole frames alone. Give --seconds that --fps divides evenly";
}

/// Returns the text of a note on a film, or on what pixels of a kind of file cannot hold.
std::string pixelText(const render::ExportNote& note) {
  if (note.kind == render::ExportNote::Kind::filmRounded ||
      note.kind == render::ExportNote::Kind::filmStretched)
    return filmText(note);
  if (note.kind == render::ExportNote::Kind::standsOnWhite)
    return "what is transparent stands on white, as files of this kind have no transparency. "
           "Take --png, --tiff, --svg or --webp for that";
  return "a channel has fewer than " + plain(note.detail) +
         " bits, as in all files of this kind. Take --png or --tiff for more";
}

/// Returns the text of a note on labels that a test does not ask for.
std::string askedText(const render::ExportNote& note) {
  const std::size_t count = note.names.size();
  const std::string names = ": " + listed(note.names) + ". ";
  if (note.kind == render::ExportNote::Kind::labelsNotAsked)
    return counted(count, "label is", "labels are") +
           " not asked for, as one does not see there what is named" + names +
           "Choose a view that shows it, or draw less of what is before it";
  if (note.kind == render::ExportNote::Kind::labelsDoubted)
    return counted(count, "label is", "labels are") +
           " not asked for, as what is named may lie on the other side" + names +
           "Say that names are right with --sides right, or give it another name";
  return counted(count, "label", "labels") + " found no room and " + (count == 1 ? "has" : "have") +
         " no card" + names + "Take a larger page (--size-mm) or smaller letters (--label-size)";
}

/// Returns the text of a note on what a file lacks besides its picture.
std::string besidesText(const render::ExportNote& note) {
  if (note.kind == render::ExportNote::Kind::subtitlesEmpty)
    return "the subtitles are empty, as no view in the film says anything. Write what views say "
           "with `sline view --text`";
  return "the file does not say whose work its surfaces are, as their terms ask: " +
         listed(note.names) + ". Give --credits line, or say it where the file is published";
}

/// Returns the text of a note on marks that have no room in the picture.
std::string marksText(const render::ExportNote& note) {
  if (note.kind == render::ExportNote::Kind::footCutOff)
    return "the picture ends " + plain(note.detail) +
           " mm above its foot, as what is written there has no other room. Choose a view that "
           "leaves some, or leave words or credits out (--marks, --credits)";
  return counted(note.names.size(), "mark", "marks") +
         " at the picture's edge found no room: " + listed(note.names) +
         ". Take a larger page, smaller letters (--label-size) or fewer marks (--marks)";
}

/// Returns the text of a note on a students' page.
std::string pageText(const render::ExportNote& note) {
  if (note.kind == render::ExportNote::Kind::pageLarge)
    return "the page has " + plain(note.detail) +
           " million triangles, too many for telephones. Give --page-triangles 500000 or "
           "--page-error 0.2, which simplify surfaces, or export less with --only";
  if (note.kind == render::ExportNote::Kind::pageSimplified)
    return "surfaces are simplified and off by " + plain(note.detail) +
           " mm at most, which the page says. Leave out --page-triangles and --page-error for "
           "exact ones";
  return "the quiz asks nothing, as no label is to be asked for. Label structures with `sline "
         "annotate`, or give --quiz off";
}

std::string labelsText(const render::ExportNote& note) {
  using Kind = render::ExportNote::Kind;
  const std::size_t count = note.names.size();
  const std::string names = ": " + listed(note.names) + ". ";
  switch (note.kind) {
    case Kind::labelsWithoutRoom:
      return counted(count, "label", "labels") + " found no room" + names +
             "Take a larger page, smaller letters (--label-size) or numbers (--labels numbers)";
    case Kind::labelsOfHidden:
      return counted(count, "label is", "labels are") + " left out, as nothing is drawn there" +
             names + "Show the structures, or leave them out of the view, too";
    case Kind::labelsOffPage:
      return counted(count, "label points", "labels point") + " to places beside the picture" +
             names + "Choose a view that shows them";
    case Kind::labelsHidden:
      return counted(count, "label points", "labels point") +
             " with a dashed line to what is hidden in this picture" + names +
             "Choose a view that shows it, or draw less of what is before it";
    case Kind::labelsOnAnatomy:
      return counted(count, "label stands", "labels stand") +
             " on anatomy, which leaves no room beside it" + names +
             "Choose a view that leaves some, a larger page or smaller letters (--label-size)";
    case Kind::pictureFramed:
      return "anatomy leaves no ground for names: the drawing ends at a frame, " + note.detail +
             " mm within the page's left and right edge. Choose a view from farther away, or "
             "--labels off";
    case Kind::labelsUntranslated:
      return counted(count, "label has", "labels have") + " no text in " + plain(note.detail) +
             " and " + (count == 1 ? "stands" : "stand") + " in the scene's own language" + names +
             "Add one with `sline annotate`, or choose another --language";
    default:
      return {};
  }
}

}  // namespace

std::string textOf(const render::ExportNote& note) {
  using Kind = render::ExportNote::Kind;
  const std::size_t count = note.names.size();
  const std::string names = ": " + listed(note.names) + ". ";
  switch (note.kind) {
    case Kind::labelsWithoutRoom:
    case Kind::labelsOfHidden:
    case Kind::labelsOffPage:
    case Kind::labelsHidden:
    case Kind::labelsOnAnatomy:
    case Kind::pictureFramed:
    case Kind::labelsUntranslated:
      return labelsText(note);
    case Kind::labelsNotAsked:
    case Kind::labelsDoubted:
    case Kind::cardsWithoutRoom:
      return askedText(note);
    case Kind::creditsLeftOut:
    case Kind::subtitlesEmpty:
      return besidesText(note);
    case Kind::marksWithoutRoom:
    case Kind::footCutOff:
      return marksText(note);
    case Kind::legendWithoutRoom:
      return counted(count, "structure", "structures") + " found no room in the legend" + names +
             "Take a larger page or smaller letters (--label-size), or list fewer (--legend)";
    case Kind::legendEmpty:
      return "the legend is empty, as nothing shown has a label or is in focus. Take --legend all";
    case Kind::sidesUnknown:
      return "R and L are left out: nobody knows the directions of what is drawn. Say them with "
             "--frame LPS or RAS where the files are read";
    case Kind::textShortened:
      return counted(count, "text was", "texts were") + " too long and " +
             (count == 1 ? "is" : "are") + " shortened" + names +
             "Write less, or take larger paper";
    case Kind::sectionsUncut:
      return counted(count, "section cuts", "sections cut") +
             " nothing in the file, which holds whole surfaces" + names +
             "Write a picture or a drawing to show the cut";
    case Kind::noiseNotDrawn:
      return counted(count, "structure is", "structures are") + " drawn without noise" + names +
             "It is made of pixels: write a picture, or take --technique streamline_hatching";
    case Kind::standsOnWhite:
    case Kind::depthNotKept:
    case Kind::filmRounded:
    case Kind::filmStretched:
      return pixelText(note);
    case Kind::pageLarge:
    case Kind::pageSimplified:
    case Kind::quizEmpty:
      return pageText(note);
  }
  return {};
}

std::string factOf(const render::ExportNote& note) {
  const std::string text = textOf(note);
  return text.substr(0, text.rfind(". "));  // what to do is the last sentence
}

}  // namespace sline::cli
