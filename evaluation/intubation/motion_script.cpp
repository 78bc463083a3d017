#include "evaluation/intubation/motion_script.h"

#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

using enum MotionParameter;

// Of an adult, metres.
constexpr double kBeforeFork = 0.005;   ///< where the tip waits before the larynx
constexpr double kGivenUpBefore = 0.03; ///< the larynx
constexpr double kBackFromArytenoid = 0.010;
constexpr double kCuffFromTip = 0.015; ///< as that of makeTube
constexpr double kFullCuffTube = 0.0034;
constexpr double kCuffedTipFromCords = 0.005;           ///< at least, however small the tube
constexpr Length kConnectorOutside = millimetres(10.0); ///< of the teeth, at least; of ours

// Seconds.
constexpr double kLook = 1.0; ///< at the patient, before and after
constexpr double kToFace = 1.0;
constexpr double kTubeAway = 1.2;
constexpr double kPush = 0.6;
constexpr double kNeckMoves = 1.5;

// Shares of LaryngoscopyStep::Full, see MotionTracks::blade.
constexpr double kBladeAside = -2.0;
constexpr double kBladeReady = -1.0;
constexpr double kJawAroundTube = 0.45;

double inMetres(double mm) { return 1e-3 * mm; }

/// Writes down one motion, movement by movement. All movements begin at m_now, and what follows
/// begins when they have ended.
class MotionWriter
{
public:
    MotionWriter(const MotionParameters& parameters, const MotionPatient& patient,
                 const TubeShape& tube, TubeBending bending, double slower)
        : m_parameters{parameters},
          m_patient{patient},
          m_tube{tube},
          m_bending{bending},
          m_slower{slower}
    {
        wait(kLook);
    }

    void wait(double seconds) { m_now += m_slower * seconds; }

    void bladeIn()
    {
        const double each = m_parameters[BladeIn_s] / 4.0;
        move(m_tracks.blade, kBladeReady, kToFace);
        for (const double step : {0.0, 1.0, 2.0, 3.0})
            move(m_tracks.blade, step, each);
    }
    void look() { wait(m_parameters[View_s]); }
    void bladeOut()
    {
        const double each = m_parameters[BladeOut_s] / 3.0;
        for (const double step : {1.0, 0.0, kBladeReady})
            move(m_tracks.blade, step, each);
        move(m_tracks.blade, kBladeAside, kToFace);
    }
    void leverOnTeeth()
    {
        move(m_tracks.lever, degrees(m_parameters[Lever_deg]).si, kToFace);
        look();
    }
    void leverNoMore() { move(m_tracks.lever, 0.0, 0.5 * kToFace); }

    /// The tube before the larynx, on the way to a target from then on.
    void tubeToLarynx(TipTarget target)
    {
        turnTo(target);
        move(m_tracks.tip, beforeFork(), m_parameters[TubeIn_s]);
        wait(m_parameters[Hesitation_s]);
    }
    void tubeTowardsLarynx()
    {
        move(m_tracks.tip, beforeFork() - size() * kGivenUpBefore, m_parameters[TubeIn_s]);
        wait(m_parameters[Hesitation_s]);
    }
    /// From before the larynx to a place on a way, metres from the start of that way, or as far as
    /// the tube can be pushed.
    void tubeOn(TipTarget target, double along)
    {
        const TipWay& way = m_patient.way(target);
        turnTo(target);
        move(m_tracks.tip, reached(way, along) - way.teeth, m_parameters[Through_s]);
        fitJaw();
    }
    void tubeOut()
    {
        act(MotionAct::BreathsEnd, MotionAct::BreathsBegin);
        act(MotionAct::CuffDeflated, MotionAct::CuffInflated);
        move(m_tracks.tip, HandTrack{MotionTracks{}.tip}.last(), kTubeAway);
        m_tracks.jaw.waitUntil(m_now);
        move(m_tracks.jaw, 0.0, kToFace);
    }
    void pushAtArytenoid()
    {
        const TipWay& way = m_patient.way(TipTarget::Arytenoid);
        const double end = way.end - way.teeth;
        turnTo(TipTarget::Arytenoid);
        move(m_tracks.tip, end, kPush);
        for (int push = 0; push < static_cast<int>(std::lround(m_parameters[Pushes])); ++push) {
            move(m_tracks.tip, end - m_patient.upper.larynxSize() * kBackFromArytenoid, kPush);
            move(m_tracks.tip, end, kPush);
        }
        move(m_tracks.tip, beforeFork(), kPush);
        wait(m_parameters[Hesitation_s]);
    }

