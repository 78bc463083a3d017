#pragma once

#include "engine/airway/monitor/airway_moment.h"
#include "engine/airway/monitor/crossing.h"
#include "engine/airway/monitor/intubation_event.h"
#include "engine/airway/monitor/way_evidence.h"

#include <optional>
#include <utility>
#include <vector>

namespace carina
{

/// How far poses are expected to be off in the patient: standard deviations of one axis.
struct PlacementError {
    Length translation = millimetres(1.5);
    Angle rotation = degrees(1.0); ///< about the landmarks, kLandmarksToCords from the cords

    /// Within which 95 % of the errors at the cords are expected to be, where that is known.
    Length boundAtCords{};

    static constexpr Length kLandmarksToCords = millimetres(100.0); ///< of ours

    /// Of a place at the cords, of one axis: of the larger of both expectations.
    [[nodiscard]] Length atCords() const;
};

/// Who reads poses for a monitor reads those of so long ago: there they lie between samples, and
/// are interpolated and not predicted. Of ours.
inline constexpr Duration kReadBehind = std::chrono::milliseconds{80};

/// What is known of an intubation that others have followed so far.
struct NotedSoFar {
    bool isBladeIn = false;
    bool wasGlottisSeen = false; ///< in this attempt,
    double glottis = 0.0;        ///< the largest share of it
    bool isTubeIn = false;       ///< in the mouth
    TubeSeat seat = TubeSeat::None;
    double confidence = 1.0; ///< in the seat
    TipReading tip{};        ///< as it was told last
    bool areShapesApart = false;
    bool hasPassedShut = false; ///< the measured tube
    /// Where the first breath went.
    std::optional<TubeSeat> breath{};
};

/// What the monitor has concluded so far. A copy of it is a checkpoint.
struct IntubationCourse {
    int attempts = 0;               ///< laryngoscopies begun
    TubeSeat seat = TubeSeat::None; ///< of the tip
    double confidence = 1.0;        ///< in that, as the tip lies
    TipReading tip{};               ///< the latest; its depth is frozen while the shapes are apart
    double glottis = 0.0;           ///< the largest share of it that was seen in this attempt

    Crossing blade{};       ///< its tip past the teeth
    Crossing view{};        ///< of the glottis, more than kLeastView
    Crossing teeth{};       ///< the tube's tip past the teeth
    Crossing cords{};       ///< past the cords' plane, in the larynx or behind it
    Crossing carina{};      ///< past the carina, of a tip that is in the airway
    Crossing shapes{};      ///< apart by more than kShapesApart
    Crossing measured{};    ///< the measured tip past the cords' plane
    WayEvidence behind{};   ///< of the oesophagus, since the cords' plane was passed
    WayEvidence left{};     ///< of the left main bronchus, since the carina was
    Passage throughCords{}; ///< the latest passage of each plane
    Passage pastCarina{};
    bool wasGlottisSeen = false;       ///< in this attempt
    bool isInOesophagus = false;       ///< the present conclusion, once the cords' plane is passed
    bool isConcluded = false;          ///< whether there is one
    bool isConvinced = false;          ///< whether the evidence was strong
    std::optional<SessionTime> seen{}; ///< when the tube was seen last,
    Vec3 p_A_seen = Vec3::Zero();      ///< and its tip there
    std::optional<SessionTime> bladeSeen{};
    std::optional<SessionTime> latest{}; ///< the latest moment

