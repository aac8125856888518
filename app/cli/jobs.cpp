// SPDX-License-Identifier: Apache-2.0
// Implements `sline jobs`: carries out a list of exports, or a part of it.
#include <algorithm>
#include <map>
#include <new>
#include <set>

#include "app/cli/commands/command.h"
#include "app/cli/files/targets.h"
#include "app/cli/flags/film_flags.h"
#include "app/cli/flags/package_flags.h"
#include "app/cli/jobs/job_ledger.h"
#include "app/cli/jobs/job_list.h"
#include "model/base/letters.h"
#include "model/disk/paths_below.h"
#include "render/export/formats/export_formats.h"

namespace sline::cli {

namespace {

struct JobsFlags {
  std::string list;
  std::string shard = "1/1";
  std::string folder;
  bool resume = false;
  bool dryRun = false;
};

/// Holds a job as it is carried out.
struct PlannedJob {
  std::string where;
  std::vector<std::string> flags;  ///< "--view=left": nothing in a list is taken for a flag
  std::vector<std::string> inputs;
  std::vector<std::filesystem::path> targets;

  JobWork work() const { return {flags, {inputs.begin(), inputs.end()}, targets}; }

  /// Returns the program's arguments. No input is a flag either, whatever its name.
  std::vector<std::string> arguments() const {
    std::vector<std::string> all{"export"};
    all.insert(all.end(), flags.begin(), flags.end());
    all.emplace_back("--");
    all.insert(all.end(), inputs.begin(), inputs.end());
    return all;
  }
};

/// Tells what `sline export` takes, from its own declaration.
class ExportCommand {
 public:
  /// `where` names the job before each of its warnings.
  explicit ExportCommand(const std::string& where = {}) : m_program("", "sline") {
    addExport(m_program, m_exit, [this, where](const std::string& message) {
      ++m_warnings;
      warn((where.empty() ? "" : where + ": ") + message);
    });
  }
  ExportCommand(const ExportCommand&) = delete;
  ExportCommand& operator=(const ExportCommand&) = delete;

  /// Returns the option of that flag, or null if there is none.
  const CLI::Option* option(const std::string& flag) {
    return flag == "input"  ? m_program.get_subcommand("export")->get_option("INPUT")
           : flag == "help" ? nullptr
                            : m_program.get_subcommand("export")->get_option_no_throw("--" + flag);
  }
  Exit run(std::vector<std::string> arguments) {
    std::reverse(arguments.begin(), arguments.end());
    try {
      m_program.parse(arguments);
    } catch (const CLI::ParseError& message) {
      std::cerr << "sline: " << message.what() << '\n';
      return Exit::wrongUse;
    } catch (const std::bad_alloc&) {
      return complain({.reason = "there is not enough memory",
                       .remedy = "Run fewer jobs at a time, or draw fewer parts"},
                      Exit::failed);
    } catch (const std::exception& failure) {
      return complain({.reason = std::string("a library failed: ") + failure.what(),
                       .remedy = "Run the job alone to see more"},
                      Exit::failed);
    }
    return m_exit;
  }
  int warnings() const { return m_warnings; }

 private:
  Exit m_exit = Exit::done;
  int m_warnings = 0;
  CLI::App m_program;
};

bool isTarget(const std::string& flag) {
  const auto formats = render::exportFormats();
  return flag == "video" || flag == "output" ||
         std::any_of(formats.begin(), formats.end(),
                     [&flag](const render::ExportFormat& each) { return flag == each.id; });
}

/// Returns a path relative to the list, as people who move both expect.
std::string besideList(const std::filesystem::path& folder, const std::string& path) {
  return (std::filesystem::path(path).is_absolute() ? std::filesystem::path(path) : folder / path)
      .string();
}

/// Returns a flag's value for a `sline export` that is run elsewhere than in the list's folder.
std::string valueBeside(const std::filesystem::path& folder, const std::string& flag,
                        const std::string& value) {
  if (flag == "camera")
    return besideList(folder, value);
  // The value is a text, or the name of a file with it.
  std::error_code unknown;
  const std::string file = besideList(folder, value);
  return flag == "text" && std::filesystem::is_regular_file(file, unknown) ? file : value;
}

std::vector<std::string> splitAtSemicolons(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(';', at), text.size());
    const std::string part = text.substr(at, end - at);
    const std::size_t first = part.find_first_not_of(' ');
    if (first != std::string::npos)
      parts.push_back(part.substr(first, part.find_last_not_of(' ') - first + 1));
    at = end + 1;
  }
  return parts;
}

