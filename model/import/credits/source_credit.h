// SPDX-License-Identifier: Apache-2.0
// Finds out whose work a file's surfaces are: what comments in its header, and texts beside it that
// are there for that, say of authors, copyright and licence. What is no text is no comment: numbers
// in binary may have the bytes of any word. Of a patient such lines say nothing;
// those that might, and names of files and folders, are no source.
#pragma once

#include <filesystem>
#include <string_view>

#include "model/scene/credit.h"

namespace sline::model {

/// The kinds of texts that say it, by where they are.
enum class CreditText {
  mesh,      ///< a mesh file: the comments of its header, or a glTF file's asset
  licence,   ///< LICENSE, COPYING: the line that names the licence best
  citation,  ///< CITATION.cff: its title, authors and license
  readme     ///< README: lines that begin with "License:", "Copyright:" or "Author:"
};

/// Returns what the text says, tidied; it may be any bytes.
SourceCredit creditIn(std::string_view text, CreditText kind);

/// Returns what the mesh file says and, where that leaves something open, what texts in its folder
/// and licences in the folder above say. What cannot be read says nothing. It reads no more than
/// the beginning of each.
SourceCredit creditOf(const std::filesystem::path& file);

}  // namespace sline::model
