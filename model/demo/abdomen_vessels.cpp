// SPDX-License-Identifier: Apache-2.0
// Aorta, inferior vena cava and the portal system: trees of tubes, blended where they branch.
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

#include "model/demo/abdomen_parts.h"
#include "model/demo/swept.h"

namespace sline::model {

namespace {
constexpr Colour arteryColour{207, 34, 20};
constexpr Colour veinColour{44, 84, 166};
constexpr Colour portalColour{152, 132, 230};

using Course = std::vector<SweptPoint>;

DemoStructure vessel(std::string name, const char* group, Colour colour,
                     const std::vector<Course>& courses) {
  const auto tubes = std::make_shared<std::vector<Swept>>();
  Box box;
  float blend = 8.0f;
  for (const Course& course : courses) {
    tubes->emplace_back(course, glm::vec3(0.31f, -0.9f, 0.3f), 1.5f);
    box.add(tubes->back().bounds());
    for (const SweptPoint& p : course)
      blend = std::min(blend, 1.2f * p.radius);
  }
  const Field field = [tubes, blend](const glm::vec3& p) {
    float d = tubes->front().distance(p);
    for (std::size_t i = 1; i < tubes->size(); ++i)
      d = blendedUnion(d, (*tubes)[i].distance(p), blend);
    return d;
  };
  DemoStructure s{.name = std::move(name),
                  .groups = {group},
                  .colour = colour,
                  .gamma = Gamma::clamped(5.0f),
                  .field = field,
                  .box = grown(box, 3.0f)};
  s.edge = 1.4f;
  s.gap = 0.4f;
  return s;
}

DemoStructure artery(std::string name, const std::vector<Course>& courses) {
  return vessel(std::move(name), "Arteries", arteryColour, courses);
}

DemoStructure vein(std::string name, const std::vector<Course>& courses) {
  return vessel(std::move(name), "Veins", veinColour, courses);
}

DemoStructure portal(std::string name, const std::vector<Course>& courses) {
  return vessel(std::move(name), "Portal system", portalColour, courses);
}

DemoStructure coarser(DemoStructure s, float edge) {
  s.edge = edge;
  return s;
}
std::vector<DemoStructure> aortaAndCoeliacTrunk() {
  return {
      coarser(artery("abdominal aorta",
                     {{{{11, 8, 134}, 11.8f},
                       {{11, 5, 106}, 11.5f},
                       {{11, -1, 76}, 11.2f},
                       {{10, -7, 38}, 10.8f},
                       {{9, -12, 0}, 10.2f},
                       {{8, -15, -34}, 9.6f},
                       {{6, -17, -70}, 9.2f},
                       {{4, -16, -99}, 9.0f}},
                      {{{6, -17, -80}, 7.0f}, {{2, -16, -98}, 7.4f}, {{-6, -14, -112}, 6.4f}},
                      {{{6, -17, -80}, 7.0f}, {{7, -16, -98}, 7.4f}, {{14, -14, -112}, 6.4f}}}),
              2.1f),
      artery("coeliac trunk", {{{{10, -14, 20}, 3.6f}, {{9, -24, 21}, 3.6f}, {{8, -30, 22}, 3.4f}},
                               // left gastric
                               {{{8, -29, 22}, 2.0f},
                                {{10, -30, 40}, 1.9f},
                                {{14, -24, 62}, 1.8f},
                                {{23, -31, 62}, 1.6f},
                                {{25, -46, 44}, 1.4f}},
                               // splenic, winding along the pancreas
                               {{{8, -29, 22}, 2.8f},
                                {{20, -29, 25}, 2.7f},
                                {{32, -15, 20}, 2.7f},
                                {{44, -6, 30}, 2.6f},
                                {{56, 6, 24}, 2.6f},
                                {{68, 13, 34}, 2.5f},
                                {{82, 22, 36}, 2.3f},
                                {{92, 29, 44}, 2.0f}},
                               // common and proper hepatic
                               {{{8, -29, 22}, 2.6f},
                                {{-4, -32, 22}, 2.6f},
                                {{-16, -35, 19}, 2.5f},
                                {{-23, -33, 28}, 2.3f},
                                {{-25, -30, 42}, 2.0f}}})};
}

std::vector<DemoStructure> mesentericArteries() {
  return {artery("superior mesenteric artery", {{{{9, -16, 4}, 3.8f},
                                                 {{8, -29, 1}, 3.9f},
                                                 {{5, -37, -12}, 3.8f},
                                                 {{3, -42, -32}, 3.6f},
                                                 {{2, -55, -54}, 3.4f},
                                                 {{-1, -56, -80}, 3.0f},
                                                 {{-8, -46, -104}, 2.4f},
                                                 {{-22, -38, -124}, 1.8f}},
                                                {{{2, -55, -54}, 2.0f},
                                                 {{-14, -60, -62}, 2.0f},
                                                 {{-36, -58, -72}, 1.7f},
                                                 {{-60, -42, -80}, 1.4f}}}),
          artery("inferior mesenteric artery", {{{{8, -22, -62}, 2.4f},
                                                 {{11, -29, -74}, 2.4f},
                                                 {{22, -31, -98}, 2.2f},
                                                 {{30, -29, -130}, 2.0f},
                                                 {{28, -20, -160}, 1.7f}},
                                                {{{20, -31, -92}, 1.6f},
                                                 {{42, -28, -98}, 1.6f},
                                                 {{66, -18, -96}, 1.4f},
                                                 {{88, 0, -92}, 1.2f}}})};
}

std::vector<DemoStructure> renalArteries() {
  return {artery("right renal artery",
                 {{{{4, -8, -10}, 3.2f},
                   {{-8, 0, -12}, 3.2f},
                   {{-24, 6, -15}, 3.1f},
                   {{-38, 17, -15}, 3.0f},
                   {{-48, 25, -8}, 2.2f},
                   {{-58, 30, -1}, 1.5f}},
                  {{{-36, 15, -15}, 2.4f}, {{-46, 25, -20}, 2.1f}, {{-56, 30, -28}, 1.5f}}}),
          artery("left renal artery",
                 {{{{14, -9, -6}, 3.2f},
                   {{24, 0, -5}, 3.2f},
                   {{36, 13, -1}, 3.1f},
                   {{46, 22, 6}, 2.2f},
                   {{57, 27, 16}, 1.5f}},
                  {{{34, 11, -2}, 2.4f}, {{45, 22, -5}, 2.1f}, {{56, 28, -12}, 1.5f}}})};
}

std::vector<DemoStructure> iliacArteries() {
  std::vector<DemoStructure> arteries;
  for (const float side : {-1.0f, 1.0f}) {
    const auto at = [side](float x, float y, float z) { return glm::vec3(4.0f + side * x, y, z); };
    arteries.push_back(coarser(artery(side < 0 ? "right iliac arteries" : "left iliac arteries",
                                      {{{at(10.8f, -14, -113.5f), 6.2f},
                                        {at(21, -11, -130), 6.0f},
                                        {at(33, -8, -150), 5.8f},
                                        {at(43, -7, -172), 5.2f},
                                        {at(53, -14, -198), 5.0f},
                                        {at(62, -30, -230), 4.8f},
                                        {at(67, -40, -248), 4.8f}},
                                       {{at(33, -8, -150), 4.4f},
                                        {at(38, 6, -170), 4.2f},
                                        {at(38, 20, -190), 3.8f},
                                        {at(35, 30, -212), 3.2f},
                                        {at(34, 34, -240), 3.0f}}}),
                               1.7f));
  }
  return arteries;
}

std::vector<DemoStructure> cavaAndRenalVeins() {
  return {coarser(vein("inferior vena cava", {{{{-14, -10, 134}, 12.5f},
                                               {{-17, -8, 114}, 12.5f},
                                               {{-20, -6, 92}, 12.5f},
                                               {{-22, -6, 60}, 12.0f},
                                               {{-22, -9, 24}, 11.5f},
                                               {{-21, -12, -16}, 11.2f},
                                               {{-21, -14, -60}, 10.8f},
                                               {{-20, -12, -100}, 10.5f},
                                               {{-20, -8, -122}, 10.0f}}}),
                  2.2f),
          vein("right renal vein",
               {{{{-26, -11, -18}, 5.0f},
                 {{-36, -2, -22}, 4.8f},
                 {{-46, 10, -19}, 4.0f},
                 {{-56, 18, -9}, 2.4f}},
                {{{-40, 2, -22}, 3.4f}, {{-48, 14, -26}, 3.0f}, {{-57, 20, -34}, 2.0f}}}),
          vein("left renal vein",
               {{{{-14, -18, -12}, 4.6f},
                 {{0, -25.5f, -11}, 4.4f},
                 {{14, -26, -8}, 4.4f},
                 {{26, -14, -4}, 4.8f},
                 {{38, 2, 0}, 4.6f},
                 {{48, 15, 6}, 3.4f},
                 {{58, 20, 16}, 2.2f}},
                {{{36, 0, -1}, 3.2f}, {{47, 14, -5}, 3.0f}, {{57, 20, -14}, 2.0f}}})};
}

std::vector<DemoStructure> portalVeins() {
  return {portal("portal vein",
                 {{{{-10, -36, 2}, 6.4f},
                   {{-17, -29, 14}, 6.2f},
                   {{-26, -21, 28}, 6.2f},
                   {{-32, -19, 42}, 5.6f},
                   {{-46, -19, 50}, 4.4f},
                   {{-58, -18, 54}, 3.2f}},
                  {{{-31, -19, 41}, 4.4f}, {{-22, -22, 48}, 4.0f}, {{-8, -27, 54}, 3.0f}}}),
          portal("superior mesenteric vein", {{{{-9.5f, -37, 1}, 5.8f},
                                               {{-8, -40, -12}, 5.6f},
                                               {{-8, -43, -32}, 5.4f},
                                               {{-9, -56, -56}, 5.0f},
                                               {{-13, -57, -82}, 4.2f},
                                               {{-21, -46, -106}, 3.2f},
                                               {{-34, -36, -126}, 2.4f}}}),
          portal("splenic vein", {{{{-9, -34, 3}, 4.6f},
                                   {{6, -34, 8}, 4.5f},
                                   {{22, -22, 12}, 4.4f},
                                   {{42, 0, 16}, 4.2f},
                                   {{62, 14, 22}, 4.0f},
                                   {{80, 24, 31}, 3.6f},
                                   {{93, 31, 39}, 2.8f}}})};
}

std::vector<DemoStructure> iliacVeins() {
  std::vector<DemoStructure> veins;
  for (const float side : {-1.0f, 1.0f}) {
    const float start = side < 0 ? -22.0f : -14.0f;
    const auto at = [side](float x, float y, float z) { return glm::vec3(side * x, y, z); };
    const glm::vec3 second = side < 0 ? glm::vec3(-28, 2, -142) : glm::vec3(4, -3, -134);
    veins.push_back(coarser(
        vein(side < 0 ? "right iliac veins" : "left iliac veins", {{{{start, -8, -122}, 7.2f},
                                                                    {second, 7.0f},
                                                                    {at(30, 8, -158), 6.8f},
                                                                    {at(41, 10, -178), 6.2f},
                                                                    {at(50, 2, -202), 5.8f},
                                                                    {at(58, -17, -230), 5.4f},
                                                                    {at(63, -27, -248), 5.2f}},
                                                                   {{at(36, 11, -168), 5.0f},
                                                                    {at(38, 24, -188), 4.6f},
                                                                    {at(35, 37, -212), 3.8f},
                                                                    {at(34, 42, -240), 3.4f}}}),
        1.7f));
  }
  return veins;
}

std::vector<DemoStructure> joined(std::initializer_list<std::vector<DemoStructure>> parts) {
  std::vector<DemoStructure> all;
  for (const std::vector<DemoStructure>& part : parts)
    all.insert(all.end(), part.begin(), part.end());
  return all;
}
}  // namespace

std::vector<DemoStructure> abdomenArteries() {
  return joined({aortaAndCoeliacTrunk(), mesentericArteries(), renalArteries(), iliacArteries()});
}

std::vector<DemoStructure> abdomenVeins() {
  return joined({cavaAndRenalVeins(), portalVeins(), iliacVeins()});
}

}  // namespace sline::model
