#pragma once

#include "engine/registration/landmarks/touch_recognition.h"
#include "engine/registration/watch/re_registration.h"
#include "models/registration/landmark_task.h"
#include "models/registration/stylus_watch.h"

namespace carina
{

/// Takes the landmarks on the manikin: by holding the stylus still, or by a key or foot switch. In
/// any order: the geometry tells which one was touched. The same lays a manikin anew that was moved
/// after its registration, by three of its landmarks.
class TouchTask
{
public:
    /// How far touches stray, at most, of a hand that takes care.
    static constexpr Length kHandFle = millimetres(2.0);

    /// @pre all outlive this.
    TouchTask(SiteEditor& editor, StylusWatch& watch, const LandmarkTask& landmarks);

    /// The landmark that is asked for: the chosen one, or the first that has no fresh touch.
    [[nodiscard]] std::optional<std::size_t> next() const;
    /// The landmark that shall be touched now, whatever the geometry says.
    void choose(std::optional<std::size_t> landmark);

    /// The touch of a landmark that counts; null where there is none.
    [[nodiscard]] const TouchedPoint* touchOf(const Landmark& landmark) const;

    /// Does nothing where no landmark is asked for.
    void take(const StylusTouch& touch);

    /// Why a manikin that was moved cannot be laid anew, in a sentence; empty where it can be.
    [[nodiscard]] QString whyNoRelay() const;
    /// The manikin was moved: its landmarks are touched again, until they tell where it lies.
    /// Refused where whyNoRelay() says why.
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
    [[nodiscard]] bool isLoose(const ReRegistration& relay) const;
    void relayIfItTells();

    SiteEditor& m_editor;
    StylusWatch& m_watch;
    const LandmarkTask& m_landmarks;
    std::optional<std::size_t> m_chosen;
};

} // namespace carina
