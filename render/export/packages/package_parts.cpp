// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/package_parts.h"

#include <glm/common.hpp>

#include "render/export/anki/anki_deck.h"
#include "render/export/encoding/xml_text.h"

namespace sline::render {

std::string lineElementText(std::string_view words) {
  return xmlText(plainLine(words));
}

std::string xmlAttribute(const char* name, std::string_view value) {
  return ' ' + std::string(name) + "=\"" + lineElementText(value) + '"';
}

std::string personCard(std::string_view name) {
  return "BEGIN:VCARD&#10;VERSION:3.0&#10;FN:" + lineElementText(name) + "&#10;END:VCARD";
}

std::string lomElement(const std::string& title, const std::string& language,
                       const ExportCredit& credit) {
  const auto words = [&language](const std::string& text) {
    return "<lom:string" + xmlAttribute("language", language) + '>' + lineElementText(text) +
           "</lom:string>";
  };
  std::string xml =
      "<lom:lom><lom:general><lom:title>" + words(title) + "</lom:title></lom:general>";
  if (!credit.author.empty())
    xml +=
        "<lom:lifeCycle><lom:contribute><lom:role><lom:source>LOMv1.0</lom:source>"
        "<lom:value>author</lom:value></lom:role><lom:entity>" +
        personCard(credit.author) + "</lom:entity></lom:contribute></lom:lifeCycle>";
  if (!credit.copyright.empty())
    xml += "<lom:rights><lom:description>" + words(credit.copyright) +
           "</lom:description></lom:rights>";
  return xml + "</lom:lom>";
}

std::string uuidOf(const std::string& name) {
  const std::string digits = hexOf(fingerprintOf(name)) + hexOf(fingerprintOf(name + "#"));
  return digits.substr(0, 8) + '-' + digits.substr(8, 4) + "-4" + digits.substr(13, 3) + "-a" +
         digits.substr(17, 3) + '-' + digits.substr(20, 12);
}

std::vector<glm::ivec2> pixelOutline(const QuestionZone& zone, const glm::ivec2& size) {
  std::vector<glm::ivec2> pixels;
  for (const glm::vec2& place : zone.outline)
    if (const auto pixel = glm::ivec2(glm::round(place * glm::vec2(size)));
        pixels.empty() || pixel != pixels.back())
      pixels.push_back(pixel);
  return pixels;
}

}  // namespace sline::render
