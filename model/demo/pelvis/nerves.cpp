// SPDX-License-Identifier: Apache-2.0
#include "model/demo/pelvis/parts.h"

namespace sline::model {

namespace {
/// The lumbosacral trunk over the sacral ala and the roots out of the anterior sacral foramina
/// gather in front of the piriformis; below it the sciatic nerve leaves as a flat cord.
Shape sacralPlexus() {
  Shape roots = branching({Tube{{{31, -72, 992}, 2.2f},
                                {{34, -65, 976}, 2.2f},
                                {{38, -52, 955}, 2.2f},
                                {{43, -43, 934}, 2.3f},
                                {{49, -34, 916}, 2.6f},
                                {{54.5f, -26, 903}, 3}},
                           Tube{{{22, -46, 961}, 2.6f},
                                {{27, -46, 949}, 2.6f},
                                {{37, -41.5f, 932}, 2.7f},
                                {{46, -34, 916}, 2.8f},
                                {{54, -26, 903}, 3}},
                           Tube{{{19, -37, 942}, 2.3f},
                                {{27, -38.5f, 933}, 2.3f},
                                {{38, -36, 919}, 2.4f},
                                {{47, -31, 908}, 2.6f},
                                {{55, -24.5f, 900}, 3}},
                           Tube{{{15, -25.5f, 926}, 1.8f},
                                {{26, -25.8f, 916.5f}, 1.8f},
                                {{38, -27, 907}, 2},
                                {{49, -26, 901}, 2.4f}}},
                          3.5f);
  Shape sciatic = shapeOf(Band{{{51, -28, 907}, 4.5f, 2.6f, {0.6f, 0, 0.8f}},
                               {{58, -21, 898}, 5.2f, 3, {0.8f, 0, 0.6f}},
                               {{67, -21, 886}, 5.4f, 3, {1, 0.1f, 0.4f}},
                               {{76, -28, 870}, 5.4f, 3, {1, 0.2f, 0.2f}},
                               {{82, -34, 848}, 5.2f, 3, {1, 0.3f, 0.1f}},
                               {{85, -39, 826}, 5, 3, {1, 0.3f, 0}},
                               {{86.5f, -43, 806}, 5, 3, {1, 0.3f, 0}},
                               {{86.8f, -44, 794}, 5, 3, {1, 0.3f, 0}}});
  return cutOff(merged(std::move(roots), std::move(sciatic), 4.0f), {86.6f, -43.4f, 802},
                {0, 0.1f, -1});
}
/// The nerve runs in the groove between psoas and iliacus, under the inguinal ligament into the
/// thigh, where it divides into branches that end.
Shape femoralNerve() {
  return cutOff(branching({Tube{{{57, -80, 1020}, 1.8f},
                                {{60.5f, -84.5f, 1011}, 1.8f},
                                {{70, -92, 986}, 1.9f},
                                {{79, -104, 957}, 2.1f},
                                {{87, -117, 934}, 2.2f},
                                {{90, -130, 917}, 2.3f},
                                {{88, -141.5f, 901}, 2.4f},
                                {{83.5f, -148, 885}, 2.2f},
                                {{80, -150, 868}, 1.8f},
                                {{77.5f, -149, 848}, 1.4f},
                                {{75, -146.5f, 826}, 1},
                                {{73, -144.5f, 806}, 0.7f}},
                           Tube{{{87, -143.5f, 897}, 1.7f},
                                {{86.5f, -149.5f, 880}, 1.4f},
                                {{89, -152, 862}, 1.2f},
                                {{93, -151, 843}, 0.9f},
                                {{96, -149, 827}, 0.7f}},
                           Tube{{{84, -147.5f, 887}, 1.6f},
                                {{76.5f, -151, 871}, 1.3f},
                                {{69, -152, 853}, 1},
                                {{63, -151, 836}, 0.7f}}},
                          2.0f),
                {60, -84, 1012}, {-0.3f, 0.3f, 0.9f});
}
}  // namespace

std::vector<DemoStructure> pelvisNerves() {
  std::vector<DemoStructure> list;
  Palette thin = nervePalette;
  thin.edge = 1.1f;
  Palette thick = nervePalette;
  thick.edge = 1.6f;
  addPair(list, thick, "sciatic nerve", sacralPlexus());
  addPair(list, thin, "obturator nerve",
          shapeOf(Tube{{{37.5f, -78, 1012}, 1.3f},
                       {{40, -80, 990}, 1.4f},
                       {{46, -74, 968}, 1.4f},
                       {{51.5f, -72, 945}, 1.4f},
                       {{57, -78, 922}, 1.4f},
                       {{55.5f, -92, 904}, 1.4f},
                       {{49.5f, -106, 890}, 1.3f},
                       {{46, -116, 879}, 1.3f},
                       {{43, -123, 869}, 1.2f}}));
  addPair(list, thin, "femoral nerve", femoralNerve());
  addPair(list, thin, "pudendal nerve",
          shapeOf(Tube{{{25, -28, 915}, 1.2f},
                       {{35, -25, 905}, 1.3f},
                       {{44.5f, -24.5f, 897}, 1.3f},
                       {{48.5f, -27.5f, 888}, 1.3f},
                       {{49.2f, -34, 877}, 1.3f},
                       {{43, -48.5f, 860}, 1.2f},
                       {{35, -66.5f, 845}, 1.1f},
                       {{26, -87, 834}, 1.0f}}));
  return list;
}

}  // namespace sline::model
