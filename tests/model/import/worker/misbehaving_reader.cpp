// SPDX-License-Identifier: Apache-2.0
// Stands in for sline-reader (environment SLINE_READER) and does on purpose what libraries do by
// mistake: the file's first word says what.
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "model/import/worker/child_main.h"

namespace sline::test {

namespace {

using Answer = Result<model::RawMeshes>;

Error said(const std::string& reason) {
  return {{}, {}, reason, {}};
}

Answer tetrahedron(bool outOfRange) {
  model::RawMesh mesh;
  mesh.name = "made";
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, outOfRange ? 4u : 3u}};
  mesh.colour = Colour{200, 30, 40};
  mesh.opacity = Opacity::clamped(0.5f);
  mesh.frame = model::Frame::ras;
  mesh.groups = {"Bones", "Left"};
  mesh.visible = false;
  return model::RawMeshes{{mesh}, {{"made.dcm", "a warning"}}};
}

/// Ends as a reader that does not check does, whatever its compiler makes of that.
Answer crash() {
  raise(SIGSEGV);
  return said("still there");
}

Answer loopForever() {
  static std::atomic<unsigned> turns = 0;
  for (;;)
    ++turns;
}

/// Loops with the limit already lowered to one second.
Answer loopForSecond() {
  const rlimit soon{1, 2};
  setrlimit(RLIMIT_CPU, &soon);
  return loopForever();
}

Answer waitForever() {
  for (;;)
    std::this_thread::sleep_for(std::chrono::hours(1));
}

/// Takes memory and uses it, as long as there is some.
Answer eat() {
  std::vector<std::unique_ptr<char[]>> taken;
  for (;;) {
    constexpr std::size_t size = std::size_t(64) << 20;
    taken.push_back(std::make_unique<char[]>(size));
    std::memset(taken.back().get(), 1, size);
  }
}

/// Eats memory with the limit already lowered.
Answer eatLittle() {
  const rlimit low{300'000'000, 300'000'000};
  setrlimit(RLIMIT_DATA, &low);
  return eat();
}

/// Tries a socket and another program; without a sandbox, one of them gets through.
Answer breakOut() {
  if (socket(AF_INET, SOCK_STREAM, 0) >= 0)
    return said("it has a socket");
  if (errno != EPERM)
    return said("sockets fail for another reason");
  char name[] = "/bin/true";
  char* arguments[] = {name, nullptr};
  execv(name, arguments);
  return said(errno == EPERM ? "kept in" : "programs fail for another reason");
}

/// Exits normally, but with bytes that no reader answers.
Answer lie() {
  const std::string bytes(1000, '\xff');
  _exit(pwrite(model::exchangeDescriptor, bytes.data(), bytes.size(), 0) > 0 ? 0 : 1);
}

Answer leaveSilently() {
  _exit(0);
}

Answer misbehave(std::span<const std::filesystem::path> files, const model::ReadOptions&) {
  std::string deed;
  std::ifstream(files.front()) >> deed;
  static const std::map<std::string, Answer (*)()> deeds = {
      {"crash", crash},
      {"loop", loopForever},
      {"loop1", loopForSecond},
      {"wait", waitForever},
      {"eat", eat},
      {"eat300", eatLittle},
      {"breakOut", breakOut},
      {"lie", lie},
      {"leave", leaveSilently},
      {"throw", []() -> Answer { throw std::runtime_error("thrown on purpose"); }},
      {"refuse",
       [] {
         return Answer(Error{"a.dcm", "line 3", "is refused", "Leave it"});
       }},
      {"mesh", [] { return tetrahedron(false); }},
      {"outOfRange", [] { return tetrahedron(true); }}};
  const auto found = deeds.find(deed);
  return found == deeds.end() ? said("no such deed") : found->second();
}
}  // namespace
}  // namespace sline::test

int main() {
  static constexpr std::array readers = {
      sline::model::ChildReader{"DICOM", sline::test::misbehave}};
  return sline::model::runReadingChild(readers);
}
