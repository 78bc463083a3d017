#pragma once

#include "apps/lab/command/patient_options.h"
#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/deformation/neck_field.h"

#include <QDir>
#include <QJsonObject>
#include <QSize>

#include <optional>
#include <vector>

namespace carina::lab
{

/// Which pictures of a patient are wanted.
struct PictureOrder {
    std::vector<LungCondition> conditions;
    VentilationMode ventilator = VentilationMode::Spontaneous;
    QSize size;  ///< of each, pixels
    QDir folder; ///< made if need be
    /// How the jaw is moved from a mouth that is shut; nothing: as the surfaces have it.
    struct Jaw {
        Angle opening{};
        Length forward{};
    };
    std::optional<Jaw> jaw{};
    HeadPosition head{};
};

/// Draws a patient as the programs do, in full detail, at the end of expiration and of inspiration
/// of a settled quiet breath with each condition: from the front, from the right side and as a
/// trainee stands. Every picture is a PNG. The keys of what is returned are in the help of
/// `render`.
///
/// @returns FileUnwritable with the path; what patientOf and drawSeries fail with.
/// @pre as drawSeries.
[[nodiscard]] Result<QJsonObject> drawPictures(Subject subject, const PictureOrder& order);

} // namespace carina::lab
