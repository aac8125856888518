// SPDX-License-Identifier: Apache-2.0
// What a person should know of a file that was written all the same. Values, not sentences: the
// command line and the window say them in their own words.
#pragma once

#include <string>
#include <vector>

namespace sline::render {

/// Something that a file lacks, or has otherwise than was ordered.
struct ExportNote {
  enum class Kind {
    labelsWithoutRoom,   ///< `names`: their texts
    labelsOfHidden,      ///< on structures that are hidden or, there, cut away; likewise
    labelsOffPage,       ///< their places are not within the picture; likewise
    labelsUntranslated,  ///< in the scene's own language; likewise, `detail`: the one asked for
    cardsWithoutRoom,    ///< labels that no card asks for; likewise
    marksWithoutRoom,    ///< `names`: of the items (`Marks`)
    sidesUnknown,        ///< no R and L: nobody knows the directions of what is visible
    textShortened,       ///< `names`: as they were meant
    sectionsUncut,       ///< the kind holds whole surfaces; `names`: the sections'
    standsOnWhite,       ///< the kind has no transparency
    depthNotKept,        ///< `detail`: bits a channel that were asked for
    filmRounded,         ///< `detail`: "1282 × 722", pixels
    filmStretched        ///< `detail`: its seconds
  };
  Kind kind = Kind::labelsWithoutRoom;
  std::vector<std::string> names;  ///< plain text; two labels may say the same
  std::string detail;
  bool operator==(const ExportNote&) const = default;
};
using ExportNotes = std::vector<ExportNote>;

/// One of the same kind and detail that is there gets the names that it has not, or not as often:
/// what is said of one page and again of the next is said once.
void addNote(ExportNotes& notes, ExportNote note);

}  // namespace sline::render
