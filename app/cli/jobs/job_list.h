// SPDX-License-Identifier: Apache-2.0
// Reads lists of exports: what is to be written from what, one job to a line. A list may come from
// any author; nothing in it is believed before it is checked.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"

namespace sline::cli {

/// Holds one entry of a job: a flag of `sline export` without its dashes, or "input".
struct JobField {
  std::string flag;
  std::vector<std::string> values;  ///< as written; empty for a flag without a value
  std::string where;                ///< "line 4, column png" or "job 4, "png", line 12, column 3"
};

struct Job {
  std::string where;  ///< "line 4" or, in a JSON list, "job 4, line 12"
  std::vector<JobField> fields;
  /// Returns the job's entry for the flag, or null if it has none.
  const JobField* find(std::string_view flag) const;
};

/// Reads a table with a heading (RFC 4180): a column for each flag, and an empty cell where a job
/// does without it. Cells are separated by whichever of comma, semicolon and tab the heading has
/// first. Errors name line and column.
Result<std::vector<Job>> jobsOfTable(std::string_view text);

/// Reads a JSON list of objects with a key for each flag. Texts, numbers, true and lists of texts
/// and numbers are values; false and null stand for a flag that is not there. No flag may occur
/// twice. Errors name the job, line and column.
Result<std::vector<Job>> jobsOfJson(std::string_view text);

/// Reads a file by its ending: .json as a JSON list, any other as a table.
Result<std::vector<Job>> readJobList(const std::filesystem::path& file);

/// Stands for one of `count` parts of a list, counted from 1.
struct Shard {
  std::size_t index = 1;
  std::size_t count = 1;
  /// Tells whether this part has the job at that place of the list, counted from 0: it takes every
  /// count-th, so that neighbours, which take about as long, are spread.
  bool has(std::size_t place) const { return place % count == index - 1; }
};
/// Reads "3/16".
Result<Shard> parseShard(std::string_view text);

}  // namespace sline::cli
