#include "engine/anatomy/laryngoscopy/seen_structure.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace carina
{
namespace
{

struct StructureFigures {
    const char* name;
    bool hidesGlottis;
};
constexpr std::array<StructureFigures, kSeenStructures> kStructures{
    {{"nothing", false},
     {"teeth", true},
     {"jaw", true},
     {"tongue", true},
     {"hard_palate", true},
     {"soft_palate", true},
     {"pharynx", true},
     {"epiglottis", true},
     {"aryepiglottic_folds", true},
     {"vestibular_folds", true},
     {"arytenoids", false},
     {"vocal_folds", false},
     {"laryngeal_cartilages", false},
     {"trachea", false},
     {"oesophagus", true},
     {"blade", true},
     {"tube", false},
     {"fluid", true},
     {"foreign_body", true}}};

/// The first row that fits a part counts; empty words fit every name.
struct Recognised {
    PartRole role;
    std::string_view words;
    SeenStructure structure;
};
constexpr std::array kRecognised{
    Recognised{PartRole::Tooth, "", SeenStructure::Teeth},
    Recognised{PartRole::Mandible, "", SeenStructure::Jaw},
    Recognised{PartRole::Skull, "", SeenStructure::HardPalate},
    Recognised{PartRole::Tongue, "", SeenStructure::Tongue},
    Recognised{PartRole::Pharynx, "hard palate", SeenStructure::HardPalate},
    Recognised{PartRole::Pharynx, "soft palate", SeenStructure::SoftPalate},
    Recognised{PartRole::Pharynx, "uvula", SeenStructure::SoftPalate},
    Recognised{PartRole::Pharynx, "oral cavity", SeenStructure::Nothing}, // the space itself
    Recognised{PartRole::Pharynx, "", SeenStructure::Pharynx},
    Recognised{PartRole::Epiglottis, "", SeenStructure::Epiglottis},
    Recognised{PartRole::Larynx, "aryepiglottic", SeenStructure::AryepiglotticFold},
    Recognised{PartRole::Larynx, "vestibular", SeenStructure::VestibularFold},
    Recognised{PartRole::Larynx, "arytenoid", SeenStructure::Arytenoid},
    Recognised{PartRole::Larynx, "corniculate", SeenStructure::Arytenoid},
    Recognised{PartRole::Larynx, "cuneiform", SeenStructure::AryepiglotticFold},
    Recognised{PartRole::Larynx, "vocal", SeenStructure::VocalFold},
    Recognised{PartRole::Larynx, "", SeenStructure::LaryngealCartilage},
    Recognised{PartRole::LaryngealMucosa, "aryepiglottic", SeenStructure::AryepiglotticFold},
    Recognised{PartRole::LaryngealMucosa, "vestibular", SeenStructure::VestibularFold},
    Recognised{PartRole::LaryngealMucosa, "corniculate", SeenStructure::Arytenoid},
    Recognised{PartRole::LaryngealMucosa, "cuneiform", SeenStructure::AryepiglotticFold},
    Recognised{PartRole::LaryngealMucosa, "vallecula", SeenStructure::Pharynx},
    Recognised{PartRole::LaryngealMucosa, "", SeenStructure::LaryngealCartilage},
    Recognised{PartRole::VocalFold, "", SeenStructure::VocalFold},
    Recognised{PartRole::Hyoid, "", SeenStructure::LaryngealCartilage},
    Recognised{PartRole::Mucosa, "", SeenStructure::Pharynx},
    Recognised{PartRole::Trachea, "", SeenStructure::Trachea},
    Recognised{PartRole::RightMainBronchus, "", SeenStructure::Trachea},
    Recognised{PartRole::LeftMainBronchus, "", SeenStructure::Trachea},
    Recognised{PartRole::Oesophagus, "", SeenStructure::Oesophagus}};

std::string nameInSmallLetters(std::string name)
{
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name;
}

const StructureFigures& rowOf(SeenStructure structure)
{
    return kStructures.at(static_cast<std::size_t>(structure));
}

} // namespace

const char* structureName(SeenStructure structure) { return rowOf(structure).name; }

bool hidesGlottis(SeenStructure structure) { return rowOf(structure).hidesGlottis; }

SeenStructure structureOf(const AnatomyPart& part)
{
    const std::string name = nameInSmallLetters(part.name);
    const auto* found = std::ranges::find_if(kRecognised, [&](const Recognised& row) {
        return row.role == part.role && name.find(row.words) != std::string::npos;
    });
    return found == kRecognised.end() ? SeenStructure::Nothing : found->structure;
}

} // namespace carina
