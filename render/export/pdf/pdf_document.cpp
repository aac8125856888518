// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/pdf_document.h"

#include <algorithm>
#include <array>
#include <exception>
#include <map>
#include <memory>
#include <qpdf/Buffer.hh>
#include <qpdf/Pl_Buffer.hh>
#include <qpdf/Pl_Flate.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>
#include <stdexcept>
#include <string_view>

#include "render/export/encoding/xmp_packet.h"
#include "render/export/pdf/pdf_fonts.h"
#include "render/export/pdf/pdf_tags.h"

namespace sline::render {

namespace {

using Object = QPDFObjectHandle;

Object real(double value) {
  return Object::newReal(value, 4);
}

/// Tells whether an entry says who or what made the file, or when, or is unique to it.
bool tellsOfMaking(const std::string& name, Object& value) {
  static constexpr std::array<std::string_view, 9> names{
      "/Metadata",     "/PieceInfo",   "/LastModified",
      "/CreationDate", "/ModDate",     "/Producer",
      "/Creator",      "/CreatorInfo", "/NM"};
  if (std::find(names.begin(), names.end(), name) != names.end())
    return true;
  // A date, under any name (ISO 32000-1, 7.9.4).
  return value.isString() && value.getStringValue().starts_with("D:");
}

/// Removes such entries from everything that the object itself holds; what it refers to is an
/// object of its own.
void removeTraces(Object object) {
  if (object.isStream())
    object = object.getDict();
  if (object.isArray()) {
    for (const Object& item : object.getArrayAsVector())
      if (!item.isIndirect())
        removeTraces(item);
    return;
  }
  if (!object.isDictionary())
    return;
  for (const std::string& name : object.getKeys()) {
    Object value = object.getKey(name);
    if (tellsOfMaking(name, value))
      object.removeKey(name);
    else if (!value.isIndirect())
      removeTraces(value);
  }
}

void keepOnly(Object dictionary, std::initializer_list<std::string_view> names) {
  for (const std::string& name : dictionary.getKeys())
    if (std::find(names.begin(), names.end(), name) == names.end())
      dictionary.removeKey(name);
}

/// Returns a dictionary below another that no other object shares.
Object ownDictionary(Object& parent, const std::string& name) {
  Object child = parent.getKey(name);
  return parent.replaceKeyAndGetNew(
      name, child.isDictionary() ? child.shallowCopy() : Object::newDictionary());
}

void addStates(Object& resources, const std::set<int>& opacities) {
  if (opacities.empty())
    return;
  Object states = ownDictionary(resources, "/ExtGState");
  for (const int percent : opacities) {
    Object state = Object::newDictionary();
    state.replaceKey("/ca", real(percent / 100.0));
    state.replaceKey("/CA", real(percent / 100.0));
    states.replaceKey(pdfStateName(percent), state);
  }
}

/// Returns a group that is transparent as a whole (ISO 32000-1, 11.6.6). `papers` has the states of
/// those that show paper.
Object formObject(QPDF& file, const PdfForm& form, const std::map<int, Object>& papers) {
  Object stream = file.newStream(form.operators);
  Object group = Object::newDictionary();
  group.replaceKey("/S", Object::newName("/Transparency"));
  group.replaceKey("/CS", Object::newName("/DeviceRGB"));
  group.replaceKey("/I", Object::newBool(true));
  Object resources = Object::newDictionary();
  addStates(resources, form.opacities);
  if (form.paper > 0)
    ownDictionary(resources, "/ExtGState")
        .replaceKey(pdfPaperName(form.paper), papers.at(form.paper));
  Object entries = stream.getDict();
  entries.replaceKey("/Type", Object::newName("/XObject"));
  entries.replaceKey("/Subtype", Object::newName("/Form"));
  entries.replaceKey(
      "/BBox", Object::newArray({real(double(form.box.low.x)), real(double(form.box.low.y)),
                                 real(double(form.box.high.x)), real(double(form.box.high.y))}));
  entries.replaceKey("/Group", group);
  entries.replaceKey("/Resources", resources);
  return stream;
}

/// Returns a state in which as much is drawn as what the operators paint is light (ISO 32000-1,
/// 11.6.5.2).
Object maskState(QPDF& file, const std::string& operators, const glm::dvec2& size,
                 const Object& resources) {
  Object form = file.newStream(operators);
  Object group = Object::newDictionary();
  group.replaceKey("/S", Object::newName("/Transparency"));
  group.replaceKey("/CS", Object::newName("/DeviceGray"));
  Object entries = form.getDict();
  entries.replaceKey("/Type", Object::newName("/XObject"));
  entries.replaceKey("/Subtype", Object::newName("/Form"));
  entries.replaceKey("/BBox", Object::newArray({real(0.0), real(0.0), real(size.x), real(size.y)}));
  entries.replaceKey("/Group", group);
  entries.replaceKey("/Resources", resources);
  Object mask = Object::newDictionary();
  mask.replaceKey("/Type", Object::newName("/Mask"));
  mask.replaceKey("/S", Object::newName("/Luminosity"));
  mask.replaceKey("/G", form);
  Object state = Object::newDictionary();
  state.replaceKey("/Type", Object::newName("/ExtGState"));
  state.replaceKey("/SMask", mask);
  return state;
}

/// Returns a state in which nothing is drawn where the gaps are black.
Object gapState(QPDF& file, const std::string& gaps, const glm::dvec2& size) {
  const std::string page =
      "0 0 " + real(size.x).unparse() + ' ' + real(size.y).unparse() + " re f\n";
  return maskState(file, "1 g " + page + gaps, size, Object::newDictionary());
}

/// Returns the named channels of the image, `count` from the first, deflated as PNG does: each byte
/// less its neighbour to the left (ISO 32000-1, 7.4.4.4).
Object channels(QPDF& file, const Image& image, std::size_t first, std::size_t count) {
  std::string rows;
  for (std::size_t y = 0; y < std::size_t(image.height); ++y) {
    rows += '\1';
    for (std::size_t x = 0; x < std::size_t(image.width); ++x)
      for (std::size_t channel = first; channel < first + count; ++channel) {
        const std::size_t at = 4 * (y * std::size_t(image.width) + x) + channel;
        rows += char(std::uint8_t(image.rgba[at] - (x > 0 ? image.rgba[at - 4] : 0)));
      }
  }
  Pl_Buffer packed("rows");
  Pl_Flate deflate("deflate", &packed, Pl_Flate::a_deflate);
  deflate.write(reinterpret_cast<unsigned char*>(rows.data()), rows.size());
  deflate.finish();
  const std::shared_ptr<Buffer> bytes = packed.getBufferSharedPointer();
  Object stream = file.newStream();
  Object how = Object::newDictionary();
  how.replaceKey("/Predictor", Object::newInteger(15));
  how.replaceKey("/Colors", Object::newInteger(std::int64_t(count)));
  how.replaceKey("/Columns", Object::newInteger(image.width));
  stream.replaceStreamData(bytes, Object::newName("/FlateDecode"), how);
  Object entries = stream.getDict();
  entries.replaceKey("/Type", Object::newName("/XObject"));
  entries.replaceKey("/Subtype", Object::newName("/Image"));
  entries.replaceKey("/Width", Object::newInteger(image.width));
  entries.replaceKey("/Height", Object::newInteger(image.height));
  entries.replaceKey("/BitsPerComponent", Object::newInteger(8));
  entries.replaceKey("/ColorSpace", Object::newName(count == 1 ? "/DeviceGray" : "/DeviceRGB"));
  entries.replaceKey("/Interpolate", Object::newBool(true));
  return stream;
}

/// Returns an image whose alpha is its soft mask (ISO 32000-1, 11.6.5.3).
Object imageObject(QPDF& file, const Image& image) {
  Object colours = channels(file, image, 0, 3);
  colours.getDict().replaceKey("/SMask", channels(file, image, 3, 1));
  return colours;
}

/// Returns a state in which lines are as the paper takes them; its forms are in millimetres, y
/// downwards.
Object paperState(QPDF& file, const PdfPaper& paper) {
  const double side = double(paper.tile.sideMm);
  std::string tiles;
  for (double y = 0.0; y < double(paper.sizeMm.y); y += side)
    for (double x = 0.0; x < double(paper.sizeMm.x); x += side)
      tiles += "q " + real(side).unparse() + " 0 0 " + real(-side).unparse() + ' ' +
               real(x).unparse() + ' ' + real(y + side).unparse() + " cm /SlTile Do Q\n";
  Object objects = Object::newDictionary();
  objects.replaceKey("/SlTile", channels(file, paper.tile.image, 0, 1));
  Object resources = Object::newDictionary();
  resources.replaceKey("/XObject", objects);
  return maskState(file, tiles, glm::dvec2(paper.sizeMm), resources);
}

void putBelow(QPDF& file, QPDFPageObjectHelper& page, const PdfContent& content,
              const glm::dvec2& size) {
  Object object = page.getObjectHandle();
  Object box = page.getAttribute("/MediaBox", false);
  if (!box.isArray() || box.getArrayNItems() != 4 || !box.getArrayItem(3).isNumber())
    throw std::runtime_error("a page without a size");
  // QPdfWriter's pages are a whole number of points high: its upper edge is moved to the page's.
  const double raised = size.y - box.getArrayItem(3).getNumericValue();
  constexpr const char* gapName = "/SlGaps";
  const bool gaps = !content.gaps.empty();
  const std::string drawing =
      gaps ? std::string("q ") + gapName + " gs\n" + taggedDrawing(content) + "Q\n"
           : taggedDrawing(content);
  page.addPageContents(file.newStream(drawing + "q 1 0 0 1 0 " + real(raised).unparse() + " cm\n"),
                       true);
  page.addPageContents(file.newStream("Q\n"), false);
  for (const char* other : {"/CropBox", "/BleedBox", "/TrimBox", "/ArtBox"})
    object.removeKey(other);
  object.replaceKey("/MediaBox",
                    Object::newArray({real(0.0), real(0.0), real(size.x), real(size.y)}));
  Object resources = ownDictionary(object, "/Resources");
  addStates(resources, content.opacities);
  if (gaps)
    ownDictionary(resources, "/ExtGState").replaceKey(gapName, gapState(file, content.gaps, size));
  if (content.forms.empty() && content.images.empty())
    return;
  std::map<int, Object> papers;
  for (const auto& [percent, paper] : content.papers)
    papers.emplace(percent, file.makeIndirectObject(paperState(file, paper)));
  Object objects = ownDictionary(resources, "/XObject");
  for (std::size_t i = 0; i < content.forms.size(); ++i)
    objects.replaceKey(pdfFormName(i), formObject(file, content.forms[i], papers));
  for (std::size_t i = 0; i < content.images.size(); ++i)
    objects.replaceKey(pdfImageName(i), imageObject(file, content.images[i]));
}

/// Writes the credit to the document's information, where all programs look, and as XMP.
void describe(QPDF& file, const PdfDescription& description) {
  Object catalog = file.getRoot();
  catalog.replaceKey("/Lang", Object::newUnicodeString(
                                  description.language.empty() ? "en" : description.language));
  Object info = Object::newDictionary();
  const auto say = [&info](const char* name, const std::string& text) {
    if (!text.empty())
      info.replaceKey(name, Object::newUnicodeString(text));
  };
  say("/Title", description.title);
  say("/Author", description.credit.author);
  say("/Copyright", description.credit.copyright);
  if (!info.getKeys().empty())
    file.getTrailer().replaceKey("/Info", file.makeIndirectObject(info));
  if (!description.title.empty()) {
    Object preferences = Object::newDictionary();
    preferences.replaceKey("/DisplayDocTitle", Object::newBool(true));
    catalog.replaceKey("/ViewerPreferences", preferences);
  }
  if (description.credit.empty())
    return;
  Object xmp = file.newStream(xmpPacket(description.credit));
  xmp.getDict().replaceKey("/Type", Object::newName("/Metadata"));
  xmp.getDict().replaceKey("/Subtype", Object::newName("/XML"));
  catalog.replaceKey("/Metadata", xmp);
}

QByteArray written(QPDF& file, bool linearized) {
  QPDFWriter writer(file);
  writer.setOutputMemory();
  writer.setLinearization(linearized);
  writer.setDeterministicID(true);
  writer.write();
  const std::shared_ptr<Buffer> bytes = writer.getBufferSharedPointer();
  return {reinterpret_cast<const char*>(bytes->getBuffer()), qsizetype(bytes->getSize())};
}

/// Joins the pages; throws what qpdf throws.
QByteArray joined(const QByteArray& painted, const std::vector<PdfContent>& below,
                  const PdfDescription& description) {
  QPDF file;
  file.setSuppressWarnings(true);
  file.setAttemptRecovery(false);
  file.processMemoryFile("pages", painted.constData(), std::size_t(painted.size()));
  std::vector<QPDFPageObjectHelper> pages = QPDFPageDocumentHelper(file).getAllPages();
  if (pages.size() != below.size())
    throw std::runtime_error("another number of pages than were painted");
  keepOnly(file.getTrailer(), {"/Root", "/Size"});
  keepOnly(file.getRoot(), {"/Type", "/Pages"});
  for (const Object& object : file.getAllObjects())
    removeTraces(object);
  std::vector<int> texts;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    texts.push_back(tagTexts(file, pages[i]));
    putBelow(file, pages[i], below[i], description.pageSize);
  }
  nameFonts(pages);
  addTags(file, pages, below, texts);
  describe(file, description);
  addNavigation(file, pages, description.navigation, description.pageSize.y);
  if (file.anyWarnings())
    throw file.getWarnings().front();

  // Objects stand in the order of their numbers, and Qt's are by chance where there are several
  // fonts; written once, they are numbered as pages refer to them.
  const QByteArray ordered = written(file, false);
  QPDF again;
  again.processMemoryFile("ordered", ordered.constData(), std::size_t(ordered.size()));
  return written(again, true);
}

}  // namespace

Result<QByteArray> joinedPdf(const QByteArray& painted, const std::vector<PdfContent>& below,
                             const PdfDescription& description) {
  try {
    return joined(painted, below, description);
  } catch (const std::exception& exception) {
    return Error{.reason = std::string("Qt's pages cannot be put together: ") + exception.what(),
                 .remedy = "Report this, with the versions of Qt and qpdf"};
  }
}

}  // namespace sline::render
