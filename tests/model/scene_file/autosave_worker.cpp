// SPDX-License-Identifier: Apache-2.0
// Stands in for the window, made to be killed: it opens a scene file (or takes over what an earlier
// worker has left), edits, saves now and then and keeps copies, and reports on standard output what
// it is about to do and what it has done. Version n of the scene has n in its name.
//   autosave_worker FILE AUTOSAVE_FOLDER MILLISECONDS_BETWEEN_COPIES SEED
#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>

#include "model/scene_file/autosave.h"
#include "tests/support/shapes.h"

using namespace sline;
using namespace sline::model;

namespace {
/// Writes the report in one piece and at once, so that it is out before anything else can happen.
void say(const std::string& what, long version) {
  const std::string line = what + " " + std::to_string(version) + "\n";
  if (write(STDOUT_FILENO, line.data(), line.size()) < 0)
    std::exit(EXIT_FAILURE);
}

int failed(const Error& error) {
  const std::string line = error.text() + "\n";
  static_cast<void>(write(STDERR_FILENO, line.data(), line.size()));
  return EXIT_FAILURE;
}

long versionOf(const Scene& scene) {
  return scene.nodes().empty() ? 0 : std::strtol(scene.nodes()[0].name.c_str(), nullptr, 10);
}

Scene version(long number) {
  Scene scene;
  scene.append({.name = std::to_string(number)});
  const auto size = float(1 + number % 50);
  scene.append({.name = "ball", .mesh = test::sphere(size, 4)});
  scene.append({.name = "ring", .mesh = test::torus(3 * size, size, 32, 16)});
  return scene;
}

long savedVersion(const std::filesystem::path& file) {
  const auto saved = readSceneFile(file);
  return saved.ok() ? versionOf(saved->scene) : 0;
}

/// Goes on from the leftovers if they are newer than `number`: first the scene is kept in a copy of
/// its own, then the leftovers are removed.
Result<long> takenOver(const Autosave& autosave, const std::filesystem::path& file, long number) {
  const auto left = recoverableIn(autosave.file().parent_path());
  for (const Recoverable& found : left)
    if (const auto copy = recovered(found); copy.ok())
      number = std::max(number, versionOf(copy->scene));
  if (!left.empty())
    if (const Status kept = autosave.keep({.scene = version(number)}, {"work", file}); !kept.ok())
      return kept.error();
  for (const Recoverable& found : left)
    forget(found);
  return number;
}

int work(const std::filesystem::path& file, const std::filesystem::path& folder, int every,
         unsigned seed) {
  std::mt19937 random(seed);
  say("started", 0);
  const auto lock = FileLock::acquire(file);
  const auto autosave = Autosave::begin(folder);
  if (!lock.ok() || !autosave.ok())
    return failed(lock.ok() ? autosave.error() : lock.error());
  const Result<long> start = takenOver(*autosave, file, savedVersion(file));
  if (!start.ok())
    return failed(start.error());
  long number = *start;
  AutosaveClock clock{std::chrono::milliseconds(every)};
  for (;;) {
    const SceneDocument document{.scene = version(++number)};
    clock.changed(std::chrono::steady_clock::now());
    say("edited", number);
    if (random() % 8 == 0) {
      say("saving", number);
      if (const Status saved = writeSceneFile(*lock, document); !saved.ok())
        return failed(saved.error());
      say("saved", number);
      autosave->discard();
      clock.kept();
    }
    if (clock.due(std::chrono::steady_clock::now())) {
      say("keeping", number);
      if (const Status kept = autosave->keep(document, {"work", file}); !kept.ok())
        return failed(kept.error());
      say("kept", number);
      clock.kept();
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 2000));
  }
}
}  // namespace

int main(int argc, char** argv) {
  if (argc != 5)
    return EXIT_FAILURE;
  return work(argv[1], argv[2], int(std::strtol(argv[3], nullptr, 10)),
              unsigned(std::strtoul(argv[4], nullptr, 10)));
}
