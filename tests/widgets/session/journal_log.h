// SPDX-License-Identifier: Apache-2.0
// What journal_worker says after each action, in a form that its test can compare.
#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "model/scene_file/fingerprint.h"
#include "model/scene_json/scene_json.h"

namespace sline::test {

inline std::uint32_t sumOf(const model::Scene& scene) {
  return model::fingerprintOf(model::sceneJson(scene)).crc;
}
inline std::uint32_t sumOf(const std::vector<model::NodeId>& ids) {
  std::string text;
  for (const model::NodeId id : ids)
    text += std::to_string(id.value) + " ";
  return model::fingerprintOf(text).crc;
}

struct JournalLog {
  std::uint32_t scene = 0;   ///< its sum
  std::uint32_t before = 0;  ///< that of the scene to which undo leads; 0: not known
  std::uint32_t selection = 0;
  bool kept = false;  ///< the journal has said since that it has all that was done so far

  static constexpr const char* keptLine = "kept\n";
  std::string line() const {
    std::ostringstream text;
    text << scene << ' ' << before << ' ' << selection << '\n';
    return text.str();
  }
  /// Returns the lines that are whole.
  static std::vector<JournalLog> from(const std::string& text) {
    std::vector<JournalLog> all;
    std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
    for (std::string line; std::getline(lines, line);) {
      JournalLog log;
      if (line + '\n' != keptLine) {
        std::istringstream(line) >> log.scene >> log.before >> log.selection;
        all.push_back(log);
      } else if (!all.empty()) {
        all.back().kept = true;
      }
    }
    return all;
  }
};

}  // namespace sline::test