    void takeStyletOut() { command(MotionAct::StyletOut); }
    void secure()
    {
        wait(m_parameters[ToCuff_s]);
        command(MotionAct::CuffInflated);
        wait(m_parameters[ToBreath_s]);
        command(MotionAct::BreathsBegin);
    }
    void flexNeck() { move(m_tracks.flexion, degrees(m_parameters[Flexion_deg]).si, kNeckMoves); }

    /// Along the trachea's way to the usual depth, or so much deeper.
    [[nodiscard]] double usualDepth() const
    {
        return m_patient.way(TipTarget::Trachea).carina - m_tube.tipAboveCarina.si
               + windpipe() * inMetres(m_parameters[Deeper_mm]);
    }
    [[nodiscard]] double beyondCarina(TipTarget target) const
    {
        return m_patient.way(target).carina + windpipe() * inMetres(m_parameters[Bronchus_mm]);
    }
    [[nodiscard]] double inOesophagus() const
    {
        return m_patient.way(TipTarget::Oesophagus).gate
               + windpipe() * inMetres(m_parameters[Oesophagus_mm]);
    }
    [[nodiscard]] double cuffInCords() const
    {
        return m_patient.way(TipTarget::Trachea).gate
               + windpipe() * inMetres(m_parameters[Cords_mm]);
    }
    [[nodiscard]] double cuffOverCords() const
    {
        const double cuff =
            kCuffFromTip * std::min(0.5 * m_tube.outerDiameter.si / kFullCuffTube, 1.0);
        return m_patient.way(TipTarget::Trachea).gate
               + std::max(m_parameters[Tip_share] * cuff, kCuffedTipFromCords);
    }

    [[nodiscard]] Result<IntubationMotion> done(std::shared_ptr<const MotionPatient> patient,
                                                TubeShape tube, std::uint32_t seed) &&
    {
        wait(kLook);
        std::mt19937 random{seed};
        const double share = m_parameters[Tremor_mm] * size();
        const double sway = m_parameters[Sway_mm] * size();
        MotionGrip grip{.roll = degrees(m_parameters[Roll_deg]),
                        .corner_A = -size() * inMetres(m_parameters[Corner_mm]) * Vec3::UnitX(),
                        .lift = m_parameters[Lift_share] * kUsualLift,
                        .bending = m_bending};
        grip.tubeHand = {inMetres(share), inMetres(sway), random};
        grip.bladeHand = {inMetres(share), inMetres(sway), random};
        const Blade& blade = motionBlade(patient->upper);
        return IntubationMotion::make(std::move(patient), std::move(tube), blade,
                                      std::move(m_tracks), grip, std::move(m_commands),
                                      fromSeconds(m_now));
    }

private:
    [[nodiscard]] double size() const { return m_patient.upper.size(); }
    [[nodiscard]] double windpipe() const { return m_patient.upper.windpipeSize(); }
    [[nodiscard]] double beforeFork() const
    {
        const TipWay& way = m_patient.way(TipTarget::Trachea);
        return way.fork - way.teeth - size() * kBeforeFork;
    }

    /// The place, or the last one before it with the connector in front of the lips.
    [[nodiscard]] double reached(const TipWay& way, double along) const
    {
        constexpr double kEach = 1e-3;
        const Length most = lengthOf(m_tube.p_E_centre) - kConnectorOutside;
        const auto isPossible = [&] {
            const auto inside = tubeInside(m_patient, m_tube, m_bending, way, along);
            return inside && *inside <= most;
        };
        while (along > way.fork && !isPossible())
            along -= kEach;
        return along;
    }
    void move(HandTrack& track, double to, double seconds)
    {
        track.waitUntil(m_now);
        track.moveTo(to, m_slower * seconds);
        m_now = track.end();
    }
    void turnTo(TipTarget target)
    {
        if (m_tracks.turns.back().target != target)
            m_tracks.turns.push_back({m_now, target});
    }
    /// The jaw is to close around the tube when the blade leaves it: nothing of it is seen before.
    void fitJaw()
    {
        m_tracks.jaw.waitUntil(m_now);
        m_tracks.jaw.moveTo(kJawAroundTube, kToFace);
        m_now = m_tracks.jaw.end();
    }
    void command(MotionAct act) { m_commands.push_back({act, fromSeconds(m_now)}); }
    /// Ends what began.
    void act(MotionAct ends, MotionAct begun)
    {
        const auto last = std::ranges::find_if(
            m_commands.rbegin(), m_commands.rend(),
            [&](const MotionCommand& c) { return c.act == begun || c.act == ends; });
        if (last != m_commands.rend() && last->act == begun)
            command(ends);
    }

