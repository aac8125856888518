// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/flag_words.h"

#include <string_view>

namespace sline::cli {

namespace {

constexpr FlagWords rows[] = {
    {"put them together on purpose", "--together"},
    {"maybe a person's, left out of names", "`sline import --keep-file-names` keeps them"},
    {"Give a threshold that makes a structure of it",
     "--threshold NAME=VALUE, or --threshold bone, skin or vessels"},
    {"made of the images, or from a threshold", "--threshold bone"},
    {"Name one of the scene's saved views", "`sline view SCENE --list` lists them"},
    {"Change it in the figure's file", "`sline compose --help` lists the keys and what they take"},
    {"Save it as a scene file", "`sline import` makes one"},
};

}  // namespace

std::span<const FlagWords> flagWords() {
  return rows;
}

std::string withFlags(std::string message) {
  for (const auto& [phrase, words] : rows)
    if (const std::size_t at = message.find(phrase); at != std::string::npos)
      message.insert(at + std::string_view(phrase).size(), " (" + std::string(words) + ")");
  return message;
}

}  // namespace sline::cli
