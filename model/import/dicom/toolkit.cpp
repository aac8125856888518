// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/toolkit.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdicent.h>
#include <dcmtk/dcmdata/dcdict.h>
#include <dcmtk/dcmdata/dcobject.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <dcmtk/oflog/oflog.h>

#include "model/import/dicom/tag.h"

namespace sline::model {

namespace {

void addToDictionary(DcmDataDictionary& dictionary, Tag tag, DcmEVR kind) {
  // The dictionary takes the entry over.
  dictionary.addEntry(new DcmDictEntry(tag.group, tag.element, DcmVR(kind), "Known", 1, 1, "DICOM",
                                       OFFalse, nullptr));
}

bool setUp() {
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  // Sequences that a writer did not know (VR "UN") are read as the dictionary says.
  dcmEnableUnknownVRConversion.set(OFTrue);
  useOwnDictionary();
  DJDecoderRegistration::registerCodecs();
  DJLSDecoderRegistration::registerCodecs();
  return true;
}

}  // namespace

void useOwnDictionary() {
  DcmDataDictionary& dictionary = dcmDataDict.wrlock();
  dictionary.reloadDictionaries(OFFalse, OFFalse);
  for (const Tag tag : sequenceTags)
    addToDictionary(dictionary, tag, EVR_SQ);
  addToDictionary(dictionary, pixelData, EVR_px);
  dcmDataDict.wrunlock();
}

void setUpToolkit() {
  [[maybe_unused]] static const bool done = setUp();
}

}  // namespace sline::model
