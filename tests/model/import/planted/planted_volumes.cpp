// SPDX-License-Identifier: Apache-2.0
// Plants names in volumes and in DICOM.
#include <QDir>

#include "tests/model/import/dicom/made_segmentations.h"
#include "tests/model/import/dicom/written_structures.h"
#include "tests/model/import/planted/planted_names.h"
#include "tests/model/import/volumes/written_brain.h"
#include "tests/model/import/volumes/written_volumes.h"

namespace sline::test {

namespace {

/// Returns a volume with two boxes, 1 and 2.
WrittenVolume boxes() {
  glm::dmat4 toLps(1.0);
  toLps[3] = {30.0, 0.0, 0.0, 1.0};
  return sampled({12, 8, 8}, toLps, [](const glm::dvec3& p) {
    const bool inside = p.y > 1.0 && p.y < 6.0 && p.z > 1.0 && p.z < 6.0;
    return !inside ? 0 : p.x > 31.0 && p.x < 35.0 ? 1 : p.x > 36.0 && p.x < 40.0 ? 2 : 0;
  });
}

QByteArray put(QByteArray bytes, qsizetype at, const QByteArray& text) {
  return bytes.replace(at, text.size(), text);
}

/// Plants the texts of a NIfTI header.
QByteArray plantedNifti(Planting& planting, QByteArray bytes, const QString& kind) {
  bytes = put(bytes, 14, planting.name("db_name of a " + kind));
  bytes = put(bytes, 148, planting.name("descrip of a " + kind));
  bytes = put(bytes, 228, planting.name("aux_file of a " + kind));
  return put(bytes, 328, planting.name("intent_name of a " + kind));
}

/// Writes a volume beside a table of its labels, of that ending, in a folder of their own.
void plantTable(Planting& planting, const QString& ending, const QByteArray& before,
                const QByteArray& between, const QByteArray& after) {
  const QString stem = planting.name("the folder of a table " + ending) + "/" +
                       planting.name("the name of a table " + ending);
  planting.write(stem + ".nii", niftiFile(boxes()));
  planting.write(stem + ending, before + planting.name("a label of a table " + ending) + between +
                                    "liver " +
                                    planting.name("a second label of a table " + ending) + after);
}

void plantNifti(Planting& planting) {
  NiftiForm form;
  form.extension =
      "<?xml version='1.0'?><CaretExtension><VolumeInformation><LabelTable>"
      "<Label Key='1' Red='1' Green='0' Blue='0'>" +
      planting.name("a label in a .nii") +
      "</Label><Label Key='2' Red='0' Green='1' Blue='0'>tumour " +
      planting.name("a second label in a .nii") +
      "</Label></LabelTable></VolumeInformation></CaretExtension>";
  planting.writeNamed(
      ".nii",
      plantedNifti(planting, niftiFile(boxes(), Number::uint8, std::endian::little, form), ".nii"));
  plantTable(planting, ".tsv", "index\tname\n1\t", "\n2\t", "\n");
  plantTable(planting, ".ctbl", "1 ", " 255 0 0 255\n2 ", " 0 255 0 255\n");
  plantTable(planting, ".txt", "1 255 0 0 1 1 1 \"", "\"\n2 0 255 0 1 1 1 \"", "\"\n");
  plantTable(planting, ".json", "{\"labels\":{\"1\":\"", "\",\"2\":\"", "\"}}");
  PairBytes pair = niftiPair(boxes());
  const QString stem = planting.name("a folder in it") + "/" +
                       planting.name("the folder of an .img") + "/" +
                       planting.name("the name of an .img");
  planting.write(stem + ".hdr", plantedNifti(planting, pair.header, ".hdr"));
  planting.write(stem + ".img", pair.image);
}

void plantNrrd(Planting& planting) {
  const QByteArray more =
      "# " + planting.name("a comment of an .nrrd") +
      "\ncontent: " + planting.name("the content of an .nrrd") +
      "\nreferring physician:=" + planting.name("a key of an .nrrd") +
      "\nSegment0_ID:=" + planting.name("the id of a segment of an .nrrd") +
      "\nSegment0_LabelValue:=1\nSegment0_Name:=" + planting.name("a segment of an .nrrd") +
      "\nSegment0_Tags:=Who:" + planting.name("a tag of an .nrrd") +
      "|\nSegment1_LabelValue:=2\nSegment1_Name:=left kidney of " +
      planting.name("a second segment of an .nrrd") + "\n";
  const QByteArray whole = nrrdFile(boxes(), "left-posterior-superior");
  planting.writeNamed(".nrrd", inserted(whole, "NRRD0005\n", more));
  const QString folder =
      planting.name("a folder in it") + "/" + planting.name("the folder of a .nhdr") + "/";
  const QByteArray data = planting.name("the data of a .nhdr") + ".raw";
  const qsizetype end = whole.indexOf("\n\n");
  planting.write(folder + planting.name("the name of a .nhdr") + ".nhdr",
                 whole.left(end) + "\ndata file: " + data + "\n\n");
  planting.write(folder + data, whole.mid(end + 2));
}

void plantMetaImage(Planting& planting) {
  const QByteArray said = "Comment = " + planting.name("a comment of an .mha") +
                          "\nPhysician = " + planting.name("a tag of an .mha") + "\n";
  const QByteArray whole = metaImageFile(boxes(), false);
  const QByteArray last = "ElementDataFile = LOCAL\n";
  const qsizetype at = whole.indexOf(last);
  if (at < 0)
    qFatal("there is no %s", last.constData());
  planting.writeNamed(".mha", whole.left(at) + said + whole.mid(at));
  const QString folder =
      planting.name("a folder in it") + "/" + planting.name("the folder of an .mhd") + "/";
  const QByteArray data = planting.name("the data of an .mhd") + ".raw";
  planting.write(folder + planting.name("the name of an .mhd") + ".mhd",
                 whole.left(at) + "ElementDataFile = " + data + "\n");
  planting.write(folder + data, whole.mid(at + last.size()));
}

void plantMgh(Planting& planting) {
  WrittenVolume volume = boxes();
  for (int& value : volume.values)
    value = value == 1 ? 7 : value == 2 ? 9 : 0;
  const auto table = [&planting](const QString& kind) {
    return replaced(replaced(mghColourTable(), "strange_thing",
                             planting.name("a label of a " + kind) + "_things"),
                    "left_kidney", "left_" + planting.name("a second label of a " + kind));
  };
  planting.writeNamed(".mgh", mghFile(volume, Number::int32, {.footer = table(".mgh")}));
  planting.writeNamed(".mgz", gzipped(mghFile(volume, Number::int32, {.footer = table(".mgz")})));
}

WrittenSegmentation segments(Planting& planting) {
  WrittenSegmentation written = emptySegmentation();
  written.segments = {
      {.number = 1, .label = planting.name("a segment of a DICOM segmentation")},
      {.number = 2,
       .label = "spleen " + planting.name("a second segment of a DICOM segmentation")}};
  addBox(written, 1, {2, 8, 2, 8, 0, 5});
  addBox(written, 2, {10, 16, 2, 8, 0, 5});
  return written;
}

}  // namespace

void plantVolumes(Planting& planting) {
  plantNifti(planting);
  plantNrrd(planting);
  plantMetaImage(planting);
  plantMgh(planting);
  planting.writeNamed(".mnc", mincFile(boxes()));
}

void plantDicom(Planting& planting) {
  planting.writeNamed(
      ".dcm", dicomFile(structureSet(
                  {{.name = planting.name("a region of a DICOM structure set"),
                    .contours = ball({0.0, 30.0, 0.0}, 10.0, -9.0, 3.0)},
                   {.name = "bladder " + planting.name("a second region of a DICOM structure set"),
                    .contours = ball({30.0, 30.0, 0.0}, 10.0, -9.0, 3.0)}})));
  planting.write("segments/" + planting.name("the name of a DICOM segmentation") + ".dcm",
                 dicomFile(segmentation(segments(planting))));
}

}  // namespace sline::test
