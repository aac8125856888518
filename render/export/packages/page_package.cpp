// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/page_package.h"

#include <QString>
#include <algorithm>
#include <utility>

#include "render/export/anki/anki_deck.h"
#include "render/export/packages/package_parts.h"

namespace sline::render {

namespace {

constexpr const char* startPage = "index.html";

/// Returns a number with a point, without zeros at its end.
std::string pointNumber(double value) {
  return QString::number(value, 'g', 6).toStdString();
}

/// Returns a name of those files: the same files have the same one.
std::string nameOfFiles(const std::map<std::string, std::string>& files) {
  std::string name;
  for (const auto& [file, bytes] : files)
    name += file + ' ' + hexOf(fingerprintOf(bytes)) + ' ';
  return name;
}

std::string fileElements(const std::map<std::string, std::string>& files) {
  std::string xml;
  for (const auto& [name, bytes] : files)
    xml += "      <file" + xmlAttribute("href", name) + "/>\n";
  return xml;
}

/// Returns what SCORM 1.2 says of a whole package, by IMS' early metadata.
std::string earlyMetadata(const PageAbout& about) {
  const auto words = [&about](const std::string& text) {
    return "<imsmd:langstring" + xmlAttribute("xml:lang", about.language) + '>' +
           lineElementText(text) + "</imsmd:langstring>";
  };
  const auto term = [](const char* text) {
    return std::string("<imsmd:langstring xml:lang=\"x-none\">") + text + "</imsmd:langstring>";
  };
  std::string xml = "<imsmd:lom><imsmd:general><imsmd:title>" + words(about.title) +
                    "</imsmd:title></imsmd:general>";
  if (!about.credit.author.empty())
    xml += "<imsmd:lifecycle><imsmd:contribute><imsmd:role><imsmd:source>" + term("LOMv1.0") +
           "</imsmd:source><imsmd:value>" + term("Author") +
           "</imsmd:value></imsmd:role><imsmd:centity><imsmd:vcard>" +
           personCard(about.credit.author) +
           "</imsmd:vcard></imsmd:centity></imsmd:contribute></imsmd:lifecycle>";
  if (!about.credit.copyright.empty())
    xml += "<imsmd:rights><imsmd:description>" + words(about.credit.copyright) +
           "</imsmd:description></imsmd:rights>";
  return xml + "</imsmd:lom>";
}

std::string scorm12Manifest(const std::map<std::string, std::string>& files,
                            const PageAbout& about) {
  const std::string id = uuidOf(nameOfFiles(files));
  return std::string(xmlHead) + "<manifest identifier=\"page-" + id +
         "\" version=\"1\" xmlns=\"http://www.imsproject.org/xsd/imscp_rootv1p1p2\" "
         "xmlns:adlcp=\"http://www.adlnet.org/xsd/adlcp_rootv1p2\" "
         "xmlns:imsmd=\"http://www.imsglobal.org/xsd/imsmd_rootv1p2p1\" "
         "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
         "xsi:schemaLocation=\"http://www.imsproject.org/xsd/imscp_rootv1p1p2 "
         "imscp_rootv1p1p2.xsd http://www.imsglobal.org/xsd/imsmd_rootv1p2p1 "
         "imsmd_rootv1p2p1.xsd http://www.adlnet.org/xsd/adlcp_rootv1p2 adlcp_rootv1p2.xsd\">\n"
         "  <metadata>\n    <schema>ADL SCORM</schema>\n    <schemaversion>1.2</schemaversion>\n"
         "    " +
         earlyMetadata(about) +
         "\n  </metadata>\n  <organizations default=\"course\">\n"
         "    <organization identifier=\"course\">\n      <title>" +
         lineElementText(about.title) +
         "</title>\n      <item identifier=\"item\" identifierref=\"page\">\n        <title>" +
         lineElementText(about.title) + "</title>\n        <adlcp:masteryscore>" +
         pointNumber(100.0 * about.passing) +
         "</adlcp:masteryscore>\n      </item>\n    </organization>\n  </organizations>\n"
         "  <resources>\n    <resource identifier=\"page\" type=\"webcontent\" "
         "adlcp:scormtype=\"sco\" href=\"" +
         startPage + "\">\n" + fileElements(files) +
         "    </resource>\n  </resources>\n</manifest>\n";
}

std::string scorm2004Manifest(const std::map<std::string, std::string>& files,
                              const PageAbout& about) {
  const std::string id = uuidOf(nameOfFiles(files));
  return std::string(xmlHead) + "<manifest identifier=\"page-" + id +
         "\" version=\"1\" xmlns=\"http://www.imsglobal.org/xsd/imscp_v1p1\" "
         "xmlns:adlcp=\"http://www.adlnet.org/xsd/adlcp_v1p3\" "
         "xmlns:adlseq=\"http://www.adlnet.org/xsd/adlseq_v1p3\" "
         "xmlns:adlnav=\"http://www.adlnet.org/xsd/adlnav_v1p3\" "
         "xmlns:imsss=\"http://www.imsglobal.org/xsd/imsss\" "
         "xmlns:lom=\"http://ltsc.ieee.org/xsd/LOM\" "
         "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
         "xsi:schemaLocation=\"http://www.imsglobal.org/xsd/imscp_v1p1 imscp_v1p1.xsd "
         "http://www.adlnet.org/xsd/adlcp_v1p3 adlcp_v1p3.xsd "
         "http://www.adlnet.org/xsd/adlseq_v1p3 adlseq_v1p3.xsd "
         "http://www.adlnet.org/xsd/adlnav_v1p3 adlnav_v1p3.xsd "
         "http://www.imsglobal.org/xsd/imsss imsss_v1p0.xsd "
         "http://ltsc.ieee.org/xsd/LOM lom.xsd\">\n"
         "  <metadata>\n    <schema>ADL SCORM</schema>\n"
         "    <schemaversion>2004 4th Edition</schemaversion>\n    " +
         lomElement(about.title, about.language, about.credit) +
         "\n  </metadata>\n  <organizations default=\"course\">\n"
         "    <organization identifier=\"course\">\n      <title>" +
         lineElementText(about.title) +
         "</title>\n      <item identifier=\"item\" identifierref=\"page\">\n        <title>" +
         lineElementText(about.title) +
         "</title>\n        <imsss:sequencing>\n          <imsss:objectives>\n"
         "            <imsss:primaryObjective objectiveID=\"quiz\" satisfiedByMeasure=\"true\">"
         "<imsss:minNormalizedMeasure>" +
         pointNumber(about.passing) +
         "</imsss:minNormalizedMeasure></imsss:primaryObjective>\n          </imsss:objectives>\n"
         "          <imsss:deliveryControls completionSetByContent=\"true\" "
         "objectiveSetByContent=\"true\"/>\n        </imsss:sequencing>\n      </item>\n"
         "      <imsss:sequencing>\n        <imsss:controlMode choice=\"true\" flow=\"true\"/>\n"
         "      </imsss:sequencing>\n    </organization>\n  </organizations>\n  <resources>\n"
         "    <resource identifier=\"page\" type=\"webcontent\" adlcp:scormType=\"sco\" href=\"" +
         startPage + "\">\n" + fileElements(files) +
         "    </resource>\n  </resources>\n</manifest>\n";
}

std::string cmi5Structure(const std::map<std::string, std::string>& files, const PageAbout& about) {
  const std::string id = uuidOf(nameOfFiles(files));
  const auto words = [&about](const char* tag, const std::string& text) {
    return std::string("    <") + tag + "><langstring" + xmlAttribute("lang", about.language) +
           '>' + lineElementText(text) + "</langstring></" + tag + ">\n";
  };
  const std::string credit = about.credit.line();
  const std::string said =
      words("title", about.title) + words("description", credit.empty() ? about.title : credit);
  return std::string(xmlHead) +
         "<courseStructure "
         "xmlns=\"https://w3id.org/xapi/profiles/cmi5/v1/CourseStructure.xsd\">\n"
         "  <course id=\"urn:uuid:" +
         id + "\">\n" + said + "  </course>\n  <au id=\"urn:uuid:" + id +
         "#page\" moveOn=\"CompletedOrPassed\" masteryScore=\"" + pointNumber(about.passing) +
         "\" launchMethod=\"AnyWindow\">\n" + said + "    <url>" + startPage +
         "</url>\n  </au>\n</courseStructure>\n";
}

}  // namespace

const char* reportName(PageStandard standard) {
  switch (standard) {
    case PageStandard::scorm12:
      return "scorm12";
    case PageStandard::scorm2004:
      return "scorm2004";
    case PageStandard::cmi5:
      break;
  }
  return "cmi5";
}

std::vector<model::ZipMember> pagePackage(PageStandard standard,
                                          const std::map<std::string, std::string>& files,
                                          const PageAbout& about) {
  std::vector<model::ZipMember> members;
  switch (standard) {
    case PageStandard::scorm12:
      members.push_back({"imsmanifest.xml", scorm12Manifest(files, about)});
      break;
    case PageStandard::scorm2004:
      members.push_back({"imsmanifest.xml", scorm2004Manifest(files, about)});
      break;
    case PageStandard::cmi5:
      members.push_back({"cmi5.xml", cmi5Structure(files, about)});
      break;
  }
  for (const auto& [name, bytes] : files)
    members.push_back({name, bytes});
  return members;
}

}  // namespace sline::render
