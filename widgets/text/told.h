// SPDX-License-Identifier: Apache-2.0
// Translates what rooms without Qt say in English: errors, remarks, reasons.
#pragma once

#include <QString>
#include <span>
#include <string>

namespace sline::widgets {

/// Returns the message in the interface's language. It is recognised by the patterns below, its
/// parts too; what none of them knows stays as it is.
QString told(const QString& english);
inline QString told(const std::string& english) {
  return told(QString::fromStdString(english));
}

/// Returns the patterns of messages as the other rooms put them together; "%1" and the like stand
/// for numbers, names and further messages. A new message gets a row there.
std::span<const char* const> toldPatterns();
/// Returns those of what an import doubts.
std::span<const char* const> doubtPatterns();
/// Returns what the system says of files, in the same form.
std::span<const char* const> systemPatterns();

/// The context in which translators find the patterns.
inline constexpr const char* toldContext = "Told";

}  // namespace sline::widgets
