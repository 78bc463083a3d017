#include "engine/session/simulated_station.h"

#include "engine/anatomy/airway/airway_measure.h"
#include "engine/geometry/rotation.h"
#include "engine/session/simulated_tools.h"
#include "engine/tracking/simulated/scripted_hands.h"

#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>

namespace carina
{

namespace
{

/// In front of the carina, on the sternum.
const Vec3 kMarker_A{0.0, -0.11, -0.02};

/// Up by a half sine in a third of a breath, down in the next, and at rest.
double chestRise(Frequency rate, SessionTime t)
{
    const double breaths = rate.si * toSeconds(t.time_since_epoch());
    const double third = 3.0 * (breaths - std::floor(breaths));
    return third < 2.0 ? 0.5 * kManikinRise.si * (1.0 - std::cos(std::numbers::pi * third)) : 0.0;
}

/// How much of a period a person is ahead of the one before: the golden ratio keeps any number of
/// them apart.
constexpr double kAhead = 0.618033988749895;
/// Where people stand around the patient's head: person 0 behind it, the next to the left of that
/// and to the right, about the vertical axis of a lying patient through the incisors. Farther to
/// the right the head is out of the tracker's working volume, which is to the patient's left.
constexpr std::array kPlaces{degrees(0.0), degrees(45.0), degrees(-45.0), degrees(90.0),
                             degrees(135.0)};

/// X_AA' from where person 0 stands.
RigidTransform standing(unsigned person, const Vec3& p_A_incisors)
{
    const Angle place = kPlaces[person % kPlaces.size()];
    return RigidTransform::translation(p_A_incisors)
           * RigidTransform{rotationFromVector(place.si * Vec3::UnitY()), Vec3::Zero()}
           * RigidTransform::translation(-p_A_incisors);
}

/// The hands and the head of one of several people.
TrueToolPose of(SimulatedPerson person, TrueToolPose hands, const HandScript& script)
{
    if (!person)
        return hands;
    return [person = std::move(person), hands = std::move(hands), X_TA = script.X_TA,
            X_AT = script.X_TA.inverse(), p_A_incisors = script.p_A_incisors,
            period = script.period](ToolRole tool, SessionTime t) -> std::optional<RigidTransform> {
        const unsigned number = person();
        const double ahead = kAhead * number - std::floor(kAhead * number);
        auto X_TO = hands(tool, t + fromSeconds(ahead * toSeconds(period)));
        if (X_TO && tool == ToolRole::Head && number % kPlaces.size() != 0)
            X_TO = X_TA * standing(number, p_A_incisors) * X_AT * *X_TO;
        return X_TO;
    };
}

/// The hands, and what the manikin wears: a marker on its chest and a probe on its torso.
TrueToolPose withManikin(TrueToolPose hands, const RigidTransform& X_TA, Frequency rate)
{
    return [=](ToolRole tool, SessionTime t) -> std::optional<RigidTransform> {
        if (tool == ToolRole::Manikin)
            return X_TA * simulatedBodyProbe();
        if (tool != ToolRole::Chest)
            return hands(tool, t);
        return X_TA * RigidTransform::translation(kMarker_A - chestRise(rate, t) * Vec3::UnitY());
    };
}

/// The markers of a tool instead of its frame O.
TrueToolPose withMarkers(TrueToolPose hands, ToolRole marked, const RigidTransform& X_ON)
{
    return [hands = std::move(hands), marked, X_ON](ToolRole tool, SessionTime t) {
        auto X_TO = hands(tool, t);
        if (X_TO && tool == marked)
            X_TO = *X_TO * X_ON;
        return X_TO;
    };
}

/// How the neck of the simulated manikin lies now.
using NeckNow = std::function<NeckField()>;

NeckNow neckOf(const AirwayLandmarks& airway, SimulatedHead head)
{
    if (!head)
        return [] { return NeckField{}; };
    return [p_A_glottis = airway.p_A_glottis, p_A_incisors = airway.p_A_incisors,
            head = std::move(head)] {
        return NeckField{p_A_glottis, p_A_incisors, head()};
    };
}

HandScript scriptOf(const AirwayLandmarks& airway, const TubeShape& tube,
                    const RigidTransform& X_TA)
{
    return {.X_TA = X_TA,
            .path_A = airway.path_A,
            .p_A_incisors = airway.p_A_incisors,
            .p_E_centre = tube.p_E_centre,
            .restAboveCarina = tube.tipAboveCarina};
}

/// The hands that bring a tube into an airway as it lies. Those of the latest position are kept;
/// in one in which they cannot be made, those before go on. For several threads.
class HandsInAirway
{
public:
    HandsInAirway(const AirwayLandmarks& airway, TubeShape tube, const RigidTransform& X_TA,
                  const ScriptedHands& neutral)
        : m_airway{airway},
          m_tube{std::move(tube)},
          m_X_TA{X_TA},
          m_hands{std::make_shared<const ScriptedHands>(neutral)}
    {
        m_tube.pieces.clear(); // nothing is drawn of it
    }

