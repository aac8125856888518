// SPDX-License-Identifier: Apache-2.0
// Finds in the beginning of a DICOM file whose it is: what keeps two patients apart. Like
// dicom_kind, this needs no reader of DICOM; unlike all else here it looks at a patient's data, of
// which nothing is to be shown or stored.
#pragma once

#include <string>
#include <string_view>

namespace sline::model {

/// Holds the values as the file has them, without padding; empty where it has none.
struct DicomIdentity {
  std::string patientId;
  std::string patientName;
  std::string study;             ///< Study Instance UID
  std::string frameOfReference;  ///< of the image, or the first that a structure set refers to
  bool complete = false;         ///< false: more of the file may say more
};

/// Reads the elements of `text`, the first bytes of a file: with explicit or implicit VR, little or
/// big endian, deflated or not. What it cannot follow ends the reading.
DicomIdentity dicomIdentity(std::string_view text);

}  // namespace sline::model
