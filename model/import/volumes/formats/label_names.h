// SPDX-License-Identifier: Apache-2.0
// What the numbers of a label volume mean, from tables in its header or in a file beside it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "model/import/source/read_options.h"
#include "model/import/volumes/formats/label_volume.h"

namespace sline::model {

/// By the number in the file. Only what a table says is set.
using LabelNames = std::map<std::int64_t, Label>;

/// Lines of number and name: 3D Slicer's colour tables and FreeSurfer's (number, name, red, green,
/// blue, alpha), ITK-SNAP's (number, red, green, blue, …, name in quotes), and tables with tabs or
/// commas, whose first line may name the columns (BIDS: index, name, color). Lines that are nothing
/// of the kind are passed over.
LabelNames labelsInTable(std::string_view text);

/// {"labels": …} or what would stand there: {"liver": 5}, {"5": "liver"} or [{"value": 5, "name":
/// "liver", "color": …}], as training sets and annotation programs write. Empty where it is no
/// JSON.
LabelNames labelsInJson(std::string_view text);

/// The LabelTable of Caret and Connectome Workbench, which other programs put into NIfTI's header
/// extension: <Label Key="5" Red="0.9" …>liver</Label>.
LabelNames labelsInCaret(std::string_view xml);

/// From the file beside `volume` that is called like it (STEM, STEM_names or STEM_labels, then
/// .ctbl, .tsv, .csv, .txt, .label or .json), else from the folder's only .ctbl. `from` becomes the
/// name of the file that was used.
LabelNames labelsBeside(const std::filesystem::path& volume, const ReadLimits& limits,
                        std::string& from);

/// Names, colours and groups by the labels' numbers. Where there are several labels, those without
/// a name are called after their number.
void nameLabels(LabelVolume& volume, const LabelNames& names);

}  // namespace sline::model
