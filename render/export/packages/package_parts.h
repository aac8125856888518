// SPDX-License-Identifier: Apache-2.0
// Writes what the files of several kinds of packages have in common.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/export/order/export_order.h"
#include "render/export/packages/question_zone.h"

namespace sline::render {

inline constexpr const char* xmlHead = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/// Returns any text as one line between tags.
std::string lineElementText(std::string_view words);
/// Returns ` name="value"`.
std::string xmlAttribute(const char* name, std::string_view value);
/// Returns a person as metadata want it, as a vCard.
std::string personCard(std::string_view name);
/// Returns an element of LOM, with the prefix "lom": title and credit.
std::string lomElement(const std::string& title, const std::string& language,
                       const ExportCredit& credit);

/// Returns an identifier in the form of a UUID, made of a name: the same for the same name.
std::string uuidOf(const std::string& name);

/// Returns the outline in whole pixels of a picture, without two like corners in a row.
std::vector<glm::ivec2> pixelOutline(const QuestionZone& zone, const glm::ivec2& size);

}  // namespace sline::render
