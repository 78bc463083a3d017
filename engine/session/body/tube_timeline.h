#pragma once

#include "engine/airway/monitor/intubation_event.h"
#include "engine/anatomy/patient/patient_build.h"
#include "engine/lungs/mechanics/tube_place.h"
#include "engine/session/parameter_timeline.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// An entry of a monitor, and when it took effect.
struct NotedStep {
    SessionTime effect{};
    IntubationEvent event;
    std::uint64_t number = 0; ///< among all entries about its patient, from 1

    friend bool operator==(const NotedStep&, const NotedStep&) = default;
};

/// Where the console sets a tube, and whether that is said of one that a monitor had in the mouth.
struct ToldTube {
    SetTube tube;
    bool isOfNoted = false;

    /// The place of a tube that a monitor follows, where it is set.
    [[nodiscard]] std::optional<TubeSeat> seatOfNoted() const
    {
        return tube.isSet() && isOfNoted ? std::optional{tube.seat} : std::nullopt;
    }
};

/// What a monitor has noted of a tube.
struct NotedTube {
    bool isWatched = false; ///< it has noted one
    bool isInMouth = false;
    TubeSeat seat = TubeSeat::None;
    Length innerDiameter{}; ///< 0: not known
};

/// Where the tracheal tube of one patient is over the session: as the console sets it, and as a
/// monitor notes it. At first nobody has set or noted one.
///
/// The console's own setting overrides what the monitor notes for as long as it is set. What is
/// said of a tube in the mouth ends when that tube is noted to be out, and leaves its cuff as it
/// is.
///
/// Changes are added in the order of the facts, whose effects follow each other likewise.
class TubeTimeline
{
public:
    /// Entries that are kept: those of several tries. Older ones are in the log, and of those about
    /// a tube at rest (IntubationStep::AtRest) each that another one followed at once.
    static constexpr std::size_t kMostNotes = 128;

    /// The console's own setting, or that it sets none.
    void setOverride(SessionTime from, const SetTube& tube);
    /// An entry about the tube (from IntubationStep::TubePastTeeth on) says where its tip is; of
    /// what people tell by their controls (isOfControls) only once poses have told of a tube.
    /// @param innerDiameter 0 where it is not known
    void note(SessionTime from, const IntubationEvent& event, Length innerDiameter);
    /// Until the tube is out of the mouth again: a cuff is emptied to take it out.
    void setCuff(SessionTime from, bool inflated) { m_cuff.set(from, inflated); }
    /// Likewise, of a tube of the console, too: of its lumen the share that is lost.
    void setObstruction(SessionTime from, double share) { m_obstruction.set(from, share); }
    /// Likewise: for the next try the tube has its stylet back.
    void drawStylet(SessionTime from) { m_stylet.set(from, false); }
    /// As ParameterTimeline; entries stay, and the last kMostNotes settings of the console.
    void forgetBefore(SessionTime t);

    [[nodiscard]] SetTube overrideAt(SessionTime t) const { return m_override.at(t).tube; }
    /// The same over time, and of which tube.
    [[nodiscard]] std::span<const ParameterTimeline<ToldTube>::Change> overrides() const
    {
        return m_override.changes();
    }
    /// Whether the console's own setting takes the place of what a monitor has noted by then.
    [[nodiscard]] bool isOverriddenAt(SessionTime t) const
    {
        return m_noted.at(t).isWatched && m_override.at(t).tube.isSet();
    }
    /// What a monitor has noted by then, whatever the console sets.
    [[nodiscard]] NotedTube notedAt(SessionTime t) const { return m_noted.at(t); }
    /// Whether a monitor has noted a tube by then.
    [[nodiscard]] bool isWatchedAt(SessionTime t) const { return m_noted.at(t).isWatched; }
    /// A watched or set tube whose tip is above the cords, or out of the mouth, has the seat None
    /// and an inner diameter above 0; where nobody has set or noted a tube, the diameter is 0. A
    /// noted tube leaks kEmptyCuffLeak until its cuff is inflated; one that the console has set,
    /// where none was in the mouth, does not. Both are obstructed as it was set.
    /// @param build for the diameter of a tube of which it is not known (usualTube)
    [[nodiscard]] TubePlace placeAt(SessionTime t, const PatientBuild& build) const;
    /// Whether both shapes of the tube are apart, by the last entry that tells it since the tube
    /// was out.
    [[nodiscard]] bool areShapesApartAt(SessionTime t) const;
    /// Whether the last entry about the blade said that it is in the mouth.
    [[nodiscard]] bool bladeInMouthAt(SessionTime t) const { return m_blade.at(t); }
    [[nodiscard]] bool cuffInflatedAt(SessionTime t) const { return m_cuff.at(t); }
    [[nodiscard]] double obstructionAt(SessionTime t) const { return m_obstruction.at(t); }
    [[nodiscard]] bool styletInAt(SessionTime t) const { return m_stylet.at(t); }
    /// The first change after t of what placeAt or bladeInMouthAt tells; SessionTime::max() where
    /// there is none.
    [[nodiscard]] SessionTime changeAfter(SessionTime t) const;
    /// The last entry by then that is as sure as the seat of the tube (isSureOfSeat); nothing where
    /// it is out, or nobody has noted one.
    [[nodiscard]] std::optional<IntubationEvent> lastOfSeatAt(SessionTime t) const;
    /// The last kMostNotes entries.
    [[nodiscard]] std::span<const NotedStep> notes() const { return m_notes; }
    /// Those of them that have a higher number: all after the last one that was looked at, also
    /// where that one is not kept any more.
    [[nodiscard]] std::span<const NotedStep> notesAfter(std::uint64_t number) const;
    /// The number of the last entry; 0 before the first.
    [[nodiscard]] std::uint64_t lastNote() const
    {
        return m_notes.empty() ? 0 : m_notes.back().number;
    }

private:
    void keep(SessionTime from, const IntubationEvent& event);

    ParameterTimeline<ToldTube> m_override{{}};
    ParameterTimeline<NotedTube> m_noted{NotedTube{}};
    ParameterTimeline<bool> m_blade{false};
    ParameterTimeline<bool> m_cuff{false};
    ParameterTimeline<double> m_obstruction{0.0};
    ParameterTimeline<bool> m_stylet{true};
    std::vector<NotedStep> m_notes;
};

/// Share of a delivered breath that escapes beside a tube whose cuff is empty. Of ours: enough to
/// be seen as a tidal volume that falls, and little enough that the patient is still ventilated, as
/// with a tube that has no cuff.
inline constexpr double kEmptyCuffLeak = 0.25;

} // namespace carina
