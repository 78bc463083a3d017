#include "engine/anatomy/anatomy.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace carina
{

namespace
{

using NamedRole = std::pair<PartRole, const char*>;

/// In the order of the enumeration: the place in the table is the role.
constexpr std::array kRoleNames{
    NamedRole{PartRole::Trachea, "trachea"},
    NamedRole{PartRole::RightMainBronchus, "right_main_bronchus"},
    NamedRole{PartRole::LeftMainBronchus, "left_main_bronchus"},
    NamedRole{PartRole::BronchialTree, "bronchial_tree"},
    NamedRole{PartRole::Larynx, "larynx"},
    NamedRole{PartRole::Epiglottis, "epiglottis"},
    NamedRole{PartRole::RightUpperLobe, "right_upper_lobe"},
    NamedRole{PartRole::RightMiddleLobe, "right_middle_lobe"},
    NamedRole{PartRole::RightLowerLobe, "right_lower_lobe"},
    NamedRole{PartRole::LeftUpperLobe, "left_upper_lobe"},
    NamedRole{PartRole::LeftLowerLobe, "left_lower_lobe"},
    NamedRole{PartRole::RightLung, "right_lung"},
    NamedRole{PartRole::LeftLung, "left_lung"},
    NamedRole{PartRole::Diaphragm, "diaphragm"},
    NamedRole{PartRole::Mandible, "mandible"},
    NamedRole{PartRole::Tooth, "tooth"},
    NamedRole{PartRole::Tongue, "tongue"},
    NamedRole{PartRole::Pharynx, "pharynx"},
    NamedRole{PartRole::Oesophagus, "oesophagus"},
    NamedRole{PartRole::Skull, "skull"},
    NamedRole{PartRole::Spine, "spine"},
    NamedRole{PartRole::Rib, "rib"},
    NamedRole{PartRole::Heart, "heart"},
    NamedRole{PartRole::Vessel, "vessel"},
    NamedRole{PartRole::Muscle, "muscle"},
    NamedRole{PartRole::Skin, "skin"},
    NamedRole{PartRole::Mucosa, "mucosa"},
    NamedRole{PartRole::LaryngealMucosa, "laryngeal_mucosa"},
    NamedRole{PartRole::VocalFold, "vocal_fold"},
    NamedRole{PartRole::Hyoid, "hyoid"},
    NamedRole{PartRole::Other, "other"},
};

constexpr bool inOrderOfRoles()
{
    for (std::size_t i = 0; i < kRoleNames.size(); ++i) {
        if (static_cast<std::size_t>(kRoleNames[i].first) != i)
            return false;
    }
    return kRoleNames.size() == static_cast<std::size_t>(PartRole::Other) + 1;
}
static_assert(inOrderOfRoles());

} // namespace

std::optional<Side> lungSide(PartRole role)
{
    switch (role) {
    case PartRole::RightUpperLobe:
    case PartRole::RightMiddleLobe:
    case PartRole::RightLowerLobe:
    case PartRole::RightLung:
        return Side::Right;
    case PartRole::LeftUpperLobe:
    case PartRole::LeftLowerLobe:
    case PartRole::LeftLung:
        return Side::Left;
    default:
        return std::nullopt;
    }
}

const char* roleName(PartRole role) { return kRoleNames[static_cast<std::size_t>(role)].second; }

std::optional<PartRole> roleFromName(const std::string& name)
{
    const auto found =
        std::find_if(kRoleNames.begin(), kRoleNames.end(),
                     [&name](const NamedRole& r) { return std::string_view{r.second} == name; });
    if (found == kRoleNames.end())
        return std::nullopt;
    return found->first;
}

} // namespace carina
