// SPDX-License-Identifier: Apache-2.0
// Knows which names of files and folders may be shown to others: files are often named after
// patients, and no program can tell a person's name from another word it does not know.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sline::model {

/// Returns of a name what may be shown: the words that the tables of anatomy, of cells or the
/// program itself know, sides, numbers of one or two digits and these with a letter ("4a", "C7b").
/// A name of such words alone stays as it is; of others the rest is left out ("Doe_Jane_liver" →
/// "liver"), and all of it where only numbers, sides and letters would be left.
std::string shownName(std::string_view name);

/// Returns the words that `shownName` leaves out, as they are written in the name. They may be a
/// person's: they are for who gives the files alone, and for no scene or product.
std::vector<std::string> wordsNotShown(std::string_view name);

}  // namespace sline::model
