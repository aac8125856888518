// SPDX-License-Identifier: Apache-2.0
#include "render/export/formats/export_formats.h"

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

}  // namespace

std::span<const ExportFormat> exportFormats() {
  static constexpr std::array formats{
      ExportFormat{"png", "PNG picture",
                   "A picture made of pixels for screens, documents and print: sRGB, grey or pure "
                   "ink, 8 or 16 bits, transparent where asked for",
                   "png", "", writePng, pixelNotesOf<PixelKind::png>},
      ExportFormat{"tiff", "TIFF picture",
                   "The same for printers and journals, with its colour profile", "tiff", "tif",
                   writeTiff, pixelNotesOf<PixelKind::tiff>},
      ExportFormat{"jpeg", "JPEG picture",
                   "A picture made of pixels where files must be small; on white", "jpg", "jpeg",
                   writeJpeg, pixelNotesOf<PixelKind::jpeg>},
      ExportFormat{"exr", "EXR picture",
                   "A picture in linear light, as halves with alpha multiplied in, for compositing",
                   "exr", "", writeExr, pixelNotesOf<PixelKind::exr>},
      ExportFormat{"webp-picture", "WebP picture",
                   "A picture for web pages, smaller than PNG and as exact: 8 bits in colour",
                   "webp", "", writeWebpPicture, pixelNotesOf<PixelKind::webp>},
      ExportFormat{"jp2", "JPEG 2000 picture",
                   "A picture for archives that ask for it, exact: 8 or 16 bits", "jp2", "",
                   writeJp2, pixelNotesOf<PixelKind::jp2>},
      ExportFormat{"svg", "SVG drawing",
                   "Vectors for Inkscape, Illustrator and print: lines and hatching as smooth "
                   "paths, hidden ones removed, a named group for each structure",
                   "svg", "", writeSvg, noNotes},
      ExportFormat{"pdf", "PDF document",
                   "The same vectors on a page of their own, or a sheet with title, legend and "
                   "numbered labels, a page to test oneself and its key",
                   "pdf", "", writePdf, noNotes},
      ExportFormat{"glb", "GLB surfaces (glTF)",
                   "Surfaces for Blender, PowerPoint, web pages and headsets: groups, names and "
                   "colours, annotations, cameras of the saved views",
                   "glb", "", writeGltf, gltfNotes},
      ExportFormat{"mp4", "MP4 film",
                   "A film for slides and web pages, where the program ffmpeg is installed", "mp4",
                   "", writeMp4, filmNotesOf<false>},
      ExportFormat{"webp", "Animated WebP", "A film that browsers show as a picture", "webp", "",
                   writeWebp, filmNotesOf<true>},
      ExportFormat{"gif", "Animated GIF",
                   "A film that every program shows, of at most 255 colours: small ones", "gif", "",
                   writeGif, filmNotesOf<true>},
      ExportFormat{"frames", "Frames of a film",
                   "A new folder of numbered PNG pictures, for programs that cut films", "", "",
                   writeFrames, filmNotesOf<true>},
      ExportFormat{"anki", "Anki deck",
                   "Cards that ask for the labels of the picture: a package for Anki (.apkg), or "
                   "text and pictures in a ZIP (.zip) or a new folder",
                   "apkg", "zip", writeAnki, noNotes},
  };
  return formats;
}

}  // namespace sline::render
