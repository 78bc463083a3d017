#pragma once

#include "engine/core/result.h"
#include "models/patient/laryngoscopy.h"
#include "widgets/scene/look/picture_quality.h"

#include <QImage>
#include <QJsonObject>
#include <QSize>

#include <functional>
#include <optional>
#include <span>

namespace carina::lab
{

/// With what a throat is looked into.
struct ScopeWay {
    BladeKind blade = kUsualBlade;
    ScopeEye eye = ScopeEye::Video;
    QSize size{640, 480}; ///< of each picture, pixels
};
/// "video" or "direct".
[[nodiscard]] QString eyeName(ScopeEye eye);
/// "macintosh-3".
[[nodiscard]] QString bladeName(BladeKind blade);

/// What is to be drawn of a laryngoscopy.
struct ScopeShot {
    LaryngoscopyStep step = LaryngoscopyStep::Full;
    AirwayEvents events{};
    HeadPosition head{}; ///< as far as a stiff neck among the events lets it
    Length lift = kUsualLift;
    std::optional<Angle> levering{}; ///< instead of the lift
    PictureQuality quality = PictureQuality::Fine;
    std::optional<SurfaceLook> look{}; ///< as SceneView::setFixedLook
    std::optional<int> sample{};       ///< of a reference, in place of the middle of each pixel
};

/// How it was drawn.
struct DrawnShot {
    std::size_t number = 0;           ///< of the shot
    const Laryngoscopy& laryngoscopy; ///< with its events and its head
    LaryngoscopyPose pose;
    GlotticView seen; ///< from the ids of the picture
    const QImage& picture;
};
/// @param shot that was drawn so
[[nodiscard]] BladeEffort effortOf(const DrawnShot& drawn, const ScopeShot& shot);

/// Draws the throat of a patient as the programs do, in full detail, once for each shot, and
/// measures each picture.
/// @param take gets them in their order; a failure ends the series
/// @returns NoGraphics where the parts of a picture cannot be read; what drawSeries and `take` fail
///          with
/// @pre as drawSeries; the laryngoscopy is of this patient
[[nodiscard]] Result<void> drawShots(const PatientModel& patient, const Laryngoscopy& laryngoscopy,
                                     const ScopeWay& way, std::span<const ScopeShot> shots,
                                     const std::function<Result<void>(const DrawnShot&)>& take);

/// How many times in a second a shot is drawn (drawingRate), with levels of detail as usual.
/// @returns what drawingRate fails with
/// @pre as drawShots
[[nodiscard]] Result<double> shotRate(const PatientModel& patient, const Laryngoscopy& laryngoscopy,
                                      const ScopeWay& way, const ScopeShot& shot);

/// Nothing is drawn as if it were difficult that is not.
/// @returns NoAirway with the event that the patient lacks a part for
[[nodiscard]] Result<void> canShowAll(const Laryngoscopy& laryngoscopy, const AirwayEvents& events);

/// The pixels of each structure that is seen, by its name.
[[nodiscard]] QJsonObject pixelsOf(const GlotticView& seen);

} // namespace carina::lab
