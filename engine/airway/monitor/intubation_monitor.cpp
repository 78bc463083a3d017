#include "engine/airway/monitor/intubation_monitor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace carina
{
namespace
{

using std::chrono::milliseconds;

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr CrossingRule kBladeRule{.band = 3e-3,
                                  .sure = 15e-3,
                                  .dwellIn = milliseconds{200},
                                  .dwellOut = IntubationMonitor::kBetweenAttempts,
                                  .keepsIn = true};
constexpr CrossingRule kTeethRule{
    .band = 3e-3, .sure = 15e-3, .dwellIn = milliseconds{200}, .dwellOut = milliseconds{400}};
constexpr CrossingRule kCordsRule{
    .band = 2e-3, .sure = 8e-3, .dwellIn = milliseconds{400}, .dwellOut = milliseconds{400}};
constexpr CrossingRule kCarinaRule{
    .band = 2e-3, .sure = 6e-3, .dwellIn = milliseconds{500}, .dwellOut = milliseconds{500}};
constexpr CrossingRule kShapesRule{
    .band = 0.5e-3, .sure = kNever, .dwellIn = milliseconds{200}, .dwellOut = milliseconds{500}};
constexpr CrossingRule kViewRule{
    .band = 0.0, .sure = kNever, .dwellIn = milliseconds{150}, .dwellOut = milliseconds{500}};

constexpr double kConvincing = 3.0; ///< log odds: 20 to 1
constexpr double kLikelier = 1.1;   ///< 3 to 1, which turns what was concluded from less
/// By then something is concluded whatever the odds are: past the cords' plane, past the carina.
constexpr double kCordsConcluded = 20e-3;
constexpr double kCarinaConcluded = 15e-3;
constexpr double kBentConcluded = 10e-3; ///< of a bent tube, of which more depth tells no more

// Factors of a step's confidence.
constexpr double kPassedUnseen = 0.7;
constexpr double kSeenInPart = 0.9;
constexpr double kShapesDiffer = 0.8;
constexpr double kForgotten = 0.5;

/// Of errors in space, by the standard deviation of one axis (chi-squared of 3 degrees of freedom).
constexpr double kWithin95 = 2.7955;

double normalBelow(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double probabilityOf(double logOdds) { return 1.0 / (1.0 + std::exp(-logOdds)); }

double knownOf(const AirwayMoment& moment, TubeSeat seat)
{
    return moment.isTipKnown || seat == TubeSeat::None ? 1.0 : IntubationMonitor::kTipNotKnown;
}

} // namespace

Length PlacementError::atCords() const
{
    const double usual = std::hypot(translation.si, rotation.si * kLandmarksToCords.si);
    return metres(std::max(usual, boundAtCords.si / kWithin95));
}

IntubationCourse courseFrom(const NotedSoFar& noted, SessionTime at)
{
    IntubationCourse course;
    course.attempts = noted.isBladeIn ? 1 : 0;
    course.blade.isIn = noted.isBladeIn;
    course.bladeSeen = at;
    course.wasGlottisSeen = noted.wasGlottisSeen;
    course.glottis = noted.glottis;

    course.tip = noted.tip;
    course.tip.at = at;
    course.seat = noted.seat;
    course.confidence = noted.confidence;
    course.teeth.isIn = noted.isTubeIn;
    course.shapes.isIn = noted.areShapesApart;
    course.cords.isIn = noted.seat != TubeSeat::None;
    course.measured.isIn = course.cords.isIn || noted.hasPassedShut;
    course.carina.isIn = isInMainBronchus(noted.seat);
    course.isConcluded = course.cords.isIn;
    course.isConvinced = noted.confidence >= probabilityOf(kConvincing);
    course.isInOesophagus = noted.seat == TubeSeat::Oesophagus;
    const auto unseen = [&course](double beyond) {
        return Passage{.reading = course.tip, .isIn = true, .wasUnseen = true, .beyond = beyond};
    };
    course.throughCords = unseen(kCordsRule.sure);
    course.pastCarina = unseen(kCarinaRule.sure);
    return course;
}

void IntubationMonitor::lookAway()
{
    for (Crossing* each : {&m_course.blade, &m_course.view, &m_course.teeth, &m_course.cords,
                           &m_course.carina, &m_course.shapes, &m_course.measured})
        each->value.reset();
    m_course.seen.reset();
}

std::vector<IntubationEvent> IntubationMonitor::take(const AirwayMoment& moment)
{
    if (m_course.latest && moment.at <= *m_course.latest)
        return {};
    m_course.latest = moment.at;
    m_noted.clear();
    takeBlade(moment);
    takeTube(moment);
    std::ranges::stable_sort(m_noted, {}, [](const IntubationEvent& event) {
        return std::pair{event.at,
                         event.step == IntubationStep::TubeOut}; // it left the rest before
    });
    return std::exchange(m_noted, {});
}

IntubationEvent IntubationMonitor::told(IntubationStep step, SessionTime at) const
{
    return {.step = step,
            .at = at,
            .seat = m_course.seat,
            .confidence = m_course.confidence,
            .depthAtTeeth = m_course.tip.depthAtTeeth,
            .tipAboveCarina = m_course.tip.aboveCarina,
            .besides = m_course.tip.besides,
            .glotticOpening = m_course.glottis};
}

/// Of the blade the tube's seat and depth are not known at that time, but those of now are no
/// worse.
void IntubationMonitor::takeBlade(const AirwayMoment& moment)
{
    if (moment.blade == Validity::Lost) {
        forgetBlade(moment.at);
        return;
    }
    m_course.bladeSeen = moment.at;
    TipReading reading = m_course.tip;
    reading.at = moment.at;
    const auto passage = m_course.blade.take(moment.bladePastTeeth.si, reading, kBladeRule);
    if (passage && passage->isIn) {
        ++m_course.attempts;
        m_course.wasGlottisSeen = false;
        m_course.glottis = 0.0;
        m_course.view = {};
    }
    if (passage)
        note(passage->isIn ? IntubationStep::BladeIn : IntubationStep::BladeOut, passage->reading,
             m_course.seat, confidenceOf(moment.blade, *passage));
    takeView(moment);
}

/// Who puts a blade down where no tracker sees it has ended the attempt.
void IntubationMonitor::forgetBlade(SessionTime now)
{
    if (!m_course.blade.isIn || !m_course.bladeSeen || now - *m_course.bladeSeen < kBladeForgotten)
        return;
    m_course.blade = {};
    TipReading reading = m_course.tip;
    reading.at = *m_course.bladeSeen;
    note(IntubationStep::BladeOut, reading, m_course.seat, kForgotten);
}

void IntubationMonitor::takeView(const AirwayMoment& moment)
{
    if (!m_course.blade.isIn || !moment.glottis)
        return;
    m_course.glottis = std::max(m_course.glottis, *moment.glottis);
    TipReading reading = m_course.tip;
    reading.at = moment.at;
    const auto passage = m_course.view.take(*moment.glottis - kLeastView, reading, kViewRule);
    if (!passage || !passage->isIn || std::exchange(m_course.wasGlottisSeen, true))
        return;
    note(IntubationStep::GlottisSeen, passage->reading, m_course.seat,
         moment.blade == Validity::PartlyOccluded ? kSeenInPart : 1.0);
}

void IntubationMonitor::takeTube(const AirwayMoment& moment)
{
    if (moment.tube == Validity::Lost || !isPossible(moment))
        return;
    read(moment);
    takeShapes(moment);
    takeTeeth(moment);
    takeCords(moment);
    takeCarina(moment);
    const TubeSeat seat = presentSeat(moment);
    if (seat != m_course.seat)
        sit(seat, moment);
    m_course.confidence = presentConfidence(moment);
    takeMeasured(moment);
}

/// Of no tube that was lost for a while before.
bool IntubationMonitor::isPossible(const AirwayMoment& moment)
{
    if (m_course.seen) {
        const Duration since = moment.at - *m_course.seen;
        const double moved = (moment.p_A_tip - m_course.p_A_seen).norm();
        if (since < kJumpForgiven && moved > kFastestTip * toSeconds(since))
            return false;
    }
    m_course.seen = moment.at;
    m_course.p_A_seen = moment.p_A_tip;
    return true;
}

void IntubationMonitor::read(const AirwayMoment& moment)
{
    m_course.tip.at = moment.at;
    m_course.tip.besides = moment.besides;
    if (m_course.shapes.isIn)
        return;
    m_course.tip.depthAtTeeth = moment.depthAtTeeth;
    m_course.tip.aboveCarina = moment.aboveCarina;
}

void IntubationMonitor::takeShapes(const AirwayMoment& moment)
{
    const auto passage =
        m_course.shapes.take((moment.besides - kShapesApart).si, m_course.tip, kShapesRule);
    if (passage)
        note(passage->isIn ? IntubationStep::ShapesApart : IntubationStep::ShapesTogether,
             passage->reading, m_course.seat, passage->wasUnseen ? kPassedUnseen : 1.0);
}

/// Whatever is told of a tube tells its seat, too: of one that is in, that which was concluded.
void IntubationMonitor::takeTeeth(const AirwayMoment& moment)
{
    const auto passage = m_course.teeth.take(moment.pastTeeth.si, m_course.tip, kTeethRule);
    if (!passage)
        return;
    const double confidence = confidenceOf(moment.tube, *passage);
    if (passage->isIn)
        note(IntubationStep::TubePastTeeth, passage->reading, m_course.seat, confidence);
    else
        note(IntubationStep::TubeOut, passage->reading, TubeSeat::None, confidence);
}

void IntubationMonitor::takeCords(const AirwayMoment& moment)
{
    if (moment.pastCords > Length{})
        m_course.behind.take(moment.pastCords, moment.towardsOesophagus, moment.tracheaToOesophagus,
                             kDoubtOfBend * moment.besides);
    const auto passage = m_course.cords.take(moment.pastCords.si, m_course.tip, kCordsRule);
    if (passage)
        m_course.throughCords = *passage;
    if (m_course.cords.isIn) {
        conclude(moment);
    } else if (passage) {
        m_course.isConcluded = false;
        m_course.behind = {};
    } else if (moment.pastCords <= Length{}) {
        m_course.behind = {};
    }
}

/// Trachea or oesophagus.
void IntubationMonitor::conclude(const AirwayMoment& moment)
{
    const bool isBent = m_course.behind.isBent(m_error.atCords());
    const double usually = isBent ? kUsuallyTrachea : 0.0;
    const double seen = m_course.behind.logOdds(m_error.atCords());
    const double odds = seen - usually;
    const double concluded = isBent ? kBentConcluded : kCordsConcluded;
    const bool isConvincing = std::abs(odds) >= kConvincing;
    const bool isDue = m_course.isConcluded
                           ? !isBent && !m_course.isConvinced && std::abs(odds) >= kLikelier
                           : moment.pastCords.si >= concluded;
    if (!isConvincing && !isDue)
        return;
    m_course.isConcluded = true;
    m_course.isConvinced = std::abs(seen) >= kConvincing;
    m_course.isInOesophagus = odds > 0.0;
}

/// A tip in the oesophagus passes no carina.
void IntubationMonitor::takeCarina(const AirwayMoment& moment)
{
    if (!m_course.cords.isIn || !m_course.isConcluded || m_course.isInOesophagus) {
        m_course.carina = {};
        m_course.left = {};
        return;
    }
    if (moment.aboveCarina < Length{})
        m_course.left.take(Length{} - moment.aboveCarina, moment.towardsLeft, moment.rightToLeft,
                           kDoubtOfBend * moment.besides);
    const auto passage = m_course.carina.take(-moment.aboveCarina.si, m_course.tip, kCarinaRule);
    if (passage)
        m_course.pastCarina = *passage;
    if (!m_course.carina.isIn && moment.aboveCarina >= Length{})
        m_course.left = {};
}

/// Only a measured tip is past cords that are shut; a tube that was there before they shut is not
/// past them anew.
void IntubationMonitor::takeMeasured(const AirwayMoment& moment)
{
    const auto passage =
        m_course.measured.take(moment.measuredPastCords.si, m_course.tip, kCordsRule);
    if (passage && passage->isIn && moment.areCordsShut)
        note(IntubationStep::PassedShut, passage->reading, m_course.seat,
             confidenceOf(moment.tube, *passage));
}

/// As far as it is concluded.
TubeSeat IntubationMonitor::presentSeat(const AirwayMoment& moment) const
{
    if (!m_course.cords.isIn || !m_course.isConcluded)
        return TubeSeat::None;
    if (m_course.isInOesophagus)
        return TubeSeat::Oesophagus;
    if (!m_course.carina.isIn)
        return TubeSeat::Trachea;
    const double odds = m_course.left.logOdds(m_error.atCords());
    const bool isBent = m_course.left.isBent(m_error.atCords());
    const double concluded = isBent ? kBentConcluded : kCarinaConcluded;
    const bool isConcluded =
        std::abs(odds) >= kConvincing
        || (!isInMainBronchus(m_course.seat) && moment.aboveCarina.si < -concluded);
    if (!isConcluded)
        return isInMainBronchus(m_course.seat) ? m_course.seat : TubeSeat::Trachea;
    return odds > 0.0 ? TubeSeat::LeftMain : TubeSeat::RightMain;
}

void IntubationMonitor::sit(TubeSeat seat, const AirwayMoment& moment)
{
    const double confidence = seatConfidence(moment, seat);
    leave(seat, confidence);
    const TipReading& cords = m_course.throughCords.reading;
    if (seat == TubeSeat::Oesophagus)
        note(IntubationStep::InOesophagus, cords, seat, confidence);
    if (isThroughCords(seat) && !isThroughCords(m_course.seat))
        note(IntubationStep::ThroughCords, cords, TubeSeat::Trachea, confidence);
    if (isInMainBronchus(seat))
        note(IntubationStep::PastCarina, m_course.pastCarina.reading, seat, confidence);
    m_course.seat = seat;
}

void IntubationMonitor::leave(TubeSeat next, double confidence)
{
    const TipReading& cords = m_course.throughCords.reading;
    if (isInMainBronchus(m_course.seat)) {
        const TipReading& carina = isThroughCords(next) ? m_course.pastCarina.reading : cords;
        note(IntubationStep::BackAboveCarina, carina, TubeSeat::Trachea, confidence);
    }
    if (isThroughCords(m_course.seat) && !isThroughCords(next))
        note(IntubationStep::BackAboveCords, cords, TubeSeat::None, confidence);
    if (m_course.seat == TubeSeat::Oesophagus)
        note(IntubationStep::OutOfOesophagus, cords, TubeSeat::None, confidence);
}

double IntubationMonitor::confidenceOf(Validity seen, const Passage& passage) const
{
    double confidence = normalBelow(passage.beyond / m_error.atCords().si);
    if (passage.wasUnseen)
        confidence *= kPassedUnseen;
    if (seen == Validity::PartlyOccluded)
        confidence *= kSeenInPart;
    return confidence;
}

/// That the ways between which a seat is concluded were told apart, by what was seen alone: what
/// usually happens says nothing of this tube.
double IntubationMonitor::wayConfidence(TubeSeat seat) const
{
    const auto toldApart = [&](const WayEvidence& evidence, bool isOther) {
        const double odds = evidence.logOdds(m_error.atCords());
        return probabilityOf(std::max(isOther ? odds : -odds, 0.0));
    };
    double confidence = 1.0;
    if (seat != TubeSeat::None)
        confidence = toldApart(m_course.behind, seat == TubeSeat::Oesophagus);
    if (isInMainBronchus(seat))
        confidence = std::min(confidence, toldApart(m_course.left, seat == TubeSeat::LeftMain));
    return m_course.shapes.isIn ? kShapesDiffer * confidence : confidence;
}

/// Of the change to a seat.
double IntubationMonitor::seatConfidence(const AirwayMoment& moment, TubeSeat seat) const
{
    const bool isAtCarina =
        isInMainBronchus(seat) || (isInMainBronchus(m_course.seat) && isThroughCords(seat));
    const Passage& passage = isAtCarina ? m_course.pastCarina : m_course.throughCords;
    return knownOf(moment, seat)
           * std::min(wayConfidence(seat), confidenceOf(moment.tube, passage));
}

/// Of the seat as the tip lies now, however it came there.
double IntubationMonitor::presentConfidence(const AirwayMoment& moment) const
{
    Length margin = moment.pastCords;
    if (m_course.seat == TubeSeat::None)
        margin = Length{} - moment.pastCords;
    else if (m_course.seat == TubeSeat::Trachea)
        margin = std::min(moment.pastCords, moment.aboveCarina);
    else if (isInMainBronchus(m_course.seat))
        margin = Length{} - moment.aboveCarina;
    const double placed = normalBelow(margin / m_error.atCords());
    return knownOf(moment, m_course.seat) * std::min(wayConfidence(m_course.seat), placed);
}

void IntubationMonitor::note(IntubationStep step, const TipReading& reading, TubeSeat seat,
                             double confidence)
{
    m_noted.push_back({.step = step,
                       .at = reading.at,
                       .seat = seat,
                       .confidence = confidence,
                       .depthAtTeeth = reading.depthAtTeeth,
                       .tipAboveCarina = reading.aboveCarina,
                       .besides = reading.besides,
                       .glotticOpening = m_course.glottis});
}

} // namespace carina
