// SPDX-License-Identifier: Apache-2.0
// Notes tell the user what is different about a file that was written all the same. They are
// values, not sentences: the command line and the window put them in their own words.
#pragma once

#include <string>
#include <vector>

namespace sline::render {

/// Describes something that a file lacks, or has otherwise than was ordered.
struct ExportNote {
  enum class Kind {
    labelsWithoutRoom,   ///< `names`: their texts
    labelsOfHidden,      ///< on structures that are hidden or cut away there; `names`: their texts
    labelsOffPage,       ///< their places are not within the picture; `names`: their texts
    labelsHidden,        ///< what they name is not seen where they point; `names`: their texts
    labelsOnAnatomy,     ///< anatomy leaves no ground beside it; `names`: their texts
    pictureFramed,       ///< anatomy leaves no ground for labels, and the drawing ends at a frame;
                         ///< `detail`: how many millimetres within the left and the right edge
    labelsUntranslated,  ///< `names`: texts in the scene's language, `detail`: the one asked for
    cardsWithoutRoom,    ///< labels that no card asks for; `names`: their texts
    marksWithoutRoom,    ///< `names`: those of the items (`Marks`)
    legendWithoutRoom,   ///< `names`: the structures'
    legendEmpty,         ///< nothing that it should list is visible
    sidesUnknown,        ///< no R and L, as the directions of what is visible are unknown
    textShortened,       ///< `names`: the full texts
    footCutOff,          ///< the picture ends above what is written at its foot; `detail`: by how
                         ///< many millimetres
    sectionsUncut,       ///< the kind of file holds whole surfaces; `names`: the sections'
    noiseNotDrawn,       ///< the kind of file holds no pixels; `names`: the structures'
    standsOnWhite,       ///< the kind of file has no transparency
    depthNotKept,        ///< `detail`: bits per channel that were asked for
    filmRounded,         ///< `detail`: "1282 × 722", pixels
    filmStretched,       ///< `detail`: its seconds
    pageLarge,           ///< for telephones; `detail`: millions of triangles
    pageSimplified,      ///< `detail`: by how many millimetres surfaces are off at most
    quizEmpty,           ///< there is nothing that its questions could ask for
    labelsNotAsked,      ///< one does not see enough of what they name; `names`: their texts
    labelsDoubted,       ///< not asked for, as they may lie on the other side; `names`: their texts
    creditsLeftOut,      ///< surfaces come under terms that want their credit beside them, and the
                         ///< file has none; `names`: the credits
    subtitlesEmpty       ///< no view says anything
  };
  Kind kind = Kind::labelsWithoutRoom;
  std::vector<std::string> names;  ///< plain text; two labels may have the same
  std::string detail;
  bool operator==(const ExportNote&) const = default;
};
using ExportNotes = std::vector<ExportNote>;

/// Adds a note. A note of the same kind and detail that is already in the list receives the names
/// that it lacks, or has fewer times, so that what is true of several pages is said once.
void addNote(ExportNotes& notes, ExportNote note);

}  // namespace sline::render