/// Tells whether a cell switches its flag on.
Result<bool> isSwitchedOn(const JobField& field) {
  if (field.values.empty())
    return true;
  const std::string word = lowerCase(field.values.front());
  for (const char* yes : {"yes", "true", "1", "x", "on"})
    if (word == yes)
      return true;
  for (const char* no : {"no", "false", "0", "off"})
    if (word == no)
      return false;
  return Error{.where = field.where,
               .reason = "\"" + field.values.front() + "\" does not say whether",
               .remedy = "Write yes or no"};
}

class JobPlanner {
 public:
  JobPlanner(const std::filesystem::path& list, const std::string& folder)
      : m_list(list.string()),
        m_beside(list.parent_path()),
        m_targets(folder.empty() ? m_beside : std::filesystem::path(folder)) {}

  Result<std::vector<PlannedJob>> of(const std::vector<Job>& jobs) {
    std::vector<PlannedJob> plannedJobs;
    for (const Job& job : jobs) {
      PlannedJob planned = TRY(planOf(job));
      plannedJobs.push_back(std::move(planned));
    }
    TRY(checkEachOther(plannedJobs));
    return plannedJobs;
  }

  /// Returns the folder that targets are relative to.
  const std::filesystem::path& targets() const { return m_targets; }
  /// Returns the real paths of all that is written.
  std::set<std::filesystem::path> written() const {
    std::set<std::filesystem::path> all;
    for (const auto& [target, where] : m_seen)
      all.insert(target);
    return all;
  }

 private:
  Result<PlannedJob> planOf(const Job& job) {
    PlannedJob planned{.where = job.where, .flags = {}, .inputs = {}, .targets = {}};
    if (!job.find("input"))
      return Error{.where = job.where,
                   .reason = "it says nothing of what to draw",
                   .remedy = "Give it an input: a scene, mesh or folder"};
    m_named.clear();
    m_film.file.reset();
    m_package = {};
    for (const JobField& field : job.fields)
      TRY(add(field, planned));
    if (planned.targets.empty())
      return Error{.where = job.where,
                   .reason = "it says nothing of what to write",
                   .remedy = "Give it a target, as in a column " +
                             std::string(render::exportFormats().front().id)};
    if (const Status fine = checkNames(planned); !fine.ok()) {
      Error error = fine.error();
      error.where = job.where + (error.file.empty() ? "" : ", " + error.file);
      return error;
    }
    return planned;
  }

  Status checkNames(const PlannedJob& planned) {
    TRY(addFilmTarget(m_film, m_named));
    TRY(addPackageTarget(m_package, m_named));
    std::vector<std::string> read = planned.inputs;
    read.push_back(m_list);
    return checkTargets(exportTargets(m_named), read);
  }

  Status add(const JobField& field, PlannedJob& planned) {
    const CLI::Option* option = m_command.option(field.flag);
    if (!option)
      return Error{.where = field.where,
                   .reason = "`sline export` has no --" + field.flag,
                   .remedy = "See `sline export --help`; `input` names what is drawn"};
    if (field.flag == "input") {
      for (const std::string& path : field.values)
        if (path.empty())
          return Error{.where = field.where,
                       .reason = "an input has no name",
                       .remedy = "Name a scene, mesh or folder"};
        else
          planned.inputs.push_back(besideList(m_beside, path));
      return Unit{};
    }
    if (isTarget(field.flag))
      return addTarget(field, planned);
    if (field.flag == "package" && field.values.size() == 1)
      m_package.kind = field.values.front();
    const std::string flag = "--" + field.flag;
    if (option->get_items_expected_max() == 0) {
      if (TRY(isSwitchedOn(field)))
        planned.flags.push_back(flag);
      return Unit{};
    }
    const bool several = option->get_expected_max() > 1;
    std::vector<std::string> values;
    for (const std::string& value : field.values)
      for (const std::string& part :
           several ? splitAtSemicolons(value) : std::vector<std::string>{value})
        values.push_back(part);
    if (values.empty() || std::find(values.begin(), values.end(), "") != values.end())
      return Error{.where = field.where,
                   .reason = flag + " needs a value",
                   .remedy = "Write one, or leave it out; see `sline export --help`"};
    for (const std::string& value : values)
      planned.flags.push_back(flag + "=" + valueBeside(m_beside, field.flag, value));
    return Unit{};
  }

