// SPDX-License-Identifier: Apache-2.0
// Words the marks in the language of the picture rather than that of the program: English, German,
// Dutch, Norwegian and Latin.
#pragma once

#include <QLocale>
#include <QString>

#include "model/camera/camera.h"
#include "model/scene/gamma_map.h"
#include "model/scene/known_frame.h"
#include "model/scene/section.h"

namespace sline::render {

struct MarkTable;

class MarkWords {
 public:
  /// Takes a BCP 47 tag; unknown languages become English. What is said of sides that are in
  /// doubt has a question mark.
  MarkWords(const std::string& language, const model::KnownSides& sides);

  /// Returns "Anterior view"; a name other than the six sides' is returned unchanged. If the camera
  /// does not see mostly the named side, the side that it does see is returned, or nothing where it
  /// looks along no axis.
  QString view(const std::string& name, const model::Camera& camera) const;
  /// Returns "Coronal section at A 12.0 mm, posterior part kept"; of what has no sides, as
  /// molecules, "Section at z = 65.8 Å, smaller z kept".
  QString section(const model::Plane& plane, model::DrawnUnit unit) const;
  /// Returns "5 sections", for more than one.
  QString sections(std::size_t count) const;
  /// Returns "5 cm at mid-depth", for a length that is true only there.
  QString atMidDepth(const QString& length) const;
  /// Returns "5 cm at the cut face", for a length that is true only there.
  QString atCutFace(const QString& length) const;
  /// Returns "touching", for two surfaces without a way between them.
  QString touching() const;
  /// Returns what Γ follows, with its unit; of a distance with "%1" for what it is from.
  QString gammaScalar(model::GammaScalar scalar, model::DrawnUnit unit) const;
  /// Returns "a place", of which there is no name.
  QString somePlace() const;
  const QLocale& locale() const { return m_locale; }

 private:
  QString doubted(const QString& text, int axis) const;

  const MarkTable& m_table;
  model::KnownSides m_sides;
  QLocale m_locale;
};

}  // namespace sline::render