    [[nodiscard]] std::shared_ptr<const ScriptedHands> in(const NeckField& neck)
    {
        const std::scoped_lock lock{m_mutex};
        if (neck.position() == m_position)
            return m_hands;
        m_position = neck.position();
        if (auto made =
                ScriptedHands::make(scriptOf(bent(m_airway, neck), bent(m_tube, neck), m_X_TA)))
            m_hands = std::make_shared<const ScriptedHands>(*std::move(made));
        return m_hands;
    }

private:
    std::mutex m_mutex;
    AirwayLandmarks m_airway;
    TubeShape m_tube;
    RigidTransform m_X_TA;
    HeadPosition m_position;                      ///< that they were last wanted in
    std::shared_ptr<const ScriptedHands> m_hands; ///< also of who calls them meanwhile
};

/// The hands, of which tube and what holds it go the way of the airway as it lies.
/// @param inAirway shared by the copies of what is returned
TrueToolPose withBentWay(const ScriptedHands& hands, std::shared_ptr<HandsInAirway> inAirway,
                         NeckNow neck)
{
    return [hands, inAirway = std::move(inAirway), neck = std::move(neck)](ToolRole tool,
                                                                           SessionTime t) {
        const bool isOfTube = tool == ToolRole::Tube || tool == ToolRole::Hand;
        return isOfTube ? (*inAirway->in(neck()))(tool, t) : hands(tool, t);
    };
}

/// The hands at a manikin whose jaw is where its head is.
TrueToolPose withNeck(TrueToolPose hands, NeckNow neck, const RigidTransform& X_TA)
{
    return [hands = std::move(hands), neck = std::move(neck), X_TA,
            X_AT = X_TA.inverse()](ToolRole tool, SessionTime t) {
        auto X_TO = hands(tool, t);
        if (const NeckField now = X_TO && tool == ToolRole::Jaw ? neck() : NeckField{};
            now.isBent())
            X_TO = X_TA * now.X_AU() * X_AT * *X_TO;
        return X_TO;
    };
}

/// The hands, which bring the tube in later, and a laryngoscope, which moves the jaw in the frame
/// of the head.
TrueToolPose withLaryngoscopy(TrueToolPose hands, LaryngoscopyScript script, NeckNow neck,
                              const RigidTransform& X_TA, const RigidTransform& X_AJ_closed)
{
    const Duration later = fromSeconds(kTubeAfterBlade * toSeconds(script.period));
    return [=, hands = std::move(hands), script = std::move(script),
            neck = std::move(neck)](ToolRole tool, SessionTime t) -> std::optional<RigidTransform> {
        switch (tool) {
        case ToolRole::Laryngoscope:
            return X_TA * scriptedLaryngoscopy(script, t, neck()).X_AL;
        case ToolRole::Jaw:
            return X_TA * scriptedLaryngoscopy(script, t, neck()).X_AJ * X_AJ_closed;
        case ToolRole::Tube:
        case ToolRole::Hand:
            return hands(tool, t - later);
        default:
            return hands(tool, t);
        }
    };
}

/// The hands, of which a motion moves tube, jaw and laryngoscope in the frame of the head, and the
/// stylus in that of the torso.
TrueToolPose withMotion(TrueToolPose hands, HandMotion motion, NeckNow neck,
                        const RigidTransform& X_TA, const RigidTransform& X_AJ_closed)
{
    return [=, hands = std::move(hands), motion = std::move(motion),
            neck = std::move(neck)](ToolRole tool, SessionTime t) -> std::optional<RigidTransform> {
        switch (tool) {
        case ToolRole::Tube:
            return X_TA * neck().X_AU() * motion(t).X_UE;
        case ToolRole::Hand:
            return X_TA * neck().X_AU() * motion(t).X_UE * handOnTube();
        case ToolRole::Laryngoscope:
            return X_TA * neck().X_AU() * motion(t).X_UL;
        case ToolRole::Jaw:
            return X_TA * neck().X_AU() * motion(t).X_UJ * X_AJ_closed;
        case ToolRole::Stylus: {
            const auto X_AS = motion(t).X_AS;
            return X_AS ? X_TA * *X_AS : hands(tool, t);
        }
        default:
            return hands(tool, t);
        }
    };
}

} // namespace

RigidTransform simulatedBodyProbe() { return RigidTransform::translation({-0.12, -0.06, 0.05}); }

Result<SimulatedStation> simulatedStation(const AirwayLandmarks& airway, const TubeShape& tube,
                                          ReadSessionClock clock,
                                          const std::optional<StationRegistration>& registration,
                                          Frequency manikinBreathes, SimulatedPerson person,
                                          SimulatedTrackerSettings device,
                                          const std::optional<LaryngoscopyScript>& laryngoscopy,
                                          SimulatedHead head, HandMotion motion)
{
    const RigidTransform X_TA = patientBeforeTracker(airway.p_A_incisors);
    const HandScript script = scriptOf(airway, tube, X_TA);
    auto hands = ScriptedHands::make(script);
    if (!hands)
        return tl::unexpected(hands.error());
    const StationRegistration exactly{.X_AT = X_TA.inverse(), .X_JA = hands->closedJaw().inverse()};
    device.handProbe = static_cast<bool>(person);
    const NeckNow neck = neckOf(airway, std::move(head));
    TrueToolPose done =
        withBentWay(*hands, std::make_shared<HandsInAirway>(airway, tube, X_TA, *hands), neck);
    if (device.laryngoscope && laryngoscopy)
        done = withLaryngoscopy(std::move(done), *laryngoscopy, neck, X_TA, hands->closedJaw());
    done = withNeck(std::move(done), neck, X_TA);
    done = of(std::move(person), std::move(done), script);
    if (motion)
        done = withMotion(std::move(done), std::move(motion), neck, X_TA, hands->closedJaw());
    TrueToolPose truth = withManikin(std::move(done), X_TA, manikinBreathes);
    const SimulatedTools marked = simulatedTools(tube);
    if (registration && registration->X_NE)
        truth = withMarkers(std::move(truth), ToolRole::Tube, marked.X_NE.inverse());
    if (registration && registration->X_NL)
        truth = withMarkers(std::move(truth), ToolRole::Laryngoscope, marked.X_NL.inverse());
    device.chestMarker = manikinBreathes.si > 0.0;
    device.bodyProbe = registration && registration->X_BA;
    auto tracker = std::make_unique<SimulatedTracker>(device, truth, std::move(clock));
    return SimulatedStation{.tracking = std::make_unique<StationTracking>(
                                std::move(tracker), registration.value_or(exactly)),
                            .X_TA = X_TA,
                            .exactly = exactly,
                            .truth = std::move(truth)};
}

} // namespace carina
