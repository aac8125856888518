// SPDX-License-Identifier: Apache-2.0
// Reads the meaning of a label volume's numbers from tables in its header or in a file beside it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "model/import/source/read_options.h"
#include "model/import/volumes/formats/label_volume.h"

namespace sline::model {

/// Maps the number in the file to its label. Only members that a table gives are set.
using LabelNames = std::map<std::int64_t, Label>;

/// Reads lines of number and name: 3D Slicer's colour tables and FreeSurfer's (number, name, red,
/// green, blue, alpha), ITK-SNAP's (number, red, green, blue, …, name in quotes), and tables with
/// tabs or commas, of which the first line may name the columns (BIDS: index, name, color). Other
/// lines are passed over.
LabelNames labelsInTable(std::string_view text);

/// Reads {"labels": …} or its value on its own: {"liver": 5}, {"5": "liver"} or [{"value": 5,
/// "name": "liver", "color": …}], as training sets and annotation programs write, and lists beside
/// each other: {"labels": ["air", "liver"], "R": [0, 200], …, "I": [0, 5]}. Returns an empty table
/// where the text is no JSON.
LabelNames labelsInJson(std::string_view text);

/// Reads the LabelTable of Caret and Connectome Workbench, which other programs put into NIfTI's
/// header extension: <Label Key="5" Red="0.9" …>liver</Label>.
LabelNames labelsInCaret(std::string_view xml);

/// Reads names from the file beside `volume` that is called like it (STEM, STEM_names or
/// STEM_labels, then .ctbl, .tsv, .csv, .txt, .label or .json), else from the folder's only .ctbl.
/// `from` becomes the name of the file that was used.
LabelNames labelsBeside(const std::filesystem::path& volume, const ReadLimits& limits,
                        std::string& from);

/// Returns the name of the file beside `volume` in which labelsBeside looks first, or nothing where
/// there is none.
std::string tableBeside(const std::filesystem::path& volume);

/// Sets names, colours and groups by the labels' numbers. Where there are several labels, those
/// without a name are called after their number.
void nameLabels(LabelVolume& volume, const LabelNames& names);

}  // namespace sline::model
