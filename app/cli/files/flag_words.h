// SPDX-License-Identifier: Apache-2.0
// Adds to what other rooms say, for whatever host, which flag or command does it here.
#pragma once

#include <span>
#include <string>

namespace sline::cli {

/// A phrase of a message, and what the command line adds behind it in brackets.
struct FlagWords {
  const char* phrase;
  const char* words;
};

/// Returns all of them; the rooms that say the phrases know nothing of flags.
std::span<const FlagWords> flagWords();

/// Returns the message with flags and commands named.
std::string withFlags(std::string message);

}  // namespace sline::cli
