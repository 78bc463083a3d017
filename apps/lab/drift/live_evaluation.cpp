#include "apps/lab/drift/live_evaluation.h"

#include "engine/geometry/rotation.h"
#include "evaluation/drift/shown_actions.h"

#include <algorithm>
#include <cmath>

namespace carina::lab
{
namespace
{

/// The poses of both objects as the actor declared them.
class DeclaredMotion
{
public:
    DeclaredMotion(const ActionScript& script, std::span<const DeclaredAction> actions)
        : m_script{script}, m_actions{actions}
    {
    }

    [[nodiscard]] LocalTime begin() const { return m_actions.front().turnedSince; }
    /// When the objects were asked to stop.
    [[nodiscard]] LocalTime end() const { return m_actions.back().called; }
    [[nodiscard]] LocalTime beginOf(int action) const
    {
        return m_actions[static_cast<std::size_t>(action)].turnedSince;
    }
    [[nodiscard]] LocalTime endOf(int action) const
    {
        return std::min(m_actions[static_cast<std::size_t>(action) + 1].turnedSince, end());
    }

    /// @pre begin() <= t < end(), here and below
    [[nodiscard]] Quat q_AO(LocalTime t) const
    {
        const std::size_t action = inForce(&DeclaredAction::turnedSince, t);
        const DeclaredAction& declared = m_actions[action];
        const EventCpo event = m_script.rotation(static_cast<int>(action));
        const double seconds = toSeconds(t - declared.turnedSince);
        return rotationFromVector(seconds * double{event.rate} * event.axis_A.cast<double>())
               * declared.q_AO;
    }
    [[nodiscard]] Vec3 p_AO(LocalTime t) const
    {
        const std::size_t action = inForce(&DeclaredAction::movedSince, t);
        const DeclaredAction& declared = m_actions[action];
        const EventCpo event = m_script.translation(static_cast<int>(action));
        const double seconds = std::max(0.0, toSeconds(t - declared.movedSince));
        return declared.p_AO + seconds * double{event.rate} * event.axis_A.cast<double>();
    }

private:
    [[nodiscard]] std::size_t inForce(LocalTime DeclaredAction::*since, LocalTime t) const
    {
        const auto moving = m_actions.first(m_actions.size() - 1); // without the one that stops
        const auto after = std::ranges::upper_bound(moving, t, {}, since);
        return static_cast<std::size_t>(std::max(after - moving.begin() - 1, std::ptrdiff_t{0}));
    }

    const ActionScript& m_script;
    std::span<const DeclaredAction> m_actions;
};

bool isWhole(const LiveLog& log, const DeclaredMotion& truth)
{
    return !log.samples.empty() && log.samples.front().machine <= truth.begin()
           && log.samples.back().machine >= truth.end() && log.samples.back().X_AO_turned
           && log.samples.back().X_AO_moved;
}

/// The samples from one time up to, not at, another.
std::span<const LiveSample> samplesIn(const LiveLog& log, LocalTime from, LocalTime to)
{
    const auto first = std::ranges::lower_bound(log.samples, from, {}, &LiveSample::machine);
    const auto last = std::ranges::lower_bound(log.samples, to, {}, &LiveSample::machine);
    return {first, std::max(first, last)};
}

/// The session time of the host at a time of the machine, from its samples around it.
std::optional<SessionTime> hostTime(const LiveLog& host, LocalTime t)
{
    const auto after = std::ranges::upper_bound(host.samples, t, {}, &LiveSample::machine);
    if (after == host.samples.begin() || after == host.samples.end())
        return std::nullopt;
    const LiveSample& a = *std::prev(after);
    const LiveSample& b = *after;
    if (!a.session || !b.session)
        return std::nullopt;
    const double share = toSeconds(t - a.machine) / toSeconds(b.machine - a.machine);
    return *a.session + fromSeconds(share * toSeconds(*b.session - *a.session));
}

struct Mean {
    double sum = 0.0;
    int count = 0;

