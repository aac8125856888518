// SPDX-License-Identifier: Apache-2.0
#include "tests/render/export/slides/opened_slides.h"

#include <filesystem>
#include <set>

#include "model/disk/zip_archive.h"

namespace sline::test {

namespace {

bool isXml(const std::string& name) {
  return name.ends_with(".xml") || name.ends_with(".rels") || name.ends_with(".svg");
}

std::string relationsOf(const std::string& part) {
  const std::size_t cut = part.rfind('/') == std::string::npos ? 0 : part.rfind('/') + 1;
  return part.substr(0, cut) + "_rels/" + part.substr(cut) + ".rels";
}

std::string resolved(const std::string& part, const std::string& target) {
  return (std::filesystem::path(part).parent_path() / target).lexically_normal().string();
}

/// What elements may hold, in the order that the transitional schemas prescribe (ECMA-376 part 4,
/// pml.xsd and dml-main.xsd), as far as our presentations use it; "*": as often as wanted.
const std::map<std::string, std::vector<std::string>>& orders() {
  static const std::vector<std::string> paragraph{"a:lnSpc", "a:buNone|a:buFont", "a:buChar",
                                                  "a:defRPr"};
  static const std::vector<std::string> run{"a:solidFill", "a:effectLst", "a:latin", "a:ea",
                                            "a:cs"};
  static const std::vector<std::string> level{"a:lvl1pPr"};
  static const std::map<std::string, std::vector<std::string>> all{
      {"a:bodyPr", {"a:noAutofit|a:normAutofit"}},
      {"a:clrScheme",
       {"a:dk1", "a:lt1", "a:dk2", "a:lt2", "a:accent1", "a:accent2", "a:accent3", "a:accent4",
        "a:accent5", "a:accent6", "a:hlink", "a:folHlink"}},
      {"a:custGeom", {"a:avLst", "a:gdLst", "a:ahLst", "a:cxnLst", "a:rect", "a:pathLst"}},
      {"a:defRPr", run},
      {"a:fmtScheme", {"a:fillStyleLst", "a:lnStyleLst", "a:effectStyleLst", "a:bgFillStyleLst"}},
      {"a:ln", {"a:noFill|a:solidFill", "a:custDash", "a:round"}},
      {"a:lstStyle", level},
      {"a:lvl1pPr", paragraph},
      {"a:p", {"a:pPr", "a:r|a:br*"}},
      {"a:path", {"a:moveTo|a:lnTo|a:cubicBezTo|a:close*"}},
      {"a:pPr", paragraph},
      {"a:r", {"a:rPr", "a:t"}},
      {"a:rPr", run},
      {"a:theme", {"a:themeElements", "a:objectDefaults", "a:extraClrSchemeLst"}},
      {"a:themeElements", {"a:clrScheme", "a:fontScheme", "a:fmtScheme"}},
      {"a:xfrm", {"a:off", "a:ext", "a:chOff", "a:chExt"}},
      {"p:blipFill", {"a:blip", "a:stretch"}},
      {"p:bodyStyle", level},
      {"p:cBhvr", {"p:cTn", "p:tgtEl", "p:attrNameLst"}},
      {"p:cSld", {"p:bg", "p:spTree"}},
      {"p:cTn", {"p:stCondLst", "p:childTnLst"}},
      {"p:cxnSp", {"p:nvCxnSpPr", "p:spPr"}},
      {"p:defaultTextStyle", level},
      {"p:grpSp", {"p:nvGrpSpPr", "p:grpSpPr", "p:sp|p:grpSp|p:cxnSp|p:pic*"}},
      {"p:notes", {"p:cSld", "p:clrMapOvr"}},
      {"p:notesMaster", {"p:cSld", "p:clrMap", "p:notesStyle"}},
      {"p:nvSpPr", {"p:cNvPr", "p:cNvSpPr", "p:nvPr"}},
      {"p:pic", {"p:nvPicPr", "p:blipFill", "p:spPr"}},
      {"p:presentation",
       {"p:sldMasterIdLst", "p:notesMasterIdLst", "p:sldIdLst", "p:sldSz", "p:notesSz",
        "p:defaultTextStyle"}},
      {"p:seq", {"p:cTn", "p:prevCondLst", "p:nextCondLst"}},
      {"p:set", {"p:cBhvr", "p:to"}},
      {"p:sld", {"p:cSld", "p:clrMapOvr", "p:timing"}},
      {"p:sldLayout", {"p:cSld", "p:clrMapOvr"}},
      {"p:sldMaster", {"p:cSld", "p:clrMap", "p:sldLayoutIdLst", "p:txStyles"}},
      {"p:sp", {"p:nvSpPr", "p:spPr", "p:txBody"}},
      {"p:spPr",
       {"a:xfrm", "a:custGeom|a:prstGeom", "a:noFill|a:solidFill", "a:ln", "a:effectLst"}},
      {"p:spTree", {"p:nvGrpSpPr", "p:grpSpPr", "p:sp|p:grpSp|p:cxnSp|p:pic*"}},
      {"p:txBody", {"a:bodyPr", "a:lstStyle", "a:p*"}},
      {"p:txStyles", {"p:titleStyle", "p:bodyStyle", "p:otherStyle"}}};
  return all;
}

/// Tells whether the place of an order takes the element.
bool takes(std::string place, const std::string& name) {
  if (place.ends_with('*'))
    place.pop_back();
  const QStringList names = QString::fromStdString(place).split(QLatin1Char('|'));
  return names.contains(QString::fromStdString(name));
}

/// Tells whether the children are those of the order.
bool inOrder(const pugi::xml_node& element, const std::vector<std::string>& order) {
  std::size_t place = 0;
  for (const auto& child : element.children()) {
    while (place < order.size() && !takes(order[place], child.name()))
      ++place;
    if (place == order.size())
      return false;
    place += order[place].ends_with('*') ? 0 : 1;
  }
  return true;
}

}  // namespace

OpenedSlides::OpenedSlides(const std::string& bytes) {
  const auto archive = model::ZipReader::open(bytes);
  if (!archive.ok()) {
    m_faults << QString::fromStdString(archive.error().text());
    return;
  }
  for (const auto& entry : archive->entries()) {
    const auto content = archive->read(entry);
    if (!content.ok())
      m_faults << QString::fromStdString(entry.name + ": " + content.error().text());
    else
      m_parts[entry.name] = *content;
  }
  for (const auto& [name, content] : m_parts)
    if (isXml(name)) {
      const auto parsed = m_documents[name].load_buffer(content.data(), content.size());
      if (!parsed)
        m_faults << QString::fromStdString(name + ": " + parsed.description());
    }
  checkTypes();
  checkRelations();
  checkShapes();
  checkOrders();
}

pugi::xml_node OpenedSlides::root(const std::string& part) const {
  const auto found = m_documents.find(part);
  return found == m_documents.end() ? pugi::xml_node() : found->second.document_element();
}

pugi::xml_node OpenedSlides::slide(int number) const {
  return root("ppt/slides/slide" + std::to_string(number) + ".xml");
}

int OpenedSlides::slides() const {
  return int(root("ppt/presentation.xml").select_nodes("p:sldIdLst/p:sldId").size());
}

std::string OpenedSlides::target(const std::string& part, const std::string& type) const {
  for (const auto& relation : root(relationsOf(part)).children("Relationship"))
    if (std::string(relation.attribute("Type").value()).ends_with("/" + type))
      return resolved(part, relation.attribute("Target").value());
  return {};
}

void OpenedSlides::checkTypes() {
  std::set<std::string> overrides;
  std::set<std::string> endings;
  for (const auto& type : root("[Content_Types].xml").children()) {
    overrides.insert(type.attribute("PartName").value());
    endings.insert(type.attribute("Extension").value());
  }
  for (const auto& [name, content] : m_parts) {
    const bool known =
        overrides.erase("/" + name) > 0 ||
        (endings.contains(name.substr(name.rfind('.') + 1)) && !name.ends_with(".xml"));
    if (!known && name != "[Content_Types].xml")
      m_faults << QString::fromStdString(name + " has no content type");
  }
  overrides.erase("");
  for (const std::string& name : overrides)
    m_faults << QString::fromStdString(name + " is typed but absent");
}

void OpenedSlides::checkRelations() {
  std::set<std::string> reached{"[Content_Types].xml"};
  for (const auto& [name, document] : m_documents) {
    std::set<std::string> known;
    const std::string relations = relationsOf(name);
    for (const auto& relation : root(relations).children("Relationship")) {
      const std::string to = resolved(name, relation.attribute("Target").value());
      if (!m_parts.contains(to))
        m_faults << QStringLiteral("%1 points to %2, which is absent")
                        .arg(QString::fromStdString(name), QString::fromStdString(to));
      reached.insert(to);
      if (!known.insert(relation.attribute("Id").value()).second)
        m_faults << QString::fromStdString(name + " names a relationship twice");
    }
    for (const auto& used : document.select_nodes("//@r:id | //@r:embed"))
      if (!name.ends_with(".svg") && !known.contains(used.attribute().value()))
        m_faults << QString::fromStdString(name + " uses " + used.attribute().value());
  }
  for (const auto& relation : root("_rels/.rels").children("Relationship"))
    reached.insert(relation.attribute("Target").value());
  for (const auto& [name, content] : m_parts)
    if (!reached.contains(name) && !name.ends_with(".rels"))
      m_faults << QString::fromStdString("nothing points to " + name);
}

void OpenedSlides::checkShapes() {
  for (const auto& [name, document] : m_documents) {
    if (!name.starts_with("ppt/"))
      continue;
    std::set<std::string> ids;
    for (const auto& named : document.select_nodes("//p:cNvPr"))
      if (!ids.insert(named.node().attribute("id").value()).second)
        m_faults << QString::fromStdString(name + " has two shapes of one number");
    for (const auto& used : document.select_nodes("//p:spTgt/@spid | //a:endCxn/@id"))
      if (!ids.contains(used.attribute().value()))
        m_faults << QString::fromStdString(name + " is about a shape that is absent");
    for (const auto& size : document.select_nodes("//a:ext[@cx]"))
      if (size.node().attribute("cx").as_llong(-1) < 0 ||
          size.node().attribute("cy").as_llong(-1) < 0)
        m_faults << QString::fromStdString(name + " has a shape of no size");
  }
}

void OpenedSlides::checkOrders() {
  for (const auto& [name, document] : m_documents)
    if (name.starts_with("ppt/") && name.ends_with(".xml"))
      for (const auto& each : document.select_nodes("//*"))
        if (const auto order = orders().find(each.node().name());
            order != orders().end() && !inOrder(each.node(), order->second))
          m_faults << QString::fromStdString(name + ": " + each.node().path());
}

QString wordsOf(const pugi::xml_node& element) {
  QStringList paragraphs;
  for (const auto& paragraph : element.select_nodes(".//a:p")) {
    QString words;
    for (const auto& part : paragraph.node().children())
      if (std::string(part.name()) == "a:br")
        words += QLatin1Char('\n');
      else
        words += QString::fromUtf8(part.child_value("a:t"));
    paragraphs << words;
  }
  return paragraphs.join(QLatin1Char('\n'));
}

QRectF placeOf(const pugi::xml_node& shape) {
  constexpr double unit = 1.0 / 36'000.0;
  const pugi::xml_node frame = shape.select_node("*/a:xfrm").node();
  const auto value = [&](const char* child, const char* name) {
    return unit * frame.child(child).attribute(name).as_double();
  };
  return {value("a:off", "x"), value("a:off", "y"), value("a:ext", "cx"), value("a:ext", "cy")};
}

std::map<QString, pugi::xml_node> groupsOn(const pugi::xml_node& slide) {
  std::map<QString, pugi::xml_node> groups;
  for (const auto& group : slide.select_nodes("p:cSld/p:spTree/p:grpSp")) {
    const auto named = group.node().select_node("p:nvGrpSpPr/p:cNvPr/@name");
    groups[QString::fromUtf8(named.attribute().value())] = group.node();
  }
  return groups;
}

}  // namespace sline::test
