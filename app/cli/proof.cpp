// SPDX-License-Identifier: Apache-2.0
// Implements `sline proof`: tells what of a picture would be lost in print, and what would help.
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "app/cli/commands/command.h"
#include "app/cli/draw_scene.h"
#include "app/cli/files/json_values.h"
#include "app/cli/files/targets.h"
#include "app/cli/files/thumbnail.h"
#include "app/cli/flags/option_kinds.h"
#include "app/cli/flags/picture_options.h"
#include "model/base/colour_text.h"
#include "model/edit/look.h"
#include "model/edit/views.h"
#include "model/look/drawing_styles.h"
#include "model/scene_file/scene_file.h"
#include "render/export/pixels/image_file.h"
#include "render/measures/proof/plate_proof.h"
#include "render/measures/proof/print_proof.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::cli {

namespace {

struct ProofFlags {
  InputFlags input;
  PictureFlags picture;
  bool json = false;
  bool all = false;
  double threshold = 10.0;
  std::string folder;
  bool apply = false;
  std::string output;
};

std::string nameOf(const model::Scene& scene, model::NodeId id) {
  const model::Node* node = scene.find(id);
  std::string name = node ? node->name : std::string();
  // Names come from files, so characters that would move the terminal's cursor are replaced.
  std::replace_if(
      name.begin(), name.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, ' ');
  return name;
}

std::string rounded(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << value;
  return text.str();
}

render::ExportOrder exportOrder(const ArrangedScene& arranged, const PictureSpec& spec) {
  constexpr float pixelMm = render::millimetresPerInch / 96.0f;
  render::ExportOrder job;
  job.scene = arranged.scene;
  job.camera = arranged.camera;
  job.page = {.sizeMm = pixelMm * glm::vec2(float(spec.size.width), float(spec.size.height)),
              .dpi = 96.0f};
  job.environment = spec.environment;
  return job;
}

Json pairJson(const model::Scene& scene, const render::ProofPair& pair,
              const render::ProofSettings& settings) {
  Json json{{"a", nameOf(scene, pair.a)},
            {"b", nameOf(scene, pair.b)},
            {"border", jsonNumber(float(pair.border))},
            {"similar_gamma", pair.similarGamma}};
  json["difference"] = Json::object();
  json["alike"] = Json::array();
  for (const render::Vision vision : render::visions) {
    json["difference"][render::nameOf(vision)] =
        jsonNumber(float(pair.difference[std::size_t(vision)]));
    if (pair.alike(vision, settings))
      json["alike"].push_back(render::nameOf(vision));
  }
  return json;
}

Json pairsJson(const model::Scene& scene, const std::vector<render::ProofPair>& pairs,
               const render::ProofSettings& settings) {
  Json json = Json::array();
  for (const render::ProofPair& pair : pairs)
    json.push_back(pairJson(scene, pair, settings));
  return json;
}

/// Holds what was measured of a picture.
struct Proofs {
  render::PrintProof print;
  std::vector<model::NodeId> subject;
  render::PlateProof plate;
};

Json plateJson(const model::Scene& scene, const Proofs& proofs) {
  Json json{{"subject_seen", jsonNumber(float(proofs.plate.subjectSeen))},
            {"ink", jsonNumber(float(proofs.plate.ink))},
            {"coloured", jsonNumber(float(proofs.plate.coloured))},
            {"holds", proofs.plate.holds()}};
  json["subject"] = Json::array();
  for (const model::NodeId id : proofs.subject)
    json["subject"].push_back(nameOf(scene, id));
  return json;
}

void printJson(const model::Scene& scene, const Proofs& proofs,
               const render::ProofSettings& settings) {
  const render::PrintProof& proof = proofs.print;
  Json root{{"least_difference", settings.leastDifference},
            {"least_gamma_step", jsonNumber(settings.leastGammaStep)}};
  root["neighbours"] = pairsJson(scene, proof.neighbours, settings);
  root["proposals"] = Json::array();
  for (const render::ProofProposal& proposal : proof.proposals) {
    Json json{{"structure", nameOf(scene, proposal.node)}};
    if (proposal.colour)
      json["colour"] = colourText(*proposal.colour);
    if (proposal.gamma)
      json["gamma"] = jsonNumber(proposal.gamma->value());
    root["proposals"].push_back(std::move(json));
  }
  root["afterwards"] = pairsJson(scene, proof.afterwards, settings);
  root["plate"] = plateJson(scene, proofs);
  std::cout << jsonText(root, 2) << '\n';
}

/// Returns "grey 3.1, deuteranopia 6.2": where they look alike, and how far apart they are there.
std::string whereAlike(const render::ProofPair& pair, const render::ProofSettings& settings) {
  std::string text;
  for (const render::Vision vision : render::visions)
    if (pair.alike(vision, settings))
      text += (text.empty() ? "" : ", ") + std::string(render::nameOf(vision)) + ' ' +
              rounded(pair.difference[std::size_t(vision)]);
  return text;
}

/// Prints the pairs that are lost in print, or those that look alike on the screen, too.
std::size_t printPairs(const model::Scene& scene, const std::vector<render::ProofPair>& pairs,
                       const render::ProofSettings& settings, bool onScreen) {
  std::size_t count = 0;
  for (const render::ProofPair& pair : pairs) {
    if (!pair.alikeAnywhere(settings) || pair.alikeOnScreen(settings) != onScreen)
      continue;
    ++count;
    std::cout << "  " << nameOf(scene, pair.a) << " | " << nameOf(scene, pair.b) << ": "
              << whereAlike(pair, settings);
    if (!onScreen)
      std::cout << " (on the screen " << rounded(pair.difference.front()) << ')';
    std::cout << '\n';
  }
  return count;
}

void printProposals(const model::Scene& scene, const render::PrintProof& proof,
                    const render::ProofSettings& settings) {
  if (!proof.proposals.empty())
    std::cout << "What would help, measured in the picture:\n";
  for (const render::ProofProposal& proposal : proof.proposals) {
    std::cout << "  " << nameOf(scene, proposal.node) << ": ";
    if (proposal.colour)
      std::cout << "colour " << colourText(*proposal.colour);
    if (proposal.gamma)
      std::cout << (proposal.colour ? ", " : "") << "gamma " << rounded(proposal.gamma->value());
    std::cout << '\n';
  }
  const auto left = std::count_if(
      proof.afterwards.begin(), proof.afterwards.end(), [&](const render::ProofPair& pair) {
        return pair.alikeAnywhere(settings) && (settings.all || !pair.alikeOnScreen(settings));
      });
  if (left > 0)
    std::cout << "No change was found for " << left << (left == 1 ? " pair" : " pairs") << '\n';
}

std::string percent(double share) {
  return rounded(100.0 * share) + " %";
}

void printPlate(const Proofs& proofs) {
  const std::size_t count = proofs.subject.size();
  std::cout << "As a plate of " << count << (count == 1 ? " structure" : " structures")
            << " drawn in detail: " << percent(proofs.plate.subjectSeen)
            << " of their silhouette is seen (at least " << percent(render::leastSubjectSeen)
            << "), " << percent(proofs.plate.ink) << " of the sheet is ink (at most "
            << percent(render::mostInk) << "), " << percent(proofs.plate.coloured)
            << " has colour (at least " << percent(render::leastColoured) << ")\n";
}

void printText(const model::Scene& scene, const Proofs& proofs,
               const render::ProofSettings& settings) {
  const render::PrintProof& proof = proofs.print;
  std::cout << proof.neighbours.size()
            << " pairs of neighbours; told apart are those whose colours "
            << "differ by " << rounded(settings.leastDifference)
            << " (CIEDE2000), or their gamma by " << rounded(settings.leastGammaStep) << '\n';
  const auto screen =
      std::count_if(proof.neighbours.begin(), proof.neighbours.end(),
                    [&](const render::ProofPair& pair) { return pair.alikeOnScreen(settings); });
  std::cout << "Not told apart in print or by all eyes:\n";
  if (printPairs(scene, proof.neighbours, settings, false) == 0)
    std::cout << "  none\n";
  if (screen > 0 && settings.all) {
    std::cout << "Alike on the screen, too:\n";
    printPairs(scene, proof.neighbours, settings, true);
  } else if (screen > 0) {
    std::cout << screen << (screen == 1 ? " pair looks" : " pairs look")
              << " alike on the screen, too, which may be meant; --all lists and mends these\n";
  }
  printProposals(scene, proof, settings);
  printPlate(proofs);
}

/// Proves the order's picture for print and as a plate of what it draws in detail.
Result<Proofs> proofsOf(const render::ExportOrder& job, const PictureSpec& spec,
                        const render::ProofSettings& settings, Progress& progress) {
  Result<render::PrintProof> print =
      render::printProof(job, settings, [&progress](double share, std::string_view what) {
        progress.show(share, what);
        return true;
      });
  progress.wipe();
  if (!print.ok())
    return print.error();
  Proofs proofs{.print = std::move(*print), .subject = model::emphasisedIn(job.scene), .plate = {}};
  proofs.plate = TRY(render::plateProof(job.scene, job.camera, proofs.subject, spec.size.aspect()));
  return proofs;
}

/// Writes the picture as each kind of eye sees it, to a file for each.
Status writeVisions(const render::ExportOrder& job, const PictureSpec& spec,
                    const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    return Error{.file = folder.string(),
                 .reason = "the folder cannot be made: " + failure.message(),
                 .remedy = "Choose a place that you may write to"};
  const auto picture = TRY(render::HeadlessPicture::create());
  const render::Image image = TRY(picture->render(
      job.scene, job.camera,
      {.width = spec.size.width, .height = spec.size.height, .environment = spec.environment},
      spec.samples));
  for (const render::Vision vision : render::visions)
    TRY(render::writeImage(render::simulateVision(image, vision),
                           folder / ("proof_" + std::string(render::nameOf(vision)) + ".png")));
  return Unit{};
}

/// Writes the scene with the proposals: in the saved view that was looked at, else as its own
/// styles. A scene without a look gets the one it was looked at with, as the proposals are for it.
Status writeCopy(const model::Imported& imported, const ProofFlags& flags,
                 const model::Scene& lookedAt, const render::PrintProof& proof) {
  model::Scene scene = imported.scene;
  if (model::hasNoLook(scene))
    scene.setNodes(lookedAt.nodes());
  model::SceneDocument document{.scene = render::withProposals(scene, proof.proposals),
                                .others = imported.others};
  const auto& views = imported.scene.views();
  const model::View* saved =
      flags.picture.cameraFile.empty() ? savedView(imported.scene, flags.picture.view) : nullptr;
  if (saved) {
    const model::Scene shown = render::withProposals(
        model::withViewApplied(imported.scene, *saved).scene, proof.proposals);
    document.scene = model::withViewUpdated(document.scene, std::size_t(saved - views.data()),
                                            model::viewOf(shown, saved->camera, saved->name))
                         .scene;
  }
  document.thumbnail = thumbnailOf(document.scene);
  return model::writeSceneFile(flags.output, document);
}

Status wellAsked(const ProofFlags& flags) {
  if (flags.apply != !flags.output.empty())
    return Error{.reason = flags.apply ? "--apply needs a file to write the changed scene to"
                                       : "-o writes the changed scene, which --apply makes",
                 .remedy = "Give both: --apply -o FILE.sline"};
  if (flags.apply && !model::isSceneFile(flags.output))
    return Error{.file = flags.output,
                 .reason = "a scene file's name ends with " + std::string(model::sceneExtension),
                 .remedy = "Give such a name"};
  const Target scene{.flag = "--output", .name = flags.output, .endings = {}, .scene = true};
  return flags.apply ? checkTargets({&scene, 1}, flags.input.inputs) : Unit{};
}

Exit runProof(const ProofFlags& flags) {
  if (const Status asked = wellAsked(flags); !asked.ok())
    return complain(asked.error(), Exit::wrongUse);
  const Result<model::ImportOptions> options = importOptions(flags.input);
  if (!options.ok())
    return complain(options.error(), Exit::wrongUse);
  const Result<PictureSpec> spec = parseFlagsWithoutOutput(flags.picture);
  if (!spec.ok())
    return complain(spec.error(), Exit::wrongUse);
  Progress progress;
  const Result<model::Imported> imported = readInputs(flags.input, *options, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  const Result<ArrangedScene> arranged = arrangeScene(imported->scene, *spec);
  if (!arranged.ok())
    return complain(arranged.error(), Exit::wrongUse);
  const render::ExportOrder job = exportOrder(*arranged, *spec);
  const render::ProofSettings settings{.leastDifference = flags.threshold, .all = flags.all};
  const Result<Proofs> proofs = proofsOf(job, *spec, settings, progress);
  if (!proofs.ok())
    return complain(proofs.error(), Exit::failed);
  if (!flags.folder.empty())
    if (const Status written = writeVisions(job, *spec, flags.folder); !written.ok())
      return complain(written.error(), Exit::failed);
  if (flags.apply)
    if (const Status written = writeCopy(*imported, flags, job.scene, proofs->print); !written.ok())
      return complain(written.error(), Exit::failed);
  if (flags.json)
    printJson(job.scene, *proofs, settings);
  else
    printText(job.scene, *proofs, settings);
  return Exit::done;
}

void declareProof(CLI::App& command, ProofFlags& flags) {
  command.add_option("INPUT", flags.input.inputs, inputHelp)->required();
  command.add_flag("--verbose", flags.input.verbose, verboseHelp);
  command.add_flag("--json", flags.json, "For programs: one JSON object on standard output");
  command.add_option("--out", flags.folder, "Writes the picture there as each kind of eye sees it")
      ->type_name("FOLDER");
  command.add_flag("--apply", flags.apply, "Writes the scene with what is proposed to the file -o");
  command.add_option("-o,--output", flags.output, "The changed scene")->type_name("FILE.sline");
  command.add_flag("--all", flags.all,
                   "Lists and mends what looks alike on the screen, too, which may be meant");
  command
      .add_option("--threshold", flags.threshold,
                  "The least difference of two colours that tells areas apart, CIEDE2000")
      ->type_name("N")
      ->check(within(1.0, 100.0))
      ->capture_default_str();
  addDrawingOptions(command, flags.picture);
  addLookOption(command, flags.picture);
  command.add_option("--smooth", flags.input.smooth, smoothHelp)
      ->type_name("auto|off|N")
      ->default_str("auto");
  command.add_option("--assembly", flags.input.assembly, assemblyHelp)->type_name("ID");
  addFrame(command, flags.input);
  addTogether(command, flags.input);
  command.footer(
      "Compares the mean colours of structures that lie side by side in the picture, in grey and\n"
      "with protanopia, deuteranopia and tritanopia (Machado, Oliveira and Fernandes 2009). What\n"
      "is proposed was drawn and measured the same way. Besides it measures whether the picture "
      "is\n"
      "a plate of what it draws in detail, on white and 1200 pixels high: how much of that "
      "nothing\n"
      "hides, and how much of the sheet is ink and has colour.\n\n"
      "  sline proof pelvis.sline --view anterior\n"
      "  sline proof abdomen.sline --view \"Urinary System\" --out proofs\n"
      "  sline proof pelvis.sline --apply -o pelvis_print.sline\n"
      "  sline proof abdomen.mrml --look auto");
}

}  // namespace

void addProof(CLI::App& program, Exit& exit) {
  addCommand<ProofFlags>(program, exit,
                         {"proof", "Find what cannot be told apart in print or by all eyes"},
                         declareProof, runProof);
}

}  // namespace sline::cli
