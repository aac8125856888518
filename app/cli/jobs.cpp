// SPDX-License-Identifier: Apache-2.0
// `sline jobs`: a list of exports, or a part of it.
#include <algorithm>
#include <map>
#include <new>
#include <set>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/job_list.h"
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

/// A job as it is carried out.
struct Order {
  std::string where;
  std::vector<std::string> arguments;  ///< of the program, from "export" on
  std::vector<std::filesystem::path> targets;
};

/// What `sline export` takes, asked of itself.
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

  /// Null where it has no such flag.
  const CLI::Option* option(const std::string& flag) {
    return flag == "input"  ? m_program.get_subcommand("export")->get_option("INPUT")
           : flag == "help" ? nullptr
                            : m_program.get_subcommand("export")->get_option_no_throw("--" + flag);
  }
  Exit run(std::vector<std::string> arguments) {
    arguments = withInputsFirst(arguments, [](const std::string& path) {
      std::error_code unknown;
      return std::filesystem::exists(path, unknown);
    });
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
  return std::any_of(formats.begin(), formats.end(),
                     [&flag](const render::ExportFormat& each) { return flag == each.id; });
}

/// Relative to the list, as everybody who moves both expects.
std::filesystem::path besideList(const std::filesystem::path& folder, const std::string& path) {
  return std::filesystem::path(path).is_absolute() ? std::filesystem::path(path) : folder / path;
}

std::vector<std::string> parted(const std::string& text) {
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

/// A flag that is there or not, as a cell says.
Result<bool> isSaid(const JobField& field) {
  if (field.values.empty())
    return true;
  std::string word = field.values.front();
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char each) { return char(std::tolower(each)); });
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

class Orders {
 public:
  Orders(const std::filesystem::path& list, const std::string& folder)
      : m_beside(list.parent_path()),
        m_targets(folder.empty() ? m_beside : std::filesystem::path(folder)) {}

  Result<std::vector<Order>> of(const std::vector<Job>& jobs) {
    std::vector<Order> orders;
    for (const Job& job : jobs) {
      Result<Order> order = orderOf(job);
      if (!order.ok())
        return order.error();
      orders.push_back(std::move(*order));
    }
    return orders;
  }

 private:
  Result<Order> orderOf(const Job& job) {
    Order order{.where = job.where, .arguments = {"export"}, .targets = {}};
    if (!job.find("input"))
      return Error{.where = job.where,
                   .reason = "it says nothing of what to draw",
                   .remedy = "Give it an input: a scene, mesh or folder"};
    for (const JobField& field : job.fields)
      if (const Status added = add(field, order); !added.ok())
        return added.error();
    if (order.targets.empty())
      return Error{.where = job.where,
                   .reason = "it says nothing of what to write",
                   .remedy = "Give it a target, as in a column " +
                             std::string(render::exportFormats().front().id)};
    return order;
  }

  Status add(const JobField& field, Order& order) {
    const CLI::Option* option = m_command.option(field.flag);
    if (!option)
      return Error{.where = field.where,
                   .reason = "`sline export` has no --" + field.flag,
                   .remedy = "See `sline export --help`; `input` names what is drawn"};
    if (field.flag == "input") {
      for (const std::string& path : field.values)
        order.arguments.push_back(besideList(m_beside, path).string());
      return Unit{};
    }
    if (isTarget(field.flag))
      return addTarget(field, order);
    const std::string flag = "--" + field.flag;
    if (option->get_items_expected_max() == 0) {
      const Result<bool> said = isSaid(field);
      if (!said.ok())
        return said.error();
      if (*said)
        order.arguments.push_back(flag);
      return Unit{};
    }
    if (field.values.empty())
      return Error{.where = field.where,
                   .reason = flag + " needs a value",
                   .remedy = "See `sline export --help`"};
    const bool several = option->get_expected_max() > 1;
    const bool path = option->get_type_name().starts_with("FILE");
    order.arguments.push_back(flag);
    for (const std::string& value : field.values)
      for (const std::string& part : several ? parted(value) : std::vector<std::string>{value})
        order.arguments.push_back(path ? besideList(m_beside, part).string() : part);
    return Unit{};
  }

  Status addTarget(const JobField& field, Order& order) {
    if (field.values.size() != 1)
      return Error{
          .where = field.where, .reason = "it names no file, or several", .remedy = "Write one"};
    const std::filesystem::path named(field.values.front());
    if (!staysBelow(named))
      return Error{.where = field.where,
                   .reason = "\"" + named.string() +
                             "\" lies outside of the folder that is "
                             "written to",
                   .remedy = "Write a path below it, or choose that folder with --to"};
    const std::filesystem::path target = (m_targets / named).lexically_normal();
    const auto [before, fresh] = m_seen.emplace(target, field.where);
    if (!fresh)
      return Error{.where = field.where,
                   .reason = "\"" + named.string() + "\" is written by " + before->second + ", too",
                   .remedy = "Give each job a target of its own"};
    order.targets.push_back(target);
    order.arguments.push_back("--" + field.flag);
    order.arguments.push_back(target.string());
    return Unit{};
  }

  std::filesystem::path m_beside;
  std::filesystem::path m_targets;
  ExportCommand m_command;
  std::map<std::filesystem::path, std::string> m_seen;
};

bool allThere(const Order& order) {
  return std::all_of(order.targets.begin(), order.targets.end(), [](const auto& target) {
    std::error_code unknown;
    return std::filesystem::exists(target, unknown);
  });
}

std::string targetsText(const Order& order) {
  std::string all;
  for (const std::filesystem::path& target : order.targets)
    all += (all.empty() ? "" : ", ") + target.string();
  return all;
}

/// Folders that targets lie in are made: who sorts figures into folders means them.
Status prepareFolders(const Order& order) {
  for (const std::filesystem::path& target : order.targets) {
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

/// What became of the jobs.
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

void carryOut(const Order& order, Tally& tally) {
  Exit exit = Exit::done;
  ExportCommand command(order.where);
  if (const Status prepared = prepareFolders(order); !prepared.ok())
    exit = complain(prepared.error(), Exit::failed);
  else
    exit = command.run(order.arguments);
  ++(exit == Exit::done ? tally.done : tally.failed);
  tally.withWarnings += command.warnings() > 0 ? 1 : 0;
  if (exit != Exit::done)
    std::cerr << "sline: " << order.where << " failed: " << targetsText(order) << '\n';
}

Exit runJobs(const JobsFlags& flags) {
  const Result<Shard> shard = parseShard(flags.shard);
  if (!shard.ok())
    return complain(shard.error(), Exit::wrongUse);
  const Result<std::vector<Job>> jobs = readJobList(flags.list);
  if (!jobs.ok())
    return complain(jobs.error(), Exit::wrongUse);
  Result<std::vector<Order>> orders = Orders(flags.list, flags.folder).of(*jobs);
  if (!orders.ok()) {
    Error error = orders.error();
    error.file = flags.list;
    return complain(error, Exit::wrongUse);
  }
  Tally tally;
  for (std::size_t i = 0; i < orders->size(); ++i) {
    const Order& order = (*orders)[i];
    if (!shard->has(i))
      continue;
    if (flags.resume && allThere(order))
      ++tally.skipped;
    else if (flags.dryRun)
      std::cout << order.where << '\t' << targetsText(order) << '\n';
    else
      carryOut(order, tally);
  }
  if (!flags.dryRun)
    tell(tally.text(orders->size()));
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
  command.add_flag("--resume", flags.resume,
                   "Leaves out jobs whose files are there already; files appear whole or not at "
                   "all, so those that are there are done");
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
