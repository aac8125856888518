// SPDX-License-Identifier: Apache-2.0
// The functions that the page's script calls (engine.js), on numbers and memory alone. There is one
// engine. What is returned as a place in memory stays until the next call.
#include <emscripten/emscripten.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/scene/known_frame.h"
#include "render/labels/orientation_letters.h"
#include "render/web/page_engine.h"

namespace sline::render::web {

namespace {

PageEngine* engine = nullptr;
std::string lastError;
std::vector<float> numbers;

bool succeeded(const Status& status) {
  lastError = status.ok() ? std::string() : status.error().text();
  return status.ok();
}

std::vector<model::NodeId> idsAt(const double* ids, int count) {
  std::vector<model::NodeId> all;
  for (int i = 0; i < count; ++i)
    all.push_back({std::uint64_t(ids[i])});
  return all;
}

void put(const glm::vec2& place) {
  numbers.push_back(place.x / PageEngine::millimetres);
  numbers.push_back(place.y / PageEngine::millimetres);
}

void put(const glm::vec3& v) {
  for (int axis = 0; axis < 3; ++axis)
    numbers.push_back(v[axis]);
}

const LabelItem* itemOf(model::AnnotationId id) {
  for (const LabelItem& item : engine->labelItems())
    if (item.id == id)
      return &item;
  return nullptr;
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE void slineOpen() {
  delete engine;
  engine = new PageEngine;
}

/// Returns the error of the last call that failed, in English, ended by a zero.
EMSCRIPTEN_KEEPALIVE const char* slineError() {
  return lastError.c_str();
}

EMSCRIPTEN_KEEPALIVE bool slineTake(const char* bytes, std::size_t size) {
  return succeeded(engine->take({bytes, size}));
}

EMSCRIPTEN_KEEPALIVE bool slineOpenPicture() {
  return succeeded(engine->openPicture());
}

EMSCRIPTEN_KEEPALIVE void slineOpenPlain() {
  engine->openPlainPicture();
}

EMSCRIPTEN_KEEPALIVE void slineSize(int width, int height, float ratio) {
  engine->setSize({width, height, ratio});
}

EMSCRIPTEN_KEEPALIVE void slineOrbit(float x, float y) {
  engine->orbit({x, y});
}

EMSCRIPTEN_KEEPALIVE void slinePan(float x, float y) {
  engine->pan({x, y});
}

EMSCRIPTEN_KEEPALIVE void slineRoll(float degrees) {
  engine->roll(degrees);
}

EMSCRIPTEN_KEEPALIVE void slineZoom(float factor, float x, float y) {
  engine->zoom(factor, {x, y});
}

EMSCRIPTEN_KEEPALIVE void slineFit(const double* ids, int count) {
  engine->fit(idsAt(ids, count));
}

/// Looks from a side, by its place in `model::anatomicalViewNames`.
EMSCRIPTEN_KEEPALIVE void slineLook(int side) {
  engine->look(model::AnatomicalView(std::clamp(side, 0, 5)));
}

/// Returns which side faces the reader, by its place in `model::anatomicalViewNames`; −1 where the
/// camera looks along no axis.
EMSCRIPTEN_KEEPALIVE int slineSide() {
  const auto side = model::anatomicalViewOf(engine->camera());
  return side ? int(*side) : -1;
}

/// Returns the letters of the sides at the left, right, upper and lower edge: "R,L,S,I".
EMSCRIPTEN_KEEPALIVE const char* slineEdges() {
  const EdgeLetters edges = edgeLetters(engine->camera(), knownSides(engine->shown()));
  static std::string letters;
  letters = edges.left + ',' + edges.right + ',' + edges.top + ',' + edges.bottom;
  return letters.c_str();
}

/// Returns twelve numbers: eye, target, up, the opening angle, the height of a parallel projection,
/// and 1 where it is one.
EMSCRIPTEN_KEEPALIVE const float* slineCamera() {
  const model::Camera& camera = engine->camera();
  numbers.clear();
  put(camera.eye);
  put(camera.target);
  put(camera.up);
  numbers.push_back(camera.fovyDegrees);
  numbers.push_back(camera.heightMm);
  numbers.push_back(camera.projection == model::Projection::orthographic ? 1.0f : 0.0f);
  return numbers.data();
}

EMSCRIPTEN_KEEPALIVE void slineSetCamera(const float* n) {
  engine->setCamera({.projection = n[11] > 0.5f ? model::Projection::orthographic
                                                : model::Projection::perspective,
                     .eye = {n[0], n[1], n[2]},
                     .target = {n[3], n[4], n[5]},
                     .up = {n[6], n[7], n[8]},
                     .fovyDegrees = n[9],
                     .heightMm = n[10]});
}

EMSCRIPTEN_KEEPALIVE void slineGoTo(int view, double share) {
  if (view >= 0)
    engine->goTo(std::size_t(view), share);
}

EMSCRIPTEN_KEEPALIVE void slineSetGamma(const double* ids, int count, float gamma) {
  engine->setGamma(idsAt(ids, count), gamma);
}

EMSCRIPTEN_KEEPALIVE float slineGamma(double id) {
  return engine->gamma({std::uint64_t(id)});
}

EMSCRIPTEN_KEEPALIVE void slineSetVisible(const double* ids, int count, bool visible) {
  engine->setVisible(idsAt(ids, count), visible);
}

EMSCRIPTEN_KEEPALIVE bool slineVisible(double id) {
  return engine->visible({std::uint64_t(id)});
}

EMSCRIPTEN_KEEPALIVE void slineResetLook() {
  engine->resetLook();
}

EMSCRIPTEN_KEEPALIVE void slineSelect(const double* ids, int count) {
  engine->select(idsAt(ids, count));
}

/// Takes three numbers for each label: its id, and the width and height of its text. `seen`: as
/// `PageEngine::setLabels`.
EMSCRIPTEN_KEEPALIVE void slineSetLabels(const double* rows, int count, bool seen) {
  std::vector<TextRoom> rooms;
  for (int i = 0; i < count; ++i, rows += 3)
    rooms.push_back({{std::uint64_t(rows[0])}, {float(rows[1]), float(rows[2])}});
  engine->setLabels(std::move(rooms), seen);
}

EMSCRIPTEN_KEEPALIVE float slineScale(bool moving) {
  return engine->scale(moving);
}

/// Draws; returns 1 for a complete picture, 0 for one that lacks something, −1 for an error.
EMSCRIPTEN_KEEPALIVE int slineDraw(bool moving) {
  const Result<bool> drawn = engine->draw(moving);
  if (!drawn.ok()) {
    lastError = drawn.error().text();
    return -1;
  }
  return *drawn ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE void slineTook(double milliseconds) {
  engine->took(milliseconds);
}

/// Returns where the plain picture's pixels are: `PageEngine::pixels`.
EMSCRIPTEN_KEEPALIVE const std::uint32_t* slinePixels() {
  return engine->pixels().data();
}

/// Returns the count of numbers, then three for each end of `PageEngine::segments`.
EMSCRIPTEN_KEEPALIVE const float* slineSegments() {
  numbers.assign(1, 0.0f);
  for (const glm::vec3& end : engine->segments())
    put(end);
  numbers[0] = float(numbers.size());
  return numbers.data();
}

/// Lays labels out. Returns the count of numbers, then for each label: its id, 1 where it is
/// hidden, the side (0 left, 1 right, 2 beside, 3 by hand), the box' corners, the counts of places
/// and of the leader's points, and these.
EMSCRIPTEN_KEEPALIVE const float* slineLabels(bool moving) {
  engine->layOutLabels(moving);
  numbers.assign(1, 0.0f);
  for (const PlacedLabel& label : engine->labels().labels) {
    const LabelItem* item = itemOf(label.id);
    if (!item)
      continue;
    numbers.push_back(float(label.id.value));
    numbers.push_back(label.hidden ? 1.0f : 0.0f);
    numbers.push_back(float(int(label.post)));
    put(label.box.low);
    put(label.box.high);
    numbers.push_back(float(item->places.size()));
    numbers.push_back(float(label.leader.size()));
    for (const glm::vec2& place : item->places)
      put(place);
    for (const glm::vec2& point : label.leader)
      put(point);
  }
  numbers[0] = float(numbers.size());
  return numbers.data();
}

/// Returns two numbers: the structure and the label at the place; 0: none.
EMSCRIPTEN_KEEPALIVE const double* slinePick(float x, float y) {
  static std::array<double, 2> picked{};
  const PageEngine::Pick pick = engine->pick({x, y});
  picked = {double(pick.structure.value), double(pick.label.value)};
  return picked.data();
}
}

}  // namespace sline::render::web
