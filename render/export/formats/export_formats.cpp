// SPDX-License-Identifier: Apache-2.0
#include "render/export/formats/export_formats.h"

#include <QtGlobal>
#include <algorithm>
#include <array>

#include "render/export/anki/anki_file.h"
#include "render/export/gltf/gltf_file.h"
#include "render/export/motion/film_file.h"
#include "render/export/pdf/pdf_file.h"
#include "render/export/pixels/pixel_files.h"
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

template <bool transparency>
ExportNotes filmNotesOf(const ExportOrder& order) {
  return filmNotes(order, transparency);
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
        .choices = {.depth = true, .grey = true, .pureInk = true},
        .bytesPerPixel = 0.4,
        .write = writePng,
        .foreseen = pixelNotesOf<PixelKind::png>},
    ExportFormat{
        .id = "tiff",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "TIFF picture"),
        .help = QT_TRANSLATE_NOOP("sline::render::ExportFormat",
                                  "The same for printers and journals, with its colour profile"),
        .extension = "tiff",
        .otherExtension = "tif",
        .choices = {.depth = true, .grey = true, .pureInk = true},
        .bytesPerPixel = 1.0,
        .write = writeTiff,
        .foreseen = pixelNotesOf<PixelKind::tiff>},
    ExportFormat{
        .id = "jpeg",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "JPEG picture"),
        .help = QT_TRANSLATE_NOOP("sline::render::ExportFormat",
                                  "A picture made of pixels where files must be small; on white"),
        .extension = "jpg",
        .otherExtension = "jpeg",
        .choices = {.grey = true},
        .bytesPerPixel = 0.25,
        .write = writeJpeg,
        .foreseen = pixelNotesOf<PixelKind::jpeg>},
    ExportFormat{
        .id = "exr",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "EXR picture"),
        .help = QT_TRANSLATE_NOOP(
            "sline::render::ExportFormat",
            "A picture in linear light, as halves with alpha multiplied in, for compositing"),
        .extension = "exr",
        .bytesPerPixel = 2.0,
        .write = writeExr,
        .foreseen = pixelNotesOf<PixelKind::exr>},
    ExportFormat{.id = "webp-picture",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "WebP picture"),
                 .help = QT_TRANSLATE_NOOP(
                     "sline::render::ExportFormat",
                     "A picture for web pages, smaller than PNG and as exact: 8 bits in colour"),
                 .extension = "webp",
                 .bytesPerPixel = 0.25,
                 .write = writeWebpPicture,
                 .foreseen = pixelNotesOf<PixelKind::webp>},
    ExportFormat{
        .id = "jp2",
        .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "JPEG 2000 picture"),
        .help = QT_TRANSLATE_NOOP("sline::render::ExportFormat",
                                  "A picture for archives that ask for it, exact: 8 or 16 bits"),
        .extension = "jp2",
        .choices = {.depth = true, .grey = true},
        .bytesPerPixel = 1.0,
        .write = writeJp2,
        .foreseen = pixelNotesOf<PixelKind::jp2>},
    ExportFormat{.id = "svg",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "SVG drawing"),
                 .help = QT_TRANSLATE_NOOP(
                     "sline::render::ExportFormat",
                     "Vectors for Inkscape, Illustrator and print: lines and hatching as smooth "
                     "paths, hidden ones removed, a named group for each structure"),
                 .extension = "svg",
                 .page = PageUse::drawing,
                 .names = true,
                 .choices = {.pureInk = true},
                 .bytesPerTriangle = 2.0,
                 .write = writeSvg,
                 .foreseen = noNotes},
    ExportFormat{.id = "pdf",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "PDF document"),
                 .help = QT_TRANSLATE_NOOP(
                     "sline::render::ExportFormat",
                     "The same vectors on a page of their own, or a sheet with title, legend and "
                     "numbered labels, a page to test oneself and its key"),
                 .extension = "pdf",
                 .page = PageUse::drawing,
                 .names = true,
                 .choices = {.pureInk = true, .sheet = true},
                 .bytesPerTriangle = 1.0,
                 .write = writePdf,
                 .foreseen = noNotes},
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
                 .bytesPerTriangle = 30.0,
                 .write = writeGltf,
                 .foreseen = gltfNotes},
    ExportFormat{.id = "mp4",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "MP4 film"),
                 .help = QT_TRANSLATE_NOOP(
                     "sline::render::ExportFormat",
                     "A film for slides and web pages, where the program ffmpeg is installed"),
                 .extension = "mp4",
                 .page = PageUse::shape,
                 .oneView = false,
                 .choices = {.film = true},
                 .write = writeMp4,
                 .foreseen = filmNotesOf<false>},
    ExportFormat{.id = "webp",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "Animated WebP"),
                 .help = QT_TRANSLATE_NOOP("sline::render::ExportFormat",
                                           "A film that browsers show as a picture"),
                 .extension = "webp",
                 .page = PageUse::shape,
                 .oneView = false,
                 .choices = {.film = true},
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
                 .choices = {.film = true},
                 .write = writeGif,
                 .foreseen = filmNotesOf<true>},
    ExportFormat{.id = "frames",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "Frames of a film"),
                 .help = QT_TRANSLATE_NOOP(
                     "sline::render::ExportFormat",
                     "A new folder of numbered PNG pictures, for programs that cut films"),
                 .page = PageUse::shape,
                 .oneView = false,
                 .choices = {.film = true},
                 .write = writeFrames,
                 .foreseen = filmNotesOf<true>},
    ExportFormat{.id = "anki",
                 .title = QT_TRANSLATE_NOOP("sline::render::ExportFormat", "Anki deck"),
                 .help = QT_TRANSLATE_NOOP(
                     "sline::render::ExportFormat",
                     "Cards that ask for the labels of the picture: a package for Anki (.apkg), or "
                     "text and pictures in a ZIP (.zip) or a new folder"),
                 .extension = "apkg",
                 .otherExtension = "zip",
                 .oneView = false,
                 .names = true,
                 .choices = {.anki = true},
                 .write = writeAnki,
                 .foreseen = noNotes},
};

}  // namespace

std::span<const ExportFormat> exportFormats() {
  return formats;
}

const ExportFormat* exportFormat(std::string_view id) {
  const std::span<const ExportFormat> all = exportFormats();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [id](const ExportFormat& each) { return id == each.id; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace sline::render
