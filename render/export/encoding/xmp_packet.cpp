// SPDX-License-Identifier: Apache-2.0
#include "render/export/encoding/xmp_packet.h"

#include "render/export/encoding/xml_text.h"

namespace sline::render {

std::string xmpPacket(const ExportCredit& credit) {
  if (credit.empty())
    return {};
  // A language that is not known is the default one.
  const std::string& language = credit.descriptionLanguage;
  // The names and the packet's id are those of §7.
  std::string xmp =
      "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
      "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
      "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
      "<rdf:Description rdf:about=\"\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n";
  if (!credit.author.empty())
    xmp += "<dc:creator><rdf:Seq><rdf:li>" + xmlText(credit.author) +
           "</rdf:li></rdf:Seq></dc:creator>\n";
  if (!credit.copyright.empty())
    xmp += "<dc:rights><rdf:Alt><rdf:li xml:lang=\"x-default\">" + xmlText(credit.copyright) +
           "</rdf:li></rdf:Alt></dc:rights>\n";
  if (!credit.description.empty()) {
    xmp += "<dc:description><rdf:Alt><rdf:li xml:lang=\"x-default\">" +
           xmlText(credit.description) + "</rdf:li>";
    if (!language.empty())
      xmp += "<rdf:li xml:lang=\"" + xmlText(language) + "\">" + xmlText(credit.description) +
             "</rdf:li>";
    xmp += "</rdf:Alt></dc:description>\n";
  }
  return xmp + "</rdf:Description>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"r\"?>";
}

}  // namespace sline::render
