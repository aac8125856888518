// SPDX-License-Identifier: Apache-2.0
#include "model/import/worker/child_main.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <string>

#include "model/import/worker/confinement.h"
#include "model/import/worker/exchange.h"

namespace sline::model {

namespace {

bool readAll(std::string& bytes) {
  struct stat status {};
  if (fstat(exchangeDescriptor, &status) != 0)
    return false;
  bytes.resize(std::size_t(status.st_size));
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count =
        pread(exchangeDescriptor, bytes.data() + done, bytes.size() - done, off_t(done));
    if (count <= 0)
      return false;
    done += std::size_t(count);
  }
  return true;
}

bool writeAll(std::string_view bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count =
        pwrite(exchangeDescriptor, bytes.data() + done, bytes.size() - done, off_t(done));
    if (count <= 0)
      return false;
    done += std::size_t(count);
  }
  return ftruncate(exchangeDescriptor, off_t(bytes.size())) == 0;
}

Result<RawMeshes> answerTo(const ReadRequest& request, std::span<const ChildReader> readers) {
  const auto reader = std::find_if(readers.begin(), readers.end(), [&](const ChildReader& one) {
    return one.kind == request.kind;
  });
  if (reader == readers.end())
    return Error{request.files.front().string(),
                 {},
                 "this build reads no " + request.kind + " files",
                 "Use another"};
  const ReadOptions options{.limits = request.limits,
                            .smoothing = request.smoothing,
                            .thresholds = request.thresholds,
                            .keepScans = request.keepScans};
  try {
    return reader->read(request.files, options);
  } catch (const std::exception& fault) {
    return Error{request.files.front().string(),
                 {},
                 "the reader of " + request.kind + " files gave up: " + fault.what(),
                 "Export the file again, or in another format"};
  }
}
}  // namespace

int runReadingChild(std::span<const ChildReader> readers) {
  std::string bytes;
  if (!readAll(bytes))
    return 2;
  const Result<ReadRequest> request = decodedRequest(bytes);
  if (!request || request->files.empty())
    return 2;
  // A child that ends without an answer has left the file empty.
  if (ftruncate(exchangeDescriptor, 0) != 0)
    return 1;
  confineThisProcess({request->limits.childBytes, request->limits.childSeconds});
  // Ending here keeps library code that runs at the end of a program from spoiling the answer; a
  // checker of leaks would find itself refused the system calls it needs.
  _exit(writeAll(encodedAnswer(answerTo(*request, readers))) ? 0 : 1);
}

}  // namespace sline::model
