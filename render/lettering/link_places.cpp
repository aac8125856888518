// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/link_places.h"

#include <QTextLayout>
#include <algorithm>
#include <limits>
#include <optional>

namespace sline::render {

namespace {

// Of a letter's size, above and below the baseline.
constexpr float aboveLetters = 0.95f;
constexpr float belowLetters = 0.3f;

/// Holds a letter as it was written, and its link if it has one.
struct WrittenLetter {
  QChar letter;
  std::optional<std::size_t> link;
};

/// Tells which letters of set lines are of which link: they follow in the order of the text, with
/// bullets, hyphens and ellipses between them that it does not have.
class LinkedLetters {
 public:
  explicit LinkedLetters(const std::string& markup) {
    for (const model::MarkedLine& line : model::markedLines(markup))
      for (const model::MarkedRun& run : line.runs) {
        if (run.link)
          m_links.push_back(*run.link);
        for (const QChar letter : QString::fromStdString(run.text))
          if (!letter.isSpace())
            m_letters.push_back(
                {letter, run.link ? std::optional(m_links.size() - 1) : std::nullopt});
      }
  }

  const model::MarkupLink& link(std::size_t at) const { return m_links[at]; }
  bool none() const { return m_links.empty(); }

  /// Returns the link of each letter of the next line; blanks within a link belong to it.
  std::vector<std::optional<std::size_t>> next(const TextLine& line) {
    const QString text = plainText(line);
    std::vector<std::optional<std::size_t>> links(std::size_t(text.size()));
    std::optional<std::size_t> last;
    std::size_t blanks = 0;
    for (std::size_t i = 0; i < links.size(); ++i) {
      const QChar letter = text[qsizetype(i)];
      if (letter.isSpace()) {
        ++blanks;
        continue;
      }
      const bool added = line.hyphenated && i + 1 == links.size();
      if (!added && m_at < m_letters.size() && m_letters[m_at].letter == letter)
        links[i] = m_letters[m_at++].link;
      if (links[i] && links[i] == last)
        std::fill_n(links.begin() + std::ptrdiff_t(i - blanks), blanks, last);
      last = links[i];
      blanks = 0;
    }
    return links;
  }

 private:
  std::vector<WrittenLetter> m_letters;
  std::vector<model::MarkupLink> m_links;
  std::size_t m_at = 0;
};

/// Returns the left and the right edge of some letters of a run, in pixels of its font; letters
/// that run from the right end at their left.
std::pair<float, float> edgesOf(const TextRun& run, std::size_t first, std::size_t last) {
  QTextLayout layout(run.text, labelFont(run.style));
  layout.beginLayout();
  QTextLine line = layout.createLine();
  line.setLineWidth(std::numeric_limits<float>::max());
  layout.endLayout();
  const auto from = float(line.cursorToX(int(first)));
  const auto to = float(line.cursorToX(int(last)));
  return std::minmax(from, to);
}

}  // namespace

std::vector<LinkPlace> linkPlaces(const std::string& markup, const LetteringText& text) {
  LinkedLetters letters(markup);
  std::vector<LinkPlace> found;
  if (letters.none())
    return found;
  const float em = text.points * millimetresPerPoint;
  float baseline = text.at.y;
  for (const TextLine& line : text.lines) {
    const std::vector<std::optional<std::size_t>> links = letters.next(line);
    const std::vector<float> places = runPlaces(text, line);
    std::size_t start = 0;
    for (std::size_t r = 0; r < line.runs.size(); ++r) {
      const std::size_t end = start + std::size_t(line.runs[r].text.size());
      for (std::size_t i = start; i < end;) {
        std::size_t j = i + 1;
        while (j < end && links[j] == links[i])
          ++j;
        if (links[i]) {
          const auto [left, right] = edgesOf(line.runs[r], i - start, j - start);
          const float origin = text.at.x + places[r];
          const float scale = em / float(labelFontPixels);
          found.push_back({.box = {{origin + left * scale, baseline - aboveLetters * em},
                                   {origin + right * scale, baseline + belowLetters * em}},
                           .baseline = baseline,
                           .link = letters.link(*links[i])});
        }
        i = j;
      }
      start = end;
    }
    baseline += text.leading;
  }
  return found;
}

std::vector<LinkPlace> linkPlaces(const LabelPlate& plate) {
  std::vector<LinkPlace> found;
  const bool linked = plate.style.mode == LabelMode::on &&
                      std::any_of(plate.labels.begin(), plate.labels.end(), [](const auto& label) {
                        return label.item.kind == model::AnnotationKind::callout &&
                               label.text.find("](#") != std::string::npos;
                      });
  if (!linked)
    return found;
  const Lettering lettering = letteringOf(plate);
  std::size_t item = 0;
  for (const ShownLabel& label : plate.labels) {
    if (!plate.layout.find(label.item.id))
      continue;
    const std::optional<LetteringText>& text = lettering.items[item++].text;
    if (label.item.kind != model::AnnotationKind::callout || !text)
      continue;
    for (LinkPlace& place : linkPlaces(label.text, *text))
      found.push_back(std::move(place));
  }
  return found;
}

}  // namespace sline::render
