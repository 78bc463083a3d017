#pragma once

#include "engine/registration/landmarks/landmark_catalogue.h"
#include "models/registration/registration_targets.h"
#include "models/registration/surface_finder.h"
#include "models/site/site_editor.h"

#include <filesystem>
#include <optional>

namespace carina
{

/// Chooses the landmarks and their positions on the patient, and predicts the TRE that they allow.
class LandmarkTask
{
public:
    /// @param offered the landmark sets of this patient, the recommended one first
    /// @pre editor, patient and surfaces outlive this; `offered` is not empty.
    LandmarkTask(SiteEditor& editor, const PatientModel& patient, const SurfaceFinder& surfaces,
                 std::vector<LandmarkCatalogue> offered);

    [[nodiscard]] const std::vector<LandmarkCatalogue>& offered() const { return m_offered; }
    /// The site's landmarks, or the recommended set while the site has none.
    [[nodiscard]] const LandmarkCatalogue& catalogue() const;
    /// The index of catalogue() in offered(); std::nullopt if it was edited.
    [[nodiscard]] std::optional<std::size_t> chosenSet() const;
    void chooseSet(std::size_t offered);

    /// The landmark that is being moved.
    [[nodiscard]] std::optional<std::size_t> chosen() const;
    void choose(std::optional<std::size_t> landmark);
    /// Moves the chosen landmark to the point where a ray first meets a surface of the patient;
    /// while snapping, to the nearest tip, or else ridge, of that surface.
    void pick(const Vec3& p_A_eye, const Vec3& dir_A);
    [[nodiscard]] bool isSnapping() const { return m_snapping; }
    void setSnapping(bool snapping);

    /// Takes the landmarks of a file. A landmark within kFileRounding of its present position is
    /// taken as unchanged. A file whose landmarks are all unchanged leaves the site as it is.
    void importFrom(const std::filesystem::path& file);
    void exportTo(const std::filesystem::path& file);

    /// Accepts the landmarks and goes on to the Touch step.
    void accept();

    /// The expected TRE at each target for touches with an FLE of kForecastFle; empty if these
    /// landmarks do not determine a registration.
    [[nodiscard]] std::vector<ExpectedError> forecast() const;
    /// The RMS TRE at the worst target for a registration with this covariance.
    [[nodiscard]] Length worstError(const Mat6& covariance_A) const;
    /// The three of these landmarks with the smallest worstError() among those whose three
    /// distances differ clearly, so that they can be told apart; empty if there are no such three.
    /// @param of indices in the catalogue
    [[nodiscard]] std::vector<std::size_t> bestTriangle(const std::vector<std::size_t>& of) const;
    /// The landmark of the recommended set whose addition reduces the RMS TRE at the worst target
    /// most, with that TRE in millimetres; std::nullopt if none reduces it.
    [[nodiscard]] std::optional<std::pair<QString, double>> wouldHelp() const;

    static constexpr Length kForecastFle = millimetres(1.0);
    /// Rounding of programs that write millimetres with three decimals.
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
