// SPDX-License-Identifier: Apache-2.0
// Finds what a person may have meant who typed a name that there is not.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sline::model {

/// Returns up to five of the names that are most like the wanted one, best first: those that
/// contain it or are contained in it, then those a few typing errors away.
std::vector<std::string> nearNames(std::string_view wanted, std::span<const std::string> names);

/// Returns them as the remedy of an error: 'Near it: "a", "b"'; empty where none is near.
std::string nearNamesText(std::string_view wanted, std::span<const std::string> names);

}  // namespace sline::model
