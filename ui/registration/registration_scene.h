#pragma once

#include "models/registration/registration_model.h"
#include "widgets/error_bands.h"
#include "widgets/scene/view/scene_frame.h"

namespace carina
{

class SceneView;

/// Shows a registration in three dimensions: the patient at rest, the landmarks on it, and the
/// stylus once the patient is registered. Open landmarks are balls, touched ones diamonds, and the
/// one that is next is a ball that swells and shrinks. A dark rim sets each off from what is
/// behind.
class RegistrationScene
{
public:
    /// @pre all outlive this.
    RegistrationScene(SceneView& scene, const RegistrationModel& registration);

    /// Takes in that the registration changed, and turns to the landmark that is next.
    void refresh();

    /// What an error on the patient is drawn with.
    struct ShownError {
        ErrorBands bands;
        ErrorRange range;
    };

    /// Draws the error that is expected everywhere on the patient, or no more.
    /// @returns nothing where none is drawn
    std::optional<ShownError> showError(bool shown);

    /// What is drawn at a time.
    [[nodiscard]] SceneFrame frameAt(LocalTime time) const;

private:
    void addMarkers();

    SceneView& m_scene;
    const RegistrationModel& m_registration;
    std::vector<LandmarkRow> m_landmarks; ///< or places to check
    std::size_t m_marked = 0;             ///< landmarks that there are markers for
    QString m_next;                       ///< name of the place that is next
};

} // namespace carina
