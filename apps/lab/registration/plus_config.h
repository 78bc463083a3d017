#pragma once

#include "engine/registration/landmarks/landmark_catalogue.h"

#include <QString>

namespace carina::lab
{

/// What a Plus configuration tells of a phantom and the stylus that touches it.
struct PlusConfig {
    Vec3 p_SQ = Vec3::Zero();        ///< the tip: translation of StylusTip to Stylus, metres
    std::vector<Landmark> landmarks; ///< of PhantomDefinition, metres, in the order of the file
};

/// Reads the XML of a Plus configuration: the Transform From="StylusTip" To="Stylus" with its
/// Matrix of 16 numbers, and each Landmark with Name and Position; all else is passed over.
/// @returns FileNotFound; FileMalformed where it is no XML, or one of these is missing or is not as
///          it should be. The detail is a sentence that names the file.
[[nodiscard]] Result<PlusConfig> readPlusConfig(const QString& file);

} // namespace carina::lab
