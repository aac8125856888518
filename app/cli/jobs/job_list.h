// SPDX-License-Identifier: Apache-2.0
// Lists of exports: what is to be written from what, a job to the line. Who wrote the list is not
// asked; nothing in it is believed before it was looked at.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"

namespace sline::cli {

/// One answer of a job: a flag of `sline export` without its dashes, or "input".
struct JobField {
  std::string flag;
  std::vector<std::string> values;  ///< as written; none for a flag that is just there
  std::string where;                ///< "line 4, column png" or "job 4, "png", line 12, column 3"
};

struct Job {
  std::string where;  ///< "line 4" or, of a JSON list, "job 4, line 12"
  std::vector<JobField> fields;
  /// Null where the job says nothing of it.
  const JobField* find(std::string_view flag) const;
};

/// A table with a heading (RFC 4180): a column for each flag, an empty cell where a job does
/// without. Cells are parted by what the heading has first of comma, semicolon and tab. Errors name
/// line and column.
Result<std::vector<Job>> jobsOfTable(std::string_view text);

/// A JSON list of objects: a key for each flag; texts, numbers, true and lists of texts and numbers
/// are values, false and null stand for a flag that is not there. No flag is there twice. Errors
/// name the job, line and column.
Result<std::vector<Job>> jobsOfJson(std::string_view text);

/// Of a file, by its ending: .json, else a table.
Result<std::vector<Job>> readJobList(const std::filesystem::path& file);

/// One of `count` parts of a list, from 1.
struct Shard {
  std::size_t index = 1;
  std::size_t count = 1;
  /// Whether it has the job at that place of the list, from 0: it takes every count-th, so that
  /// neighbours, which take about as long, are spread.
  bool has(std::size_t place) const { return place % count == index - 1; }
};
/// "3/16".
Result<Shard> parseShard(std::string_view text);

/// Whether a path that a list gives stays in the folder it is relative to: it is not absolute and
/// never climbs out.
bool staysBelow(const std::filesystem::path& path);

/// Where a path leads, with all its links followed, a last one that leads to nothing yet, too.
std::filesystem::path realPath(const std::filesystem::path& path);
/// Whether it leads below the folder, links followed.
bool liesBelow(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace sline::cli