    void add(double value) { sum += value, ++count; }
    [[nodiscard]] double value() const { return count > 0 ? sum / count : 0.0; }
};

double p95Of(std::vector<double> values)
{
    if (values.empty())
        return 0.0;
    const auto rank =
        static_cast<std::ptrdiff_t>(std::ceil(0.95 * static_cast<double>(values.size()))) - 1;
    std::ranges::nth_element(values, values.begin() + rank);
    return values[static_cast<std::size_t>(rank)];
}

/// What is shown of an object of which nothing is known is where it was to begin with.
Quat turnedIn(const LiveSample& sample)
{
    return sample.X_AO_turned ? sample.X_AO_turned->rotation() : Quat::Identity();
}
Vec3 movedIn(const LiveSample& sample)
{
    return sample.X_AO_moved ? sample.X_AO_moved->translation() : Vec3::Zero();
}

/// What a viewer saw of the actions that it showed.
ShownActions shownOf(const LiveLog& viewer, const ActionScript& script, const DeclaredMotion& truth)
{
    ShownActions shown;
    for (int action = 0; action < script.actions(); ++action) {
        const LocalTime end = truth.endOf(action);
        const auto samples = samplesIn(viewer, truth.beginOf(action), end);
        if (samples.empty())
            continue;
        for (const LiveSample& seen : samples) {
            shown.addSample(angleBetween(truth.q_AO(seen.machine), turnedIn(seen)).si);
            if (seen.machine <= end - ShownActions::kLook)
                shown.look(turnedIn(seen));
        }
        shown.endAction(turnedIn(samples.back()), script.rotation(action).axis_A.cast<double>());
    }
    return shown;
}

void addShown(const LiveRun& run, const ActionScript& script, const DeclaredMotion& truth,
              DriftFigures& figures)
{
    std::vector<ShownActions> shown;
    for (std::size_t viewer = 1; viewer < run.participants.size(); ++viewer) {
        shown.push_back(shownOf(run.participants[viewer], script, truth));
        figures.lost += shown.back().lost();
    }
    figures.timeAverageShown = meanShown(shown);
}

void addOverTime(const LiveRun& run, const DeclaredMotion& truth, DriftFigures& figures)
{
    std::vector<double> angles;
    Mean angle;
    Mean distance;
    for (std::size_t viewer = 1; viewer < run.participants.size(); ++viewer) {
        for (const LiveSample& seen :
             samplesIn(run.participants[viewer], truth.begin(), truth.end())) {
            angles.push_back(angleBetween(truth.q_AO(seen.machine), turnedIn(seen)).si);
            angle.add(angles.back());
            distance.add((movedIn(seen) - truth.p_AO(seen.machine)).norm());
        }
    }
    figures.timeAverage = angle.value();
    figures.position = distance.value();
    figures.p95 = p95Of(std::move(angles));
}

/// Of each viewer's last sample of an action.
ActionDrift driftAtEndOf(const LiveRun& run, const DeclaredMotion& truth, int action)
{
    Mean angle;
    Mean rawAngle;
    Mean distance;
    for (std::size_t viewer = 1; viewer < run.participants.size(); ++viewer) {
        const auto samples =
            samplesIn(run.participants[viewer], truth.begin(), truth.endOf(action));
        if (samples.empty())
            continue;
        const LiveSample& seen = samples.back();
        const Quat q = truth.q_AO(seen.machine);
        angle.add(angleBetween(q, turnedIn(seen)).si);
        rawAngle.add(2.0 * std::acos(std::clamp((q * turnedIn(seen).conjugate()).w(), -1.0, 1.0)));
        distance.add((movedIn(seen) - truth.p_AO(seen.machine)).norm());
    }
    return {angle.value(), rawAngle.value(), distance.value()};
}

std::optional<double> clockErrorOf(const LiveRun& run, const DeclaredMotion& truth)
{
    Mean error;
    for (const LiveLog& log : run.participants) {
        for (int action = 0; action < run.settings.actions; ++action) {
            const auto samples = samplesIn(log, truth.begin(), truth.endOf(action));
            if (samples.empty() || !samples.back().session)
                continue;
            if (const auto host = hostTime(run.host, samples.back().machine))
                error.add(std::abs(toSeconds(*samples.back().session - *host)));
        }
    }
    return error.count > 0 ? std::optional{error.value()} : std::nullopt;
}

/// How long the actor waited to see what it began.
double responseOf(const LiveRun& run)
{
    Mean wait;
    for (int action = 0; action < run.settings.actions; ++action) {
        const auto& declared = run.participants.front().actions[static_cast<std::size_t>(action)];
        wait.add(toSeconds(declared.turnedSince - declared.called));
    }
    return wait.value();
}

void addLimits(const LiveRun& run, const ActionScript& script, DriftFigures& figures)
{
    Mean limit;
    Mean positionLimit;
    const double whole = toSeconds(ActionScript::kActionTime);
    for (int action = 0; action < script.actions(); ++action) {
        for (std::size_t viewer = 2; viewer <= run.participants.size(); ++viewer) {
            const Duration least = run.leastDelay(viewer, ActionScript::startOf(action));
            const double d = std::min(toSeconds(least), whole);
            limit.add(script.changeOfAngularVelocity(action) * d * d / (2.0 * whole));
            positionLimit.add(script.changeOfVelocity(action) * d * d / (2.0 * whole));
        }
    }
    figures.limit = limit.value();
    figures.positionLimit = positionLimit.value();
}

bool areAlike(const LiveLog& a, const LiveLog& b)
{
    const LiveSample& x = a.samples.back();
    const LiveSample& y = b.samples.back();
    return x.X_AO_turned->matrix() == y.X_AO_turned->matrix()
           && x.X_AO_moved->matrix() == y.X_AO_moved->matrix();
}

double gapP95Of(const LiveRun& run)
{
    std::vector<double> gaps;
    for (const LiveLog& log : run.participants)
        for (std::size_t i = 1; i < log.samples.size(); ++i)
            gaps.push_back(toSeconds(log.samples[i].machine - log.samples[i - 1].machine));
    return p95Of(std::move(gaps));
}

Result<void> checkStrategies(const LiveRun& run)
{
    const auto isAnother = [&](const LiveLog& log) { return log.strategy != run.strategy; };
    if (isAnother(run.host))
        return fail(Errc::FileMalformed, "the host ran another strategy");
    const auto found = std::ranges::find_if(run.participants, isAnother);
    if (found == run.participants.end())
        return {};
    const auto number = found - run.participants.begin() + 1;
    return fail(Errc::FileMalformed,
                "participant " + std::to_string(number) + " ran another strategy");
}

Result<void> checkLogs(const LiveRun& run)
{
    const auto incomplete = [](const std::string& who) {
        return fail(Errc::FileMalformed, "the log of " + who + " is incomplete");
    };
    const LiveLog& actor = run.participants.front();
    const auto isDated = [](const DeclaredAction& action) {
        return action.turnedSince > LocalTime{} && action.movedSince > LocalTime{};
    };
    if (actor.actions.size() != static_cast<std::size_t>(run.settings.actions) + 1
        || !std::ranges::all_of(actor.actions, isDated))
        return incomplete("participant 1");
    const ActionScript script{run.settings, run.seed};
    const DeclaredMotion truth{script, actor.actions};
    if (!isWhole(run.host, truth))
        return incomplete("the host");
    for (std::size_t i = 0; i < run.participants.size(); ++i)
        if (!isWhole(run.participants[i], truth))
            return incomplete("participant " + std::to_string(i + 1));
    return checkStrategies(run);
}

} // namespace

Result<LiveFigures> evaluateLive(const LiveRun& run)
{
    if (const auto checked = checkLogs(run); !checked)
        return tl::unexpected(checked.error());
    const ActionScript script{run.settings, run.seed};
    const DeclaredMotion truth{script, run.participants.front().actions};
    LiveFigures figures;
    addOverTime(run, truth, figures.drift);
    addShown(run, script, truth, figures.drift);
    for (int action = 0; action < script.actions(); ++action) {
        figures.drift.actions.push_back(driftAtEndOf(run, truth, action));
        figures.drift.atEvent += figures.drift.actions.back().angle / script.actions();
    }
    figures.drift.clockError = clockErrorOf(run, truth);
    figures.drift.response = responseOf(run);
    addLimits(run, script, figures.drift);
    figures.isEndStateSame = std::ranges::all_of(
        run.participants, [&](const LiveLog& log) { return areAlike(log, run.host); });
    const auto count = static_cast<Duration::rep>(run.participants.size());
    for (const LiveLog& log : run.participants) {
        figures.handshakeMean += log.handshake / count;
        figures.handshakeMax = std::max(figures.handshakeMax, log.handshake);
    }
    figures.gapP95 = fromSeconds(gapP95Of(run));
    return figures;
}

} // namespace carina::lab
