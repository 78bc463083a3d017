#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace carina
{

/// What makes an airway difficult, or the view easier, while it is worked in.
enum class AirwayEventKind : std::uint8_t {
    TongueOedema,       ///< the tongue swells, towards the palate and the pharynx
    PharyngealSwelling, ///< the side walls of the pharynx come inward
    Epiglottitis,       ///< the epiglottis swells to a ball
    LaryngealOedema,    ///< arytenoids and aryepiglottic folds swell over the glottis
    Laryngospasm,       ///< the cords shut; partly, a slit remains
    FloppyEpiglottis,   ///< the epiglottis falls back over the glottis
    AnteriorLarynx,     ///< the larynx lies farther to the front, out of the line of sight
    AngioOedema,        ///< lips, the front of the tongue and the entrance of the larynx swell
    LaryngealWeb,       ///< the cords are joined in front
    ExternalPressure,   ///< BURP, a manoeuvre: the larynx is pressed back, up and to the right
    TrachealStenosis,   ///< the trachea is narrow at some rings below the cords
    TrachealDeviation,  ///< the trachea goes to the patient's right between larynx and carina
    Goitre,             ///< a swelling before the trachea, which it narrows and pushes aside
    NeckObesity,        ///< pharynx narrower, tongue base larger, neck thicker
    ProminentIncisors,  ///< the upper ones stand out to the front, and lower
    Trismus,            ///< the mouth opens less
    StiffNeck,          ///< head and neck move less
    Burn,               ///< erythema, soot and oedema from the mouth to the larynx
    Secretions,         ///< saliva and mucus stand in the throat
    Blood,              ///< the same, blood
    Vomit,              ///< the same, what came up from the stomach
    ForeignBody,        ///< a solid lies beside or over the glottis
    FragileTeeth,       ///< the upper incisors are loose, one leans: a warning comes earlier
    Swallowing, ///< the patient swallows again and again; 1: with a whole rise of the larynx
};
inline constexpr int kAirwayEventKinds = 24;

/// One of them, and how severe it is.
struct AirwayEvent {
    AirwayEventKind kind = AirwayEventKind::TongueOedema;
    double severity = 0.0; ///< 0: nothing is to be seen of it, 1: the worst that is drawn

    friend bool operator==(const AirwayEvent&, const AirwayEvent&) = default;
};

/// Those of a patient at a moment: of each kind one at most, in the order of the kinds.
using AirwayEvents = std::vector<AirwayEvent>;

/// The name of a kind in files, JSON and options: "tongue_oedema".
[[nodiscard]] const char* eventName(AirwayEventKind kind);
[[nodiscard]] std::optional<AirwayEventKind> eventNamed(std::string_view name);

/// How severe one of them is; 0 where it is not there.
[[nodiscard]] double severityOf(const AirwayEvents& events, AirwayEventKind kind);

/// Adds one to proper ones: of two of a kind the worse counts. One of severity 0 adds nothing.
void worsen(AirwayEvents& events, const AirwayEvent& by);

/// Whether each kind is there once at most, in order, with a severity of 0 to 1.
[[nodiscard]] bool areProper(const AirwayEvents& events);

} // namespace carina