    const MotionParameters& m_parameters;
    const MotionPatient& m_patient;
    const TubeShape& m_tube;
    TubeBending m_bending;
    double m_slower;
    double m_now = 0.0;
    MotionTracks m_tracks;
    std::vector<MotionCommand> m_commands;
};

/// With the blade in the mouth: to a place, and the tube is left there.
void intubate(MotionWriter& hands, TipTarget target, double along)
{
    hands.tubeToLarynx(target);
    hands.tubeOn(target, along);
    hands.takeStyletOut();
    hands.bladeOut();
    hands.secure();
}

void lookAndIntubate(MotionWriter& hands, TipTarget target, double along)
{
    hands.bladeIn();
    hands.look();
    intubate(hands, target, along);
}

void threeAttempts(MotionWriter& hands)
{
    hands.bladeIn();
    hands.look();
    hands.tubeTowardsLarynx();
    hands.tubeOut();
    hands.bladeOut();
    hands.wait(kLook);
    hands.bladeIn();
    hands.look();
    hands.tubeToLarynx(TipTarget::Oesophagus);
    hands.tubeOn(TipTarget::Oesophagus, hands.inOesophagus());
    hands.wait(kLook);
    hands.tubeOut();
    hands.bladeOut();
    hands.wait(kLook);
    lookAndIntubate(hands, TipTarget::Trachea, hands.usualDepth());
}

void write(MotionWriter& hands, MotionKind kind, const MotionParameters& parameters)
{
    switch (kind) {
    case MotionKind::Good:
    case MotionKind::Slow:
        return lookAndIntubate(hands, TipTarget::Trachea, hands.usualDepth());
    case MotionKind::Oesophageal:
        return lookAndIntubate(hands, TipTarget::Oesophagus, hands.inOesophagus());
    case MotionKind::RightMainstem:
        return lookAndIntubate(hands, TipTarget::RightMain,
                               hands.beyondCarina(TipTarget::RightMain));
    case MotionKind::LeftMainstem:
        return lookAndIntubate(hands, TipTarget::LeftMain, hands.beyondCarina(TipTarget::LeftMain));
    case MotionKind::ThreeAttempts:
        return threeAttempts(hands);
    case MotionKind::DentalLever:
        hands.bladeIn();
        hands.leverOnTeeth();
        hands.leverNoMore();
        return intubate(hands, TipTarget::Trachea, hands.usualDepth());
    case MotionKind::TooShallow:
        return lookAndIntubate(hands, TipTarget::Trachea, hands.cuffInCords());
    case MotionKind::NeckFlexed:
        lookAndIntubate(hands, TipTarget::Trachea, hands.usualDepth());
        hands.wait(kLook);
        hands.flexNeck();
        return hands.wait(2.0 * kLook); // for the tube to rest
    case MotionKind::StuckAtArytenoid:
        hands.bladeIn();
        hands.look();
        hands.tubeToLarynx(TipTarget::Arytenoid);
        hands.pushAtArytenoid();
        return intubate(hands, TipTarget::Trachea, hands.usualDepth());
    case MotionKind::CuffAboveCords:
        return lookAndIntubate(hands, TipTarget::Trachea, hands.cuffOverCords());
    case MotionKind::LateRecognition:
        lookAndIntubate(hands, TipTarget::Oesophagus, hands.inOesophagus());
        hands.wait(parameters[Recognised_s]);
        hands.tubeOut();
        return lookAndIntubate(hands, TipTarget::Trachea, hands.usualDepth());
    }
}

} // namespace

std::mt19937 generatorOf(MotionKind kind, std::uint32_t seed)
{
    std::seed_seq seeds{seed, static_cast<std::uint32_t>(kind)};
    return std::mt19937{seeds};
}

Result<IntubationMotion> scriptedMotion(MotionKind kind, const MotionParameters& parameters,
                                        std::shared_ptr<const MotionPatient> patient,
                                        TubeShape tube, std::uint32_t seed, TubeBending bending)
{
    const double slower = kind == MotionKind::Slow ? parameters[Slower] : 1.0;
    const std::shared_ptr<const MotionPatient> kept = patient;
    const TubeShape shape = tube;
    MotionWriter hands{parameters, *kept, shape, bending, slower};
    write(hands, kind, parameters);
    return std::move(hands).done(std::move(patient), std::move(tube), seed);
}

} // namespace carina
