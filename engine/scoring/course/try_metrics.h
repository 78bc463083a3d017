#pragma once

#include "engine/airway/monitor/intubation_event.h"
#include "engine/core/pauses.h"
#include "engine/scoring/course/force_meter.h"
#include "engine/scoring/course/oxygen_meter.h"
#include "engine/scoring/motion/motion_meter.h"
#include "engine/scoring/motion/plane_meter.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// How a try at intubating ended.
enum class TryOutcome : std::uint8_t {
    Trachea,
    RightMain,
    LeftMain,
    OesophagusUnrecognised, ///< the tube is still there
    OesophagusRecognised,   ///< it was taken out of there, and no tube is in place
    Abandoned,              ///< no tube is in place
};
inline constexpr TryOutcome kLastTryOutcome = TryOutcome::Abandoned;

/// Once that the tube's tip was in the oesophagus.
struct OesophagealStay {
    SessionTime in{};
    std::optional<SessionTime> out{}; ///< nothing: until the end of the try

    friend bool operator==(const OesophagealStay&, const OesophagealStay&) = default;
};

/// What only a person, or another device, can tell of a try.
enum class TryCheck : std::uint8_t {
    Prepared,       ///< laryngoscope, tube and what fixes it were made ready
    MaskVentilated, ///< and effectively so
    BladeFromRight, ///< the blade went in as its kind is meant to
    PressureAsked,  ///< on the larynx, where it would have helped
    Auscultated,    ///< both lungs, and the tube fixed
};
inline constexpr std::size_t kTryChecks = 5;

/// The place of the tube at the end of a try, where it lies in the airway.
struct TubeDepth {
    SessionTime at{};        ///< when it was measured
    Length atTeeth{};        ///< of the tip, along the tube
    Length aboveCarina{};    ///< of the tip, along the airway; negative beyond
    double confidence = 1.0; ///< that the tip was there, 0 to 1

    friend bool operator==(const TubeDepth&, const TubeDepth&) = default;
};

/// What was measured of one try at intubating a patient. What was not is std::nullopt.
struct TryMetrics {
    TryOutcome outcome = TryOutcome::Abandoned;
    double confidence = 1.0; ///< of the event that the outcome rests on, 0 to 1
    bool isTold = false;     ///< the outcome is what a person said, not what was measured
    SessionTime begun{};     ///< the blade or the tube passed the teeth for the first time
    SessionTime ended{};
    Pauses pauses{}; ///< of the session; no time that is told counts them

    std::vector<SessionTime> attempts{}; ///< when the blade went in; or the tube, without a blade
    bool hadBlade = false; ///< a laryngoscope was seen to go in: view and blade are measured
    /// Something read what the laryngoscope sees: without a view the glottis was not seen then;
    /// else nobody knows.
    bool isViewRead = true;
    std::optional<SessionTime> view{};         ///< the glottis was seen for the first time
    std::optional<SessionTime> throughCords{}; ///< for good
    std::optional<SessionTime> firstBreath{};  ///< through the tube, into a lung
    std::optional<SessionTime> cuffInflated{}; ///< and not empty again
    std::optional<SessionTime> passedShut{};   ///< see IntubationStep::PassedShut
    Duration bladeTime{};                      ///< that the blade was in the mouth
    std::optional<double> glotticOpening{};    ///< the largest share that was seen, 0 to 1
    std::vector<OesophagealStay> oesophagus{};
    std::optional<TubeDepth> depth{};
    std::optional<Length> depthWanted{}; ///< by the rule of the scenario

    std::optional<Angle> headExtension{}; ///< when the blade went in
    std::optional<OxygenFigures> oxygen{};
    std::optional<ForceFigures> incisors{};
    std::optional<ForceFigures> tongue{};
    std::optional<PlaneFigures> plane{}; ///< of the laryngoscope, while its blade was in
    std::optional<MotionFigures> hand{}; ///< of the laryngoscope, likewise
    std::optional<MotionFigures> head{}; ///< of the trainee, during the try
    std::array<std::optional<bool>, kTryChecks> checks{};

    /// How long the try had gone on then.
    [[nodiscard]] Duration sinceBegun(SessionTime t) const { return pauses.between(begun, t); }

    [[nodiscard]] const std::optional<bool>& check(TryCheck of) const
    {
        return checks[static_cast<std::size_t>(of)];
    }

    friend bool operator==(const TryMetrics&, const TryMetrics&) = default;
};

/// Whether a try begins with this step where none is under way.
[[nodiscard]] bool beginsTry(IntubationStep step);

/// What follows from the events of a try; all that rests on other measurements is left out.
///
/// The tube's passage through the cords is the last one that was not undone. The depth is that of
/// the last event with the tip in trachea or bronchus: a tube that comes to rest at another depth
/// is an event of its own (IntubationStep::AtRest). There is none where measured and constrained
/// tube had parted by then. A monitor may conclude otherwise later, and then notes with its time
/// that the tip has left where it was taken to be: an oesophagus that it left when it came there
/// does not count.
/// @param events in the order in which they were noted, of one try
/// @pre events is not empty
[[nodiscard]] TryMetrics courseOf(std::span<const IntubationEvent> events, SessionTime ended,
                                  const Pauses& pauses = {});

} // namespace carina
