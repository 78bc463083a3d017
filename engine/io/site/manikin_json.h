#pragma once

#include "engine/io/files/json_fields.h"
#include "engine/io/site/site_manikin.h"

namespace carina
{

/// A manikin's profile as a JSON object, and back. All but the name may be left out:
///
///     name             text
///     note             text
///     landmarks        a list of objects with a name; landmarks_source, text, is due with them
///     patient          text, as after --patient; patient_source, text, is due with it
///     teeth_to_carina  mm (100 to 350) and source
///
/// Reading reports what is missing or wrong as a fault of `fields`.
[[nodiscard]] QJsonObject jsonManikinProfile(const ManikinProfile& profile);
[[nodiscard]] ManikinProfile readManikinProfile(JsonFields& fields);

/// The manikin of a site file, and back:
///
///     profile                        as above
///     measured_teeth_to_carina_mm    100 to 350
///     airway                         a list of place ("incisors", "epiglottis", "glottis",
///                                    "carina"; none twice) and p_MQ_mm
///     registered_at                  made_at of the registration that M is of
[[nodiscard]] QJsonObject jsonManikin(const SiteManikin& manikin);
[[nodiscard]] SiteManikin readManikin(JsonFields& fields);

/// Reads a profile that somebody wrote: as above, with "schema": "carina.manikin/1".
/// @returns the errors of readJsonFile; FileMalformed for a fault. The detail names file and field.
[[nodiscard]] Result<ManikinProfile> readManikinFile(const std::filesystem::path& file);

} // namespace carina
