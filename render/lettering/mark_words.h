// SPDX-License-Identifier: Apache-2.0
// What marks say, in the language of the picture rather than that of the program: English, German,
// Dutch, Norwegian and Latin.
#pragma once

#include <QLocale>
#include <QString>

#include "model/scene/camera.h"
#include "model/scene/section.h"

namespace sline::render {

struct MarkTable;

class MarkWords {
 public:
  /// A BCP 47 tag; English for languages that are not known.
  explicit MarkWords(const std::string& language);

  /// "Anterior view"; a name that is none of the six sides' as it is. Of a side that the camera
  /// does not see most of: the side that it sees, or nothing where it looks along no axis.
  QString view(const std::string& name, const model::Camera& camera) const;
  /// "Coronal section at A 12.0 mm, posterior part kept".
  QString section(const model::Plane& plane) const;
  /// "5 sections"; for more than one.
  QString sections(std::size_t count) const;
  /// "5 cm at mid-depth", of a length that is true there alone.
  QString atMidDepth(const QString& length) const;
  const QLocale& locale() const { return m_locale; }

 private:
  const MarkTable& m_table;
  QLocale m_locale;
};

}  // namespace sline::render
