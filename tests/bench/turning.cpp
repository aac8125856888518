// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/turning.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

#include "render/measures/ink_frames.h"
#include "render/measures/line_faults.h"
#include "render/measures/line_steadiness.h"
#include "render/measures/steadiness.h"
#include "render/measures/subject.h"

namespace sline::bench {

namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

/// Adds up steps.
struct Sum {
  double shares = 0.0;
  double flicker = 0.0;
  double worst = 0.0;
  int worstStep = 0;
  double longest = 0.0;
  double crawl = 0.0;
  double worstCrawl = 0.0;
  std::map<std::string, std::array<double, render::lineKindCount>> where;
  double drawn = 0.0;

  void add(const render::LinePops& pops, int step) {
    shares += pops.share();
    flicker += pops.flicker();
    if (pops.share() > worst) {
      worst = pops.share();
      worstStep = step;
    }
    longest = std::max(longest, pops.longest);
    crawl += pops.crawl();
    worstCrawl = std::max(worstCrawl, pops.crawl());
    drawn += pops.drawn;
    for (const auto& [name, lengths] : pops.where)
      for (std::size_t kind = 0; kind < lengths.size(); ++kind)
        where[name][kind] += lengths[kind];
  }

  std::string text(const char* title, int steps) const {
    std::string result = formatted(
        "%s: %.3f %% of the length pops at a step, at worst %.3f %% (step %d); flicker %.3f %%, "
        "longest %.1f λ; "
        "dashes %.2f %%, at worst %.2f %%\n",
        title, 100.0 * shares / steps, 100.0 * worst, worstStep, 100.0 * flicker / steps, longest,
        100.0 * crawl / steps, 100.0 * worstCrawl);
    std::vector<std::pair<std::string, std::array<double, render::lineKindCount>>> rows(
        where.begin(), where.end());
    const auto total = [](const auto& row) {
      return std::accumulate(row.second.begin(), row.second.end(), 0.0);
    };
    std::sort(rows.begin(), rows.end(),
              [&](const auto& a, const auto& b) { return total(a) > total(b); });
    rows.resize(std::min<std::size_t>(rows.size(), 12));
    for (const auto& [name, lengths] : rows)
      result += formatted("    %-34s suggestive %8.1f λ  contours %8.1f λ of %.0f\n", name.c_str(),
                          lengths[0], lengths[1], drawn);
    return result;
  }
};

struct Drawn {
  int strokes = 0;
  double length = 0.0;
};

Drawn drawnOf(const render::InkFrame& frame, render::LineKind kind) {
  Drawn drawn;
  for (const render::StructureInk& ink : frame.structures)
    for (const render::InkLine& line : ink.lines) {
      if (line.kind != kind)
        continue;
      double length = 0.0;
      for (std::size_t i = 1; i < line.points.size(); ++i)
        length += double(glm::distance(line.points[i].at, line.points[i - 1].at) / frame.unit());
      ++drawn.strokes;
      drawn.length += length;
    }
  return drawn;
}

}  // namespace

std::string measureTurning(const TurningRun& run) {
  render::InkFrames frames(run.scene, run.width, run.height);
  const glm::vec3 middle = run.scene.visibleBounds().centre();
  std::string text;
  for (const auto& [rules, title] :
       {std::pair(render::InkRules::picture, "pictures"), {render::InkRules::vectors, "vectors"}}) {
    Sum sum;
    std::optional<render::InkFrame> before;
    for (int i = 0; i <= run.steps; ++i) {
      render::InkFrame now =
          frames.at(render::turned(run.camera, middle, render::turnStep * float(i)), rules);
      if (before)
        sum.add(render::popsBetween(*before, now), i);
      before.emplace(std::move(now));
    }
    text += sum.text(title, run.steps);
  }
  return text;
}

std::string measureCurves(const TurningRun& run) {
  render::InkFrames frames(run.scene, run.width, run.height);
  const glm::vec3 middle = run.scene.visibleBounds().centre();
  render::CurveFaults all;
  std::map<std::string, double> narrowest;
  std::map<std::string, render::CurveFaults> each;
  for (int side = 0; side < 8; ++side)
    frames.forEachCurve(render::turned(run.camera, middle, 45.0f * float(side)),
                        [&](const std::string& name, const render::PictureView& view,
                            const render::LineSet& exact, const render::StructureLines& curves) {
                          render::addFaults(view, exact, curves.lines, all);
                          render::CurveFaults one;
                          render::addFaults(view, exact, curves.lines, one);
                          each[name].exactWidth += one.exactWidth;
                          each[name].drawnWidth += one.drawnWidth;
                        });
  std::string text;
  for (const render::LineKind kind : {render::LineKind::contour, render::LineKind::suggestive}) {
    const std::vector<float>& d = all.distances[std::size_t(kind)];
    text += formatted("%s: %zu points, median %.3f λ, p99.9 %.3f λ, max %.3f λ\n",
                      kind == render::LineKind::contour ? "contours" : "suggestive contours",
                      d.size(), double(render::percentile(d, 0.5)),
                      double(render::percentile(d, 0.999)), double(render::percentile(d, 1.0)));
  }
  text += formatted("thin outlines: narrower by %.2f %% in all\n", 100.0 * all.narrowing());
  for (const auto& [name, faults] : each)
    if (faults.exactWidth > 500.0 && faults.narrowing() > 0.01)
      text += formatted("    %-34s %.2f %% of %.0f λ\n", name.c_str(), 100.0 * faults.narrowing(),
                        faults.exactWidth);
  return text;
}

std::string measureScales(const TurningRun& run, const std::vector<model::NodeId>& structures) {
  const float aspect = float(run.width) / float(run.height);
  std::string text = formatted("%-34s %27s %27s\n", "suggestive strokes and their length",
                               "it fills the picture", "as large as in the scene");
  for (const model::NodeId id : structures) {
    const model::Scene alone = render::isolated(run.scene, id);
    const model::Mesh& mesh = *alone.nodes().front().mesh;
    const model::Camera near = model::fitted(
        model::anatomicalCamera(model::AnatomicalView::anterior, mesh.bounds(), aspect),
        mesh.positions(), aspect);
    text += formatted("%-34s", alone.nodes().front().name.c_str());
    for (const model::Camera& camera : {near, run.camera}) {
      std::array<Drawn, 2> drawn;
      for (const bool scaled : {false, true}) {
        std::vector<model::Node> nodes = alone.nodes();
        nodes.front().style.gamma = Gamma::clamped(2.0f);
        nodes.front().style.lineScale = scaled ? 1.0f : 0.0f;
        model::Scene scene = alone;
        scene.setNodes(std::move(nodes));
        drawn[scaled] = drawnOf(
            render::InkFrames(scene, run.width, run.height).at(camera, render::InkRules::vectors),
            render::LineKind::suggestive);
      }
      text += formatted(" %3d → %3d, %6.0f → %5.0f λ;", drawn[0].strokes, drawn[1].strokes,
                        drawn[0].length, drawn[1].length);
    }
    text += '\n';
  }
  return text;
}

}  // namespace sline::bench
