// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/elements.h"

#include <algorithm>
#include <iterator>

#include "model/base/letters.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

constexpr Colour alkali{143, 106, 190};
constexpr Colour earth{86, 158, 72};
constexpr Colour metal{138, 146, 160};
constexpr Colour iron{206, 112, 48};
constexpr Colour copper{190, 116, 62};
constexpr Colour halogen{60, 152, 76};
constexpr Colour grey{150, 150, 150};

constexpr Element elements[] = {
    {"H", "hydrogen", 1.20f, 0.31f, {235, 235, 235}},
    {"He", "helium", 1.40f, 0.28f, grey},
    {"Li", "lithium", 1.82f, 1.28f, alkali},
    {"Be", "beryllium", 1.53f, 0.96f, earth},
    {"B", "boron", 1.92f, 0.84f, {226, 160, 140}},
    {"C", "carbon", 1.70f, 0.76f, {112, 112, 112}},
    {"N", "nitrogen", 1.55f, 0.71f, {58, 92, 190}},
    {"O", "oxygen", 1.52f, 0.66f, {204, 48, 42}},
    {"F", "fluorine", 1.47f, 0.57f, halogen},
    {"Ne", "neon", 1.54f, 0.58f, grey},
    {"Na", "sodium", 2.27f, 1.66f, alkali},
    {"Mg", "magnesium", 1.73f, 1.41f, earth},
    {"Al", "aluminium", 1.84f, 1.21f, metal},
    {"Si", "silicon", 2.10f, 1.11f, {206, 178, 128}},
    {"P", "phosphorus", 1.80f, 1.07f, {226, 134, 32}},
    {"S", "sulphur", 1.80f, 1.05f, {214, 182, 48}},
    {"Cl", "chlorine", 1.75f, 1.02f, halogen},
    {"Ar", "argon", 1.88f, 1.06f, grey},
    {"K", "potassium", 2.75f, 2.03f, alkali},
    {"Ca", "calcium", 2.31f, 1.76f, earth},
    {"Sc", "scandium", 2.00f, 1.70f, metal},
    {"Ti", "titanium", 2.00f, 1.60f, metal},
    {"V", "vanadium", 2.00f, 1.53f, metal},
    {"Cr", "chromium", 2.00f, 1.39f, metal},
    {"Mn", "manganese", 2.00f, 1.39f, {156, 112, 182}},
    {"Fe", "iron", 2.00f, 1.32f, iron},
    {"Co", "cobalt", 2.00f, 1.26f, {214, 132, 150}},
    {"Ni", "nickel", 1.63f, 1.24f, {92, 176, 92}},
    {"Cu", "copper", 1.40f, 1.32f, copper},
    {"Zn", "zinc", 1.39f, 1.22f, {122, 128, 172}},
    {"Ga", "gallium", 1.87f, 1.22f, metal},
    {"Ge", "germanium", 2.11f, 1.20f, metal},
    {"As", "arsenic", 1.85f, 1.19f, {172, 120, 196}},
    {"Se", "selenium", 1.90f, 1.20f, {222, 150, 36}},
    {"Br", "bromine", 1.85f, 1.20f, {158, 58, 44}},
    {"Kr", "krypton", 2.02f, 1.16f, grey},
    {"Rb", "rubidium", 3.03f, 2.20f, alkali},
    {"Sr", "strontium", 2.49f, 1.95f, earth},
    {"Y", "yttrium", 2.00f, 1.90f, metal},
    {"Zr", "zirconium", 2.00f, 1.75f, metal},
    {"Nb", "niobium", 2.00f, 1.64f, metal},
    {"Mo", "molybdenum", 2.00f, 1.54f, metal},
    {"Tc", "technetium", 2.00f, 1.47f, metal},
    {"Ru", "ruthenium", 2.00f, 1.46f, metal},
    {"Rh", "rhodium", 2.00f, 1.42f, metal},
    {"Pd", "palladium", 1.63f, 1.39f, metal},
    {"Ag", "silver", 1.72f, 1.45f, metal},
    {"Cd", "cadmium", 1.58f, 1.44f, {226, 196, 110}},
    {"In", "indium", 1.93f, 1.42f, metal},
    {"Sn", "tin", 2.17f, 1.39f, metal},
    {"Sb", "antimony", 2.06f, 1.39f, metal},
    {"Te", "tellurium", 2.06f, 1.38f, metal},
    {"I", "iodine", 1.98f, 1.39f, {122, 54, 148}},
    {"Xe", "xenon", 2.16f, 1.40f, grey},
    {"Cs", "caesium", 3.43f, 2.44f, alkali},
    {"Ba", "barium", 2.68f, 2.15f, earth},
    {"La", "lanthanum", 2.00f, 2.07f, metal},
    {"Ce", "cerium", 2.00f, 2.04f, metal},
    {"Pr", "praseodymium", 2.00f, 2.03f, metal},
    {"Nd", "neodymium", 2.00f, 2.01f, metal},
    {"Sm", "samarium", 2.00f, 1.98f, metal},
    {"Eu", "europium", 2.00f, 1.98f, metal},
    {"Gd", "gadolinium", 2.00f, 1.96f, metal},
    {"Tb", "terbium", 2.00f, 1.94f, metal},
    {"Dy", "dysprosium", 2.00f, 1.92f, metal},
    {"Ho", "holmium", 2.00f, 1.92f, metal},
    {"Er", "erbium", 2.00f, 1.89f, metal},
    {"Tm", "thulium", 2.00f, 1.90f, metal},
    {"Yb", "ytterbium", 2.00f, 1.87f, metal},
    {"Lu", "lutetium", 2.00f, 1.87f, metal},
    {"Hf", "hafnium", 2.00f, 1.75f, metal},
    {"Ta", "tantalum", 2.00f, 1.70f, metal},
    {"W", "tungsten", 2.00f, 1.62f, metal},
    {"Re", "rhenium", 2.00f, 1.51f, metal},
    {"Os", "osmium", 2.00f, 1.44f, metal},
    {"Ir", "iridium", 2.00f, 1.41f, metal},
    {"Pt", "platinum", 1.75f, 1.36f, metal},
    {"Au", "gold", 1.66f, 1.36f, {216, 174, 58}},
    {"Hg", "mercury", 1.55f, 1.32f, metal},
    {"Tl", "thallium", 1.96f, 1.45f, metal},
    {"Pb", "lead", 2.02f, 1.46f, metal},
    {"Bi", "bismuth", 2.07f, 1.48f, metal},
    {"Po", "polonium", 1.97f, 1.40f, metal},
    {"Th", "thorium", 2.00f, 2.06f, metal},
    {"U", "uranium", 1.86f, 1.96f, metal},
};

constexpr Element unknown{"X", "unknown element", 2.00f, 0.76f, grey};

}  // namespace

const Element* elementOf(std::string_view symbol) {
  if (equalsIgnoringCase(symbol, "d"))
    symbol = "H";
  const auto* const found = std::find_if(
      std::begin(elements), std::end(elements),
      [symbol](const Element& element) { return equalsIgnoringCase(symbol, element.symbol); });
  return found == std::end(elements) ? nullptr : found;
}

const Element& unknownElement() {
  return unknown;
}

}  // namespace sline::model
