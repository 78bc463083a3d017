#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

#include <optional>
#include <span>

namespace carina
{

/// The drift of one viewer over the actions that it showed. Where the message of an action is lost
/// and not repeated, its drift is as large as chance has it and hides everything else in a short
/// run.
///
/// An action is shown if the object turns about its axis in the viewer's picture in the last
/// instants of the action. That after one that was not shown does not count either: its news finds
/// the object far off.
class ShownActions
{
public:
    /// How long before the end of an action look() is to be called.
    static constexpr Duration kLook = std::chrono::milliseconds{100};

    void addSample(double angle) { m_angles += angle, ++m_samples; }
    /// @param q_AO orientation of the object in the viewer's picture
    void look(const Quat& q_AO) { m_before = q_AO; }
    /// The next sample is of the next action. @param axis_A of the action that ended
    void endAction(const Quat& q_AO, const Vec3& axis_A);

    [[nodiscard]] int lost() const { return m_lost; } ///< actions that were not shown

private:
    friend std::optional<double> meanShown(std::span<const ShownActions> viewers);

    Quat m_before = Quat::Identity();
    bool m_wasShown = true; // the action before
    double m_angles = 0.0;  // of this action
    int m_samples = 0;
    double m_shownAngles = 0.0;
    int m_shownSamples = 0;
    int m_lost = 0;
};

/// Mean of the samples of all viewers; nothing where none is left.
[[nodiscard]] std::optional<double> meanShown(std::span<const ShownActions> viewers);

} // namespace carina
