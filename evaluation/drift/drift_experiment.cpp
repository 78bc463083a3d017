#include "evaluation/drift/drift_experiment.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"
#include "evaluation/drift/drawn_views.h"
#include "evaluation/drift/shown_actions.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace carina
{
namespace
{

/// Both objects are at rest and known to all from about here on, or from the start.
constexpr Duration kRestFrom = std::chrono::seconds{-5};
/// No simple fraction of an action or of a tick, so that samples meet all phases of both.
constexpr Duration kSampleInterval = std::chrono::nanoseconds{1'000'703};

/// One run on its way.
class DriftRun
{
public:
    explicit DriftRun(const DriftSettings& settings)
        : m_settings{settings},
          m_script{settings.script, settings.seed},
          m_star{*settings.strategy, settings.participants, settings.scenario, settings.legs,
                 settings.seed,      -settings.warmUp,      choiceOf(settings)},
          m_views{m_star, settings.scenario.frames, settings.seed},
          m_shown(settings.participants - 1U)
    {
    }

    DriftFigures run()
    {
        // At another phase of everybody's ticks in each run.
        std::mt19937 random{m_settings.seed};
        const Duration phase{static_cast<Duration::rep>(random() % 1'000'000'000U)};
        act(-1, std::max(kRestFrom - phase, -m_settings.warmUp));
        m_star.runTo(Duration{-1});
        const VirtualStar::Traffic before = m_star.traffic();
        Duration sample{};
        for (int action = 0; action < m_script.actions(); ++action) {
            act(action, ActionScript::startOf(action));
            addResponse(action);
            addLimit(action);
            const Duration end = ActionScript::startOf(action + 1);
            for (; sample < end - ShownActions::kLook; sample += kSampleInterval)
                addSample(sample);
            for (std::size_t i = 0; i < m_shown.size(); ++i)
                m_shown[i].look(m_views.turned(static_cast<std::uint16_t>(i + 2)).rotation());
            for (; sample < end; sample += kSampleInterval)
                addSample(sample);
            addEndOfAction(action, end - Duration{1});
        }
        return figures(before);
    }

private:
    static StrategyChoice choiceOf(const DriftSettings& settings)
    {
        return {.kind = settings.strategy->kind,
                .asa = settings.asa,
                .longestLag = settings.longestLag};
    }

    void act(int action, Duration t)
    {
        m_star.act(m_script.rotation(action), t);
        m_star.act(m_script.translation(action), t);
    }

    /// The pose of an object in the actor's own view.
    RigidTransform actors(ObjectId object, Duration t) const
    {
        const auto shown = m_star.shown(1, object, t);
        return shown ? shown->acted.X_AO : RigidTransform{};
    }

    double angleOf(std::uint16_t viewer, const Quat& truth) const
    {
        return angleBetween(truth, m_views.turned(viewer).rotation()).si;
    }

    double rawAngleOf(std::uint16_t viewer, const Quat& truth) const
    {
        const Quat shown = m_views.turned(viewer).rotation();
        return 2.0 * std::acos(std::clamp((truth * shown.conjugate()).w(), -1.0, 1.0));
    }

    double distanceOf(std::uint16_t viewer, const Vec3& truth) const
    {
        return (m_views.moved(viewer).translation() - truth).norm();
    }

    void addSample(Duration t)
    {
        m_views.runTo(t);
        const Quat q = actors(ActionScript::kTurned, t).rotation();
        const Vec3 p = actors(ActionScript::kMoved, t).translation();
        for (std::uint16_t viewer = 2; viewer <= m_star.participants(); ++viewer) {
            m_angles.push_back(angleOf(viewer, q));
            m_shown[viewer - 2U].addSample(m_angles.back());
            m_position += distanceOf(viewer, p);
        }
    }

    void addEndOfAction(int action, Duration t)
    {
        m_views.runTo(t);
        const Quat q = actors(ActionScript::kTurned, t).rotation();
        const Vec3 p = actors(ActionScript::kMoved, t).translation();
        const double viewers = m_star.participants() - 1;
        ActionDrift mean;
        for (std::uint16_t viewer = 2; viewer <= m_star.participants(); ++viewer) {
            mean.angle += angleOf(viewer, q) / viewers;
            mean.rawAngle += rawAngleOf(viewer, m_script.q_AO(t)) / viewers;
            mean.distance += distanceOf(viewer, p) / viewers;
            m_shown[viewer - 2U].endAction(m_views.turned(viewer).rotation(),
                                           m_script.rotation(action).axis_A.cast<double>());
        }
        m_actions.push_back(mean);
        for (std::uint16_t id = 1; id <= m_star.participants(); ++id) {
            if (const auto error = m_star.clockError(id, t)) {
                m_clockError += std::abs(toSeconds(*error));
                ++m_clockReadings;
            }
        }
    }

    /// How long the actor waits to see an action that it just began.
    void addResponse(int action)
    {
        const Duration t = ActionScript::startOf(action);
        const auto axisAfter = [&](Duration after) {
            return m_star.shown(1, ActionScript::kTurned, t + after)->axis_A;
        };
        Duration before{-1};
        Duration seen = kLongestLocalLag;
        const Vec3 begun = axisAfter(seen);
        if (m_script.changeOfAngularVelocity(action) == 0.0)
            return; // nobody can see it begin
        while (seen - before > Duration{1}) {
            const Duration middle = before + (seen - before) / 2;
            (axisAfter(middle) == begun ? seen : before) = middle;
        }
        m_response += toSeconds(seen);
        ++m_responses;
    }

    void addLimit(int action)
    {
        const double whole = toSeconds(ActionScript::kActionTime);
        for (std::uint16_t viewer = 2; viewer <= m_star.participants(); ++viewer) {
            const Duration least = m_star.leastDelay(viewer, ActionScript::startOf(action));
            const double d = std::min(toSeconds(least), whole);
            m_limit += m_script.changeOfAngularVelocity(action) * d * d / (2.0 * whole);
            m_positionLimit += m_script.changeOfVelocity(action) * d * d / (2.0 * whole);
        }
    }

    DriftFigures figures(const VirtualStar::Traffic& before)
    {
        const double seconds = toSeconds(ActionScript::startOf(m_script.actions()));
        const double events = double(m_script.actions()) * (m_star.participants() - 1);
        const auto samples = static_cast<double>(m_angles.size());
        const VirtualStar::Traffic after = m_star.traffic();
        DriftFigures figures;
        for (const ActionDrift& action : m_actions)
            figures.atEvent += action.angle / static_cast<double>(m_actions.size());
        for (const double angle : m_angles)
            figures.timeAverage += angle / samples;
        const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.95 * samples)) - 1;
        std::ranges::nth_element(m_angles, m_angles.begin() + rank);
        figures.p95 = m_angles[static_cast<std::size_t>(rank)];
        figures.position = m_position / samples;
        figures.limit = m_limit / events;
        figures.positionLimit = m_positionLimit / events;
        figures.actions = std::move(m_actions);
        figures.timeAverageShown = meanShown(m_shown);
        for (const ShownActions& shown : m_shown)
            figures.lost += shown.lost();
        figures.response = m_responses > 0 ? m_response / m_responses : 0.0;
        if (m_clockReadings > 0)
            figures.clockError = m_clockError / m_clockReadings;
        // Each datagram is between the host and one participant.
        figures.bytesPerSecond =
            static_cast<double>(after.bytes - before.bytes) / (seconds * m_star.participants());
        figures.probesPerSecond = static_cast<double>(after.probes - before.probes) / seconds;
        return figures;
    }

    const DriftSettings& m_settings;
    ActionScript m_script;
    VirtualStar m_star;
    DrawnViews m_views;
    std::vector<double> m_angles;
    double m_position = 0.0;
    std::vector<ActionDrift> m_actions;
    std::vector<ShownActions> m_shown; // of participant 2 and on
    double m_limit = 0.0;
    double m_positionLimit = 0.0;
    double m_response = 0.0;
    int m_responses = 0;
    double m_clockError = 0.0;
    int m_clockReadings = 0;
};

void addShare(ActionDrift& sum, const ActionDrift& one, double share)
{
    sum.angle += share * one.angle;
    sum.rawAngle += share * one.rawAngle;
    sum.distance += share * one.distance;
}

} // namespace

DriftFigures runDrift(const DriftSettings& settings)
{
    CARINA_EXPECTS(settings.strategy != nullptr && settings.participants >= 2);
    return DriftRun{settings}.run();
}

DriftFigures runDrift(DriftSettings settings, int seeds)
{
    CARINA_EXPECTS(seeds >= 1);
    DriftFigures mean;
    mean.actions.resize(static_cast<std::size_t>(settings.script.actions));
    double shown = 0.0;
    int runsShown = 0;
    for (int i = 0; i < seeds; ++i, ++settings.seed) {
        const DriftFigures one = runDrift(settings);
        mean.atEvent += one.atEvent / seeds;
        mean.timeAverage += one.timeAverage / seeds;
        mean.p95 += one.p95 / seeds;
        mean.position += one.position / seeds;
        mean.limit += one.limit / seeds;
        mean.positionLimit += one.positionLimit / seeds;
        mean.response += one.response / seeds;
        mean.lost += one.lost / seeds;
        if (one.timeAverageShown)
            shown += *one.timeAverageShown, ++runsShown;
        if (one.clockError)
            mean.clockError = mean.clockError.value_or(0.0) + *one.clockError / seeds;
        mean.bytesPerSecond += one.bytesPerSecond / seeds;
        mean.probesPerSecond += one.probesPerSecond / seeds;
        for (std::size_t action = 0; action < one.actions.size(); ++action)
            addShare(mean.actions[action], one.actions[action], 1.0 / seeds);
    }
    if (runsShown > 0)
        mean.timeAverageShown = shown / runsShown;
    return mean;
}

} // namespace carina
