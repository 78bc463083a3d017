#pragma once

#include "apps/lab/command/patient_options.h"
#include "engine/core/result.h"

#include <QDir>
#include <QJsonObject>
#include <QSize>

#include <cstddef>

namespace carina::lab
{

/// Which registration's error is drawn, and how.
struct ErrorPictureOrder {
    std::size_t landmarks = 4; ///< the first of those on rib cage and jaw, 3 to 8
    Length fle = millimetres(1.0);
    QSize size;  ///< of each picture, pixels
    QDir folder; ///< made if need be
};

/// Draws on a patient at rest how far a registration would be off: from the front, from the right
/// side, as a trainee stands, and cut open in the middle. Every picture is a PNG with the scale in
/// its corner. The keys of what is returned are in the help of `render`.
///
/// @returns FileUnwritable with the path; what fitCovariance, patientOf and drawSeries fail with.
/// @pre as drawSeries.
[[nodiscard]] Result<QJsonObject> drawErrorPictures(Subject subject,
                                                    const ErrorPictureOrder& order);

} // namespace carina::lab
