// SPDX-License-Identifier: Apache-2.0
// Asks the operating system about this program. Support for other systems belongs here and in the
// other sources of this room.
#pragma once

#include <filesystem>

#include "model/base/result.h"

namespace sline::model {

/// Returns a number that no other process has while this one runs.
int processNumber();

/// Tells whether a process of that number runs here, whoever's it is.
bool isRunning(int process);

/// Returns the path of the running program's own file, or an empty path where the system does not
/// tell.
std::filesystem::path programFile();

/// Lowers the calling thread's share to about a third of that of other threads, so that a window
/// stays quick while it works.
void standBack();

/// Opens on /dev/null those standard streams that were closed: otherwise a file that is written
/// might get the number of standard output and receive what is printed. Printing there fails, as it
/// should.
void keepStandardStreams();

/// Tells whether standard error goes to a terminal.
bool errorsGoToTerminal();

/// Returns the function of that name in the library, which is loaded if necessary and stays loaded,
/// because the libraries it depends on do not unload well. Null where the library has no such
/// function; the error says why it cannot be loaded.
Result<void*> functionOf(const std::filesystem::path& library, const char* name);

/// Gives this process's free memory back to the system.
void giveMemoryBack();

}  // namespace sline::model
