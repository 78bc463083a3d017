#pragma once

#include "models/patient/patient_model.h"
#include "models/registration/landmark_task.h"
#include "models/registration/stylus_watch.h"
#include "models/site/site_editor.h"

#include <QStringList>

#include <filesystem>
#include <optional>
#include <vector>

namespace carina
{

/// The name of a place of the airway, as shown.
[[nodiscard]] QString airwayPlaceName(AirwayPlace place);

/// The manikin of the site beside the patient: its make, the length of its airway, and places of
/// its airway that are touched with the stylus.
class ManikinTask
{
public:
    /// @pre all outlive this.
    ManikinTask(SiteEditor& editor, const PatientModel& patient, const LandmarkTask& landmarks);

    /// The built-in profiles, then the site's own if it is another.
    [[nodiscard]] std::vector<ManikinProfile> offered() const;
    /// Index in offered(); std::nullopt while none is chosen.
    [[nodiscard]] std::optional<std::size_t> chosen() const;
    /// Takes a profile; std::nullopt for none. While no landmark is touched, the profile's
    /// landmarks are taken too, where the patient has them all.
    void choose(std::optional<std::size_t> profile);
    /// Takes a profile from a file.
    void importFrom(const std::filesystem::path& file);

    /// Sets the length from teeth to carina as measured with a tube; std::nullopt: not measured.
    void setMeasured(std::optional<Length> teethToCarina);
    [[nodiscard]] std::optional<Length> measured() const;

    /// One sentence: why the airway cannot be touched now; empty if it can.
    [[nodiscard]] QString whyNoTouch() const;
    /// Starts touching the airway from the teeth on; refused if whyNoTouch() is not empty.
    void beginTouch();
    void endTouch();
    [[nodiscard]] bool isTouching() const { return next().has_value(); }
    /// The place to touch next; std::nullopt while nothing is to be touched.
    [[nodiscard]] std::optional<AirwayPlace> next() const;
    /// Leaves out a place that the stylus does not reach.
    void skip();
    /// Records a touch of next(). @pre isTouching()
    void take(const StylusTouch& touch);

    /// A place in the patient's airway, as drawn; std::nullopt where the patient has none.
    [[nodiscard]] std::optional<Vec3> placeInPatient(AirwayPlace place) const;
    /// A touched place of the manikin's airway in A, by the present registration; std::nullopt
    /// where it was not touched since the fit.
    [[nodiscard]] std::optional<Vec3> placeInManikin(AirwayPlace place) const;
    /// Whether places were touched, but before the present fit.
    [[nodiscard]] bool isStale() const;

    /// How the manikin's airway differs from the patient's, in sentences.
    [[nodiscard]] QStringList comparison() const;

private:
    void advance();
    void adopt(ManikinProfile profile);
    [[nodiscard]] std::optional<LandmarkCatalogue> landmarksOf(const ManikinProfile& profile) const;
    [[nodiscard]] std::optional<SourcedLength> manikinLength() const;
    [[nodiscard]] QString lengths() const;
    [[nodiscard]] QString straightLengths() const;
    [[nodiscard]] QString farthest() const;
    [[nodiscard]] QString advice() const;
    [[nodiscard]] QString otherPatient() const;

    SiteEditor& m_editor;
    const PatientModel& m_patient;
    const LandmarkTask& m_landmarks;
    std::optional<AirwayPlace> m_next; ///< on the Overview
};

} // namespace carina
