// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/dicom/written_structures.h"

#include <cmath>
#include <numbers>

namespace sline::test {

namespace {

WrittenSet region(const WrittenRegion& written, int number) {
  WrittenSet item;
  if (written.colour)
    item.push_back(text({0x3006, 0x002a}, "IS",
                        QByteArray::number(written.colour->red) + "\\" +
                            QByteArray::number(written.colour->green) + "\\" +
                            QByteArray::number(written.colour->blue)));
  std::vector<WrittenSet> contours;
  for (const auto& contour : written.contours) {
    QByteArray data;
    for (const glm::dvec3& p : contour)
      data += (data.isEmpty() ? "" : "\\") + decimals(p);
    contours.push_back({text({0x3006, 0x0042}, "CS", written.geometry),
                        text({0x3006, 0x0046}, "IS", QByteArray::number(qsizetype(contour.size()))),
                        // A DS with more than 64 kB does not fit two bytes of length.
                        text({0x3006, 0x0050}, data.size() > 0xfffe ? "UT" : "DS", data)});
  }
  if (!contours.empty())
    item.push_back(sequence({0x3006, 0x0040}, std::move(contours)));
  item.push_back(text({0x3006, 0x0084}, "IS", QByteArray::number(number)));
  return item;
}

}  // namespace

WrittenSet structureSet(const std::vector<WrittenRegion>& regions) {
  const auto& id = identities();
  WrittenSet set = identifying("1.2.840.10008.5.1.4.1.1.481.3");
  set.push_back(text({0x3006, 0x0002}, "SH", id[18]));
  std::vector<WrittenSet> names;
  std::vector<WrittenSet> contours;
  std::vector<WrittenSet> observed;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const QByteArray number = QByteArray::number(qsizetype(i) + 1);
    names.push_back({text({0x3006, 0x0022}, "IS", number), text({0x3006, 0x0024}, "UI", id[17]),
                     text({0x3006, 0x0026}, "LO", regions[i].name),
                     text({0x3006, 0x0028}, "ST", id[19])});
    contours.push_back(region(regions[i], int(i) + 1));
    observed.push_back({text({0x3006, 0x0084}, "IS", number),
                        text({0x3006, 0x00a4}, "CS", regions[i].type),
                        text({0x3006, 0x00a6}, "PN", id[20])});
  }
  set.push_back(sequence({0x3006, 0x0020}, std::move(names)));
  set.push_back(sequence({0x3006, 0x0039}, std::move(contours)));
  set.push_back(sequence({0x3006, 0x0080}, std::move(observed)));
  return set;
}

std::vector<glm::dvec3> circle(const glm::dvec3& centre, double radius, int corners) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    points.push_back(centre + radius * glm::dvec3(std::cos(angle), std::sin(angle), 0.0));
  }
  return points;
}

std::vector<std::vector<glm::dvec3>> ball(const glm::dvec3& centre, double radius, double first,
                                          double step) {
  std::vector<std::vector<glm::dvec3>> contours;
  for (double z = first; z < centre.z + radius; z += step)
    if (std::abs(z - centre.z) < radius)
      contours.push_back(circle({centre.x, centre.y, z},
                                std::sqrt(radius * radius - (z - centre.z) * (z - centre.z))));
  return contours;
}

std::vector<std::vector<glm::dvec3>> rod(const glm::dvec3& centre, double radius,
                                         const std::vector<double>& heights) {
  std::vector<std::vector<glm::dvec3>> contours;
  for (const double height : heights)
    contours.push_back(circle({centre.x, centre.y, height}, radius));
  return contours;
}

}  // namespace sline::test
