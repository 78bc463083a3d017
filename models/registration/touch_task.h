#pragma once

#include "engine/registration/landmarks/touch_recognition.h"
#include "engine/registration/watch/re_registration.h"
#include "models/registration/landmark_task.h"
#include "models/registration/stylus_watch.h"

namespace carina
{

/// Records the touches of the landmarks on the manikin: the stylus is held still, or a key or foot
/// switch is pressed. They may be touched in any order: the landmark is recognised by its position
/// relative to the other touches (recogniseTouch). Also re-registers a manikin that was moved after
/// its registration ("registered again" on screen), from three or more of its landmarks.
class TouchTask
{
public:
    /// The largest FLE expected of careful touches.
    static constexpr Length kHandFle = millimetres(2.0);

    /// @pre all outlive this.
    TouchTask(SiteEditor& editor, StylusWatch& watch, const LandmarkTask& landmarks);

    /// The landmark to touch next: the chosen one, or else the first without a fresh touch;
    /// std::nullopt if all are touched.
    [[nodiscard]] std::optional<std::size_t> next() const;
    /// The next touch is taken for this landmark, without recognition; std::nullopt to recognise
    /// it.
    void choose(std::optional<std::size_t> landmark);

    /// The fresh touch of a landmark; null if there is none.
    [[nodiscard]] const TouchedPoint* touchOf(const Landmark& landmark) const;

    /// Records a touch. Does nothing if next() is empty.
    void take(const StylusTouch& touch);

    /// One sentence: why a moved manikin cannot be re-registered now; empty if it can.
    [[nodiscard]] QString whyNoRelay() const;
    /// The manikin was moved: its landmarks are touched again until they determine its pose.
    /// Refused if whyNoRelay() is not empty.
    void beginRelay();
    void cancelRelay();
    [[nodiscard]] bool isRelaying() const { return m_editor.site().relay.has_value(); }

private:
    [[nodiscard]] const std::vector<Landmark>& landmarks() const;
    [[nodiscard]] bool canBeTouched(const Landmark& landmark) const;
    [[nodiscard]] std::vector<std::size_t> inTurn() const;
    [[nodiscard]] Result<TouchFinding> recognise(const StylusTouch& touch) const;
    void take(const StylusTouch& touch, std::size_t landmark);
    void rename(const StylusTouch& touch, const TouchFinding& finding);
    void refuse(const TouchFinding& finding);
    [[nodiscard]] std::pair<EarlierRegistration, std::vector<Retouch>> touchedAgain() const;
    /// @param alike from touches as good as those of the registration
    [[nodiscard]] bool isLoose(const ReRegistration& alike) const;
    void relayIfItTells();

    SiteEditor& m_editor;
    StylusWatch& m_watch;
    const LandmarkTask& m_landmarks;
    std::optional<std::size_t> m_chosen;
};

} // namespace carina
