// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/package_flags.h"

#include <CLI/CLI.hpp>
#include <vector>

#include "render/export/formats/export_formats.h"

namespace sline::cli {

namespace {

std::vector<std::string> packageKinds() {
  std::vector<std::string> kinds;
  for (const render::ExportFormat& format : render::exportFormats())
    if (format.forLearning)
      kinds.emplace_back(format.id);
  return kinds;
}

}  // namespace

void declarePackage(CLI::App& command, PackageFlags& flags) {
  command
      .add_option("--package", flags.kind,
                  "For a learning system, with -o: the same as the flag of that name")
      ->check(CLI::IsMember(packageKinds()));
  command.add_option("-o,--output", flags.file, "The file that --package writes")
      ->type_name("FILE");
}

Status addPackageTarget(const PackageFlags& flags, std::map<std::string, std::string>& targets) {
  if (flags.kind.empty() && flags.file.empty())
    return Unit{};
  if (flags.file.empty())
    return Error{.reason = "--package " + flags.kind + " names no file",
                 .remedy = "Write one after -o"};
  if (flags.kind.empty())
    return Error{.file = flags.file,
                 .reason = "nothing says what kind of file that is",
                 .remedy = "Give it after the flag of its kind, as in --png " + flags.file +
                           ", or add --package with a learning system's"};
  const auto [other, fresh] = targets.emplace(flags.kind, flags.file);
  if (!fresh)
    return Error{.file = flags.file,
                 .reason = "--package " + flags.kind + " and --" + flags.kind + ' ' +
                           other->second + " ask for two files of one kind",
                 .remedy = "Leave one out, or export twice"};
  return Unit{};
}

}  // namespace sline::cli
