// SPDX-License-Identifier: Apache-2.0
#include "model/import/worker/reading_child.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>

#include "model/disk/memory_budget.h"
#include "model/disk/process.h"
#include "model/import/worker/child_main.h"
#include "model/import/worker/confinement.h"

namespace sline::model {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int pollIntervalMs = 20;
/// A child that waits, for a disc that hangs or for itself, uses no computing time.
constexpr std::uint64_t waitingFactor = 6;

/// A descriptor that closes with its owner.
class Descriptor {
 public:
  explicit Descriptor(int number) : m_number(number) {}
  ~Descriptor() {
    if (m_number >= 0)
      close(m_number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return m_number; }

 private:
  int m_number;
};

/// Ends and reaps the child, however the scope is left.
class Child {
 public:
  explicit Child(pid_t id) : m_id(id), m_handle(int(syscall(SYS_pidfd_open, id, 0))) {}
  ~Child() {
    if (!m_ended) {
      kill(m_id, SIGKILL);
      while (waitpid(m_id, &m_status, 0) < 0 && errno == EINTR) {
      }
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Waits a moment; returns true once the child has ended.
  bool hasEnded() {
    pollfd handle{m_handle.number(), POLLIN, 0};
    // Without a handle (kernels before 5.3) this just waits.
    poll(&handle, 1, pollIntervalMs);
    if (!m_ended && waitpid(m_id, &m_status, WNOHANG) == m_id)
      m_ended = true;
    return m_ended;
  }
  int status() const { return m_status; }

 private:
  pid_t m_id;
  Descriptor m_handle;
  int m_status = 0;
  bool m_ended = false;
};

Error faultOfMachine(const std::string& deed) {
  return {{}, {}, deed + ": " + std::strerror(errno), "Close other programs and try again"};
}

std::optional<pid_t> startChild(const std::filesystem::path& program, int exchange) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  // Libraries print messages; the important ones come with the answer.
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, exchange, exchangeDescriptor);
  posix_spawn_file_actions_addclosefrom_np(&actions, exchangeDescriptor + 1);
  std::string name = program.string();
  char* arguments[] = {name.data(), nullptr};
  pid_t id = 0;
  const int fault = posix_spawn(&id, name.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (fault == 0)
    return id;
  errno = fault;
  return std::nullopt;
}

/// Returns the limits with the usual values in place of their stand-ins.
ReadLimits withUsualLimits(ReadLimits limits, std::span<const std::filesystem::path> files) {
  if (limits.childBytes == 0)
    limits.childBytes =
        std::uint64_t(sysconf(_SC_PHYS_PAGES)) * std::uint64_t(sysconf(_SC_PAGESIZE)) / 2;
  std::uintmax_t size = 0;
  for (const std::filesystem::path& file : files) {
    std::error_code code;
    const std::uintmax_t own = std::filesystem::file_size(file, code);
    size += code ? 0 : own;
  }
  if (limits.childSeconds == 0)
    limits.childSeconds = 60 + size / 1'000'000;
  return limits;
}

Error readerError(const std::string& reason) {
  return {{}, {}, reason, "It may be damaged: export it again, or in another format"};
}

/// Returns why there is no answer.
Error faultOf(int status, std::string_view kind, const ReadLimits& limits) {
  const std::string reader = "the reader of " + std::string(kind) + " files ";
  if (WIFEXITED(status) && WEXITSTATUS(status) == outOfMemoryStatus)
    return readerError(reader + "wanted more than " + gigabytes(limits.childBytes) +
                       " of memory for this file");
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    return readerError(reader + "did not come to an end within " +
                       std::to_string(limits.childSeconds) + " s of computing");
  if (WIFSIGNALED(status))
    return readerError(reader + "crashed over this file (" + strsignal(WTERMSIG(status)) + ")");
  return readerError(reader + "gave no answer for this file");
}

Result<RawMeshes> answerIn(int exchange) {
  struct stat status {};
  if (fstat(exchange, &status) != 0)
    return faultOfMachine("its answer could not be read");
  const auto size = std::size_t(status.st_size);
  if (size == 0)
    return readerError("the program that reads it gave no answer");
  void* bytes = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, exchange, 0);
  if (bytes == MAP_FAILED)
    return faultOfMachine("its answer could not be read");
  Result<RawMeshes> answer = decodedAnswer({static_cast<const char*>(bytes), size});
  munmap(bytes, size);
  return answer;
}

/// Returns the answer of the child, without the file's name in errors.
Result<RawMeshes> askChild(const std::filesystem::path& program, const ReadRequest& request,
                           const std::function<bool()>& goesOn) {
  const Descriptor exchange(memfd_create("sline-reader", MFD_CLOEXEC));
  const std::string bytes = encodedRequest(request);
  if (exchange.number() < 0 ||
      write(exchange.number(), bytes.data(), bytes.size()) != ssize_t(bytes.size()))
    return faultOfMachine("there is no memory to read it");
  const std::optional<pid_t> id = startChild(program, exchange.number());
  if (!id)
    return faultOfMachine(program.string() + " could not be started");
  Child child(*id);
  const auto latest =
      Clock::now() + std::chrono::seconds(waitingFactor * request.limits.childSeconds);
  while (!child.hasEnded()) {
    if (!goesOn())
      return Error{{}, {}, "reading was given up", {}};
    if (Clock::now() > latest)
      return readerError("the reader of " + request.kind + " files did not come to an end within " +
                         std::to_string(waitingFactor * request.limits.childSeconds) + " s");
  }
  if (!WIFEXITED(child.status()) || WEXITSTATUS(child.status()) != 0)
    return faultOf(child.status(), request.kind, request.limits);
  return answerIn(exchange.number());
}
}  // namespace

std::filesystem::path readerProgram() {
  if (const char* named = std::getenv("SLINE_READER"); named && *named)
    return named;
  std::error_code code;
  const std::filesystem::path here = programFile().parent_path();
  for (const char* place : {"sline-reader", "../lib/sline/sline-reader"})
    if (std::filesystem::is_regular_file(here / place, code))
      return here / place;
  return {};
}

Result<RawMeshes> readInChild(std::string_view kind, std::span<const std::filesystem::path> files,
                              const ReadOptions& options) {
  const std::filesystem::path program = readerProgram();
  if (program.empty())
    return Error{files.front().string(),
                 {},
                 std::string(kind) + " files are read by sline-reader, which is not beside Sline",
                 "Install Sline again"};
  Result<RawMeshes> answer = askChild(program,
                                      {std::string(kind),
                                       {files.begin(), files.end()},
                                       withUsualLimits(options.limits, files),
                                       options.smoothing,
                                       options.thresholds,
                                       options.keepScans},
                                      options.goesOn);
  if (answer)
    return answer;
  Error error = answer.error();
  error.file = files.front().string();
  return error;
}

}  // namespace sline::model
