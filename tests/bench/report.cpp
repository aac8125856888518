// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/report.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace sline::bench {

namespace {
using Json = nlohmann::ordered_json;

Json json(const Spread& spread) {
  return {{"median", spread.median}, {"p95", spread.p95}};
}

void line(std::ostream& out, const std::string& name, const Spread& spread) {
  out << std::left << std::setw(22) << name << std::right << std::setw(10) << spread.median
      << std::setw(10) << spread.p95 << '\n';
}
}  // namespace

double Report::bytesPerTriangle() const {
  return triangles == 0 ? 0.0 : (restRssMiB - baseRssMiB) * 1024.0 * 1024.0 / double(triangles);
}

double Report::peakRatio() const {
  const double held = restRssMiB - baseRssMiB;
  return held > 0.0 ? (peakRssMiB - baseRssMiB) / held : 0.0;
}

double Report::frameRatio() const {
  const double yardstick = std::min(phong.median, vtkPhong.median);
  return yardstick > 0.0 ? frame.median / yardstick : 0.0;
}

double Report::vectorsRatio() const {
  return frame.median > 0.0 ? vectorsMs / frame.median : 0.0;
}

std::string asJson(const Report& r) {
  Json passes = Json::object();
  for (const auto& [name, spread] : r.passes)
    passes[name] = json(spread);
  const Json all{{"triangles", r.triangles},
                 {"structures", r.structures},
                 {"import_ms", r.importMs},
                 {"preprocess_ms", r.preprocessMs},
                 {"bytes_per_triangle", r.bytesPerTriangle()},
                 {"peak_ratio", r.peakRatio()},
                 {"frame_ms", json(r.frame)},
                 {"moving_ms", json(r.moving)},
                 {"lines_ms", json(r.lines)},
                 {"passes_ms", passes},
                 {"phong_ms", json(r.phong)},
                 {"vtk_phong_ms", json(r.vtkPhong)},
                 {"vectors_ms", r.vectorsMs},
                 {"gamma_ratio", r.gammaRatio},
                 {"reopen_ms", r.reopenMs},
                 {"driver", r.driver}};
  return all.dump(2) + "\n";
}

std::string asText(const Report& r) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(1);
  out << r.structures << " structures, " << r.triangles << " triangles, " << r.driver << '\n'
      << "import " << r.importMs << " ms, preprocessing " << r.preprocessMs << " ms\n"
      << "memory " << r.baseRssMiB << " MiB before, " << r.restRssMiB << " after, " << r.peakRssMiB
      << " at most: " << r.bytesPerTriangle() << " bytes per triangle, " << r.peakRatio()
      << " times that at most\n\n"
      << "milliseconds              median       p95\n";
  line(out, "frame", r.frame);
  line(out, "  lines", r.lines);
  for (const auto& [name, spread] : r.passes)
    line(out, "  " + name, spread);
  line(out, "moving", r.moving);
  line(out, "plain Phong", r.phong);
  line(out, "VTK's Phong", r.vtkPhong);
  out << "vector drawing " << r.vectorsMs << " ms, reopening " << r.reopenMs << " ms\n";
  out << std::setprecision(2) << "frame / smaller yardstick " << r.frameRatio()
      << ", vector drawing / frame " << r.vectorsRatio() << ", step of Γ / frame " << r.gammaRatio
      << '\n';
  return out.str();
}

}  // namespace sline::bench
