#include "widgets/scene/appearance.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace carina
{

namespace
{

constexpr QColor kIvory{232, 220, 192};
constexpr QColor kCartilage{178, 208, 222};

QColor vesselColor(std::string name)
{
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array kVeins{"vein", "vena", "venous", "sinus"};
    const bool vein = std::any_of(kVeins.begin(), kVeins.end(), [&](const char* word) {
        return name.find(word) != std::string::npos;
    });
    return vein ? QColor{92, 116, 176} : QColor{186, 72, 66};
}

} // namespace

Appearance appearanceOf(const AnatomyPart& part)
{
    switch (part.role) {
    case PartRole::Trachea:
    case PartRole::RightMainBronchus:
    case PartRole::LeftMainBronchus:
        return {MaterialGroup::Airway, kCartilage};
    case PartRole::BronchialTree:
        return {MaterialGroup::SoftTissue, {186, 200, 206}};
    case PartRole::Larynx:
        return {MaterialGroup::Airway, {196, 214, 208}};
    case PartRole::Epiglottis:
        return {MaterialGroup::SoftTissue, {226, 178, 150}};
    case PartRole::RightUpperLobe:
    case PartRole::LeftUpperLobe:
        return {MaterialGroup::Lung, {226, 158, 158}};
    case PartRole::RightMiddleLobe:
        return {MaterialGroup::Lung, {232, 176, 160}};
    case PartRole::RightLowerLobe:
    case PartRole::LeftLowerLobe:
        return {MaterialGroup::Lung, {208, 140, 150}};
    case PartRole::RightLung:
    case PartRole::LeftLung:
        return {MaterialGroup::Lung, {224, 156, 158}};
    case PartRole::Diaphragm:
        return {MaterialGroup::Veil, {150, 84, 78}};
    case PartRole::Mandible:
        return {MaterialGroup::Bone, {236, 224, 196}};
    case PartRole::Tooth:
        return {MaterialGroup::Bone, {246, 242, 228}};
    case PartRole::Skull:
    case PartRole::Spine:
        return {MaterialGroup::Bone, {214, 202, 176}};
    case PartRole::Rib:
        return {MaterialGroup::Veil, kIvory};
    case PartRole::Tongue:
        return {MaterialGroup::SoftTissue, {202, 112, 112}};
    case PartRole::Pharynx:
        return {MaterialGroup::Airway, {216, 150, 138}};
    case PartRole::Oesophagus:
        return {MaterialGroup::Veil, {186, 132, 104}};
    case PartRole::Heart:
        return {MaterialGroup::Veil, {164, 68, 66}};
    case PartRole::Vessel:
        return {MaterialGroup::Veil, vesselColor(part.name)};
    case PartRole::Muscle:
        return {MaterialGroup::Veil, {160, 82, 76}};
    case PartRole::Skin:
        return {MaterialGroup::Skin, {222, 186, 164}};
    case PartRole::Other:
        return {MaterialGroup::SoftTissue, {168, 160, 152}};
    }
    return {};
}

} // namespace carina
