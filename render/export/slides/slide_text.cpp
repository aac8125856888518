// SPDX-License-Identifier: Apache-2.0
#include "render/export/slides/slide_text.h"

#include <QLocale>
#include <QString>
#include <algorithm>
#include <cmath>

#include "model/scene/markup.h"
#include "render/export/encoding/xml_text.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

constexpr float leastShare = 0.25f;
constexpr float lineOfPoints = 1.2f;  // a line's height, in sizes of the font
constexpr float brokenLine = 1.05f;   // as lines end between words, they hold less

bool runsFromRight(const std::string& text) {
  return QString::fromStdString(text).isRightToLeft();
}

/// Returns a paragraph that says in which direction it runs: some programs let it run as the one
/// before.
std::string paragraph(const std::string& runs, bool rightToLeft) {
  return std::string("<a:p><a:pPr ") +
         (rightToLeft ? "algn=\"r\" rtl=\"1\"" : "algn=\"l\" rtl=\"0\"") + "/>" + runs + "</a:p>";
}

}  // namespace

std::string slideXmlText(const std::string& text) {
  QString clean = QString::fromStdString(text);
  clean.removeIf([](QChar c) { return c.category() == QChar::Other_Control; });
  return xmlText(clean.toStdString());
}

long emu(double millimetres) {
  return std::lround(36'000.0 * millimetres);
}

std::string slideLanguage(const std::string& tag) {
  if (tag.empty())
    return {};
  const QLocale locale(QString::fromStdString(tag));
  if (locale.language() == QLocale::C)
    return slideXmlText(tag);
  // The locale's own name is language and region ("de_DE").
  return locale.name().replace(QLatin1Char('_'), QLatin1Char('-')).toStdString();
}

std::string slideBullet(float marginMm, const std::string& side, bool rightToLeft,
                        const std::string& leading) {
  const std::string margin = std::to_string(emu(double(marginMm)));
  // In text from the right, too, programs take this margin for that of the bullet's side.
  return "<a:pPr marL=\"" + margin + "\" indent=\"-" + margin + "\" algn=\"" + side + "\" rtl=\"" +
         (rightToLeft ? "1" : "0") + "\">" + leading +
         "<a:buFont typeface=\"Arial\"/><a:buChar char=\"\u2022\"/></a:pPr>";
}

std::string slideRun(const std::string& text, const model::LetterStyle& style,
                     const RunLook& look) {
  const std::string words = slideXmlText(text);
  if (words.empty())
    return {};
  std::string attributes;
  if (const std::string language = slideLanguage(look.language); !language.empty())
    attributes += " lang=\"" + language + "\"";
  if (look.points > 0.0f)
    attributes += " sz=\"" + std::to_string(std::lround(100.0f * look.points)) + "\"";
  attributes += style.bold ? " b=\"1\"" : "";
  attributes += style.italic ? " i=\"1\"" : "";
  const std::string properties =
      "<a:rPr" + attributes +
      (look.inside.empty() ? std::string("/>") : ">" + look.inside + "</a:rPr>");
  return "<a:r>" + properties + "<a:t>" + words + "</a:t></a:r>";
}

std::string lineParagraphs(const SlideWords& words) {
  const std::string line = plainLine(words.text);
  return paragraph(slideRun(line, {}, {.language = words.language, .inside = {}}),
                   runsFromRight(line));
}

std::string plainParagraphs(const SlideWords& words) {
  const std::string shown = model::withoutLinks(words.text);
  std::string all;
  std::string_view rest = shown;
  while (true) {
    const std::size_t end = rest.find('\n');
    const std::string line(rest.substr(0, end));
    all += paragraph(slideRun(line, {}, {.language = words.language, .inside = {}}),
                     runsFromRight(line));
    if (end == std::string_view::npos)
      return all;
    rest.remove_prefix(end + 1);
  }
}

std::string markedParagraphs(const SlideWords& words) {
  std::string all;
  for (const model::MarkedLine& line : model::markedLines(words.text)) {
    std::string runs;
    std::string plain;
    for (const model::MarkedRun& run : line.runs) {
      runs += slideRun(run.text, run.style, {.language = words.language, .inside = {}});
      plain += run.text;
    }
    const bool right = runsFromRight(plain);
    if (line.bullet) {
      all += "<a:p>";
      all += slideBullet(18.0f * millimetresPerPoint, right ? "r" : "l", right);
      all += runs + "</a:p>";
    } else {
      all += paragraph(runs, right);
    }
  }
  return all.empty() ? "<a:p/>" : all;
}

std::string keyParagraphs(const std::vector<SlideKeyLine>& lines) {
  std::string all;
  for (const SlideKeyLine& line : lines)
    all += paragraph((line.number > 0 ? slideRun(std::to_string(line.number), {.bold = true}) +
                                            slideRun("\u2002", {})
                                      : std::string()) +
                         slideRun(plainLine(line.words.text), {},
                                  {.language = line.words.language, .inside = {}}),
                     runsFromRight(line.words.text));
  return all.empty() ? "<a:p/>" : all;
}

float shareThatFits(const std::vector<std::string>& lines, float points, const glm::vec2& boxMm,
                    int columns) {
  std::vector<float> widths;
  widths.reserve(lines.size());
  for (const std::string& line : lines)
    widths.push_back(textWidthMm(TextLine(QString::fromStdString(line)), points));
  const float column = boxMm.x / float(columns);
  const float height = lineOfPoints * points * millimetresPerPoint;
  constexpr float step = 0.05f;
  float share = 1.0f;
  for (; share > leastShare; share -= step) {
    float rows = 0.0f;
    for (const float width : widths)
      rows += std::max(1.0f, std::ceil(brokenLine * share * width / column));
    const float perColumn = std::floor(boxMm.y / (share * height));
    if (rows <= perColumn * float(columns))
      break;
  }
  return std::max(share, leastShare);
}

std::string fittedBody(float share, int columns) {
  std::string body = "<a:bodyPr";
  if (columns > 1)
    body += " numCol=\"" + std::to_string(columns) + "\" spcCol=\"180000\"";
  // In thousandths of a percent.
  const long scale = std::lround(100'000.0 * double(share));
  return body + (scale < 100'000
                     ? "><a:normAutofit fontScale=\"" + std::to_string(scale) + "\"/></a:bodyPr>"
                     : "><a:normAutofit/></a:bodyPr>");
}

}  // namespace sline::render
