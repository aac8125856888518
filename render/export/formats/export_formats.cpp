// SPDX-License-Identifier: Apache-2.0
#include "render/export/formats/export_formats.h"

#include <QtGlobal>
#include <algorithm>
#include <array>

#include "render/export/anki/anki_file.h"
#include "render/export/anki/anki_options.h"
#include "render/export/gltf/gltf_file.h"
#include "render/export/motion/film_file.h"
#include "render/export/motion/film_options.h"
#include "render/export/order/common_options.h"
#include "render/export/order/drawing_notes.h"
#include "render/export/order/view_orders.h"
#include "render/export/packages/package_file.h"
#include "render/export/packages/package_options.h"
#include "render/export/pdf/pdf_file.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/pixels/pixel_files.h"
#include "render/export/pixels/pixel_options.h"
#include "render/export/pixels/pixel_weight.h"
#include "render/export/slides/slide_options.h"
#include "render/export/slides/slides_file.h"
#include "render/export/students/students_file.h"
#include "render/export/students/students_options.h"
#include "render/export/svg/svg_file.h"

namespace sline::render {

namespace {

ExportNotes noNotes(const ExportOrder&) {
  return {};
}

template <PixelKind kind>
ExportNotes pixelNotesOf(const ExportOrder& order) {
  return pixelNotes(order, kind);
}

template <PixelKind kind>
double pixelWeightOf(const ExportOrder& order, const Image& page, const ExportProgress&) {
  return pixelWeight(order, kind, page);
}

template <bool transparency>
ExportNotes filmNotesOf(const ExportOrder& order) {
  return filmNotes(order, transparency);
}

OptionList noOptions() {
  return {};
}

OptionList printOptions() {
  static constexpr std::array all{&depthOption, &greyOption, &pureInkOption, &samplesOption,
                                  &viewsOption};
  return all;
}

OptionList jpegOptions() {
  static constexpr std::array all{&greyOption, &samplesOption, &viewsOption};
  return all;
}

OptionList jp2Options() {
  static constexpr std::array all{&depthOption, &greyOption, &samplesOption, &viewsOption};
  return all;
}

OptionList screenOptions() {
  static constexpr std::array all{&samplesOption, &viewsOption};
  return all;
}

OptionList drawingOptions() {
  static constexpr std::array all{&pureInkOption, &viewsOption};
  return all;
}

constexpr std::array formats{
    ExportFormat{
        .id = "png",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "PNG picture"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "A picture made of pixels for screens, documents and print: sRGB, grey or pure "
            "ink, 8 or 16 bits, transparent where asked for"),
        .extension = "png",
        .options = printOptions,
        .write = writePng,
        .foreseen = pixelNotesOf<PixelKind::png>,
        .weigh = pixelWeightOf<PixelKind::png>},
    ExportFormat{
        .id = "tiff",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "TIFF picture"),
        .help = QT_TRANSLATE_NOOP("sline::render::ExportFormat",
                                  "The same for printers and journals, with its colour profile"),
        .extension = "tiff",
        .otherExtension = "tif",
        .options = printOptions,
        .write = writeTiff,
        .foreseen = pixelNotesOf<PixelKind::tiff>,
        .weigh = pixelWeightOf<PixelKind::tiff>},
    ExportFormat{
        .id = "jpeg",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "JPEG picture"),
        .help = QT_TRANSLATE_NOOP("sline::render::ExportFormat",
                                  "A picture made of pixels where files must be small; on white"),
        .extension = "jpg",
        .otherExtension = "jpeg",
        .options = jpegOptions,
        .write = writeJpeg,
        .foreseen = pixelNotesOf<PixelKind::jpeg>,
        .weigh = pixelWeightOf<PixelKind::jpeg>},
    ExportFormat{
        .id = "exr",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "EXR picture"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "A picture in linear light, as halves with alpha multiplied in, for compositing"),
        .extension = "exr",
        .options = screenOptions,
        .write = writeExr,
        .foreseen = pixelNotesOf<PixelKind::exr>,
        .weigh = pixelWeightOf<PixelKind::exr>},
    ExportFormat{.id = "webp-picture",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "WebP picture"),
                 .help = QT_TRANSLATE_NOOP(
                     "sline::render::ExportFormat",
                     "A picture for web pages, smaller than PNG and as exact: 8 bits in colour"),
                 .extension = "webp",
                 .options = screenOptions,
                 .write = writeWebpPicture,
                 .foreseen = pixelNotesOf<PixelKind::webp>,
                 .weigh = pixelWeightOf<PixelKind::webp>},
    ExportFormat{
        .id = "jp2",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "JPEG 2000 picture"),
        .help = QT_TRANSLATE_NOOP("sline::render::ExportFormat",
                                  "A picture for archives that ask for it, exact: 8 or 16 bits"),
        .extension = "jp2",
        .options = jp2Options,
        .write = writeJp2,
        .foreseen = pixelNotesOf<PixelKind::jp2>,
        .weigh = pixelWeightOf<PixelKind::jp2>},
    ExportFormat{
        .id = "svg",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "SVG drawing"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "Vectors for Inkscape, Illustrator and print: lines and hatching as smooth "
            "paths, hidden ones removed, a named group for each structure"),
        .extension = "svg",
        .page = PageUse::drawing,
        .names = true,
        .options = drawingOptions,
        .write = writeSvg,
        .foreseen = drawingNotes,
        .weigh = [](const ExportOrder& order, const Image&,
                    const ExportProgress& progress) { return svgWeight(order, progress); }},
    ExportFormat{
        .id = "pdf",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "PDF document"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "The same vectors on a page of their own, or a sheet with title, legend and "
            "numbered labels, a page to test oneself and its key; of all saved views with "
            "contents and an index"),
        .extension = "pdf",
        .page = PageUse::drawing,
        .oneView = false,
        .names = true,
        .options = sheetOptions,
        .write = writePdf,
        .foreseen = drawingNotes,
        .weigh = [](const ExportOrder& order, const Image&,
                    const ExportProgress& progress) { return pdfWeight(order, progress); }},
    ExportFormat{
        .id = "pptx",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "PowerPoint slides"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "A slide for each saved view with its title, text and notes: labels are text boxes and "
            "lines that can be edited there, over the drawing"),
        .extension = "pptx",
        .page = PageUse::slides,
        .oneView = false,
        .names = true,
        .options = slideOptions,
        .write = writeSlides,
        .foreseen = drawingNotes},
    ExportFormat{
        .id = "page",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "For students (HTML page)"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "One file for any browser, also offline and on telephones: the scene to turn, with its "
            "tree, labels, saved views as a tour, and a quiz"),
        .extension = "html",
        .otherExtension = "htm",
        .page = PageUse::none,
        .oneView = false,
        .names = true,
        .options = studentsOptions,
        .write = writeStudentsPage,
        .foreseen = studentsNotes},
    ExportFormat{
        .id = "page-folder",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "For students (web site)"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "The same page as a new folder of files for a web server, most of which are the same "
            "for every scene; browsers do not open it from a disk"),
        .page = PageUse::none,
        .oneView = false,
        .names = true,
        .options = studentsOptions,
        .write = writeStudentsFolder,
        .foreseen = studentsNotes},
    ExportFormat{.id = "glb",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "GLB surfaces (glTF)"),
                 .help = QT_TRANSLATE_NOOP(
                     "sline::render::ExportFormat",
                     "Surfaces for Blender, PowerPoint, web pages and headsets: groups, names and "
                     "colours, annotations, cameras of the saved views"),
                 .extension = "glb",
                 .page = PageUse::none,
                 .oneView = false,
                 .names = true,
                 .options = noOptions,
                 .write = writeGltf,
                 .foreseen = gltfNotes,
                 .weigh = [](const ExportOrder& order, const Image&,
                             const ExportProgress&) { return gltfWeight(order); }},
    ExportFormat{.id = "mp4",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "MP4 film"),
                 .help = QT_TRANSLATE_NOOP(
                     "sline::render::ExportFormat",
                     "A film for slides and web pages, where the program ffmpeg is installed"),
                 .extension = "mp4",
                 .page = PageUse::shape,
                 .oneView = false,
                 .options = filmOptions,
                 .write = writeMp4,
                 .foreseen = filmNotesOf<false>},
    ExportFormat{.id = "webp",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "Animated WebP"),
                 .help = QT_TRANSLATE_NOOP("sline::render::ExportFormat",
                                           "A film that browsers show as a picture"),
                 .extension = "webp",
                 .page = PageUse::shape,
                 .oneView = false,
                 .options = filmOptions,
                 .write = writeWebp,
                 .foreseen = filmNotesOf<true>},
    ExportFormat{.id = "gif",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "Animated GIF"),
                 .help = QT_TRANSLATE_NOOP(
                     "sline::render::ExportFormat",
                     "A film that every program shows, of at most 255 colours: small ones"),
                 .extension = "gif",
                 .page = PageUse::shape,
                 .oneView = false,
                 .options = filmOptions,
                 .write = writeGif,
                 .foreseen = filmNotesOf<true>},
    ExportFormat{.id = "frames",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "Frames of a film"),
                 .help = QT_TRANSLATE_NOOP(
                     "sline::render::ExportFormat",
                     "A new folder of numbered PNG pictures, for programs that cut films"),
                 .page = PageUse::shape,
                 .oneView = false,
                 .options = filmOptions,
                 .write = writeFrames,
                 .foreseen = filmNotesOf<true>},
    ExportFormat{
        .id = "anki",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "Anki deck"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "Cards that ask for the labels of the picture, or of all saved views: a package for "
            "Anki (.apkg), or text and pictures in a ZIP (.zip) or a new folder"),
        .extension = "apkg",
        .otherExtension = "zip",
        .oneView = false,
        .names = true,
        .options = ankiOptions,
        .write = writeAnki,
        .foreseen = noNotes},
    ExportFormat{
        .id = "moodle",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "Moodle questions"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "Questions with pictures, made of the labels, as XML for a question bank: markers to "
            "be put in place, names to be typed or chosen"),
        .extension = "xml",
        .oneView = false,
        .names = true,
        .forLearning = true,
        .options = questionOptions,
        .write = writeMoodle,
        .foreseen = noNotes},
    ExportFormat{
        .id = "qti",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "QTI questions"),
        .help = QT_TRANSLATE_NOOP("sline::render::ExportFormat",
                                  "The same for other question banks and examination systems, as a "
                                  "package of QTI 2.1"),
        .extension = "zip",
        .oneView = false,
        .names = true,
        .forLearning = true,
        .options = questionOptions,
        .write = writeQti,
        .foreseen = noNotes},
    ExportFormat{
        .id = "h5p",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "H5P questions"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "The same as content for H5P, to be played where its content types are installed"),
        .extension = "h5p",
        .oneView = false,
        .names = true,
        .forLearning = true,
        .options = questionSetOptions,
        .write = writeH5p,
        .foreseen = noNotes},
    ExportFormat{
        .id = "scorm12",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "SCORM 1.2 package"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "The page for students in a package that tells a learning system each answer and the "
            "score, by the standard that most systems know"),
        .extension = "zip",
        .page = PageUse::none,
        .oneView = false,
        .names = true,
        .forLearning = true,
        .options = pagePackageOptions,
        .write = writeScorm12,
        .foreseen = studentsNotes},
    ExportFormat{.id = "scorm2004",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "SCORM 2004 package"),
                 .help = QT_TRANSLATE_NOOP("sline::render::ExportFormat",
                                           "The same by SCORM 2004, 4th edition"),
                 .extension = "zip",
                 .page = PageUse::none,
                 .oneView = false,
                 .names = true,
                 .forLearning = true,
                 .options = pagePackageOptions,
                 .write = writeScorm2004,
                 .foreseen = studentsNotes},
    ExportFormat{
        .id = "cmi5",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "cmi5 package"),
        .help = QT_TRANSLATE_NOOP("sline::render::ExportFormat",
                                  "The same by cmi5, for systems with a learning record store"),
        .extension = "zip",
        .page = PageUse::none,
        .oneView = false,
        .names = true,
        .forLearning = true,
        .options = pagePackageOptions,
        .write = writeCmi5,
        .foreseen = studentsNotes},
};

}  // namespace

