#pragma once

#include "models/registration/registration_model.h"
#include "widgets/error_bands.h"
#include "widgets/scene/view/scene_frame.h"

namespace carina
{

class SceneView;

/// Shows a registration in three dimensions: the patient at rest, the landmarks on it, and the
/// stylus once the patient is registered. Open landmarks are balls, touched ones diamonds, and the
/// next one is a pulsating ball. A dark rim separates each from the background.
class RegistrationScene
{
public:
    /// @pre all outlive this.
    RegistrationScene(SceneView& scene, const RegistrationModel& registration);

    /// Updates the scene after RegistrationModel::changed(), and turns the view to the next
    /// landmark.
    void refresh();

    /// The colour bands and the range of a drawn error map.
    struct ShownError {
        ErrorBands bands;
        ErrorRange range;
    };

    /// Shows or hides the map of the expected error on the patient.
    /// @returns std::nullopt if no map is drawn
    std::optional<ShownError> showError(bool shown);

    /// The frame to draw at a time.
    [[nodiscard]] SceneFrame frameAt(LocalTime time) const;

private:
    void addMarkers();

    SceneView& m_scene;
    const RegistrationModel& m_registration;
    std::vector<LandmarkRow> m_landmarks; ///< or check points
    std::size_t m_marked = 0;             ///< number of markers in the scene
    QString m_next;                       ///< name of the next point
};

} // namespace carina
