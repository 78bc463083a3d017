#pragma once

#include "engine/airway/monitor/patient_ways.h"
#include "engine/core/session_time.h"
#include "engine/tracking/pose_sample.h"

#include <optional>
#include <span>

namespace carina
{

/// A tube at a moment: its centre line from connector to tip, in A, metres.
struct TubeCurves {
    Validity validity = Validity::Lost;
    std::span<const Vec3> p_A_shown;    ///< as it is drawn; two points at least unless it is lost
    std::span<const Vec3> p_A_measured; ///< by pose and rest curve; empty: as shown
    bool isTipKnown = true;             ///< else the tip may be elsewhere altogether
};

/// A laryngoscope at a moment.
struct BladeSeen {
    Validity validity = Validity::Lost;
    Vec3 p_A_tip = Vec3::Zero();
    std::optional<double> glottis{}; ///< the share of it that is seen, where it was measured
};

/// What one moment says of tube and blade, by signed distances. Those of a thing that is lost have
/// no meaning.
struct AirwayMoment {
    SessionTime at{};
    Validity tube = Validity::Lost;
    Vec3 p_A_tip = Vec3::Zero();
    Length pastTeeth{};         ///< of the tip; negative in front of the incisors and beside the
                                ///< ways, where a tube in a body cannot be
    Length pastCords{};         ///< through the cords' plane, likewise, in the larynx or behind it
    Length towardsOesophagus{}; ///< of the measured tip, from halfway; negative: airway
    Length tracheaToOesophagus{}; ///< at the height of the tip
    Length aboveCarina{};         ///< along the airway, negative beyond; to kFarthestFromCarina
    Length towardsLeft{};         ///< of that, from halfway between both; negative: right
    Length rightToLeft{};         ///< of these, at the height of the tip; 0 above the carina
    Length depthAtTeeth{};        ///< along the tube; 0 outside
    Length measuredPastCords{};   ///< of the tip as it was measured
    Length besides{};             ///< distance of both tips
    bool isTipKnown = true;       ///< TubeCurves::isTipKnown
    bool areCordsShut = false;    ///< in the virtual patient
    Validity blade = Validity::Lost;
    Length bladePastTeeth{}; ///< of its tip
    std::optional<double> glottis{};

    friend bool operator==(const AirwayMoment&, const AirwayMoment&) = default;
};

/// A tip farther than this from the way over the tongue is not in an adult's mouth or throat; and
/// one this far from trachea, oesophagus and bronchi not in one of them: the skin in front of a
/// neck is farther away. Of ours.
inline constexpr Length kMostFromTongueWay = millimetres(30.0);
inline constexpr Length kMostFromWindpipe = millimetres(15.0);
/// Likewise of a blade's tip, which is led in front of that way, to the vallecula, and lifts it: in
/// an adult it is up to 45 mm from where the way was. Only there: elsewhere, or to the side, what
/// is so far away may be a cheek or the skin under the chin. Of ours.
inline constexpr Length kMostBladeFromTongueWay = millimetres(45.0);
/// From this share of the way on the vallecula is in front of it: at 0.87 to 0.92 in the built-in
/// patients, and of a blade that lifts it in a flexed neck at 0.71. Of ours.
inline constexpr double kToVallecula = 0.6;
/// Beside the glottis by more than this, in an adult, a tip lies in a piriform fossa, from which it
/// goes into the oesophagus. Of ours: half a glottis' width, and half a tube.
inline constexpr Length kBesideGlottis = millimetres(10.0);

/// Farther along from the carina lies no place of an airway; a tip that lies beside the patient
/// counts as this far. Of ours.
inline constexpr Length kFarthestFromCarina = millimetres(500.0);

/// @param ways of the patient, as they are drawn at that moment
[[nodiscard]] AirwayMoment airwayMoment(SessionTime at, const PatientWays& ways,
                                        const TubeCurves& tube, const BladeSeen& blade,
                                        bool areCordsShut = false);

} // namespace carina
