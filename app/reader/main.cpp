// SPDX-License-Identifier: Apache-2.0
// The `sline-reader` program: reads one file for Sline and ends. Only Sline starts it
// (model/import/worker/reading_child.h); this file lists what it can read.
#include <array>
#include <cstdio>
#include <cstdlib>

#include "model/import/dicom/dicom.h"
#include "model/import/foreign/foreign.h"
#include "model/import/worker/child_main.h"

namespace {

using namespace sline::model;

constexpr std::array readers = {ChildReader{"DICOM", readDicomFiles},
                                ChildReader{"FBX", readingFirst<readFbx>},
                                ChildReader{"COLLADA", readingFirst<readCollada>},
                                ChildReader{"Blender", readingFirst<readBlend>},
                                ChildReader{"VTU", readingFirst<readVtu>},
                                ChildReader{"compressed glTF", readingFirst<readCompressedGltf>}};
}  // namespace

int main() {
  // DCMTK would read a dictionary of all elements at each start; the entries that are needed are
  // built in (dicom/toolkit.h).
  setenv("DCMDICTPATH", "/none", 1);
  const int status = runReadingChild(readers);
  if (status == 2)
    std::fputs("sline-reader is started by Sline, to read files in a process of its own.\n",
               stderr);
  return status;
}
