// SPDX-License-Identifier: Apache-2.0
// Writes paragraphs of DrawingML (ECMA-376 part 1, §21.1.2).
#pragma once

#include <string>
#include <vector>

#include "render/export/slides/slide_deck.h"

namespace sline::render {

/// Returns millimetres as DrawingML counts them, in units of 1/36000 of one.
long emu(double millimetres);

/// Returns text of any origin as XML may hold it, without characters that control something.
std::string slideXmlText(const std::string& text);

/// Returns a BCP 47 tag with the region that is usual for it ("de-DE"), as presentations name
/// languages; an empty text for an empty tag.
std::string slideLanguage(const std::string& tag);

/// Describes the letters of a run beside their style.
struct RunLook {
  std::string language;  ///< BCP 47 tag
  std::string inside;    ///< what the run's properties hold: XML
  float points = 0.0f;   ///< 0: those of the placeholder
};

/// Returns the properties of a paragraph with a bullet, whose lines begin so far from its side;
/// `leading` is the property of its lines' distance.
std::string slideBullet(float marginMm, const std::string& side, bool rightToLeft,
                        const std::string& leading = {});

/// Returns a run; one without words gives nothing.
std::string slideRun(const std::string& text, const model::LetterStyle& style,
                     const RunLook& look = {});

/// Returns a placeholder's text of one paragraph; blanks stand in place of breaks.
std::string lineParagraphs(const SlideWords& words);
/// Returns paragraphs of plain text, one for each of its lines.
std::string plainParagraphs(const SlideWords& words);
/// Returns paragraphs of text that is marked up as callouts are.
std::string markedParagraphs(const SlideWords& words);
/// Returns a paragraph for each line of a key.
std::string keyParagraphs(const std::vector<SlideKeyLine>& lines);

/// Returns the part of its size in which lines of text have room in a box, 0.25 … 1, when they
/// flow through so many columns.
float shareThatFits(const std::vector<std::string>& lines, float points, const glm::vec2& boxMm,
                    int columns = 1);
/// Returns the body properties of a placeholder of which the text is so much smaller.
std::string fittedBody(float share, int columns = 1);

}  // namespace sline::render
