#pragma once

#include "engine/registration/landmarks/landmark_catalogue.h"
#include "models/registration/registration_targets.h"
#include "models/registration/surface_finder.h"
#include "models/site/site_editor.h"

#include <filesystem>
#include <optional>

namespace carina
{

/// Chooses the landmarks and their places on the patient, and tells beforehand what they are good
/// for.
class LandmarkTask
{
public:
    /// @param offered the sets of landmarks of this patient, the recommended one first
    /// @pre editor, patient and surfaces outlive this; there is one offered.
    LandmarkTask(SiteEditor& editor, const PatientModel& patient, const SurfaceFinder& surfaces,
                 std::vector<LandmarkCatalogue> offered);

    [[nodiscard]] const std::vector<LandmarkCatalogue>& offered() const { return m_offered; }
    /// The site's, or, before it has one, the recommended one.
    [[nodiscard]] const LandmarkCatalogue& catalogue() const;
    /// Which of the offered ones that is; nothing where it was changed.
    [[nodiscard]] std::optional<std::size_t> chosenSet() const;
    void chooseSet(std::size_t offered);

    /// The landmark that is being moved.
    [[nodiscard]] std::optional<std::size_t> chosen() const;
    void choose(std::optional<std::size_t> landmark);
    /// Takes the place where a ray first meets the patient as the chosen landmark's: of it the
    /// nearest tip or ridge that a finger finds, while snapping.
    void pick(const Vec3& p_A_eye, const Vec3& dir_A);
    [[nodiscard]] bool isSnapping() const { return m_snapping; }
    void setSnapping(bool snapping);

    /// Takes the landmarks of a file. One that lies within kFileRounding of where it was has not
    /// moved; a file that moves, adds and drops none changes nothing, whatever it is called.
    void importFrom(const std::filesystem::path& file);
    void exportTo(const std::filesystem::path& file);

    /// Takes the landmarks as they are, and goes on to touching.
    void accept();

    /// What to expect of touches that stray by kForecastFle; empty for a layout that is none.
    [[nodiscard]] std::vector<ExpectedError> forecast() const;
    /// The RMS error that a registration's covariance makes at the worst target.
    [[nodiscard]] Length worstError(const Mat6& covariance_A) const;
    /// The three of these landmarks that make the least of it by themselves and cannot be taken for
    /// one another, for their distances differ; none where there are no such three.
    /// @param of places in the catalogue
    [[nodiscard]] std::vector<std::size_t> bestTriangle(const std::vector<std::size_t>& of) const;
    /// The landmark of the recommended set that would help most, with the error at the worst target
    /// in millimetres; nothing where none does.
    [[nodiscard]] std::optional<std::pair<QString, double>> wouldHelp() const;

    static constexpr Length kForecastFle = millimetres(1.0);
    /// Some programs write three decimals of a millimetre.
    static constexpr Length kFileRounding = millimetres(0.001);

private:
    SiteEditor& m_editor;
    const PatientModel& m_patient;
    const SurfaceFinder& m_surfaces;
    std::vector<LandmarkCatalogue> m_offered;
    std::vector<RegistrationTarget> m_targets;
    std::optional<std::size_t> m_chosen;
    bool m_snapping = true;
};

} // namespace carina