std::span<const ExportFormat> exportFormats() {
  return formats;
}

bool ExportFormat::has(const ExportOption& option) const {
  if (option.group == OptionGroup::credit)
    return true;
  if (option.group != OptionGroup::kind)
    return page != PageUse::none;
  const OptionList own = options();
  return std::find(own.begin(), own.end(), &option) != own.end();
}

bool ExportFormat::holdsViews() const {
  return !oneView && has(viewsOption);
}

std::vector<const ExportOption*> exportOptions() {
  const OptionList first = pictureOptions();
  const OptionList last = creditOptions();
  std::vector<const ExportOption*> all(first.begin(), first.end());
  for (const ExportFormat& format : formats)
    for (const ExportOption* option : format.options())
      if (std::find(all.begin(), all.end(), option) == all.end())
        all.push_back(option);
  all.insert(all.end(), last.begin(), last.end());
  return all;
}

void dropForeignOptions(ExportOrder& order, const ExportFormat& format) {
  for (const ExportOption* option : exportOptions())
    if (option->group == OptionGroup::kind && !format.has(*option))
      option->field.write(order, option->field.read(ExportOrder()));
}

const ExportFormat* exportFormat(std::string_view id) {
  const std::span<const ExportFormat> all = exportFormats();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [id](const ExportFormat& each) { return id == each.id; });
  return found == all.end() ? nullptr : &*found;
}

bool namesSources(const ExportFormat& format) {
  constexpr std::array<std::string_view, 6> those{"page",    "page-folder", "glb",
                                                  "scorm12", "scorm2004",   "cmi5"};
  return std::find(those.begin(), those.end(), format.id) != those.end();
}

}  // namespace sline::render
