// SPDX-License-Identifier: Apache-2.0
// Lists what an import doubts: sides, units, what a file says twice, and patients.
#include <QtGlobal>

#include "widgets/text/told.h"

namespace sline::widgets {

namespace {

constexpr const char* doubtRows[] = {
    QT_TRANSLATE_NOOP("Told",
                      "%1 of %2 left/right names contradict the frame %3 that the files give; %4"),
    QT_TRANSLATE_NOOP("Told", "front and back are right: if the files are mirrored, choose %1"),
    QT_TRANSLATE_NOOP("Told", "front and back are swapped too: choose %1"),
    QT_TRANSLATE_NOOP("Told",
                      "if left and right are swapped, choose %1 where front and back are swapped "
                      "too, else %2"),
    QT_TRANSLATE_NOOP("Told",
                      "names of front and back contradict the frame %1; if the files are mirrored, "
                      "choose %2"),
    QT_TRANSLATE_NOOP("Told",
                      "surfaces whose files do not say their frame lie beside the others, whether "
                      "they are read as LPS or as RAS; %1 was assumed"),
    QT_TRANSLATE_NOOP("Told",
                      "scenes of 3D Slicer beside it disagree about its coordinates; none of them "
                      "was followed"),
    QT_TRANSLATE_NOOP("Told",
                      "%1 of %2 structures are not as large as their names say: \"%3\" is %4 mm "
                      "large, and such structures are %5 to %6 mm; %7"),
    QT_TRANSLATE_NOOP("Told", "\"%1\" is %2 mm large, and such structures are %3 to %4 mm; %5"),
    QT_TRANSLATE_NOOP("Told", "no usual unit would make it right"),
    QT_TRANSLATE_NOOP("Told", "it would be right if the file's unit were %1 mm"),
    QT_TRANSLATE_NOOP("Told", "it would be right if the file's unit were %1 or %2 mm"),
    QT_TRANSLATE_NOOP("Told", "its unit is stated (%1) and was followed"),
    QT_TRANSLATE_NOOP("Told", "%1 lies on the other side than its name says"),
    QT_TRANSLATE_NOOP("Told", "%1 lie on the other side than their names say"),
    QT_TRANSLATE_NOOP("Told",
                      "molecules are drawn with 1 Å as 1 mm, ten million times as large as \"%1\" "
                      "beside them; no scale bar holds for both, so open them apart"),
    QT_TRANSLATE_NOOP("Told", "SlicerRT's segmentations are RAS"),
    QT_TRANSLATE_NOOP("Told",
                      "says that it holds the voxels %1 of a reference image, which are not as "
                      "many as it has; it was placed as if its origin were its own"),
    QT_TRANSLATE_NOOP("Told",
                      "says that it holds the voxels %1 of a reference image, and an offset in "
                      "it, as files with an origin of their own do; it was placed by its origin "
                      "alone"),
    QT_TRANSLATE_NOOP("Told",
                      "says that it holds the voxels %1 of a reference image; its origin was "
                      "taken to be that image's"),
    QT_TRANSLATE_NOOP("Told", "\"%1\" is flat: it has no extent in a direction"),
    QT_TRANSLATE_NOOP("Told",
                      "\"%1\" beside it gives none of its labels a name that is understood"),
    QT_TRANSLATE_NOOP("Told",
                      "holds %1 label volumes of one place, as points in time; structures of all "
                      "of them lie over each other"),
    QT_TRANSLATE_NOOP(
        "Told",
        "sform and qform place it differently, by up to %1 of its units; the sform was taken"),
    QT_TRANSLATE_NOOP("Told",
                      "sform and qform place it differently, by up to %1 of its units and with "
                      "left and right swapped; the sform was taken"),
    QT_TRANSLATE_NOOP("Told", "is drawn on one slice; made %1 mm thick, as the file says"),
    QT_TRANSLATE_NOOP("Told",
                      "is drawn on one slice; made %1 mm thick, as slices of other structures are"),
    QT_TRANSLATE_NOOP("Told", "is drawn on one slice; made %1 mm thick, which nothing tells"),
    QT_TRANSLATE_NOOP("Told", "is of another patient than the files before it; left out"),
    QT_TRANSLATE_NOOP("Told",
                      "files of one patient lie in different frames of reference: nothing says "
                      "that what is laid over each other fits"),
    QT_TRANSLATE_NOOP("Told", "it is of another patient than the other files now"),
    QT_TRANSLATE_NOOP("Told",
                      "another file of this name is not as it was read; name its folder if that "
                      "one is meant"),
    QT_TRANSLATE_NOOP("Told", "\"%1\" is %2 large now and was %3: its file may have another unit"),
    QT_TRANSLATE_NOOP("Told",
                      "\"%1\" lies %2 away from where it was: it may be another body's, or "
                      "mirrored"),
    QT_TRANSLATE_NOOP("Told", "the files are of %1 patients: %2"),
    QT_TRANSLATE_NOOP("Told", "the names of the files tell of %1 bodies: %2"),
    QT_TRANSLATE_NOOP(
        "Told", "the files are of %1 studies, and nothing says that they are of one patient: %2"),
    QT_TRANSLATE_NOOP("Told", "Give the files of one patient, or put them together on purpose"),
    QT_TRANSLATE_NOOP("Told",
                      "names of sides in this folder contradict the frame of the others, %1; it "
                      "was taken, and is not certain here"),
    QT_TRANSLATE_NOOP("Told", "the files of this folder are read as %1, unlike others: %2"),
    QT_TRANSLATE_NOOP("Told", "it came from more than %1 studies"),
    QT_TRANSLATE_NOOP("Told", "what was there already is read as %1 now: %2"),
    QT_TRANSLATE_NOOP("Told", "left and right of what was there already are certain now: %1"),
    QT_TRANSLATE_NOOP("Told", "is a scan rather than a label volume: %1"),
    QT_TRANSLATE_NOOP("Told",
                      "Give a threshold that makes a structure of it, or choose the segmentation "
                      "that was made of it"),
    QT_TRANSLATE_NOOP("Told",
                      "Structures come from a DICOM segmentation or RT structure set, from label "
                      "maps and meshes made of the images, or from a threshold"),
    QT_TRANSLATE_NOOP("Told", "Name one of the scene's saved views"),
    QT_TRANSLATE_NOOP("Told", "Change it in the figure's file"),
    QT_TRANSLATE_NOOP("Told", "Save it as a scene file, and name it with its ending .sline"),
};

}  // namespace

std::span<const char* const> doubtPatterns() {
  return doubtRows;
}

}  // namespace sline::widgets