    friend bool operator==(const IntubationCourse&, const IntubationCourse&) = default;
};

/// Of a monitor that goes on from there: it notes what has become different since, and nothing
/// that is noted already. What follows was not seen to happen. A blade that it never sees is out
/// kBladeForgotten later.
[[nodiscard]] IntubationCourse courseFrom(const NotedSoFar& noted, SessionTime at);

/// Tells the steps of an intubation from moments in ascending time.
///
/// A step is the passage of a plane by a tip. It is noted once the tip is beyond by more than noise
/// (Crossing), with the time of the passage itself. Whether a tip that passes the cords' plane goes
/// into the trachea or the oesophagus, and past the carina into which bronchus, is concluded from
/// where it lies between both ways at all depths (WayEvidence), and concluded anew when the
/// evidence turns: a conclusion from weak evidence, of a depth at which there had to be one, by
/// less than one from strong evidence. The steps then have the times of the earlier passage. How
/// far both shapes of the tube are apart is doubt about where its tip is (kDoubtOfBend). Where that
/// is larger than the registration's error little is left of the evidence: then more depth is not
/// awaited, and a tip past the cords' plane is taken to be in the trachea, as most are
/// (kUsuallyTrachea), unless the evidence is stronger. The confidence is that of the evidence
/// alone.
///
/// A sample is left out in which the tip has moved faster than kFastestTip since one less than
/// kJumpForgiven before. Where the tube was not seen while it passed, the step's confidence is
/// lower; also where it was partly seen, near a plane for the registration's error, or where the
/// evidence is weak, and while measured and constrained shape are apart, when the depth stays what
/// it was before. In a seat of a tip of which nobody knows where it is the confidence is
/// kTipNotKnown of that.
///
/// An attempt begins with the blade past the teeth and ends when it was out for kBetweenAttempts,
/// or lost for kBladeForgotten. All constants are of ours.
class IntubationMonitor
{
public:
    explicit IntubationMonitor(const PlacementError& error = {}, IntubationCourse course = {})
        : m_error{error}, m_course{std::move(course)}
    {
    }

    /// From now on.
    void expect(const PlacementError& error) { m_error = error; }
    /// What happens until the next moment is not seen, as in a pause.
    void lookAway();

    /// @returns what is known now, by time. A moment that is not later than the one before says
    ///          nothing.
    [[nodiscard]] std::vector<IntubationEvent> take(const AirwayMoment& moment);

    /// A step that people tell by their controls, as CuffInflated, with how the tube lies.
    [[nodiscard]] IntubationEvent told(IntubationStep step, SessionTime at) const;

    [[nodiscard]] const IntubationCourse& course() const { return m_course; }

    static constexpr Length kShapesApart = {5e-3};
    /// Standard deviation of the measured tip's place between the ways, of the shapes' distance.
    static constexpr double kDoubtOfBend = 0.8;
    /// Log odds: of 149 tubes that physicians placed out of hospital 10 were found in the
    /// oesophagus (Timmermann et al., Anesth Analg 2007;104:619).
    static constexpr double kUsuallyTrachea = 2.63;
    static constexpr double kTipNotKnown = 0.45; ///< less than half is never told as known
    static constexpr double kLeastView = 0.05;
    static constexpr double kFastestTip = 2.0; ///< m/s
    static constexpr Duration kJumpForgiven = std::chrono::milliseconds{200};
    static constexpr Duration kBetweenAttempts = std::chrono::seconds{2};
    static constexpr Duration kBladeForgotten = std::chrono::seconds{10};

private:
    void takeBlade(const AirwayMoment& moment);
    void forgetBlade(SessionTime now);
    void takeView(const AirwayMoment& moment);
    void takeTube(const AirwayMoment& moment);
    [[nodiscard]] bool isPossible(const AirwayMoment& moment);
    void read(const AirwayMoment& moment);
    void takeShapes(const AirwayMoment& moment);
    void takeTeeth(const AirwayMoment& moment);
    void takeCords(const AirwayMoment& moment);
    void conclude(const AirwayMoment& moment);
    void takeCarina(const AirwayMoment& moment);
    void takeMeasured(const AirwayMoment& moment);
    [[nodiscard]] TubeSeat presentSeat(const AirwayMoment& moment) const;
    void sit(TubeSeat seat, const AirwayMoment& moment);
    void leave(TubeSeat next, double confidence);
    [[nodiscard]] double confidenceOf(Validity seen, const Passage& passage) const;
    [[nodiscard]] double wayConfidence(TubeSeat seat) const;
    [[nodiscard]] double presentConfidence(const AirwayMoment& moment) const;
    [[nodiscard]] double seatConfidence(const AirwayMoment& moment, TubeSeat seat) const;
    void note(IntubationStep step, const TipReading& reading, TubeSeat seat, double confidence);

    PlacementError m_error;
    IntubationCourse m_course;
    std::vector<IntubationEvent> m_noted; ///< of the moment that is taken
};

} // namespace carina
