// SPDX-License-Identifier: Apache-2.0
// What a program asks of the operating system about itself. Other systems get their answers here,
// and in the other sources of this room.
#pragma once

#include <filesystem>

#include "model/base/result.h"

namespace sline::model {

/// Returns a number that no other process has while this one runs.
int processNumber();

/// Returns where the running program's own file lies; empty where the system does not tell.
std::filesystem::path programFile();

/// Leaves the calling thread about a third of the share of threads that do not stand back, so that
/// a window stays quick while it works.
void standBack();

/// Opens on nothing what of the standard streams was closed: else a file that is written might get
/// the number of standard output and, within it, what is printed. Printing there fails, as it
/// should.
void keepStandardStreams();

/// Returns whether somebody reads standard error on a terminal.
bool errorsGoToTerminal();

/// Returns the function of that name in the library, which is loaded where it is not yet and stays:
/// libraries below it do not like to go. Null where the library has no such function; the error
/// says why it cannot be loaded.
Result<void*> functionOf(const std::filesystem::path& library, const char* name);

/// Gives memory that is free in this process back to the system.
void giveMemoryBack();

}  // namespace sline::model