  Status addTarget(const JobField& field, PlannedJob& planned) {
    if (field.values.size() != 1)
      return Error{
          .where = field.where, .reason = "it names no file, or several", .remedy = "Write one"};
    const std::filesystem::path named(field.values.front());
    const std::filesystem::path target = (m_targets / named).lexically_normal();
    if (!model::staysBelow(named) || !model::liesBelow(target, m_targets))
      return Error{.where = field.where,
                   .reason = "\"" + named.string() +
                             "\" lies outside of the folder that is "
                             "written to",
                   .remedy = "Write a path below it, or choose that folder with --to"};
    const auto [before, fresh] = m_seen.emplace(model::realPath(target), field.where);
    if (!fresh)
      return Error{.where = field.where,
                   .reason = "\"" + named.string() + "\" is written by " + before->second + ", too",
                   .remedy = "Give each job a target of its own"};
    planned.targets.push_back(target);
    planned.flags.push_back("--" + field.flag + "=" + target.string());
    if (field.flag == "video")
      m_film.file = target.string();
    else if (field.flag == "output")
      m_package.file = target.string();
    else
      m_named[field.flag] = target.string();
    return Unit{};
  }

  /// Fails if a job would write what another reads, since the order in which they are done is
  /// unknown.
  Status checkEachOther(const std::vector<PlannedJob>& plannedJobs) const {
    std::map<std::filesystem::path, std::string> readers;
    for (const PlannedJob& planned : plannedJobs)
      for (const std::string& input : planned.inputs)
        readers.emplace(model::realPath(input), planned.where);
    for (const PlannedJob& planned : plannedJobs)
      for (const std::filesystem::path& target : planned.targets)
        if (const auto reader = readers.find(model::realPath(target)); reader != readers.end())
          return Error{.where = planned.where,
                       .reason = "\"" + target.string() + "\" is read by " + reader->second,
                       .remedy = "Give it another name"};
    return Unit{};
  }

  std::string m_list;
  std::filesystem::path m_beside;
  std::filesystem::path m_targets;
  ExportCommand m_command;
  std::map<std::filesystem::path, std::string> m_seen;
  std::map<std::string, std::string> m_named;  ///< the targets of the job being checked
  FilmFlags m_film;                            ///< the --video of that job
  PackageFlags m_package;                      ///< its --package
};

std::string targetsText(const PlannedJob& planned) {
  std::string all;
  for (const std::filesystem::path& target : planned.targets)
    all += (all.empty() ? "" : ", ") + target.string();
  return all;
}

/// Makes the folders that targets lie in: a list that sorts figures into folders means them to
/// exist.
Status prepareFolders(const PlannedJob& planned) {
  for (const std::filesystem::path& target : planned.targets) {
    std::error_code failed;
    if (target.has_parent_path())
      std::filesystem::create_directories(target.parent_path(), failed);
    if (failed)
      return Error{.file = target.parent_path().string(),
                   .reason = "the folder cannot be made: " + failed.message(),
                   .remedy = "Choose another with --to"};
  }
  return Unit{};
}

/// Counts how the jobs ended.
struct Tally {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t skipped = 0;
  std::size_t withWarnings = 0;

  std::string text(std::size_t all) const {
    return std::to_string(done) + " jobs done, " + std::to_string(failed) + " failed, " +
           std::to_string(skipped) + " skipped, of " + std::to_string(all) + " in the list" +
           (withWarnings > 0 ? "; " + std::to_string(withWarnings) + " with warnings" : "");
  }
};

