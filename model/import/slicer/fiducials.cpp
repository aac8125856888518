// SPDX-License-Identifier: Apache-2.0
#include "model/import/slicer/fiducials.h"

#include "model/disk/whole_file.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/naming/names.h"
#include "model/import/slicer/fiducial_files.h"
#include "model/import/source/text_cursor.h"
#include "model/import/source/values.h"

namespace sline::model {

namespace {
constexpr std::string_view table = ".fcsv";
constexpr std::string_view markups = ".mrk.json";
}  // namespace

bool isFiducialFile(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return endsLike(name, table) || endsLike(name, markups);
}

std::string fiducialExtensions() {
  std::string list(table);
  list += " or ";
  return list += markups;
}

Result<Fiducials> readFiducials(const std::filesystem::path& file, const ReadLimits& limits) {
  const std::string text = TRY(readText(file, std::size_t(limits.fileBytes)));
  if (endsLike(file.filename().string(), table))
    return fiducialsInTable(text, file);
  std::string name = file.filename().string();
  name.resize(name.size() - std::min(name.size(), markups.size()));
  return fiducialsInMarkups(text, file, readableName(name));
}

Annotation annotationOf(const Fiducial& fiducial) {
  Annotation annotation{.kind = fiducial.kind,
                        .text = fiducial.text,
                        .colour = fiducial.colour,
                        .visible = fiducial.visible,
                        .locked = fiducial.locked};
  for (const glm::dvec3& place : fiducial.places) {
    const double turn = fiducial.frame == Frame::ras ? -1.0 : 1.0;
    annotation.anchors.emplace_back(
        glm::vec3(narrowed(turn * place.x), narrowed(turn * place.y), narrowed(place.z)));
  }
  return annotation;
}

}  // namespace sline::model
