#pragma once

#include "engine/anatomy/anatomy.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace carina
{

/// A group of a patient's organs, which is listed and lifted out as one.
enum class OrganGroup : std::uint8_t {
    Airway, ///< with mouth, pharynx and bronchi
    Lungs,
    Skeleton, ///< with teeth
    Vessels,  ///< with the heart
    Muscles,  ///< with the diaphragm
    Other,    ///< oesophagus, skin and whatever was not recognised
};
inline constexpr std::array kOrganGroups{OrganGroup::Airway,   OrganGroup::Lungs,
                                         OrganGroup::Skeleton, OrganGroup::Vessels,
                                         OrganGroup::Muscles,  OrganGroup::Other};

/// The group of a part with this role.
[[nodiscard]] OrganGroup groupOf(PartRole role);

/// The name of a group in facts and logs ("skeleton"), which does not change, and its inverse;
/// nothing for an unknown name.
[[nodiscard]] const char* groupName(OrganGroup group);
[[nodiscard]] std::optional<OrganGroup> groupFromName(std::string_view name);

} // namespace carina