void carryOut(const PlannedJob& planned, const JobLedger& ledger, Tally& tally) {
  Exit exit = Exit::done;
  ExportCommand command(planned.where);
  const std::string read = ledger.readBy(planned.work());
  if (const Status prepared = prepareFolders(planned); !prepared.ok())
    exit = complain(prepared.error(), Exit::failed);
  else
    exit = command.run(planned.arguments());
  ++(exit == Exit::done ? tally.done : tally.failed);
  tally.withWarnings += command.warnings() > 0 ? 1 : 0;
  if (exit == Exit::done) {
    if (const Status kept = ledger.remember(planned.work(), read); !kept.ok())
      warn(planned.where + ": " + kept.error().text());
    return;
  }
  std::cerr << "sline: " << planned.where << " failed: " << targetsText(planned) << '\n';
}

Exit runJobs(const JobsFlags& flags) {
  const Result<Shard> shard = parseShard(flags.shard);
  if (!shard.ok())
    return complain(shard.error(), Exit::wrongUse);
  const Result<std::vector<Job>> jobs = readJobList(flags.list);
  if (!jobs.ok())
    return complain(jobs.error(), Exit::wrongUse);
  JobPlanner planner(flags.list, flags.folder);
  Result<std::vector<PlannedJob>> plannedJobs = planner.of(*jobs);
  if (!plannedJobs.ok()) {
    Error error = plannedJobs.error();
    error.file = flags.list;
    return complain(error, Exit::wrongUse);
  }
  const JobLedger ledger(planner.targets(), planner.written());
  Tally tally;
  for (std::size_t i = 0; i < plannedJobs->size(); ++i) {
    const PlannedJob& planned = (*plannedJobs)[i];
    if (!shard->has(i))
      continue;
    if (flags.resume && ledger.done(planned.work()))
      ++tally.skipped;
    else if (flags.dryRun)
      std::cout << planned.where << '\t' << targetsText(planned) << '\n';
    else
      carryOut(planned, ledger, tally);
  }
  if (!flags.dryRun)
    tell(tally.text(plannedJobs->size()));
  return tally.failed == 0 ? Exit::done : Exit::failed;
}

void declareJobs(CLI::App& command, JobsFlags& flags) {
  command
      .add_option("LIST", flags.list,
                  "The jobs: a table (.csv) with a column for each flag of `sline export` and "
                  "`input` for what is drawn, or a JSON list (.json) of objects with these keys")
      ->required()
      ->type_name("FILE");
  command
      .add_option("--shard", flags.shard,
                  "Only this part of the list: 3/16 takes every 16th job from the third on. All "
                  "parts together do each job once")
      ->type_name("I/N")
      ->capture_default_str();
  command.add_flag(
      "--resume", flags.resume,
      "Leaves out jobs that were done before: with the same flags, of the same inputs, "
      "and with files that are as they were written. What was done is kept as "
      "checksums in .sline-jobs beside the files");
  command
      .add_option("--to", flags.folder,
                  "The folder that targets are relative to; else the list's own")
      ->type_name("FOLDER");
  command.add_flag("--dry-run", flags.dryRun, "Says what would be written, and writes nothing");
  command.footer(
      "A list figures.csv:\n\n"
      "  input,svg,view,size-mm,gamma\n"
      "  pelvis.sline,out/pelvis-front.svg,anterior,180x120,\n"
      "  pelvis.sline,out/pelvis-back.svg,posterior,180x120,bladder=4; uterus=3\n\n"
      "Paths are relative to the list. Several values of a flag are parted by semicolons; a flag\n"
      "without a value has yes or no. A job that fails does not stop those after it; the exit "
      "code\n"
      "says if any did.\n\n"
      "On one machine, with GNU parallel:\n\n"
      "  parallel -j 4 sline jobs figures.csv --resume --shard {}/16 ::: $(seq 16)\n\n"
      "On a cluster, as a Slurm array (sbatch figures.sh):\n\n"
      "  #!/bin/bash\n"
      "  #SBATCH --array=1-16 --cpus-per-task=2 --mem=4G\n"
      "  sline jobs figures.csv --resume --shard \"$SLURM_ARRAY_TASK_ID/16\"");
}

}  // namespace

void addJobs(CLI::App& program, Exit& exit) {
  addCommand<JobsFlags>(program, exit, {"jobs", "Export a list of figures, or a part of it"},
                        declareJobs, runJobs);
}

}  // namespace sline::cli
