#include "widgets/scene/look/appearance.h"

#include "engine/anatomy/organ_group.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace carina
{

namespace
{

constexpr QColor kIvory{229, 221, 192};
constexpr QColor kCartilage{178, 208, 222};

/// Of what lines mouth and larynx: pink, paler where it lies over cartilage, redder where it is
/// thick.
QColor mucosaColor(const std::string& name)
{
    struct Named {
        const char* word;
        QColor color;
    };
    constexpr std::array kNamed{
        Named{"tubercle", {226, 165, 150}},   Named{"aryepiglottic", {217, 140, 134}},
        Named{"vestibular", {201, 100, 106}}, Named{"ingiva", {217, 136, 142}},
        Named{" lip", {181, 92, 94}},         Named{"arch", {192, 98, 100}},
        Named{"tonsil", {214, 142, 126}}};
    const auto found = std::ranges::find_if(
        kNamed, [&name](const Named& n) { return name.find(n.word) != std::string::npos; });
    return found == kNamed.end() ? QColor{204, 116, 118} : found->color;
}

/// Arches and tonsils are told from the wall on which they lie.
QColor pharynxColor(const std::string& name)
{
    const bool isOfFauces =
        name.find(" arch") != std::string::npos || name.find("tonsil") != std::string::npos;
    return isOfFauces ? mucosaColor(name) : QColor{220, 145, 156};
}

QColor vesselColor(std::string name)
{
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array kVeins{"vein", "vena", "venous", "sinus"};
    const bool vein = std::any_of(kVeins.begin(), kVeins.end(), [&](const char* word) {
        return name.find(word) != std::string::npos;
    });
    return vein ? QColor{92, 116, 176} : QColor{188, 73, 57};
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
        return {MaterialGroup::SoftTissue, {186, 203, 211}};
    case PartRole::Larynx:
    case PartRole::Hyoid:
        return {MaterialGroup::Airway, {192, 216, 211}};
    case PartRole::Epiglottis:
        return {MaterialGroup::SoftTissue, {214, 171, 141}};
    case PartRole::RightUpperLobe:
    case PartRole::LeftUpperLobe:
        return {MaterialGroup::Lung, {229, 158, 163}};
    case PartRole::RightMiddleLobe:
        return {MaterialGroup::Lung, {200, 175, 133}};
    case PartRole::RightLowerLobe:
    case PartRole::LeftLowerLobe:
        return {MaterialGroup::Lung, {188, 134, 157}};
    case PartRole::RightLung:
    case PartRole::LeftLung:
        return {MaterialGroup::Lung, {229, 158, 163}};
    case PartRole::Diaphragm:
        return {MaterialGroup::Veil, {166, 100, 102}};
    case PartRole::Mandible:
        return {MaterialGroup::Bone, {233, 224, 197}};
    case PartRole::Tooth:
        return {MaterialGroup::Bone, {246, 242, 228}};
    case PartRole::Skull:
    case PartRole::Spine:
        return {MaterialGroup::Bone, {228, 222, 196}};
    case PartRole::Rib:
        return {MaterialGroup::Veil, kIvory};
    case PartRole::Tongue:
        return {MaterialGroup::SoftTissue, {191, 97, 123}};
    case PartRole::Pharynx:
        return {MaterialGroup::Airway, pharynxColor(part.name)};
    case PartRole::Oesophagus:
        return {MaterialGroup::Veil, {176, 129, 100}};
    case PartRole::Heart:
        return {MaterialGroup::Veil, {153, 60, 61}};
    case PartRole::Vessel:
        return {MaterialGroup::Veil, vesselColor(part.name)};
    case PartRole::Muscle:
        return {MaterialGroup::Veil, {144, 71, 68}};
    case PartRole::Skin:
        return {MaterialGroup::Skin, {201, 162, 136}};
    case PartRole::Mucosa:
    case PartRole::LaryngealMucosa:
        return {MaterialGroup::Airway, mucosaColor(part.name)};
    case PartRole::VocalFold:
        return {MaterialGroup::SoftTissue, {248, 244, 232}};
    case PartRole::Other:
        return {MaterialGroup::SoftTissue, {168, 160, 152}};
    }
    return {};
}

BodyRegion bodyRegionOf(PartRole role)
{
    switch (groupOf(role)) {
    case OrganGroup::Airway:
        return BodyRegion::Airway;
    case OrganGroup::Lungs:
        return BodyRegion::Lungs;
    case OrganGroup::Skeleton:
        return BodyRegion::Skeleton;
    case OrganGroup::Vessels:
        return BodyRegion::Vessels;
    case OrganGroup::Muscles:
        return BodyRegion::Muscles;
    case OrganGroup::Other:
        break;
    }
    return BodyRegion::Other;
}

} // namespace carina
