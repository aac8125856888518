// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/volume_readers.h"

#include "model/import/readers/text_cursor.h"

namespace sline::model {

Result<LabelVolumes> readVolume(const std::filesystem::path& file, const ReadOptions& options) {
  std::filesystem::path name = file;
  if (equalsIgnoringCase(name.extension().string(), ".gz"))
    name.replace_extension();
  const std::string ending = name.extension().string();
  const auto is = [&ending](const char* known) { return equalsIgnoringCase(ending, known); };
  if (is(".nrrd") || is(".nhdr"))
    return readNrrd(file, options);
  if (is(".mha") || is(".mhd"))
    return readMetaImage(file, options);
  if (is(".mgh") || is(".mgz"))
    return readMgh(file, options);
  if (is(".mnc"))
    return readMinc(file, options);
  return readNifti(file, options);
}

}  // namespace sline::model
