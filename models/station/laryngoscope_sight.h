#pragma once

#include "engine/anatomy/laryngoscopy/glottic_view.h"
#include "models/patient/laryngoscopy.h"
#include "models/station/station_view.h"

#include <QString>

#include <optional>
#include <vector>

namespace carina
{

/// What there is of a laryngoscope at a station.
enum class LaryngoscopeState : std::uint8_t {
    None,     ///< nobody there has one that was ever seen
    Lost,     ///< it is out of its tracker's view, or nothing is heard of it
    Away,     ///< the virtual patient is not where the manikin is
    NoLarynx, ///< the patient lacks what it is to show
    Outside,  ///< it is seen, but not in the patient's mouth
    Live,     ///< it is seen in the mouth
};

/// How a patient's upper incisors are called.
enum class UpperTeeth : std::uint8_t {
    Firm,
    Loose,
    LooseAndNear, ///< a blade is to be warned of them
};
/// Warned of within kNearLooseTeeth times how loose they are, until a blade is farther away than
/// that by kLooseTeethLetGo.
/// @param looseTeeth 0 to 1, as LaryngoscopeSight::looseTeeth
/// @param before of the blade's pose before this one
[[nodiscard]] UpperTeeth upperTeeth(const BladeContact& contact, double looseTeeth,
                                    UpperTeeth before);
inline constexpr Length kNearLooseTeeth = millimetres(3.0);  ///< of ours
inline constexpr Length kLooseTeethLetGo = millimetres(0.5); ///< of ours

/// A laryngoscope of a station at a moment, and how the tissue gives way to it. All but the state
/// is for Outside and Live only.
struct LaryngoscopeSight {
    LaryngoscopeState state = LaryngoscopeState::None;
    RigidTransform X_AL{};
    FollowingThroat throat{};
    BladeField tissue{};
    BladeEffort effort{}; ///< for Live only
    Blade blade{};
    bool isBladeKnown = false; ///< touched, or told by its name; else the usual one is taken
    bool isOfWorker = false;   ///< of who is at work, or the own one while nobody is
    JawSight jaw = JawSight::NoProbe;
    double looseTeeth = 0.0; ///< severity of AirwayEventKind::FragileTeeth, where there are any
    UpperTeeth teeth = UpperTeeth::Firm; ///< for Live only

    /// No other one is graded: whose it is has the tube, and the jaw is moved by their probe. And
    /// none is while the mouth is drawn as nobody holds it.
    [[nodiscard]] bool isGraded() const
    {
        const bool isMouthKnown = jaw == JawSight::NoProbe || jaw == JawSight::Seen;
        return state == LaryngoscopeState::Live && isOfWorker && isMouthKnown;
    }
};

/// The laryngoscope with which somebody works at a station: that of who is at work, else of
/// somebody; of several one that is seen, of these the first that was shared; nullptr without one.
[[nodiscard]] const PersonPose* laryngoscopeOf(const StationMoment& moment);

/// The laryngoscope of a station in its patient, and what events and breath change of that
/// patient's airway. The places by which a blade moves tissue, and events change it, are looked for
/// when there first is one or the other. While one of them is there the cords part with the
/// patient's own inspiration and come together with expiration; of who does not breathe they stay
/// as they are in the surfaces, and go there within kCordsGo.
class StationLaryngoscope
{
public:
    /// @pre the patient outlives this
    explicit StationLaryngoscope(const PatientModel& patient) : m_patient{&patient} {}

    /// Another patient lies there from now on. @pre as before
    void lieIn(const PatientModel& patient)
    {
        m_patient = &patient;
        m_laryngoscopy.reset();
        m_handled = {};
    }
    /// The blade of this program's laryngoscope, as it was touched; std::nullopt: as its name says.
    void takeOwnBlade(const std::optional<Blade>& blade) { m_ownBlade = blade; }
    [[nodiscard]] const std::optional<Blade>& ownBlade() const { return m_ownBlade; }
    /// The blade of somebody's laryngoscope: as touched, as its name says, or the usual one.
    [[nodiscard]] Blade bladeOf(const PersonPose& laryngoscope) const
    {
        return knownBladeOf(laryngoscope).value_or(carina::bladeOf(kUsualBlade));
    }

    /// @param throat of the patient, as it is drawn at that moment
    [[nodiscard]] LaryngoscopeSight at(const StationMoment& moment, const FollowingThroat& throat);

    /// What events and breath change of the airway at a moment, to be drawn; nothing where there is
    /// no event and no laryngoscope is seen, and of a patient that lacks what one is to show.
    [[nodiscard]] AirwayField changesAt(const StationMoment& moment);

    /// The glottis, as it is drawn there. @pre there was a Live one
    [[nodiscard]] GlotticLine glottisAt(const FollowingThroat& throat,
                                        const BladeField& tissue) const;

    /// What lies in the throat by events, with or without a laryngoscope: nothing where no event is
    /// there, and of a patient that lacks what one is to show. @pre changesAt of the same moment
    /// was asked for before
    [[nodiscard]] std::vector<ThroatContent> contentsIn(const StationMoment& moment,
                                                        const FollowingThroat& throat,
                                                        const BladeField& tissue) const;

private:
    [[nodiscard]] std::optional<Blade> knownBladeOf(const PersonPose& laryngoscope) const;
    [[nodiscard]] Laryngoscopy* changedAt(const StationMoment& moment);
    [[nodiscard]] double inspirationAt(const StationMoment& moment);
    [[nodiscard]] LaryngoscopeSight sightAt(const StationMoment& moment,
                                            const FollowingThroat& throat);
    void handle(LaryngoscopeSight& sight, ObjectId object);

    /// Where in a breath the cords were.
    struct Cords {
        SessionTime time{};
        double inspiration = kInspirationAsMade;
    };

    /// The poses of one laryngoscope with one blade.
    struct Handled {
        ObjectId object{};
        BladeForm form{};
        LeveringWatch watch{};
        UpperTeeth teeth = UpperTeeth::Firm; ///< at the latest one
    };

    const PatientModel* m_patient;
    Cords m_cords;
    Handled m_handled;
    std::optional<Blade> m_ownBlade;
    std::optional<Result<Laryngoscopy>> m_laryngoscopy;
};

/// The time in which cords go from the narrowest to the widest of a breath at the fastest.
inline constexpr Duration kCordsGo = std::chrono::milliseconds{150};

/// What keeps the view of a laryngoscope from being shown, and what to do, as a sentence; empty
/// while it is Live.
[[nodiscard]] QString laryngoscopeText(LaryngoscopeState state);

/// What the blade does to tongue, epiglottis and teeth, in two lines: "Lifting · tongue about 38 N
/// (estimate) · epiglottis not touched", and "Teeth free (4 mm)" or "▲ Teeth pressed: about 12 N
/// (estimate)". Loose teeth are called so: "▲ Loose teeth near (2.4 mm)".
[[nodiscard]] QString bladeEffortText(const BladeEffort& effort,
                                      UpperTeeth teeth = UpperTeeth::Firm);

/// What stands beneath the picture: why there is none; or its grade, or why it has none and what to
/// do, and what the blade does; and in a last line which blade is assumed, where none is known.
/// @param read in the picture last, whether or not it tells of the glottis; nothing while there is
///             nothing recent
[[nodiscard]] QString laryngoscopeText(const LaryngoscopeSight& sight,
                                       const std::optional<GlotticView>& read);

} // namespace carina
