// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/subtitles.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/scene/label_words.h"
#include "model/scene/markup.h"
#include "render/lettering/caption.h"

namespace sline::render {

namespace {

/// Returns hours, minutes, seconds and thousandths, as "00:01:02.500".
std::string cueTime(double seconds) {
  const long thousandths = std::lround(1000.0 * seconds);
  char text[32];
  std::snprintf(text, sizeof text, "%02ld:%02ld:%02ld.%03ld", thousandths / 3'600'000,
                thousandths / 60'000 % 60, thousandths / 1000 % 60, thousandths % 1000);
  return text;
}

std::string cueText(const std::string& plain) {
  std::string text;
  for (const char c : plain) {
    if (c == '&')
      text += "&amp;";
    else if (c == '<')
      text += "&lt;";
    else if (c == '>')
      text += "&gt;";
    else if (static_cast<unsigned char>(c) >= ' ')
      text += c;
  }
  return text;
}

std::string cueLine(const model::MarkedLine& line) {
  std::string text = line.bullet ? std::string(model::bulletSign) : std::string();
  for (const model::MarkedRun& run : line.runs) {
    text += run.style.bold ? "<b>" : "";
    text += run.style.italic ? "<i>" : "";
    text += cueText(run.text);
    text += run.style.italic ? "</i>" : "";
    text += run.style.bold ? "</b>" : "";
  }
  return text;
}

}  // namespace

std::string webVtt(const Film& film, const std::string& language) {
  const std::string tag = model::firstLanguage(language);
  std::string file = "WEBVTT\n";
  for (const FilmCue& cue : film.cues()) {
    std::string lines;
    for (const model::MarkedLine& line :
         model::markedLines(captionMarkup(cue.words.title.in(tag), cue.words.text.in(tag))))
      // A blank line would end the cue.
      if (const std::string text = cueLine(line);
          text.find_first_not_of(" \t") != std::string::npos)
        lines += text + "\n";
    if (!lines.empty())
      file.append("\n" + cueTime(cue.begin) + " --> " + cueTime(cue.end) + "\n").append(lines);
  }
  return file;
}

}  // namespace sline::render
