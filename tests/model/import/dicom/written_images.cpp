// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/dicom/written_images.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdict.h>
#include <dcmtk/dcmdata/dcfilefo.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpeg/djrploss.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <dcmtk/dcmjpls/djrparam.h>
#include <openjpeg.h>

#include <QFile>
#include <algorithm>

#include "model/import/dicom/toolkit.h"

namespace sline::test {

namespace {

/// Lends the encoders the toolkit's dictionary, since they write elements that the readers' own
/// does not know.
class FullDictionary {
 public:
  FullDictionary() {
    model::setUpToolkit();
    dcmDataDict.wrlock().reloadDictionaries(OFTrue, OFTrue);
    dcmDataDict.wrunlock();
  }
  ~FullDictionary() { model::useOwnDictionary(); }
  FullDictionary(const FullDictionary&) = delete;
  FullDictionary& operator=(const FullDictionary&) = delete;
};

QByteArray number(double value) {
  return QByteArray::number(value, 'g', 10);
}

E_TransferSyntax syntaxOf(Packing packing) {
  switch (packing) {
    case Packing::jpegBaseline:
      return EXS_JPEGProcess1;
    case Packing::jpegExtended:
      return EXS_JPEGProcess2_4;
    case Packing::jpegLossless:
      return EXS_JPEGProcess14SV1;
    case Packing::jpegLs:
      return EXS_JPEGLSLossless;
    case Packing::jpegLsNear:
      return EXS_JPEGLSLossy;
    case Packing::none:
      break;
  }
  return EXS_LittleEndianExplicit;
}

OFCondition choose(DcmDataset& data, Packing packing) {
  const bool lossless = packing == Packing::jpegLs;
  const DJLSRepresentationParameter nearly(packing == Packing::jpegLsNear ? 2 : 0, lossless);
  const DJ_RPLossy lossy(95);
  const bool byLs = lossless || packing == Packing::jpegLsNear;
  const bool byLossy = packing == Packing::jpegBaseline || packing == Packing::jpegExtended;
  const DcmRepresentationParameter* parameter = nullptr;
  if (byLs)
    parameter = &nearly;
  else if (byLossy)
    parameter = &lossy;
  return data.chooseRepresentation(syntaxOf(packing), parameter);
}

OPJ_SIZE_T append(void* bytes, OPJ_SIZE_T size, void* user) {
  static_cast<QByteArray*>(user)->append(static_cast<const char*>(bytes), qsizetype(size));
  return size;
}

}  // namespace

std::vector<std::uint16_t> pixelsOf(const WrittenImage& written) {
  const unsigned mask = (1u << written.stored) - 1u;
  std::vector<std::uint16_t> pixels;
  for (int y = 0; y < written.rows; ++y)
    for (int x = 0; x < written.columns; ++x)
      pixels.push_back(std::uint16_t(unsigned(written.value(x, y)) & mask));
  return pixels;
}

WrittenSet image(const WrittenImage& written) {
  WrittenSet set = identifying(written.sopClass);
  for (WrittenElement& element : set)
    if (element.tag == model::Tag{0x0020, 0x000e})
      element.value = written.series;
  const glm::dvec3& p = written.position;
  set.push_back(
      text({0x0020, 0x0032}, "DS", number(p.x) + "\\" + number(p.y) + "\\" + number(p.z)));
  set.push_back(text({0x0020, 0x0037}, "DS", written.orientation));
  set.push_back(shorts({0x0028, 0x0002}, {1}));
  set.push_back(text({0x0028, 0x0004}, "CS", "MONOCHROME2"));
  set.push_back(shorts({0x0028, 0x0010}, {std::uint16_t(written.rows)}));
  set.push_back(shorts({0x0028, 0x0011}, {std::uint16_t(written.columns)}));
  set.push_back(text({0x0028, 0x0030}, "DS", written.spacing));
  set.push_back(shorts({0x0028, 0x0100}, {std::uint16_t(written.stored > 8 ? 16 : 8)}));
  set.push_back(shorts({0x0028, 0x0101}, {written.stored}));
  set.push_back(shorts({0x0028, 0x0102}, {std::uint16_t(written.stored - 1)}));
  set.push_back(shorts({0x0028, 0x0103}, {std::uint16_t(written.isSigned ? 1 : 0)}));
  set.push_back(text({0x0028, 0x1052}, "DS", number(written.intercept)));
  set.push_back(text({0x0028, 0x1053}, "DS", number(written.slope)));
  QByteArray bytes;
  for (const std::uint16_t pixel : pixelsOf(written)) {
    bytes += char(pixel & 0xff);
    if (written.stored > 8)
      bytes += char(pixel >> 8);
  }
  set.push_back({{0x7fe0, 0x0010}, written.stored > 8 ? "OW" : "OB", bytes, {}});
  return set;
}

WrittenSet enhancedImage(const std::vector<WrittenImage>& slices) {
  WrittenSet set = image(slices.front());
  const auto take = [&](model::Tag tag) {
    const auto at = std::find_if(set.begin(), set.end(),
                                 [&](const WrittenElement& element) { return element.tag == tag; });
    const WrittenElement taken = *at;
    set.erase(at);
    return taken;
  };
  QByteArray bytes;
  std::vector<WrittenSet> frames;
  for (const WrittenImage& slice : slices) {
    const WrittenSet one = image(slice);
    bytes += one.back().value;
    const auto position = std::find_if(one.begin(), one.end(), [](const WrittenElement& element) {
      return element.tag == model::Tag{0x0020, 0x0032};
    });
    frames.push_back({sequence({0x0020, 0x9113}, {{*position}})});
  }
  take({0x0020, 0x0032});
  const WrittenSet shared{
      sequence({0x0020, 0x9116}, {{take({0x0020, 0x0037})}}),
      sequence({0x0028, 0x9110}, {{take({0x0028, 0x0030})}}),
      sequence({0x0028, 0x9145}, {{take({0x0028, 0x1052}), take({0x0028, 0x1053})}})};
  take({0x7fe0, 0x0010});
  set.push_back(text({0x0028, 0x0008}, "IS", QByteArray::number(qsizetype(slices.size()))));
  set.push_back(sequence({0x5200, 0x9229}, {shared}));
  set.push_back(sequence({0x5200, 0x9230}, frames));
  set.push_back({{0x7fe0, 0x0010}, "OW", bytes, {}});
  return set;
}

QByteArray packed(const QByteArray& file, Packing packing) {
  if (packing == Packing::none)
    return file;
  const FullDictionary dictionary;
  DJEncoderRegistration::registerCodecs();
  DJLSEncoderRegistration::registerCodecs();
  const QTemporaryDir folder;
  const std::string name = put(folder, "plain.dcm", file).string();
  DcmFileFormat format;
  const bool done = format.loadFile(name.c_str()).good() &&
                    choose(*format.getDataset(), packing).good() &&
                    format.saveFile(name.c_str(), syntaxOf(packing)).good();
  if (!done)
    qFatal("cannot pack the pixels");
  QFile made(QString::fromStdString(name));
  if (!made.open(QIODevice::ReadOnly))
    qFatal("cannot read what was packed");
  return made.readAll();
}

QByteArray jpeg2000(const std::vector<std::uint16_t>& pixels, int columns, int rows, int bits,
                    bool isSigned) {
  opj_image_cmptparm_t plane{};
  plane.dx = plane.dy = 1;
  plane.w = OPJ_UINT32(columns);
  plane.h = OPJ_UINT32(rows);
  plane.prec = OPJ_UINT32(bits);
  plane.sgnd = isSigned ? 1 : 0;
  opj_image_t* image = opj_image_create(1, &plane, OPJ_CLRSPC_GRAY);
  image->x1 = plane.w;
  image->y1 = plane.h;
  const int mask = (1 << bits) - 1;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const int value = pixels[i] & mask;
    image->comps[0].data[i] = isSigned && value > mask / 2 ? value - mask - 1 : value;
  }
  opj_cparameters_t parameters;
  opj_set_default_encoder_parameters(&parameters);
  parameters.numresolution = 2;
  parameters.tcp_numlayers = 1;
  parameters.cp_disto_alloc = 1;
  opj_codec_t* codec = opj_create_compress(OPJ_CODEC_J2K);
  opj_stream_t* stream = opj_stream_default_create(OPJ_FALSE);
  QByteArray made;
  opj_stream_set_user_data(stream, &made, nullptr);
  opj_stream_set_write_function(stream, append);
  const bool done = opj_setup_encoder(codec, &parameters, image) != 0 &&
                    opj_start_compress(codec, image, stream) != 0 &&
                    opj_encode(codec, stream) != 0 && opj_end_compress(codec, stream) != 0;
  opj_stream_destroy(stream);
  opj_destroy_codec(codec);
  opj_image_destroy(image);
  if (!done)
    qFatal("cannot pack the pixels");
  return made;
}

QByteArray jpeg2000File(const WrittenImage& written, Syntax syntax) {
  WrittenSet set = image(written);
  set.back() = pieces({jpeg2000(pixelsOf(written), written.columns, written.rows, written.stored,
                                written.isSigned)});
  return dicomFile(set, {syntax});
}

QByteArray runsOf(const WrittenImage& written) {
  QByteArray high;
  QByteArray low;
  for (const std::uint16_t pixel : pixelsOf(written)) {
    high += char(pixel >> 8);
    low += char(pixel & 0xff);
  }
  return runs({high, low});
}

QByteArray runLengthFile(const WrittenImage& written) {
  WrittenSet set = image(written);
  set.back() = pieces({runsOf(written)});
  return dicomFile(set, {Syntax::runLength});
}

std::filesystem::path put(const QTemporaryDir& folder, const QString& name,
                          const QByteArray& bytes) {
  const QString path = folder.filePath(name);
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
    qFatal("cannot write %s", qPrintable(path));
  return path.toStdString();
}

}  // namespace sline::test
