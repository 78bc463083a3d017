#pragma once

#include "tests/models/registration/made_site.h"
#include "tests/models/registration/registration_site.h"

namespace carina::test
{

/// The tasks of fitting and verifying on a site as it was made, without a tracker that sees
/// anything: what is touched is told.
struct MadeDesk {
    explicit MadeDesk(Site site)
        : editor{folder.filePath(QStringLiteral("site.json")).toStdString(), std::move(site), [] {
                     return QDateTime{{2004, 3, 27}, {10, 15}, Qt::UTC};
                 }}
    {
    }

    /// The stylus is held at a place of the anatomy, off it by so much.
    void verifyAt(const Vec3& p_AQ, const Vec3& off_A = Vec3::Zero())
    {
        verifying.take(touchAt(p_AQ, off_A));
    }

    QTemporaryDir folder;
    WrittenTracker tracker;
    SiteEditor editor;
    StylusWatch watch{tracker, [] { return std::optional{SessionTime{}}; }};
    SurfaceFinder surfaces{RegistrationSite::patient()};
    FitTask fitting{editor, watch, RegistrationSite::patient(), surfaces};
    VerifyTask verifying{editor, watch, RegistrationSite::patient(), surfaces, checks()};

    /// Two places of their own, and all landmarks.
    static std::vector<Landmark> checks()
    {
        std::vector<Landmark> places = RegistrationSite::checks();
        for (const Landmark& landmark : eightLandmarks().landmarks)
            places.push_back(landmark);
        return places;
    }
};

/// Any direction, of that RMS length.
inline Vec3 anyError(std::mt19937& random, Length rms)
{
    std::normal_distribution<double> part{0.0, rms.si / std::sqrt(3.0)};
    return {part(random), part(random), part(random)};
}

/// All landmarks touched by a hand that strays so far.
inline Site touchedBy(std::mt19937& random, Length hand)
{
    Site site = preparedSite();
    for (const Landmark& landmark : eightLandmarks().landmarks)
        site = withTouch(std::move(site), landmark.name,
                         touchAt(landmark.p_AQ, anyError(random, hand)));
    return site;
}

} // namespace carina::test
